"""A sheet on the canvas of a page: where it is looked at from, its points; the same by the browser's SVG."""

from __future__ import annotations

import base64
import io
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import numpy as np

if TYPE_CHECKING:
    from playwright.sync_api import Page

SVG = "{http://www.w3.org/2000/svg}"
ElementTree.register_namespace("", SVG[1:-1])
GROUND = "#d9d9d5"
"""What lies about a sheet."""


class Seen(NamedTuple):
    """Where a sheet is looked at from: the upper left corner, mm, and how large, px a millimetre."""

    x: float
    y: float
    zoom: float

    def spot(self, x: float, y: float) -> tuple[float, float]:
        """Return where a point of the sheet (mm, y downward) stands on the canvas, px."""
        return (x - self.x) * self.zoom, (y - self.y) * self.zoom


RESTED = """async () => {
  const desk = document.querySelector(".desk");
  for (let before; before !== desk.dataset.seen || before === undefined; ) {
    before = desk.dataset.seen;
    await new Promise((done) => setTimeout(done, 130));
    for (let k = 0; k < 3; k += 1) await new Promise((done) => requestAnimationFrame(done));
  }
  return desk.dataset.seen;
}"""
"""The page sets its letters anew 120 ms after the last move: a longer timer that is set later comes after."""


def seen(page: Page) -> Seen:
    """Return where the sheet is looked at from, once it stands still."""
    return Seen(*map(float, page.evaluate(RESTED).split()))


def picture(page: Page) -> Any:
    """Return the points of the canvas, red, green and blue."""
    seen(page)
    told = page.locator(".desk canvas").evaluate("one => one.toDataURL('image/png')")
    return points(base64.b64decode(told.partition(",")[2]))


def points(png: bytes) -> Any:
    from PIL import Image

    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(np.int16)


def size(page: Page) -> tuple[int, int]:
    """Return the width and the height of the desk, CSS px."""
    box = page.locator(".desk").evaluate("one => [one.clientWidth, one.clientHeight]")
    return int(box[0]), int(box[1])


def by_svg(page: Page, text: str, where: Seen, wide: int, high: int, file: Path) -> Any:
    """Return the points of a sheet's SVG in a window of the desk's size, looked at from the same place."""
    tree = ElementTree.fromstring(text)
    tree.set("width", str(wide))
    tree.set("height", str(high))
    tree.set("viewBox", f"{where.x} {where.y} {wide / where.zoom} {high / where.zoom}")
    tree.set("preserveAspectRatio", "xMinYMin")
    body = ElementTree.tostring(tree, encoding="unicode")
    style = f"body {{ margin: 0; background: {GROUND}; }} svg {{ display: block; }}"
    file.write_text(
        f"<!DOCTYPE html><meta charset=utf-8><style>{style}</style>{body}", encoding="utf-8"
    )
    page.goto(file.as_uri())
    clip = {"x": 0, "y": 0, "width": wide, "height": high}
    return points(page.screenshot(clip=clip))  # type: ignore[arg-type]


def without(text: str, gone: Callable[[Element], bool]) -> str:
    """Return the SVG of a sheet without some of its elements; its frame stays."""
    tree = ElementTree.fromstring(text)
    for group in tree.findall(f"{SVG}g"):
        if "frame" in (group.get("class") or "").split():
            continue
        for parent in (tree, *group.iter()):
            for one in list(parent):
                if (parent is not tree or one is group) and gone(one):
                    parent.remove(one)
    return ElementTree.tostring(tree, encoding="unicode")


def unlike(one: Any, other: Any, by: int = 1, most: int = 40) -> float:
    """Return the share of points that are in one picture as no point near is in the other.

    ``by``: how far is near; ``most``: how much they may differ all the same: edges are smoothed otherwise.
    """
    return max(_beyond(one, other, by, most), _beyond(other, one, by, most))


def _beyond(one: Any, other: Any, by: int, most: int) -> float:
    low, top = (_near(_near(other, by, 0, of), by, 1, of) for of in (np.minimum, np.maximum))
    return float(((one < low - most) | (one > top + most)).any(axis=2).mean())


def _near(one: Any, by: int, axis: int, of: np.ufunc) -> Any:
    """Return the least or the greatest of what is so near along an axis of a picture."""
    around = [(by, by) if k == axis else (0, 0) for k in range(one.ndim)]
    padded, size = np.pad(one, around, mode="edge"), one.shape[axis]
    found = np.take(padded, range(size), axis)
    for shift in range(1, 2 * by + 1):
        beside = slice(shift, shift + size)
        of(found, padded[beside] if axis == 0 else padded[:, beside], out=found)
    return found
