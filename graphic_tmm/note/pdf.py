"""A note as PDF: pages set by typst from what pandoc writes for it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from graphic_tmm.errors import SheetError, installing
from graphic_tmm.language.catalogue import code_of, speaking
from graphic_tmm.language.said import said
from graphic_tmm.note import pandoc
from graphic_tmm.note.document import Document, Figure, SideBySide, Table
from graphic_tmm.note.figures import DrawnFigure
from graphic_tmm.note.styles import APART, NEARER, TYPST
from graphic_tmm.note.target import CONTENTS, LEADING, RAGGED, Target, Tree, escaped, raw
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.formats import size_of
from graphic_tmm.paper.sheet_frame import FIELDS, drawing_area, frame
from graphic_tmm.paper.write.svg import svg

SHORT = 8
"""A table of so many rows stands on one page."""

_SHORT = re.compile(r"(?<=\.\.)\.")
"""Three points, for which typst has a sign of its own."""

_STROKE = re.compile(r'(?<="\)) \\/ ?| \\/ (?=upright\()')
"""The stroke of a fraction beside digits, which has no white about it."""


def pdf(document: Document, stem: str, shown: Mapping[str, DrawnFigure]) -> dict[str, str | bytes]:
    """Return the note as PDF: tagged, with bookmarks, its title and its language."""
    typst = typesetter("pdf")

    def figure(block: Figure, caption: Tree) -> list[Tree]:
        parts = [
            shown[one.id] for one in (block.parts if isinstance(block, SideBySide) else [block])
        ]
        told = [
            f'image("{one.name}.svg", width: {one.width}mm, alt: {quoted(one.alt)})'
            for one in parts
        ]
        image = told[0] if len(told) == 1 else f"beside({', '.join(told)})"
        opening = f"#figure(kind: image, supplement: none, {image}, caption: ["
        closing = raw("typst", f"]) <{block.id}>", block=True)
        return [raw("typst", opening, block=True), caption, closing]

    contents = f"#contents({quoted(speaking(document.language)(CONTENTS))})"
    target = Target(
        "typst",
        lambda block: raw("typst", ""),
        lambda outline: [raw("typst", contents, block=True)],
        lambda: [raw("typst", "#pagebreak(weak: true)", block=True)],
        ("--wrap=none",),
        _set,
        _tabled,
        _part,
        figure=figure,
        word=escaped("typst", _SHORT),
        piece=lambda one: [raw("typst", "#box["), one, raw("typst", "]")],
        measured=True,
        whole=_whole,
        continued=lambda id, words: raw("typst", f"#continued(<{id}>)[{words}]"),
    )
    body = _STROKE.sub(r"\\/", pandoc.written(document, target).decode("utf-8"))
    head = (
        f"#set document(title: {quoted(document.title)}, date: none)\n"
        f"#set text(lang: {quoted(code_of(document.language))})\n"
        f"#let apart = {APART.get(document.language, NEARER)}\n"
        f"{_margins(document)}"
    )
    with TemporaryDirectory() as folder:
        home = Path(folder)
        for one in shown.values():
            (home / f"{one.name}.svg").write_text(one.svg, encoding="utf-8")
        file = home / "note.typ"
        text = f"{TYPST}{body}"
        if document.frame is not None:
            file.write_text(f"{head}#let drawn = false\n{text}{_COUNT}", encoding="utf-8")
            told = typst.query(
                str(file), "<pages>", field="value", one=True, root=folder, ignore_system_fonts=True
            )
            _frames(document, document.frame, int(told), home)
        drawn = str(document.frame is not None).lower()
        file.write_text(f"{head}#let drawn = {drawn}\n{text}", encoding="utf-8")
        made: bytes = typst.compile(str(file), root=folder, format="pdf", ignore_system_fonts=True)
    return {f"{stem}.pdf": made}


_COUNT = "\n#context [#metadata(counter(page).final().first()) <pages>]\n"
"""What tells how many pages there are."""
_ASIDE, _ABOVE = (8.0, 5.0), 10.0
"""Between the frame and the text, left and right; above the text and below it, mm (ГОСТ 2.105)."""


def _margins(document: Document) -> str:
    """Return the margins of the pages, and the lower one of the first page of text."""
    left, right, top, bottom, low = 30.0, 15.0, 20.0, 20.0, 20.0
    if document.frame is not None:
        first, other = (
            drawing_area(_A4, document.language, one, text=True) for one in (True, False)
        )
        width, height = size_of(_A4)
        left, right = first.inner.left + _ASIDE[0], width - first.inner.right + _ASIDE[1]
        top = height - first.inner.top + _ABOVE
        low, bottom = (one.occupied[0].top + _ABOVE for one in (first, other))
    room = f"(left: {left}mm, right: {right}mm, top: {top}mm, bottom: {bottom}mm)"
    framed = str(document.frame is not None).lower()
    return f"#let room = {room}\n#let low = {low}mm\n#let framed = {framed}\n"


_A4 = "A4"


def _frames(document: Document, fields: Mapping[str, str], count: int, home: Path) -> None:
    """Write the frames of the pages behind the title page, which is counted."""
    known = {key: text for key, text in fields.items() if key in FIELDS}
    for number in range(2, count + 1):
        edge = frame(
            _A4,
            language=document.language,
            first=number == 2,
            number=number,
            count=count,
            fields=known,
            check=False,
            text=True,
            again=False,
        )
        sheet = Sheet("frame", "", _A4, *size_of(_A4), (edge,), document.language)
        (home / f"frame-{number}.svg").write_text(svg(sheet), encoding="utf-8")


def _set(block: Tree, style: str) -> list[Tree]:
    """Return a paragraph of the title page as typst sets it."""
    if style == "space":
        return [raw("typst", "#v(1fr)", block=True)]
    if style in (RAGGED, LEADING):
        return [raw("typst", f"#{style}[", block=True), block, raw("typst", "]", block=True)]
    opening = "#great[" if style == "title" else "#centred["
    return [raw("typst", opening, block=True), block, raw("typst", "]", block=True)]


def _whole(lines: list[Tree]) -> list[Tree]:
    """Return the lines of one formula as typst keeps them together."""
    return [raw("typst", "#together[", block=True), *lines, raw("typst", "]", block=True)]


def _part(heading: Tree) -> list[Tree]:
    """Return a heading as typst sets it in the middle."""
    return [raw("typst", "#part[", block=True), heading, raw("typst", "]", block=True)]


def _tabled(made: Tree, table: Table) -> list[Tree]:
    """Return a table as typst sets it: without lines if it has none, on one page if it is short."""
    if table.long or (table.ruled and len(table.rows) > SHORT):
        return [made]
    opening = raw("typst", "#whole[" if table.ruled else "#bare[", block=True)
    return [opening, made, raw("typst", "]", block=True)]


def quoted(text: str) -> str:
    """Return a text as typst writes it."""
    return '"{}"'.format(" ".join(text.split()).replace("\\", "\\\\").replace('"', '\\"'))


def typesetter(form: str) -> Any:
    """Return the package that sets PDF, and paints figures.

    Raises
    ------
    SheetError
        If it is not installed; says how to install it.
    """
    try:
        import typst
    except ImportError as error:
        raise SheetError(
            said(
                "a note as {form} needs the package typst: {remedy}",
                form=form,
                remedy=installing("[note]"),
            )
        ) from error
    return typst
