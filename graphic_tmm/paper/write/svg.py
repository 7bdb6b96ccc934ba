"""A sheet as SVG in true millimetres: only here is y turned over, only here is svgwrite used.

A drawing becomes a group with its title, a layer to Inkscape; in it every pen has a group that carries the
style, a layer within. Strokes of one pen that come from the same steps (``data-of``: slots of their marks), in
the same position (``data-at``: its index), or that are the same part (``data-part``), are one path; those that
a page must find (a title, data) stand alone. Lettering
is drawn as strokes, each label a group that bears its words as a title; live text there is none, for a CAD
program would take it for ink. Where a search needs it (in a PDF) it lies white under everything.
"""

from __future__ import annotations

import cmath
import math
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple
from urllib.parse import quote
from xml.etree.ElementTree import Element, SubElement

from graphic_tmm.errors import SheetError
from graphic_tmm.language.catalogue import SOURCE, speaking
from graphic_tmm.language.numbers import number as spoken
from graphic_tmm.language.units import unit_name
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Sheet, Stroke
from graphic_tmm.paper.lettering import letters
from graphic_tmm.paper.pens import KINDS, LETTERING, Pen, pens, refuse_unknown, stretched, tracing
from graphic_tmm.paper.write.svg_path import clockwise, length, number, path_data

if TYPE_CHECKING:
    import svgwrite


_SPECIAL = re.compile('[&<>"\r\n\t]')
_SIGNS = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"}


class ReadyElement:
    """An element that svgwrite takes into its groups as one of its own."""

    __slots__ = ("xml",)

    def __init__(self, tag: str, attributes: Mapping[str, str], title: str = "") -> None:
        """``attributes``: by their names in SVG; those without a value are left out."""
        named = {name: attributes[name] for name in sorted(attributes) if attributes[name]}
        self.xml = Element(tag, named)
        if title:
            SubElement(self.xml, "title").text = title

    def add(self, tag: str, attributes: Mapping[str, str]) -> None:
        """Put an element into it; see `ReadyElement`."""
        self.xml.append(ReadyElement(tag, attributes).xml)

    def get_xml(self) -> Any:
        """Return it as a tree, as svgwrite asks for it."""
        return self.xml


def svg_text(tree: Element) -> str:
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


FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML 1.0 does not allow."""

ANCHORS = {"start": 0.0, "middle": 0.5, "end": 1.0}


def clean(text: str) -> str:
    """Return text without the characters XML forbids, every run of white space as one space."""
    return " ".join(FORBIDDEN.sub("", text).split())


class Under(NamedTuple):
    """A picture under a sheet, of the same size: its file next to the SVG, the colour of the ink over it."""

    file: str
    colour: str = "#d0006f"


def svg(
    sheet: Sheet, *, under: Under | None = None, searchable: bool = False, layers: bool = True
) -> str:
    """Return the sheet as SVG text: millimetres, one element a line, no outside references.

    ``under``: a picture instead of the paper; all ink upon it is thin, of one colour, and hides nothing.
    ``searchable``: with live text, white under the ink; ``layers``: its groups are layers to Inkscape.

    Raises SheetError for a coordinate that is not finite, an unknown pen, or an unfit data name.
    """
    import svgwrite

    width, height = number(sheet.width), number(sheet.height)
    page = svgwrite.Drawing(
        size=(f"{width}mm", f"{height}mm"),
        viewBox=f"0 0 {width} {height}",
        profile="full",
        debug=False,
    )
    page.elements.clear()  # an empty <defs>
    if layers:
        page["xmlns:inkscape"] = "http://www.inkscape.org/namespaces/inkscape"
    if sheet.language:
        page["lang"] = page["xml:lang"] = sheet.language
    titles = "; ".join(clean(drawing.title or drawing.name) for drawing in sheet.drawings)
    page.set_desc(title=clean(sheet.title), desc=titles)
    writer = _Writer(page, sheet.height, sheet.language or SOURCE, layers=layers)
    if under is None:
        page.add(page.rect(size=(width, height), fill="white", class_="paper"))
    else:
        page.add(writer.picture(under.file, width, height))
    if searchable:
        page.add(writer.words(label for drawing in sheet.drawings for label in drawing.labels))
    names = ids(sheet)
    box = pens(sheet.format)
    if under is not None:
        box = tracing(box, under.colour)
        writer.trace = box["thin"]
    for name, drawing in zip(names, sheet.drawings, strict=True):
        page.add(writer.drawing(name, drawing, box))
    return svg_text(page.get_xml())


class _Writer:
    """What turns records of ink into elements of one page."""

    def __init__(
        self, page: svgwrite.Drawing, height: float, language: str, *, layers: bool
    ) -> None:
        self.page, self.layers = page, layers
        self.height = height
        self.language = language
        self.speech = speaking(language)
        self.trace: Pen | None = None
        """The one pen of all lettering; None: black, as wide as its size asks for."""

    def drawing(self, name: str, drawing: Drawing, box: Mapping[str, Pen]) -> Any:
        """Return the group of a drawing: its pens in their order, then its lettering."""
        group = self.layer(clean(drawing.title or drawing.name))
        group.update({"id": name, "class_": f"drawing {_slug(drawing.name)}"})
        refuse_unknown((stroke.pen for stroke in drawing.strokes), box, drawing.name)
        for key, pen in box.items():
            strokes = [stroke for stroke in drawing.strokes if stroke.pen == key]
            if strokes:
                group.add(self.pen(key, pen, strokes))
        for width, labels in _by_width(drawing.labels).items():
            group.add(self.lettering(width, labels))
        return group

    def layer(self, title: str) -> Any:
        """Return an empty group that Inkscape takes for a layer, with a title."""
        group = self.page.g()
        group.set_desc(title=title)
        return self.layered(group, title)

    def layered(self, group: Any, label: str) -> Any:
        """Return a group as a layer to Inkscape, where a sheet has any."""
        if self.layers:
            group["inkscape:groupmode"] = "layer"
            group["inkscape:label"] = label
        return group

    def picture(self, file: str, width: str, height: str) -> Any:
        """Return a layer with a picture of the size of the sheet."""
        group = self.layer(clean(file))
        placed = self.page.image(_address(file), insert=(0, 0), size=(width, height))
        placed.stretch()
        group.add(placed)
        return group

    def pen(self, key: str, pen: Pen, strokes: Sequence[Ink]) -> Any:
        """Return the group of one pen: merged paths, and the strokes with data one by one."""
        group = self.page.g(
            class_=f"pen {key}",
            fill=pen.fill,
            stroke=pen.colour,
            stroke_width=number(pen.width),
            stroke_linecap="butt" if pen.dashes else "round",
            stroke_linejoin="round",
        )
        self.layered(group, self.speech(KINDS[key]))
        merged: dict[tuple[object, ...], list[str]] = {}
        styles: dict[tuple[object, ...], tuple[dict[str, str], Ink]] = {}
        alone = []
        for stroke in strokes:
            if stroke.title or stroke.data or pen.fill != "none":
                alone.append(stroke)
                continue
            style = _style(pen, stroke)
            source = (stroke.of, stroke.position, stroke.part)
            shape = (*style.values(), clockwise(stroke), source)
            styles[shape] = style, stroke
            merged.setdefault(shape, []).append(path_data(stroke, self.height))
        for shape, pieces in merged.items():
            style, stroke = styles[shape]
            told = {"d": "".join(pieces), **style, **_from_steps(stroke)}
            group.elements.append(ReadyElement("path", told))
        group.elements += [self.single(pen, stroke) for stroke in alone]
        return group

    def single(self, pen: Pen, stroke: Ink) -> ReadyElement:
        """Return the path of one stroke with its title and its data attributes."""
        told = {"d": path_data(stroke, self.height), **_style(pen, stroke), **_from_steps(stroke)}
        of = dict(stroke.data).get("unit", "")
        own = unit_name(of, self.language)
        data = ((name, own if name == "unit" else value) for name, value in stroke.data)
        told |= {_attribute(name): clean(value) for name, value in data}
        title = f"{stroke.title.removesuffix(of)}{own}" if of and of != own else stroke.title
        return ReadyElement("path", told, clean(title))

    def lettering(self, width: float, labels: Sequence[Label]) -> Any:
        """Return the labels written with a pen of one width (mm)."""
        ink = self.trace or Pen(width)
        group = self.page.g(
            class_="lettering",
            fill="none",
            stroke=ink.colour,
            stroke_width=number(ink.width),
            stroke_linecap="round",
            stroke_linejoin="round",
        )
        size = spoken(10 * width, self.speech.language)
        self.layered(group, f"{self.speech(LETTERING)} {size}")
        for label in labels:
            written = letters.letter(label.text, size=label.size, inclined=label.inclined)
            if not written.parts:
                continue
            start = label.at - shift(label, written.width)
            x, y = start.real, self.height - start.imag
            words = clean(letters.plain(label.text))
            told = {"aria-label": words, "class": "label", "role": "img", **_from_steps(label)}
            element = ReadyElement("g", told, words)
            for pen in written.pens:
                d = letters.svg_path(written, x, y, angle=label.turn, pen=pen)
                own = {} if pen == width or self.trace else {"stroke-width": number(pen)}
                element.add("path", {"d": d, **own})
            group.elements.append(element)
        return group

    def words(self, labels: Iterable[Label]) -> Any:
        """Return the white layer of live text: only for search and for copying out."""
        group = self.page.g(
            class_="words", fill="white", font_family="sans-serif", aria_hidden="true"
        )
        for label in labels:
            text = clean(letters.plain(label.text))
            if not text:
                continue
            x, y = number(label.at.real), number(self.height - label.at.imag)
            style = {"font_size": number(label.size), "text_anchor": label.anchor}
            if label.turn:
                style["transform"] = f"rotate({number(-label.turn)} {x} {y})"
            group.add(self.page.text(text, x=[x], y=[y], **style))
        return group


def _from_steps(one: Ink | Label) -> dict[str, str]:
    """Return the attributes of an element that name the marks whose steps drew it, its position, its part."""
    told = {"data-of": " ".join(map(str, one.of))}
    if one.position is not None:
        told["data-at"] = str(one.position)
    if not isinstance(one, Label):
        told["data-part"] = clean(one.part)
    return told


def _style(pen: Pen, stroke: Ink) -> dict[str, str]:
    """Return what a stroke adds to the style of its group: its own dashes, or its filling."""
    if isinstance(stroke, Stroke) and stroke.filled:
        return {"fill": pen.colour if pen.fill == "none" else pen.fill, "stroke": "none"}
    closed = isinstance(stroke, Stroke) and stroke.closed
    dashes = stretched(pen.dashes, length(stroke), closed=closed) if pen.dashes else ()
    return {"stroke-dasharray": " ".join(map(number, dashes))} if dashes else {}


def _by_width(labels: Iterable[Label]) -> dict[float, list[Label]]:
    """Return the labels grouped by the width of their pen, in the order first met."""
    groups: dict[float, list[Label]] = {}
    for label in labels:
        groups.setdefault(letters.letter(label.text, size=label.size).pen, []).append(label)
    return groups


def shift(label: Label, width: float) -> complex:
    """Return the way from the start of a label's lettering to its anchor."""
    if label.anchor not in ANCHORS:
        raise SheetError(
            f"label {label.text!r}: anchor {label.anchor!r} is none of {', '.join(ANCHORS)}"
        )
    return cmath.rect(width * ANCHORS[label.anchor], math.radians(label.turn))


def _attribute(name: str) -> str:
    """Return the name of a data attribute."""
    if not re.fullmatch("[a-z][a-z0-9-]*", name):
        raise SheetError(f"{name!r} is no name of data: use small letters, digits and '-'")
    return f"data-{name}"


def _address(file: str) -> str:
    """Return the name of a file in this folder as an address: only what would mean something else is coded."""
    return re.sub("[%#?:\\\\\x00-\x1f\x7f\ud800-\udfff]", lambda c: quote(os.fsencode(c[0])), file)


def _slug(text: str) -> str:
    """Return text as a word fit for an id: Latin letters and digits, everything else as one '-'."""
    return re.sub("[^0-9a-z]+", "-", text.lower()).strip("-") or "x"


def ids(sheet: Sheet) -> list[str]:
    """Return the ids of the drawings of a sheet in SVG, each its own: one met again is numbered from 2."""
    taken: dict[str, None] = {}
    for drawing in sheet.drawings:
        base, k = f"s-{_slug(f'{sheet.name}-{drawing.name}')}", 2
        unique = base
        while unique in taken:
            unique, k = f"{base}-{k}", k + 1
        taken[unique] = None
    return list(taken)
