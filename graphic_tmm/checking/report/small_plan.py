"""A small plan: SVG to stand inside a page or a Markdown file, true to shape, without references and text.

Letters are strokes, as on a sheet: a reader of Markdown that leaves out drawings leaves nothing of them behind.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from graphic_tmm.checking.records import FINE, WRONG, Picture
from graphic_tmm.checking.report.chart import COLOURS
from graphic_tmm.checking.report.rendering import render
from graphic_tmm.checking.report.words import shown
from graphic_tmm.paper.drawing import Bezier, Ink, line
from graphic_tmm.paper.lettering.letters import letter, svg_path
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.write.svg_path import path_data

if TYPE_CHECKING:
    from markupsafe import Markup

WIDTH, HEIGHT = 90.0, 64.0
"""The picture is at most so wide and high, mm: half of a page between its margins, two lessons on a page."""
EDGE = 3.0
"""White about the plan, mm: a cross on its edge is whole."""
BEYOND = 0.5
"""What was found is shown as far as this share of the plan beyond it; what is farther runs out of the picture.
Chosen by eye."""
FAR = 5.0
"""What was found farther than so many times the plan's size is drawn as far, in its direction."""
LEAST, LARGEST = 2.5, 3.5
"""Letters are as large as on the sheet, made smaller with the plan, but between these, mm (ГОСТ 2.304)."""
CROSS = 1.3
"""Half of the cross at the point that was found, mm."""
LEFT_OUT = frozenset({"guide", "hatching"})
"""Hatching is too fine for so small a picture."""


class _Page(NamedTuple):
    """How the plan stands in the picture: its left and lower edge, mm of the plan; how many times as large."""

    left: float
    low: float
    times: float
    height: float

    def at(self, z: complex) -> complex:
        """Return where a point of the plan stands, mm from the lower left corner, y upward."""
        return complex(EDGE, EDGE) + self.times * (z - complex(self.left, self.low))

    def scaled(self, one: Ink) -> Ink:
        """Return ink of the plan as it stands in the picture."""
        if isinstance(one, Bezier):
            return one._replace(controls=tuple(map(self.at, one.controls)))
        moved = ((self.at(complex(x, y)), bulge) for x, y, bulge in one.path)
        return one._replace(path=tuple((z.real, z.imag, bulge) for z, bulge in moved))


class _Letter(NamedTuple):
    """A letter with its index: the data of its strokes, the width of the pen, the box of its ink."""

    data: str
    pen: str
    box: tuple[float, float, float, float]


def small_plan(picture: Picture, label: str) -> Markup:
    """Return a plan as an SVG element: the plan grey, what is due green, what was found red."""
    picture = _near(picture)
    left, low, right, top = _box(picture)
    room = (WIDTH - 2 * EDGE) / (right - left), (HEIGHT - 2 * EDGE) / (top - low)
    times = min(1.0, *room)
    width, height = ((b - a) * times + 2 * EDGE for a, b in ((left, right), (low, top)))
    page = _Page(left, low, times, height)
    ink = [one for one in picture.drawing.strokes if one.part not in LEFT_OUT]
    of = set(picture.of) if len(picture.due) < 2 else set()  # else the due segment is drawn itself
    meant = [not one.part and bool(set(one.of) & of) for one in ink]
    letters = list(_letters(page, picture))
    edges = [(0.0, 0.0, width, height), *(one.box for one in letters)]
    x, y = (min(edge[k] for edge in edges) for k in (0, 1))
    size = tuple(max(edge[k + 2] for edge in edges) - (x, y)[k] for k in (0, 1))
    return render(
        "plan.svg",
        label=shown(label),
        box=[f"{value:.2f}" for value in (x, y, *size)],
        due=COLOURS[FINE],
        found=COLOURS[WRONG],
        ink=_drawn(page, [one for one, its in zip(ink, meant, strict=True) if not its]),
        meant=_drawn(page, [one for one, its in zip(ink, meant, strict=True) if its]),
        letters=letters,
        due_line=_line(page, picture.due),
        found_line=_line(page, picture.found),
        due_mark=_disc(page, picture.due),
        found_mark=_cross(page, picture.found),
    )


def _near(picture: Picture) -> Picture:
    """Return the picture with what was found so near that it can be drawn; what is no number is left out."""
    found = picture.found
    if not all(map(cmath.isfinite, (*found, *picture.due))):
        return picture._replace(due=(), found=())
    left, low, right, top = bounds(picture.drawing)
    middle, most = complex(left + right, low + top) / 2, FAR * max(right - left, top - low)
    ways = [z - middle for z in found]
    near = (middle + way * min(1.0, most / max(abs(way), most)) for way in ways)
    return picture._replace(found=tuple(near))


def _box(picture: Picture) -> tuple[float, float, float, float]:
    """Return what the picture shows of the plan's plane, mm: the plan, and what was found if it is not far."""
    left, low, right, top = bounds(picture.drawing)
    far = BEYOND * max(right - left, top - low)
    for z in (*picture.due, *picture.found):
        left, right = max(min(left, z.real), left - far), min(max(right, z.real), right + far)
        low, top = max(min(low, z.imag), low - far), min(max(top, z.imag), top + far)
    return left, low, max(right, left + 1.0), max(top, low + 1.0)


def _drawn(page: _Page, ink: Iterable[Ink]) -> tuple[str, str]:
    """Return the data of the paths of lines, and of filled shapes (arrows)."""
    lines, filled = "", ""
    for one in map(page.scaled, ink):
        data = path_data(one, page.height)
        if not isinstance(one, Bezier) and one.filled:
            filled += data
        else:
            lines += data
    return lines, filled


def _letters(page: _Page, picture: Picture) -> Iterator[_Letter]:
    """Yield the letters: each stands to its point as it does on the sheet, by its own size."""
    labels = picture.drawing.labels
    for one, named in zip(labels, picture.named or [one.at for one in labels], strict=True):
        size = min(max(one.size * page.times, LEAST), LARGEST)
        put = letter(one.text, size=size, inclined=one.inclined)
        at = page.at(named) + (one.at - named) * size / one.size
        x = at.real - {"start": 0.0, "middle": 0.5, "end": 1.0}[one.anchor] * put.width
        y = page.height - at.imag
        left, low, right, top = put.ink
        yield _Letter(
            svg_path(put, x, y), f"{size / 10:.2f}", (x + left, y - top, x + right, y - low)
        )


def _line(page: _Page, ends: Sequence[complex]) -> str:
    return _path(page, *ends) if len(ends) == 2 else ""


def _disc(page: _Page, ends: Sequence[complex]) -> tuple[str, str] | None:
    """Return the middle of the circle about the due point; None if there is none."""
    if not ends:
        return None
    at = page.at(ends[-1])
    return f"{at.real:.2f}", f"{page.height - at.imag:.2f}"


def _cross(page: _Page, ends: Sequence[complex]) -> str:
    if not ends:
        return ""
    at, ways = ends[-1], (CROSS * (1 + 1j) / page.times, CROSS * (1 - 1j) / page.times)
    return "".join(_path(page, at - way, at + way) for way in ways)


def _path(page: _Page, start: complex, end: complex) -> str:
    return path_data(page.scaled(line("thin", start, end)), page.height)
