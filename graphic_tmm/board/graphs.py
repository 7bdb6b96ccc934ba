"""Graphs on a common base: ordinates laid off, chords or tangents against a pole, segments in succession.

A graph has two scales, one along the base and one of its ordinates, and its own view on the board. What stands
at the boundaries of the intervals and what stands at their middles are two kinds of things here: a chord gives
a value of the middle (`Middles`), and only a curve read at the boundaries makes `Boundaries` of it again.
"""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board import graph_reasons as why
from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import abscissa
from graphic_tmm.board.operations.graph_curves import (
    closed_graph,
    graph_of_differences,
    graph_of_rays,
    open_graph,
    open_graph_of_middles,
    taut_graph,
)
from graphic_tmm.board.operations.graphs import (
    arrival,
    at_zero,
    erect,
    following,
    halve,
    level_off,
    succession,
    touching,
)
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure_along,
    meet,
    parallel,
    ray,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point
from graphic_tmm.bounds import INTERVALS
from graphic_tmm.errors import ConstructionError


class Base(NamedTuple):
    """What graphs one below the other share: the length of the base, its scale, where the positions stand.

    ``intervals``: how many; ``x`` the abscissa of every position (Length), ``mu`` the scale along the base,
    ``zero`` the direction of the base (Angle).
    """

    intervals: int
    length: Mark
    x: Mark
    mu: Mark
    zero: Mark


class Axes(NamedTuple):
    """The axes of one graph: its view, origin, the two lines, the feet of positions, the end, the middles.

    ``after``: of each foot the one that follows it.
    """

    base: Base
    view: str
    mu: Mark
    origin: Mark
    along: Mark
    up: Mark
    feet: Mark
    end: Mark
    middles: Mark
    after: Mark


class Boundaries(NamedTuple):
    """Points of a graph at the boundaries of the intervals, and the point at the end of the base."""

    points: Mark
    end: Mark


class Middles(NamedTuple):
    """Points of a graph at the middles of the intervals."""

    points: Mark


class Pole(NamedTuple):
    """The pole of a graph: the point left of the origin, and its distance H from there (Length)."""

    point: Mark
    distance: Mark


def lay_base(draft: Draft, length: Mark, mu: Mark, count: int, numbers: object) -> Base:
    """Divide a base into ``count`` even intervals; ``numbers``: of each position, from 0 at its beginning.

    Raises
    ------
    ConstructionError
        With fewer than four intervals.
    """
    if not INTERVALS.holds(count):
        raise ConstructionError(
            f"{mu.view}: a graph needs {INTERVALS.least} intervals at least, not {count}: take more positions"
        )
    intervals = draft.take(Number, "N", float(count))
    n = draft.take(Number, "n", numbers, role=roles.STATION)
    x = draft.draw(abscissa, "x_{n}", n, length, intervals, why=why.STATION)
    return Base(count, length, x, mu, draft.direction(0.0))


def draw_axes(draft: Draft, view: str, base: Base, mu: Mark) -> Axes:
    """Draw the axes of a graph in a view of its own; ``mu``: the scale of its ordinates."""
    axes = erect_axes(draft, view, base, mu)
    draft.lay_out(None, mu)
    lines = (axes.origin, axes.along, axes.up, axes.feet, axes.end, axes.middles)
    draft.figure("axes", view, *lines, mu, base.mu, base.length)
    return axes


def erect_axes(draft: Draft, view: str, base: Base, mu: Mark) -> Axes:
    """Draw axes alone: what stands on them is laid out by another."""
    draft.open(view)
    origin = draft.take(Point, "O", 0j)
    along = draft.draw(ray, "(Ox)", origin, base.zero, why=why.BASE_AXIS)
    up = draft.draw(square, "(Oy)", origin, along, sense=1, why=why.UP_AXIS)
    feet = draft.draw(lay_off, "i", along, base.x, why=why.FOOT)
    end = draft.draw(lay_off, str(base.intervals), along, base.length, why=why.END)
    after = draft.draw(following, "i+1", feet, end, row=base.intervals)
    middles = draft.draw(halve, "m", feet, after)
    return Axes(base, view, mu, origin, along, up, feet, end, middles, after)


def lay_ordinates(draft: Draft, axes: Axes, lengths: Mark, letter: str) -> Boundaries:
    """Lay off an ordinate for every position; the graph is closed: its end stands as high as its beginning."""
    line = draft.draw(square, "(i)", axes.feet, axes.along, sense=1, why=why.ORDINATE_LINE)
    points = draft.draw(lay_off, letter, line, lengths, why=why.ORDINATE)
    return close(draft, axes, points)


def close(draft: Draft, axes: Axes, points: Mark) -> Boundaries:
    """Carry the height of the first point across to the end of the base."""
    first = draft.draw(at_zero, f"{points.letter}_0", points, free=True)
    level = draft.draw(parallel, f"({first.letter}x)", first, axes.along, sense=1, why=why.REPEATS)
    last = draft.draw(
        square, f"({axes.end.letter})", axes.end, axes.along, sense=1, why=why.REPEATS
    )
    return Boundaries(points, draft.draw(meet, f"{points.letter}_N", level, last, why=why.REPEATS))


def read(draft: Draft, axes: Axes, points: Mark, letter: str) -> Mark:
    """Measure the ordinates of points at the boundaries, with their signs."""
    return draft.draw(measure_along, letter, axes.feet, points, axes.up, why=why.ORDINATE_READ)


def through(draft: Draft, axes: Axes, points: Boundaries | Middles, *, closed: bool = True) -> Mark:
    """Draw the smooth curve through the points of a graph: of what the mechanism does."""
    row, letter = axes.base.intervals, _name(points)
    if closed:
        return draft.draw(closed_graph, letter, points.points, axes.base.length, row=row)
    if isinstance(points, Boundaries):
        return draft.draw(open_graph, letter, points.points, points.end, row=row)
    return draft.draw(open_graph_of_middles, letter, points.points, row=row)


