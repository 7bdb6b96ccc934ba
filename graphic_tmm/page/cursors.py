"""Cursors on the diagrams of a mechanism: where on the sheet's own curves each angle of the crank stands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.graphs import erect, over
from graphic_tmm.board.record import Construction, Figure, Mark, Step
from graphic_tmm.board.values import Complexes, Curve, Point
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.dense import Dense
from graphic_tmm.paper.drawing import Bezier, Drawing, Sheet
from graphic_tmm.paper.write.svg import ids

ORIGIN, FEET, END = 0, 3, 4
"""The marks of axes among those of their figure."""


class Cursor(NamedTuple):
    """A curve of a view of a sheet, on which a point moves with the crank.

    ``view``: the id of the view, on the ``sheet`` of that number; ``curve``: its slot; ``spots``: the point at
    every angle, mm, where the sheet has it, NaN where there is none; ``origin``: where the graph begins there.
    ``letter``: of what it tells; ``mu``: of its ordinates, in ``unit``; ``upright``: it stands over a base.
    ``chart``: of what graph, ``behind``: so many positions behind the others it runs; ``base``: the beginning
    and the end of its base, none where it has none; ``point``: of a curve over points that move with the
    mechanism the one that runs on it, None where its place on the curve is its number in the row.
    """

    view: str
    sheet: int
    curve: int
    spots: Complexes
    origin: complex
    letter: str
    mu: float
    unit: str
    upright: bool
    reading: Mark | None
    chart: Chart
    behind: int
    base: tuple[Mark, ...]
    point: Mark | None


def cursors(dense: Dense, drawn: Drawn, sheets: Sequence[Sheet]) -> Iterator[Cursor]:
    """Yield the curves of the charts that sheets show; ``drawn``: the board as the sheets show it."""
    log, reading = drawn.construction, drawn.numbers.drawn
    charts = {chart.view: chart for chart in drawn.project.charts}
    curves = [
        s for s in log.steps if s.it.kind is Curve and s.it.view in charts and s.it in reading
    ]
    for number, sheet in enumerate(sheets):
        for name, view in zip(ids(sheet), sheet.drawings, strict=True):
            for step in curves:
                if step.it.view not in view.shows or not _inked(view, step):
                    continue
                chart, origin = charts[step.it.view], view.origin(step.it.view)
                axes = _axes(log, step)
                base = tuple(axes.marks[k] for k in (ORIGIN, END)) if axes is not None else ()
                for through, behind in _through(chart, step):
                    spots, upright = _spots(dense, log, step, reading, through, behind)
                    read = _read(log, step, chart, through)
                    yield Cursor(
                        name,
                        number,
                        step.it.slot,
                        spots + origin,
                        origin,
                        _called(chart, read),
                        float(reading[chart.mu][0, 0]),
                        chart.unit,
                        upright,
                        read,
                        chart,
                        behind,
                        base if upright else (),
                        through if _over_points(dense, log, step, through) else None,
                    )


def _through(chart: Chart, step: Step) -> Iterator[tuple[Mark, int]]:
    """Yield the points through which a curve goes, and how many positions each follow the first."""
    yield step.uses[0], 0
    for one in chart.followers:
        if one.curve == step.it:
            yield one.points, one.behind


def _inked(view: Drawing, step: Step) -> bool:
    """Whether a curve is there in the end."""
    return any(isinstance(one, Bezier) and one.of == (step.it.slot,) for one in view.strokes)


def _called(chart: Chart, read: Mark | None) -> str:
    """Return the letter of what a curve tells: y_{P} is told as P, y_k on a diagram of p as p_k."""
    if read is None or len(chart.ordinates) < 2:
        return chart.symbol
    of, _, index = read.name.partition("_")
    if of != "y":
        return read.name
    # the side of a piston is no letter of its own: y_{kB} is told as p_{kB}
    told = index.strip("{}")
    return told if index.startswith("{") and not told[0].islower() else f"{chart.symbol}_{index}"


def _read(log: Construction, step: Step, chart: Chart, through: Mark) -> Mark | None:
    """Return the reading, from the base, of the points that a curve goes through or that were marked on it."""
    points = {through}
    points |= {one.it for one in log.steps if one.uses[:1] == (step.it,) and one.it.kind is Point}
    axes = _axes(log, step)
    found = (s for s in log.steps if s.it in chart.ordinates and s.uses[1] in points)
    return next((s.it for s in found if axes is None or s.uses[0] == axes.marks[FEET]), None)


def _spots(
    dense: Dense, log: Construction, step: Step, reading: Reading, through: Mark, behind: int
) -> tuple[Complexes, bool]:
    """Return where on a curve every angle stands, mm of its view, and whether it stands over a base.

    ``through``: the points on it that run there, ``behind`` so many positions.
    """
    count = dense.drawn.project.count
    numbers = dense.numbers - behind
    curve: Curve = reading[step.it]
    axes = _axes(log, step)
    if axes is not None and not curve.closed:
        origin, end = (reading[axes.marks[k]][0, 0] for k in (ORIGIN, END))
        feet = origin + numbers / count * (end - origin)
        return np.asarray(erect.run(curve, feet[None, :])[0]), True
    if _over_points(dense, log, step, through):
        x = np.broadcast_to(dense.drawn.reading[through].real, (1, numbers.size))
        return np.asarray(x + 1j * over.run(curve, dense.numbers[None, :], x, behind=behind))[
            0
        ], False
    return _on(curve, numbers), False


def _axes(log: Construction, step: Step) -> Figure | None:
    return next((f for f in log.figures if f.kind == "axes" and f.view == step.it.view), None)


def _over_points(dense: Dense, log: Construction, step: Step, through: Mark) -> bool:
    """Whether a place on a curve is sought over a point that moves with the mechanism."""
    return through in dense.drawn.reading and _axes(log, step) is None


def _on(curve: Curve, numbers: np.ndarray) -> Complexes:
    """Return places on a curve, whose knots are the positions, by their numbers in the row."""
    knots, tangents = curve.knots[0], curve.tangents[0]
    first = np.floor(numbers).astype(int) % knots.size
    after = (first + 1) % knots.size
    u = numbers - np.floor(numbers)
    p, q, m, n = knots[first], knots[after], tangents[first], tangents[after]
    return np.asarray(
        p * (2 * u + 1) * (u - 1) ** 2
        + m * u * (u - 1) ** 2
        + q * u**2 * (3 - 2 * u)
        + n * u**2 * (u - 1)
    )


def on_paper(spots: Complexes, sheet: Sheet) -> Complexes:
    """Return places on a sheet, mm; NaN of those beside it."""
    there = (abs(spots.real - sheet.width / 2) <= sheet.width / 2) & (
        abs(spots.imag - sheet.height / 2) <= sheet.height / 2
    )
    return np.where(there, spots, complex("nan"))
