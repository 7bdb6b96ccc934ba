"""PDF and PNG of sheets, by typst (extra ``pdf``): every page exactly the size of its sheet."""

from __future__ import annotations

import math
import struct
import zlib
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal

from graphic_tmm.errors import SheetError, installing
from graphic_tmm.language.catalogue import code_of
from graphic_tmm.language.said import said
from graphic_tmm.paper import sheet_frame
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.write.svg import clean, svg

PPI = 150.0
"""Dots per inch of a PNG: an A1 sheet has 4967 × 3508."""
BEHIND_HEADER = 8 + 25
"""Where the first chunk of a PNG after its header begins: signature, then 13 bytes in a chunk."""
HAIR = 1e-6
"""By how much the paper of a PNG is narrower, and lower, than a whole number of dots (of itself)."""


def pdf(sheets: Sequence[Sheet]) -> bytes:
    """Return one PDF with a page for each sheet, and a bookmark for each of their views.

    Raises
    ------
    SheetError
        If typst is not installed.
    """
    return _compiled(sheets, "pdf")[0]


def png(sheet: Sheet, *, ppi: float = PPI) -> bytes:
    """Return a sheet as PNG with its physical size; raises SheetError if typst is not installed."""
    return _sized(_compiled([_on_dots(sheet, ppi)], "png", ppi)[0], ppi)


def _sized(image: bytes, ppi: float) -> bytes:
    """Return a PNG with its dots to the metre, without which it is printed at any size (chunk pHYs)."""
    dots = round(ppi / 0.0254)
    told = b"pHYs" + struct.pack(">IIB", dots, dots, 1)
    chunk = struct.pack(">I", len(told) - 4) + told + struct.pack(">I", zlib.crc32(told))
    return image[:BEHIND_HEADER] + chunk + image[BEHIND_HEADER:]


def _on_dots(sheet: Sheet, ppi: float) -> Sheet:
    """Return a sheet on paper of whole dots, everything as far from its upper left corner as before.

    typst paints an image first on dots of its own, their number across rounded up, and from it their
    number down; then it takes for each dot of the page the nearest of these. On paper a hair short
    of whole dots, in both ways, both are the same dots; on any other a row or a column may be left
    out, and what lies beyond it stands a dot off.
    """
    across, down = (round(size * ppi / 25.4) for size in (sheet.width, sheet.height))
    width = _short(across * 25.4 / ppi)
    height = _short(width * down / across)
    moved = tuple(drawing.moved(1j * (height - sheet.height)) for drawing in sheet.drawings)
    return sheet._replace(width=width, height=height, drawings=moved)


def _short(size: float) -> float:
    """Return the largest size in whole micrometres (as SVG has them) that is a hair short."""
    return math.floor(size * (1 - HAIR) * 1000) / 1000


def _quoted(text: str) -> str:
    """Return a text as typst writes it."""
    return '"{}"'.format(clean(text).replace("\\", "\\\\").replace('"', '\\"'))


def _bookmarks(sheet: Sheet, number: int) -> Iterator[str]:
    """Yield the bookmarks of a sheet and of its views, each at its upper left corner.

    They are hidden headings: not drawn, and not matched by a search. ``number``: of the sheet in a set; 0 for
    a single sheet, which needs no bookmark of its own.
    """
    if number:
        yield _heading(1, f"{number}. {sheet.title}", 0.0, 0.0)
    for drawing in sheet.drawings:
        if drawing.name != sheet_frame.NAME and (drawing.strokes or drawing.labels):
            left, _, _, top = bounds(drawing)
            title = drawing.title or drawing.name
            yield _heading(2 if number else 1, title, left, sheet.height - top)


def _heading(level: int, text: str, right: float, down: float) -> str:
    shown = f"heading(level: {level}, outlined: false, bookmarked: true, {_quoted(text)})"
    return f"#place(dx: {right:.3f}mm, dy: {down:.3f}mm, hide({shown}))"


def _compiled(
    sheets: Sequence[Sheet], form: Literal["pdf", "png"], ppi: float = PPI
) -> list[bytes]:
    try:
        import typst
    except ImportError as error:
        raise SheetError(
            said("{form} needs the package typst: {remedy}", form=form, remedy=installing("[pdf]"))
        ) from error
    with TemporaryDirectory() as folder:
        home = Path(folder)
        lines = [f"#set document(title: {_quoted(sheets[0].title)}, date: none)"]
        if sheets[0].language:
            lines.append(f"#set text(lang: {_quoted(code_of(sheets[0].language))})")
        for k, sheet in enumerate(sheets):
            (home / f"{k}.svg").write_text(svg(sheet, searchable=True), encoding="utf-8")
            size = f"width: {sheet.width}mm, height: {sheet.height}mm"
            number = k + 1 if len(sheets) > 1 else 0
            marks = "".join(_bookmarks(sheet, number)) if form == "pdf" else ""
            lines.append(f'#page({size}, margin: 0pt)[{marks}#image("{k}.svg", {size})]')
        (home / "sheets.typ").write_text("\n".join(lines), encoding="utf-8")
        made: Any = typst.compile(str(home / "sheets.typ"), root=folder, format=form, ppi=ppi)
    return made if isinstance(made, list) else [made]