def taut(draft: Draft, axes: Axes, points: Boundaries) -> Mark:
    """Draw the curve that stays between its points: of what is laid on the mechanism, forces and moments."""
    row, over = axes.base.intervals, axes.base.length
    return draft.draw(taut_graph, _name(points), points.points, over, row=row)


def along_rays(
    draft: Draft, axes: Axes, points: Boundaries, pole: Mark, ordinates: Boundaries, source: Axes
) -> Mark:
    """Draw the curve of an integral, by the rays from its pole to the ordinates of what was integrated."""
    marks = (*points, pole, ordinates.points, source.up)
    return draft.draw(graph_of_rays, _name(points), *marks, row=axes.base.intervals)


def difference(draft: Draft, axes: Axes, points: Boundaries, first: Mark, second: Mark) -> Mark:
    """Draw the curve through points whose ordinates are everywhere those of one curve less those of another."""
    marks = (*points, first, second)
    return draft.draw(graph_of_differences, _name(points), *marks, row=axes.base.intervals)


def _name(points: Boundaries | Middles) -> str:
    return f"({points.points.letter}–{points.points.letter})"


def on_curve(draft: Draft, axes: Axes, curve: Mark, letter: str) -> Boundaries:
    """Mark the points of a curve over the boundaries of the intervals."""
    points = draft.draw(erect, letter, curve, axes.feet)
    return Boundaries(points, draft.draw(erect, f"{letter}_N", curve, axes.end))


def set_pole(draft: Draft, axes: Axes, distance: Mark) -> Pole:
    """Mark the pole at its distance H to the left of the origin."""
    draft.open(axes.view)
    left = draft.draw(square, "(OP)", axes.origin, axes.up, sense=1, why=why.POLE_LINE)
    return Pole(draft.draw(lay_off, "P", left, distance, role=roles.POLE, why=why.POLE), distance)


def by_chords(
    draft: Draft, source: Axes, at: Boundaries, to: Axes, pole: Pole, letter: str
) -> Middles:
    """Differentiate by chords: rays from the pole parallel to them give the values of the middles."""
    draft.open(source.view)
    after = draft.draw(
        following, f"{at.points.letter}+1", at.points, at.end, row=source.base.intervals
    )
    chord = draft.draw(
        join, f"({at.points.letter},{after.letter})", at.points, after, why=why.CHORD
    )
    draft.open(to.view)
    rays = draft.draw(parallel, "(P)", pole.point, chord, sense=1, why=why.RAY)
    return Middles(_carried(draft, to, rays, to.middles, letter))


def by_tangents(
    draft: Draft, source: Axes, curve: Mark, to: Axes, pole: Pole, letter: str
) -> Boundaries:
    """Differentiate by tangents: rays from the pole parallel to them give the values of the boundaries."""
    draft.open(source.view)
    slopes = draft.draw(touching, f"(τ_{{{curve.letter.strip('()')[0]}}})", curve, source.feet)
    draft.open(to.view)
    rays = draft.draw(parallel, "(P)", pole.point, slopes, sense=1, why=why.RAY)
    return close(draft, to, _carried(draft, to, rays, to.feet, letter))


def _carried(draft: Draft, axes: Axes, rays: Mark, feet: Mark, letter: str) -> Mark:
    """Carry where rays from the pole meet the ordinate axis across to over their feet."""
    cut = draft.draw(meet, f"{letter}_y", axes.up, rays, why=why.CUT_OFF)
    level = draft.draw(parallel, f"({cut.letter})", cut, axes.along, sense=1, why=why.CARRIED)
    over = draft.draw(square, f"({feet.letter})", feet, axes.along, sense=1, why=why.CARRIED)
    return draft.draw(meet, letter, over, level, why=why.CARRIED)


def integrate(
    draft: Draft,
    source: Axes,
    curve: Mark,
    to: Axes,
    pole: Pole,
    letter: str,
    *,
    mean: str = "areas",
    at: Boundaries | None = None,
) -> Boundaries:
    """Integrate: the mean ordinate of each interval gives a ray from the pole, the rays segments in succession.

    ``mean``: that of the "areas" below the curve, the curve's ordinate at the "middles", or that of the
    "chords" between the points ``at``.
    """
    row = source.base.intervals
    draft.open(source.view)
    high = _mean_ordinates(draft, source, curve, mean, at)
    level = draft.draw(
        parallel, f"({high.letter})", high, source.along, sense=1, why=why.MEAN_LEVEL
    )
    cut = draft.draw(meet, "h_y", source.up, level, free=True, why=why.MEAN_LEVEL)
    rays = draft.draw(join, f"(P{cut.letter})", pole.point, cut, why=why.MEAN_RAY)
    draft.open(to.view)
    points = draft.draw(succession, letter, to.origin, rays, to.feet, to.end, row=row)
    return Boundaries(
        points, draft.draw(arrival, f"{letter}_N", to.origin, rays, to.feet, to.end, row=row)
    )


def _mean_ordinates(
    draft: Draft, source: Axes, curve: Mark, mean: str, at: Boundaries | None
) -> Mark:
    row = source.base.intervals
    if mean == "middles":
        return draft.draw(erect, "h", curve, source.middles, free=True)
    if mean == "areas":
        return draft.draw(level_off, "h", curve, source.feet, source.after, free=True)
    assert at is not None
    after = draft.draw(following, f"{at.points.letter}+1", *at, row=row, free=True)
    return draft.draw(halve, "h", at.points, after, free=True)
