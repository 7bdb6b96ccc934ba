"""The records of ink: strokes, curves and labels in millimetres, y upward, and the sheet they stand on.

A ``Path`` is a tuple of vertices (x, y, bulge): the bulge of the segment to the next vertex, as in DXF
(the tangent of a quarter of the arc's angle, counter-clockwise positive; 0 for a straight line).
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

Vertex = tuple[float, float, float]
Path = tuple[Vertex, ...]
Data = tuple[tuple[str, str], ...]


class Stroke(NamedTuple):
    """One line drawn with one pen: a path; ``title`` and ``data`` are read by a page, not drawn."""

    pen: str
    path: Path
    closed: bool = False
    filled: bool = False
    title: str = ""
    data: Data = ()


class Bezier(NamedTuple):
    """A smooth curve: 3n + 1 control points (complex, mm) of cubic arcs in succession."""

    pen: str
    controls: tuple[complex, ...]
    title: str = ""
    data: Data = ()


class Label(NamedTuple):
    """Lettering: mark-up as `letters` takes it, the anchor point on the base line (mm), size of capitals.

    ``anchor`` is "start", "middle" or "end"; ``turn`` in degrees, counter-clockwise.
    """

    text: str
    at: complex
    size: float = 5.0
    anchor: str = "start"
    turn: float = 0.0
    inclined: bool = True


class Within(NamedTuple):
    """What an empty sheet offers a view: widths and heights of its largest free rectangles, mm."""

    sizes: tuple[tuple[float, float], ...]

    @property
    def width(self) -> float:
        """The width of the widest of them."""
        return max(width for width, _ in self.sizes)

    def share(self, width: float, height: float) -> float:
        """Return how many times larger what takes so much room may be; below 1 it does not fit."""
        return max(min(w / max(width, 1e-9), h / max(height, 1e-9)) for w, h in self.sizes)


class Stand(NamedTuple):
    """How a view stands among the others of a sheet.

    Views of one ``block`` stand together; ``below``: the block that stands above it. ``kind``: "lead" at the
    upper left, first of its sheet; "row" in rows with its block, "pair" no farther than 25 mm from the view
    before it; "table" wherever there is room for it; "" in its order.
    """

    block: str = ""
    kind: str = ""
    below: str = ""


class Drawing(NamedTuple):
    """A view: everything of one plan, table or block, that layout moves as a whole.

    ``cell`` (left, bottom, right, top) is the room it takes if that is more than its ink. ``apart``: what it
    comes apart into where no sheet holds it whole; None if it does not. ``stand``: how it stands among others.
    """

    name: str
    title: str
    strokes: tuple[Stroke | Bezier, ...] = ()
    labels: tuple[Label, ...] = ()
    cell: tuple[float, float, float, float] | None = None
    apart: Callable[[Within], Sequence[Drawing]] | None = None
    stand: Stand = Stand()

    def moved(self, by: complex) -> Drawing:
        """Return the drawing translated by ``by`` (complex, mm)."""
        dx, dy = by.real, by.imag
        strokes = tuple(
            stroke._replace(controls=tuple(c + by for c in stroke.controls))
            if isinstance(stroke, Bezier)
            else stroke._replace(path=tuple((x + dx, y + dy, b) for x, y, b in stroke.path))
            for stroke in self.strokes
        )
        labels = tuple(label._replace(at=label.at + by) for label in self.labels)
        cell = self.cell
        if cell is not None:
            cell = (cell[0] + dx, cell[1] + dy, cell[2] + dx, cell[3] + dy)
        return self._replace(strokes=strokes, labels=labels, cell=cell)


class Sheet(NamedTuple):
    """A sheet of paper: its format, its size in mm, the drawings in sheet coordinates (y upward).

    ``language``: of its texts, "ru" or "en"; "" if it is not known.
    """

    name: str
    title: str
    format: str
    width: float
    height: float
    drawings: tuple[Drawing, ...]
    language: str = ""

    def _repr_svg_(self) -> str:
        """Return the sheet as SVG: a notebook shows it."""
        from graphic_tmm.paper.write.svg import svg

        return svg(self)


def line(pen: str, *points: complex, closed: bool = False, filled: bool = False) -> Stroke:
    """Return a straight-sided stroke through ``points`` (complex, mm)."""
    return Stroke(pen, tuple((z.real, z.imag, 0.0) for z in points), closed, filled)


def circle(pen: str, centre: complex, radius: float, *, filled: bool = False) -> Stroke:
    """Return a full circle as two half arcs."""
    x, y = centre.real, centre.imag
    return Stroke(pen, ((x - radius, y, 1.0), (x + radius, y, 1.0)), True, filled)


def arc(pen: str, centre: complex, radius: float, start: float, sweep: float) -> Stroke:
    """Return an arc from the angle ``start`` over ``sweep`` (degrees, counter-clockwise positive)."""
    pieces = max(1, math.ceil(abs(sweep) / 90 - 1e-9))
    bulge = math.tan(math.radians(sweep / pieces) / 4)
    path = []
    for k in range(pieces + 1):
        z = centre + cmath.rect(radius, math.radians(start + sweep * k / pieces))
        path.append((z.real, z.imag, bulge if k < pieces else 0.0))
    return Stroke(pen, tuple(path))
