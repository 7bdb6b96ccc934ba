"""What mistakes do: changes of the log, of what was given, or of the figures, each a few lines.

Each takes a scene as drawn and yields, variant by variant, what its figures would then be.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Line, Side
from graphic_tmm.checking.cells import Cell, Key, cells_and_points, pointed, position_names
from graphic_tmm.drawn import DrawnScene

Figures = Mapping[Key, Cell]


def altered(
    made: DrawnScene, change: Callable[[Step], Step], given: Mapping[Mark, object]
) -> Figures | None:
    """Return the figures of a mechanism whose log has been changed step by step; None if nothing changes."""
    if made.mechanism is None:
        return None
    drawn, log = made.mechanism, made.mechanism.construction
    steps = tuple(change(step) for step in log.steps)
    if steps == log.steps and not given:
        return None
    project = replace(drawn.project, construction=log._replace(steps=steps))
    other = replace(drawn, project=project, given={**drawn.given, **given})
    rest = (one for one in made.boards if one is not drawn)
    return cells_and_points(made._replace(boards=(other.drawn_by(EXACT), *rest)))


def running(name: str, run: Callable[..., Any]) -> Callable[[DrawnScene], Iterator[Figures]]:
    """Return the mistake of calculating one operation by another formula: run(right result, *values)."""

    def change(step: Step) -> Step:
        if step.op.name != name:
            return step
        right = step.op.run
        return step._replace(op=step.op._replace(run=lambda *v, **c: run(right(*v, **c), *v)))

    def figures(made: DrawnScene) -> Iterator[Figures]:
        found = altered(made, change, {})
        if found is not None:
            yield found

    return figures


def wrong_end(made: DrawnScene) -> Iterator[Figures]:
    """A normal component points from its centre."""

    def change(step: Step) -> Step:
        if step.it.role == roles.NORMAL:
            return step._replace(choice={"sense": -step.choice["sense"]})
        return step

    found = altered(made, change, {})
    if found is not None:
        yield found


def wrong_link(made: DrawnScene) -> Iterator[Figures]:
    """Another link's length divides a normal component: of any that has one, or of the crank."""
    if made.mechanism is None:
        return
    log, plans = made.mechanism.construction, pointed()
    steps = log.steps
    places = {view.name for view in log.views if view.name in plans and view.pole is None}
    rays = {step.it for step in steps if step.op.name == "ray"}
    cranks = [
        step.uses[1]
        for step in steps
        if step.op.name == "lay_off" and step.uses[0] in rays and step.it.view in places
    ]
    normals = [step for step in steps if step.op.name == "normal"]
    lengths = list(dict.fromkeys([*(step.uses[2] for step in normals), *cranks]))
    for step in normals:
        for other in lengths:
            if other == step.uses[2]:
                continue

            def change(one: Step, step: Step = step, other: Mark = other) -> Step:
                if one.it != step.it:
                    return one
                return one._replace(uses=(*one.uses[:2], other, *one.uses[3:]))

            found = altered(made, change, {})
            if found is not None:
                yield found


def not_reversed(made: DrawnScene) -> Iterator[Figures]:
    """Inertia forces point along the accelerations."""

    def change(step: Step) -> Step:
        if step.it.role == roles.INERTIA and step.it.kind is Line:
            return step._replace(uses=(step.uses[0], step.uses[2], step.uses[1]))
        return step

    found = altered(made, change, {})
    if found is not None:
        yield found


def other_assembly(made: DrawnScene) -> Iterator[Figures]:
    """One dyad is assembled the other way."""
    if made.mechanism is None:
        return
    for mark, value in made.mechanism.given.items():
        if mark.kind is Side:
            flipped = -np.asarray(value, dtype=np.float64)
            found = altered(made, lambda step: step, {mark: flipped})
            if found is not None:
                yield found


def speed_by(factor: float) -> Callable[[DrawnScene], Iterator[Figures]]:
    """Return the mistake of a crank that many times as fast."""

    def figures(made: DrawnScene) -> Iterator[Figures]:
        if made.mechanism is None:
            return
        project = made.mechanism.project
        speeds = {mark for one in project.chapters for mark in one.speeds(project)}
        given = {
            mark: np.asarray(value) * factor
            for mark, value in made.mechanism.given.items()
            if mark in speeds
        }
        if not given:
            return
        found = altered(made, lambda step: step, given)
        if found is not None:
            yield found

    return figures


def cellwise(change: Callable[[Key, Cell], Cell]) -> Callable[[DrawnScene], Iterator[Figures]]:
    """Return the mistake of changing figures one by one."""

    def figures(made: DrawnScene) -> Iterator[Figures]:
        yield {key: change(key, cell) for key, cell in cells_and_points(made).items()}

    return figures


