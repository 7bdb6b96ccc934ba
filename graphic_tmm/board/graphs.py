"""Graphs on a common base: ordinates laid off, chords or tangents against a pole; and why it is done so."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.bounds import INTERVALS
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
    standing,
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
from graphic_tmm.errors import ConstructionError
from graphic_tmm.language.said import said

BASE_AXIS = said(
    "The base of the graph stands for the turn of the crank: time, or angle, from the zero position on."
)
UP_AXIS = said("Ordinates are laid off square to the base.")
ROW_AXIS = said(
    "The base of the graph stands for the row: time, or angle, from its first position to its last."
)
FOOT = said("Each position stands over its own share of the base.")
END = said("The base ends where the turn does.")
ROW_END = said("The base ends where the row does, with its last position.")
ORDINATE_LINE = said("Over its place on the base each position has an ordinate of its own.")
ORDINATE = said("The ordinate shows, to scale, what was found for this position.")
REPEATS = said("After a whole turn everything repeats itself: the graph ends as high as it began.")
ORDINATE_READ = said(
    "The ordinate of the graph, times its scale factor, is the quantity in this position."
)
POLE_LINE = said(
    "The pole stands on the axis of the base, before its origin: rays from it slope as the graph does."
)
POLE = said(
    "Over the pole distance a ray of the slope tan α rises by H·tan α: the distance decides the scale."
)
CHORD = said(
    "The chord has the mean slope of the graph over its interval; in the middle of the interval the graph "
    "slopes nearly alike."
)
RAY = said(
    "A ray from the pole with this slope cuts off, on the axis of ordinates, a segment proportional to the "
    "slope: to the derivative."
)
CUT_OFF = said(
    "The segment from the origin to here is the derivative, to the scale that the pole distance gives."
)
CARRIED = said("What was cut off on the axis is carried across to where it belongs on the base.")
MEAN_LEVEL = said("The mean ordinate of the interval is carried across to the axis of ordinates.")
MEAN_RAY = said(
    "The ray from the pole to the mean ordinate has the slope with which the integral rises over this "
    "interval."
)
STATION = said(
    "The base is divided into as many equal parts as the row has intervals; a position outside the row "
    "stands between its neighbours as the crank pin divides their arc."
)


class Base(NamedTuple):
    """What graphs one below the other share: the length of the base, its scale, where the positions stand.

    ``intervals``: how many; ``x`` the abscissa of every position (Length), ``mu`` the scale along the base,
    ``zero`` the direction of the base (Angle). ``closed``: at its end everything is as at its beginning; else
    the last position of the row stands there.
    """

    intervals: int
    length: Mark
    x: Mark
    mu: Mark
    zero: Mark
    closed: bool = True


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


def lay_base(
    draft: Draft, length: Mark, mu: Mark, count: int, numbers: object, *, closed: bool = True
) -> Base:
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
    x = draft.draw(abscissa, "x_{n}", n, length, intervals, why=STATION)
    return Base(count, length, x, mu, draft.direction(0.0), closed)


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
    axis, ends = (BASE_AXIS, END) if base.closed else (ROW_AXIS, ROW_END)
    along = draft.draw(ray, "(Ox)", origin, base.zero, why=axis)
    up = draft.draw(square, "(Oy)", origin, along, sense=1, why=UP_AXIS)
    feet = draft.draw(lay_off, "i", along, base.x, why=FOOT)
    end = draft.draw(lay_off, str(base.intervals), along, base.length, why=ends)
    after = draft.draw(following, "i+1", feet, end, row=base.intervals)
    middles = draft.draw(halve, "m", feet, after)
    return Axes(base, view, mu, origin, along, up, feet, end, middles, after)


def lay_ordinates(draft: Draft, axes: Axes, lengths: Mark, letter: str) -> Boundaries:
    """Lay off an ordinate for every position."""
    line = draft.draw(square, "(i)", axes.feet, axes.along, sense=1, why=ORDINATE_LINE)
    points = draft.draw(lay_off, letter, line, lengths, why=ORDINATE)
    return close(draft, axes, points)


def close(draft: Draft, axes: Axes, points: Mark) -> Boundaries:
    """Carry the height of the first point across to the end of the base; of an open row the last is there."""
    if not axes.base.closed:
        at = axes.base.intervals
        return Boundaries(
            points, draft.draw(standing, f"{points.letter}_N", points, place=at, why=ROW_END)
        )
    first = draft.draw(at_zero, f"{points.letter}_0", points, free=True)
    level = draft.draw(parallel, f"({first.letter}x)", first, axes.along, sense=1, why=REPEATS)
    last = draft.draw(square, f"({axes.end.letter})", axes.end, axes.along, sense=1, why=REPEATS)
    return Boundaries(points, draft.draw(meet, f"{points.letter}_N", level, last, why=REPEATS))


def measure_ordinates(draft: Draft, axes: Axes, points: Mark, letter: str) -> Mark:
    """Measure the ordinates of points at the boundaries, with their signs."""
    return draft.draw(measure_along, letter, axes.feet, points, axes.up, why=ORDINATE_READ)


def through(draft: Draft, axes: Axes, points: Boundaries | Middles, *, closed: bool = True) -> Mark:
    """Draw the smooth curve through the points of a graph: of what the mechanism does.

    ``closed``: the curve repeats itself, if its row does.
    """
    row, letter = axes.base.intervals, _name(points)
    if closed and axes.base.closed:
        return draft.draw(closed_graph, letter, points.points, axes.base.length, row=row)
    if isinstance(points, Boundaries):
        return draft.draw(open_graph, letter, points.points, points.end, row=row)
    return draft.draw(open_graph_of_middles, letter, points.points, row=row)


def taut(draft: Draft, axes: Axes, points: Boundaries, role: str = "") -> Mark:
    """Draw the curve that stays between its points: of what is laid on the mechanism, forces and moments."""
    row, over = axes.base.intervals, axes.base.length
    return draft.draw(taut_graph, _name(points), points.points, over, row=row, role=role)


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
    left = draft.draw(square, "(OP)", axes.origin, axes.up, sense=1, why=POLE_LINE)
    return Pole(draft.draw(lay_off, "P", left, distance, role=roles.POLE, why=POLE), distance)


def by_chords(
    draft: Draft, source: Axes, at: Boundaries, to: Axes, pole: Pole, letter: str
) -> Middles:
    """Differentiate by chords: rays from the pole parallel to them give the values of the middles."""
    draft.open(source.view)
    after = draft.draw(
        following, f"{at.points.letter}+1", at.points, at.end, row=source.base.intervals
    )
    chord = draft.draw(join, f"({at.points.letter},{after.letter})", at.points, after, why=CHORD)
    draft.open(to.view)
    rays = draft.draw(parallel, "(P)", pole.point, chord, sense=1, why=RAY)
    return Middles(_carried(draft, to, rays, to.middles, letter))


def by_tangents(
    draft: Draft, source: Axes, curve: Mark, to: Axes, pole: Pole, letter: str
) -> Boundaries:
    """Differentiate by tangents: rays from the pole parallel to them give the values of the boundaries."""
    draft.open(source.view)
    slopes = draft.draw(touching, f"(τ_{{{curve.letter.strip('()')[0]}}})", curve, source.feet)
    draft.open(to.view)
    rays = draft.draw(parallel, "(P)", pole.point, slopes, sense=1, why=RAY)
    return close(draft, to, _carried(draft, to, rays, to.feet, letter))


def _carried(draft: Draft, axes: Axes, rays: Mark, feet: Mark, letter: str) -> Mark:
    """Carry where rays from the pole meet the ordinate axis across to over their feet."""
    cut = draft.draw(meet, f"{letter}_y", axes.up, rays, why=CUT_OFF)
    level = draft.draw(parallel, f"({cut.letter})", cut, axes.along, sense=1, why=CARRIED)
    over = draft.draw(square, f"({feet.letter})", feet, axes.along, sense=1, why=CARRIED)
    return draft.draw(meet, letter, over, level, why=CARRIED)


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
    draft.open(source.view)
    high = _mean_ordinates(draft, source, curve, mean, at)
    return add_up(draft, source, high, to, pole, letter)


def add_up(draft: Draft, source: Axes, high: Mark, to: Axes, pole: Pole, letter: str) -> Boundaries:
    """Integrate by mean ordinates: ``high`` are points as high as these, anywhere over their intervals."""
    row = source.base.intervals
    draft.open(source.view)
    level = draft.draw(parallel, f"({high.letter})", high, source.along, sense=1, why=MEAN_LEVEL)
    cut = draft.draw(meet, f"{high.name}_y", source.up, level, free=True, why=MEAN_LEVEL)
    rays = draft.draw(join, f"(P{cut.letter})", pole.point, cut, why=MEAN_RAY)
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
