"""Elements of an SVG by the thousand, beside those of svgwrite: made at once, and the whole tree as text."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any
from xml.etree.ElementTree import Element, SubElement

_SPECIAL = re.compile('[&<>"\r\n\t]')
_SIGNS = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"}


class Made:
    """An element that svgwrite takes into its groups as one of its own."""

    __slots__ = ("xml",)

    def __init__(self, tag: str, attributes: Mapping[str, str], title: str = "") -> None:
        """``attributes``: by their names in SVG; those without a value are left out."""
        named = {name: attributes[name] for name in sorted(attributes) if attributes[name]}
        self.xml = Element(tag, named)
        if title:
            SubElement(self.xml, "title").text = title

    def add(self, tag: str, attributes: Mapping[str, str]) -> None:
        """Put an element into it; see `Made`."""
        self.xml.append(Made(tag, attributes).xml)

    def get_xml(self) -> Any:
        """Return it as a tree, as svgwrite asks for it."""
        return self.xml


def text_of(tree: Element) -> str:
    """Return a tree as text, one element a line."""
    lines = list[str]()
    _write(tree, lines)
    return "\n".join(lines) + "\n"


def _write(one: Element, lines: list[str]) -> None:
    """Put the lines of an element behind others."""
    told = "".join([f' {name}="{_safe(value)}"' for name, value in one.items()])
    if len(one):
        lines.append(f"<{one.tag}{told}>")
        for inner in one:
            _write(inner, lines)
        lines.append(f"</{one.tag}>")
    elif one.text:
        lines.append(f"<{one.tag}{told}>{_SPECIAL.sub(_within, one.text)}</{one.tag}>")
    else:
        lines.append(f"<{one.tag}{told} />")


def _safe(value: str) -> str:
    return _SPECIAL.sub(_coded, value)


def _coded(match: re.Match[str]) -> str:
    sign = match[0]
    return _SIGNS.get(sign) or f"&#{ord(sign):02d};"


def _within(match: re.Match[str]) -> str:
    """Return how a sign stands between tags: quotation marks and white space as they are."""
    sign = match[0]
    return _SIGNS[sign] if sign in "&<>" else sign
