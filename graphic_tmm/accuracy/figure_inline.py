"""The figure of an answer within a page or a note: short SVG with neither a style sheet nor inline styles.

A page's policy refuses inline styles, and a style sheet in a figure would be one of the whole page. Black and
white are named, so that a page in the dark can exchange them.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from graphic_tmm.accuracy.answer import Answer
from graphic_tmm.accuracy.cost_figure import vector

MM = 25.4 / 72.0
"""Millimetres of a point."""
NAMED = {"#000000": "black", "#ffffff": "white"}
"""Colours that pages know by their names."""
_LEFT_OUT = re.compile(r"<metadata>.*?</metadata>|<!--.*?-->|<style.*?</style>", re.DOTALL)
_TAG = re.compile(r"<[^>]*>")
_STYLE = re.compile(r' style="([^"]*)"')
_LONG = re.compile(r"-?\d+\.\d{2,}")
_ID = re.compile(r' id="([^"]*)"')
_USED = re.compile(r'(?:href="|url\()#([^")]+)')
_HEAD = re.compile(r'<svg [^>]*width="([\d.]+)pt" height="([\d.]+)pt"[^>]*>')


class InlineFigure(NamedTuple):
    """A figure as an element of SVG; its width and height, mm."""

    svg: str
    width: float
    height: float


def inline_figure(answer: Answer, *, lettered: bool = False) -> InlineFigure:
    """Return the figure of an answer; ``lettered``: its letters as text, which is a third as long."""
    return inline(vector(answer, lettered=lettered))


def inline(drawn: str) -> InlineFigure:
    """Return a figure of matplotlib as an element."""
    text = _LEFT_OUT.sub("", drawn[drawn.index("<svg") :])
    text = re.sub(r">\s+<", "><", re.sub(r"\s*\n\s*", " ", text)).strip()
    head = _HEAD.match(text)
    assert head is not None
    width, height = float(head[1]), float(head[2])
    used = set(_USED.findall(text))
    body = _TAG.sub(lambda tag: _short(tag[0], used), text[head.end() :])
    opening = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}"'
        ' stroke-linejoin="round" stroke-linecap="butt">'
    )
    return InlineFigure(opening + body.replace("<defs></defs>", ""), width * MM, height * MM)


def _short(tag: str, used: set[str]) -> str:
    """Return a tag with attributes for its style, without ids that nothing uses, in hundredths of a point."""
    tag = _ID.sub(lambda one: one[0] if one[1] in used else "", tag)
    tag = _STYLE.sub(_attributes, tag.replace("xlink:href", "href"))
    return _LONG.sub(lambda one: _rounded(float(one[0])), tag)


def _rounded(value: float) -> str:
    """Return a number in hundredths; one that is less than 1, which may be a scale, in three digits."""
    return f"{round(value, 2):g}" if abs(value) >= 1.0 else f"{value:.3g}"


def _attributes(style: re.Match[str]) -> str:
    """Return a style as attributes."""
    pairs = (one.split(":", 1) for one in style[1].split(";") if one.strip())
    told = ((name.strip(), value.strip()) for name, value in pairs)
    return "".join(f' {name}="{NAMED.get(value, value)}"' for name, value in told)
