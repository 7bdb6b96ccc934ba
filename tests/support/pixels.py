"""Views as a browser paints them: in a page, and alone, from the SVG of the sheet, at one place and scale."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image

from graphic_tmm.paper.write.svg import svg

if TYPE_CHECKING:
    from playwright.sync_api import Page

    from graphic_tmm.paper.drawing import Sheet

STYLE = "body { margin: 0; background: white } svg { position: absolute; display: none }"


def alone(sheets: Sequence[Sheet], file: Path) -> Path:
    """Write sheets, one over the other, none of them shown, as a page of their own."""
    body = "\n".join(svg(sheet) for sheet in sheets)
    head = f'<!DOCTYPE html><meta charset="utf-8"><title>.</title><style>{STYLE}</style>'
    file.write_text(head + body, encoding="utf-8")
    return file


def show_alone(page: Page, sheet: int, view: str, there: Mapping[str, Any]) -> None:
    """Show one view of a sheet, by its id, in a page of `alone`, ``there``: see `lesson.at_the_end`.

    Its title and what stands below that are not seen; titles are the widest of the letters of no mark.
    """
    page.evaluate(
        """([number, view, { rect, box }]) => {
          const sheets = [...document.querySelectorAll("body > svg")];
          sheets.forEach((one, k) => { one.style.display = k === number ? "block" : "none"; });
          const sheet = sheets[number];
          for (const one of sheet.querySelectorAll("g.drawing")) {
            one.style.display = one.id === view ? "" : "none";
          }
          const own = [...sheet.getElementById(view).querySelectorAll(".label:not([data-of])")];
          const wide = (one) => Number(one.parentElement.getAttribute("stroke-width"));
          const most = Math.max(0.5, ...own.map(wide));
          const low = (one) => { const at = one.getBBox(); return at.y + at.height; };
          const title = Math.max(-Infinity, ...own.filter((one) => wide(one) === most).map(low));
          const gone = (one) => wide(one) === most || one.getBBox().y >= title - 1;
          for (const one of title === -Infinity ? [] : own) if (gone(one)) one.style.display = "none";
          sheet.setAttribute("viewBox", box);
          sheet.setAttribute("width", rect.width);
          sheet.setAttribute("height", rect.height);
          sheet.style.left = `${rect.x}px`;
          sheet.style.top = `${rect.y}px`;
        }""",
        [sheet, view, there],
    )


def at(page: Page, there: Mapping[str, Any]) -> np.ndarray:
    """Return what is painted at a place of a page as grey values, 0 black, 255 white."""
    picture = Image.open(io.BytesIO(page.screenshot(clip=there["rect"])))
    return np.asarray(picture.convert("L")).astype(int)
