"""The catalogue of mistakes: each a change of the log, of what was given, or of the figures, in a few lines.

To add one, write a function from a scene as drawn to what its figures would then be, and enter it with a name
and a sentence in both languages.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Side
from graphic_tmm.checking.cells import Cell, Key, cells, position_names
from graphic_tmm.studio import Made

Figures = Mapping[Key, Cell]


class Mistake(NamedTuple):
    """A mistake: its name, what it says in English and Russian, what figures it leads to, by variant."""

    name: str
    en: str
    ru: str
    figures: Callable[[Made], Iterator[Figures]]


def altered(
    made: Made, change: Callable[[Step], Step], given: Mapping[Mark, object]
) -> Figures | None:
    """Return the figures of a mechanism whose log has been changed step by step; None if nothing changes."""
    if made.work is None:
        return None
    project = made.work.project
    steps = tuple(change(step) for step in project.construction.steps)
    if steps == project.construction.steps and not given:
        return None
    log = project.construction._replace(steps=steps)
    work = replace(
        made.work,
        project=replace(project, construction=log),
        given={**made.work.given, **given},
    )
    return cells(made._replace(work=work.drawn_by(EXACT)))


def _running(name: str, run: Callable[..., Any]) -> Callable[[Made], Iterator[Figures]]:
    """Return the mistake of calculating one operation by another formula: run(right result, *values)."""

    def change(step: Step) -> Step:
        if step.op.name != name:
            return step
        right = step.op.run
        return step._replace(op=step.op._replace(run=lambda *v, **c: run(right(*v, **c), *v)))

    def figures(made: Made) -> Iterator[Figures]:
        found = altered(made, change, {})
        if found is not None:
            yield found

    return figures


def _wrong_end(made: Made) -> Iterator[Figures]:
    def change(step: Step) -> Step:
        if step.op.name == "parallel" and step.it.letter.startswith("(n_"):
            return step._replace(choice={"sense": -step.choice["sense"]})
        return step

    found = altered(made, change, {})
    if found is not None:
        yield found


def _wrong_link(made: Made) -> Iterator[Figures]:
    """Another link's length divides a normal component."""
    if made.work is None:
        return
    normals = [s for s in made.work.project.construction.steps if s.op.name == "normal"]
    lengths = list(dict.fromkeys(step.uses[2] for step in normals))
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


def _not_reversed(made: Made) -> Iterator[Figures]:
    def change(step: Step) -> Step:
        if step.op.name == "action" and step.it.letter.startswith("(P_{i"):
            return step._replace(uses=(step.uses[0], step.uses[2], step.uses[1]))
        return step

    found = altered(made, change, {})
    if found is not None:
        yield found


def _other_assembly(made: Made) -> Iterator[Figures]:
    if made.work is None:
        return
    for mark, value in made.work.given.items():
        if mark.kind is Side:
            flipped = -np.asarray(value, dtype=np.float64)
            found = altered(made, lambda step: step, {mark: flipped})
            if found is not None:
                yield found


def _speed_by(factor: float) -> Callable[[Made], Iterator[Figures]]:
    def figures(made: Made) -> Iterator[Figures]:
        if made.work is None or made.work.project.velocities is None:
            return
        speed = made.work.project.velocities.speed
        rates = made.work.project.velocities.rates.values()
        given = {
            mark: np.asarray(made.work.given[mark]) * factor
            for mark in {speed, *rates}
            if mark is not None and mark in made.work.given
        }
        found = altered(made, lambda step: step, given)
        if found is not None:
            yield found

    return figures


def _cellwise(change: Callable[[Key, Cell], Cell]) -> Callable[[Made], Iterator[Figures]]:
    def figures(made: Made) -> Iterator[Figures]:
        yield {key: change(key, cell) for key, cell in cells(made).items()}

    return figures


def _by(factor: float, *, mm: bool = True) -> Callable[[Key, Cell], Cell]:
    def change(key: Key, cell: Cell) -> Cell:
        length = cell.mm * factor if mm and cell.mm is not None else cell.mm
        return Cell(length, None if cell.value is None else cell.value * factor, cell.unit)

    return change


def _decimal(made: Made) -> Iterator[Figures]:
    for factor in (10.0, 0.1, 100.0, 0.01):
        yield {key: _by(factor)(key, cell) for key, cell in cells(made).items()}


def _inverted(key: Key, cell: Cell) -> Cell:
    if not cell.mm or cell.value is None or cell.value == 0.0:
        return cell
    return cell._replace(value=cell.mm * cell.mm / cell.value)


def _degrees(key: Key, cell: Cell) -> Cell:
    if cell.value is None or cell.unit not in ("1/s", "1/s²", "rad", "°"):
        return cell
    factor = math.pi / 180.0 if cell.unit == "°" else 180.0 / math.pi
    return cell._replace(value=cell.value * factor)


