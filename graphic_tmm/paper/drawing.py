"""The records of ink: strokes, curves and labels in millimetres, y upward, and the sheet they stand on.

A ``Path`` is a tuple of vertices (x, y, bulge): the bulge of the segment to the next vertex, as in DXF
(the tangent of a quarter of the arc's angle, counter-clockwise positive; 0 for a straight line).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from graphic_tmm.paper.arithmetic import polar, tangent

Vertex = tuple[float, float, float]
Path = tuple[Vertex, ...]
Data = tuple[tuple[str, str], ...]
TABLE, EQUATIONS, GRAPH, HEADING = "table", "equations", "graph", "heading"
"""What a view is, where code asks: a ruled table, equations line by line, a graph on axes, a row's heading.
A chapter's own stand in the chapter; of all others, "", nobody asks."""


class Symbol(NamedTuple):
    """A conventional sign: its ``kind``, where its origin stands (mm), how far it is turned (degrees)."""

    kind: str
    at: complex
    turn: float = 0.0


class Stroke(NamedTuple):
    """One line drawn with one pen: a path; ``title`` and ``data`` are read by a page, not drawn.

    ``of``: the slots of the marks, and so of the steps, that it comes from; ``position``: the one it belongs to
    (index), None: to all of them. ``part``: what it is a part of where no step left it: a body of the plan
    ("link", "guide": ``of`` are its marks) or what a view adds ("axis", "hatching"; ``of`` is empty).
    ``symbol``: the conventional sign of which it is a stroke.
    """

    pen: str
    path: Path
    closed: bool = False
    filled: bool = False
    title: str = ""
    data: Data = ()
    of: tuple[int, ...] = ()
    position: int | None = None
    part: str = ""
    symbol: Symbol | None = None


class Bezier(NamedTuple):
    """A smooth curve: 3n + 1 control points (complex, mm) of cubic arcs in succession; see `Stroke`."""

    pen: str
    controls: tuple[complex, ...]
    title: str = ""
    data: Data = ()
    of: tuple[int, ...] = ()
    position: int | None = None
    part: str = ""


Ink = Stroke | Bezier


class Label(NamedTuple):
    """Lettering: mark-up as `letters` takes it, the anchor point on the base line (mm), size of capitals.

    ``anchor`` is "start", "middle" or "end"; ``turn`` in degrees, counter-clockwise. ``of``, ``position``: the
    marks that it names, and where; see `Stroke`.
    """

    text: str
    at: complex
    size: float = 5.0
    anchor: str = "start"
    turn: float = 0.0
    inclined: bool = True
    of: tuple[int, ...] = ()
    position: int | None = None


class Wanted(NamedTuple):
    """A label that wants a place: what it says, the point it names, and where it would like to be.

    ``radius``: how far from the point the ink of the point's own symbol reaches, mm. ``toward``: a direction
    (complex) that is preferred, 0 for none. ``of``, ``position``: the marks that it names; see `Label`.
    ``line``: the vector or curve that it names, corner by corner, mm; ``others``: those that it might be taken
    to name: it stands nearer to its own, or a leader that crosses none of them leads it there.
    """

    text: str
    at: complex
    size: float
    radius: float = 1.0
    toward: complex = 0j
    of: tuple[int, ...] = ()
    position: int | None = None
    line: tuple[complex, ...] = ()
    others: tuple[tuple[complex, ...], ...] = ()


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


class Heading(NamedTuple):
    """What is told once of a row of views: title and shared scale factor ("": they differ), heights in mm."""

    title: str
    scale: str
    sizes: tuple[float, float]


class Stand(NamedTuple):
    """How a view stands among the others of a sheet.

    Views of one ``block`` stand together; ``below``: the block that stands above it. ``kind``: "lead" at the
    upper left, first of its sheet; "row" in rows with its block, "pair" no farther than 25 mm from the view
    before it, all of a ``position`` (an index) before the next; "note" behind the rows of its block, "table"
    behind all of its sheet, both on any sheet of a set; "" in its order. ``heading``: of its row.
    """

    block: str = ""
    kind: str = ""
    below: str = ""
    position: int = 0
    heading: Heading | None = None


