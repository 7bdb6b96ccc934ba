"""PDF and PNG of sheets, by typst (extra ``pdf``): every page exactly the size of its sheet."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.svg import svg

PPI = 150.0
"""Dots per inch of a PNG: an A1 sheet has 4967 × 3508."""


def pdf(sheets: Sequence[Sheet]) -> bytes:
    """Return one PDF with a page for each sheet.

    Raises
    ------
    SheetError
        If typst is not installed.
    """
    return _compiled(sheets, "pdf")[0]


def png(sheet: Sheet, *, ppi: float = PPI) -> bytes:
    """Return a sheet as PNG; raises SheetError if typst is not installed."""
    return _compiled([sheet], "png", ppi)[0]


def _compiled(
    sheets: Sequence[Sheet], form: Literal["pdf", "png"], ppi: float = PPI
) -> list[bytes]:
    try:
        import typst
    except ImportError as error:
        raise SheetError(
            f"{form} needs the package typst: pip install 'graphic-tmm[pdf]'"
        ) from error
    with TemporaryDirectory() as folder:
        home = Path(folder)
        lines = ["#set document(date: none)"]
        for k, sheet in enumerate(sheets):
            (home / f"{k}.svg").write_text(svg(sheet), encoding="utf-8")
            size = f"width: {sheet.width}mm, height: {sheet.height}mm"
            lines.append(f'#page({size}, margin: 0pt)[#image("{k}.svg", {size})]')
        (home / "sheets.typ").write_text("\n".join(lines), encoding="utf-8")
        made: Any = typst.compile(str(home / "sheets.typ"), root=folder, format=form, ppi=ppi)
    return made if isinstance(made, list) else [made]