def _by(factor: float, *, mm: bool = True) -> Callable[[Key, Cell], Cell]:
    def change(key: Key, cell: Cell) -> Cell:
        length = cell.mm * factor if mm and cell.mm is not None else cell.mm
        value = None if cell.value is None else cell.value * factor
        return cell._replace(mm=length, value=value)

    return change


def decimal(made: DrawnScene) -> Iterator[Figures]:
    """The decimal point stands one or two places off."""
    for factor in (10.0, 0.1, 100.0, 0.01):
        yield {key: _by(factor)(key, cell) for key, cell in cells_and_points(made).items()}


def opposite(made: DrawnScene) -> Iterator[Figures]:
    """Figures and points on the other side; then the angular acceleration that was given."""
    yield {key: _opposite(cell) for key, cell in cells_and_points(made).items()}
    if made.mechanism is None:
        return
    given = made.mechanism.given
    turned = {mark: -np.asarray(given[mark]) for mark in given if mark.unit == "1/s²"}
    if turned:
        found = altered(made, lambda step: step, turned)
        if found is not None:
            yield found


def _opposite(cell: Cell) -> Cell:
    mm, value, spot = (None if x is None else -x for x in (cell.mm, cell.value, cell.spot))
    return Cell(mm, value, cell.unit, spot)  # type: ignore[arg-type]


def turned(made: DrawnScene) -> Iterator[Figures]:
    """The plan of velocities is drawn a quarter to either side."""
    views = made.mechanism.construction.views if made.mechanism is not None else ()
    speeds = {v.name for v in views if v.pole is not None and v.pole.role == roles.VELOCITY}
    found = cells_and_points(made)
    for quarter in (1j, -1j):
        yield {
            key: cell._replace(spot=cell.spot * quarter)
            if cell.spot is not None and key[0] in speeds
            else cell
            for key, cell in found.items()
        }


def inverted(key: Key, cell: Cell) -> Cell:
    """The length is divided by μ."""
    if not cell.mm or cell.value is None or cell.value == 0.0:
        return cell
    return cell._replace(value=cell.mm * cell.mm / cell.value)


def degrees(key: Key, cell: Cell) -> Cell:
    """Radians are degrees and the other way round."""
    if cell.value is None or cell.unit not in ("1/s", "1/s²", "rad", "°"):
        return cell
    factor = math.pi / 180.0 if cell.unit == "°" else 180.0 / math.pi
    return cell._replace(value=cell.value * factor)


def of_another_plan(made: DrawnScene) -> Iterator[Figures]:
    """Each plan's mm times the scale factor of another."""
    if made.mechanism is None:
        return
    found, factors = cells_and_points(made), [s.value for s in made.mechanism.scales.values()]
    for mu in dict.fromkeys(factors):
        yield {
            key: cell if cell.mm is None else cell._replace(value=cell.mm * mu)
            for key, cell in found.items()
        }


def backwards(place: int, count: int) -> int:
    """Return which position has a number if they are numbered backwards."""
    return -place % count


def further(shift: int) -> Callable[[int, int], int]:
    """Return which position has a number if they are numbered from another one on."""
    return lambda place, count: (place + shift) % count


def half_way(made: DrawnScene) -> Iterator[Figures]:
    """The crank's angles are counted from half a turn further on."""
    if made.mechanism is None:
        return
    given = made.mechanism.given
    counted = [mark for mark in given if mark.role == roles.CRANK_ANGLE]
    found = altered(
        made, lambda step: step, {mark: np.asarray(given[mark]) + 180.0 for mark in counted}
    )
    if found is not None:
        yield found


def numbered(to: Callable[[int, int], int]) -> Callable[[DrawnScene], Iterator[Figures]]:
    """Return the mistake of numbering the positions otherwise."""

    def figures(made: DrawnScene) -> Iterator[Figures]:
        found, names = cells_and_points(made), position_names(made)
        count = made.mechanism.project.count if made.mechanism is not None else len(names)
        order = list(range(count))
        moved = [to(k, count) for k in order]
        other = {names[k]: names[moved[k]] for k in order}
        yield {
            (plan, segment, at): found.get((plan, segment, other.get(at, at)), cell)
            for (plan, segment, at), cell in found.items()
        }

    return figures


def at_the_end(made: DrawnScene) -> Iterator[Figures]:
    """A chord's value stands at an end of its interval instead of its middle."""
    if made.mechanism is None:
        return
    views = {chart.view for chart in made.mechanism.project.charts}
    steps = made.mechanism.construction.steps
    halved = {s.it: s.uses for s in steps if s.op.name == "halve" and s.it.view in views}
    for end in (1, 0):

        def change(step: Step, end: int = end) -> Step:
            if step.op.name != "square" or step.uses[0] not in halved:
                return step
            return step._replace(uses=(halved[step.uses[0]][end], *step.uses[1:]))

        found = altered(made, change, {})
        if found is not None:
            yield found