class Drawing(NamedTuple):
    """A view: everything of one plan, table or block, that layout moves as a whole.

    ``name`` is for readers and files; ``role`` tells code what it is, ``position`` where it is drawn alone (an
    index of all that the board has; None: in none, or in several).
    ``cell`` (left, bottom, right, top) is the room it takes if that is more than its ink. ``apart``: what it
    comes apart into where no sheet holds it whole; None if it does not. ``stand``: how it stands among others,
    ``foot``: how high the caption at its lower edge is, mm: captions of a row begin on one line.
    ``rubbed``: what was drawn on the way and is rubbed out at the end: no sheet shows it. ``shows``: the views
    of the log of which it is the picture. ``wanted``: letters that have no place yet (see `labels.finished`).
    ``numbers``: of the positions that stand in it together, by index, what they are called. ``begins``: the
    slots of the marks, its axes, with which everything appears that a view adds to its steps; none: it is there
    from the beginning. ``origins``: where the views of the log that it shows have their own origin, mm; see
    `origin`.
    """

    name: str
    title: str
    strokes: tuple[Ink, ...] = ()
    labels: tuple[Label, ...] = ()
    cell: tuple[float, float, float, float] | None = None
    apart: Callable[[Within], Sequence[Drawing]] | None = None
    stand: Stand = Stand()
    foot: float = 0.0
    rubbed: tuple[Ink, ...] = ()
    shows: tuple[str, ...] = ()
    wanted: tuple[Wanted, ...] = ()
    numbers: tuple[tuple[int, str], ...] = ()
    begins: tuple[int, ...] = ()
    origins: tuple[tuple[str, complex], ...] = ()
    role: str = ""
    position: int | None = None

    def origin(self, view: str) -> complex:
        """Return where the origin of a view of the log stands (complex, mm)."""
        return dict(self.origins).get(view, 0j)

    def moved(self, by: complex) -> Drawing:
        """Return the drawing translated by ``by`` (complex, mm)."""
        dx, dy = by.real, by.imag
        strokes = tuple([shifted(stroke, by) for stroke in self.strokes])
        rubbed = tuple([shifted(stroke, by) for stroke in self.rubbed])
        labels = tuple(label._replace(at=label.at + by) for label in self.labels)
        wanted = tuple(one._replace(at=one.at + by) for one in self.wanted)
        cell = self.cell
        if cell is not None:
            cell = (cell[0] + dx, cell[1] + dy, cell[2] + dx, cell[3] + dy)
        origins = tuple((view, self.origin(view) + by) for view in self.shows)
        return self._replace(
            strokes=strokes,
            labels=labels,
            cell=cell,
            rubbed=rubbed,
            wanted=wanted,
            origins=origins,
        )


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


def shifted(stroke: Ink, by: complex) -> Ink:
    """Return a stroke translated by ``by`` (complex, mm)."""
    if isinstance(stroke, Bezier):
        return stroke._replace(controls=tuple([c + by for c in stroke.controls]))
    dx, dy = by.real, by.imag
    # made anew field by field: of the thousands on a sheet that takes half as long as `_replace`
    return Stroke(
        stroke.pen,
        tuple([(x + dx, y + dy, bulge) for x, y, bulge in stroke.path]),
        stroke.closed,
        stroke.filled,
        stroke.title,
        stroke.data,
        stroke.of,
        stroke.position,
        stroke.part,
        stroke.symbol and stroke.symbol._replace(at=stroke.symbol.at + by),
    )


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
    bulge = tangent(sweep / pieces / 4)
    path = []
    for k in range(pieces + 1):
        z = centre + polar(radius, start + sweep * k / pieces)
        path.append((z.real, z.imag, bulge if k < pieces else 0.0))
    return Stroke(pen, tuple(path))