def _of_another_plan(made: Made) -> Iterator[Figures]:
    """Each plan's mm times the scale factor of another."""
    if made.work is None:
        return
    found, factors = cells(made), [s.value for s in made.work.scales.values()]
    for mu in dict.fromkeys(factors):
        yield {
            key: cell if cell.mm is None else cell._replace(value=cell.mm * mu)
            for key, cell in found.items()
        }


def _numbered(shift: int | None) -> Callable[[Made], Iterator[Figures]]:
    """Return the mistake of numbering the positions backwards (None), or from another one on."""

    def figures(made: Made) -> Iterator[Figures]:
        found, names = cells(made), position_names(made)
        count = made.work.project.count if made.work is not None else len(names)
        order = list(range(count))
        moved = [(-k) % count if shift is None else (k + shift) % count for k in order]
        other = {names[k]: names[moved[k]] for k in order}
        yield {
            (plan, segment, at): found.get((plan, segment, other.get(at, at)), cell)
            for (plan, segment, at), cell in found.items()
        }

    return figures


def _at_the_end(made: Made) -> Iterator[Figures]:
    """A chord's value stands at an end of its interval instead of its middle."""
    found, names = cells(made), position_names(made)
    if made.work is None or made.work.project.kinematic is None:
        return
    row = names[: made.work.project.count]
    for step in (1, -1):
        moved: dict[Key, Cell] = dict(found)
        for k, name in enumerate(row):
            other = row[(k + step) % len(row)]
            for symbol in ("V", "a"):
                key, next_ = ("diagrams", symbol, name), ("diagrams", symbol, other)
                if key in found and next_ in found:
                    moved[key] = _mean(found[key], found[next_])
        yield moved


def _mean(one: Cell, other: Cell) -> Cell:
    def middle(a: float | None, b: float | None) -> float | None:
        return None if a is None or b is None else (a + b) / 2.0

    return Cell(middle(one.mm, other.mm), middle(one.value, other.value), one.unit)


CATALOGUE = (
    Mistake(
        "Coriolis left out",
        "the Coriolis acceleration is left out",
        "не учтено ускорение Кориолиса",
        _running("coriolis", lambda right, *v: 0.0 * right),
    ),
    Mistake(
        "Coriolis turned",
        "the Coriolis acceleration points the wrong way",
        "ускорение Кориолиса направлено в обратную сторону",
        _running("coriolis", lambda right, *v: -right),
    ),
    Mistake(
        "normal of the wrong link",
        "a normal component is divided by the length of another link",
        "нормальная составляющая разделена на длину другого звена",
        _wrong_link,
    ),
    Mistake(
        "normal from the wrong end",
        "a normal component points away from the centre of rotation",
        "нормальная составляющая направлена от центра вращения",
        _wrong_end,
    ),
    Mistake(
        "ω/r for ω·r",
        "ω/l is calculated for ω·l",
        "вместо ω·l вычислено ω/l",
        _running("product", lambda right, omega, length: omega / length),
    ),
    Mistake(
        "v/l inverted",
        "an angular velocity is calculated as l/v",
        "угловая скорость вычислена как l/v",
        _running("rate", lambda right, *v: 1.0 / np.where(right == 0.0, np.nan, right)),
    ),
    Mistake(
        "degrees for radians",
        "degrees are written for radians",
        "вместо радиан записаны градусы",
        _cellwise(_degrees),
    ),
    Mistake(
        "rpm for rad/s",
        "revolutions a minute are taken for rad/s",
        "обороты в минуту приняты за рад/с",
        _speed_by(30.0 / math.pi),
    ),
    Mistake(
        "μ inverted",
        "a length is divided by μ instead of multiplied",
        "длина разделена на μ, а не умножена",
        _cellwise(_inverted),
    ),
    Mistake(
        "μ of another plan",
        "a length is multiplied by the scale factor of another plan",
        "длина умножена на масштабный коэффициент другого плана",
        _of_another_plan,
    ),
    Mistake(
        "decimal point slipped",
        "a decimal point has slipped",
        "сдвинута десятичная запятая",
        _decimal,
    ),
    Mistake(
        "numbering reversed",
        "the positions are numbered backwards",
        "положения пронумерованы в обратную сторону",
        _numbered(None),
    ),
    Mistake(
        "numbering shifted",
        "the positions are numbered one further",
        "нумерация положений сдвинута на одно вперёд",
        _numbered(1),
    ),
    Mistake(
        "numbering shifted back",
        "the positions are numbered one too few",
        "нумерация положений сдвинута на одно назад",
        _numbered(-1),
    ),
    Mistake(
        "other assembly",
        "a group is assembled the other way",
        "группа собрана иначе",
        _other_assembly,
    ),
    Mistake(
        "inertia not reversed",
        "an inertia force points along the acceleration",
        "сила инерции направлена по ускорению",
        _not_reversed,
    ),
    Mistake(
        "chord's value at the end",
        "the value of a chord stands at the end of its interval",
        "значение хорды отложено на конце интервала",
        _at_the_end,
    ),
)
"""All mistakes that change figures by themselves; those of single readings are in `mistakes`."""
