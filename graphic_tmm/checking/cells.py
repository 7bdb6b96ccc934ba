"""The cells of a scene's table: the figures, with their units, that readings are compared with."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple, TypeVar

from graphic_tmm.board import roles
from graphic_tmm.board.values import Complexes, Point, Reals
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import DrawnScene, single
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain
from graphic_tmm.readers.columns import Column, Readings, Tabled
from graphic_tmm.readers.table import positions_of, scene_columns, scene_results
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.units import UNITS, plain_unit

T = TypeVar("T")
Key = tuple[str, str, str]
"""Plan, segment, position ("" for a result)."""
RESULTS = "results"
"""The plan of the results of the whole project, which have no position."""


class Cell(NamedTuple):
    """One figure: mm on the sheet (None where nothing is drawn), the quantity, its unit.

    ``spot``: of a point, where it stands, mm from the pole of its plan. ``direction``: an angle that a whole
    turn more does not change.
    """

    mm: float | None
    value: float | None
    unit: str
    spot: complex | None = None
    direction: bool = False


def pointed() -> tuple[str, ...]:
    """Return the plans whose points can be compared by their coordinates."""
    return tuple(plan for one in chapters() for plan in Readings.of(one).pointed)


def position_names(made: DrawnScene) -> tuple[str, ...]:
    """Return the numbers of the positions of a scene."""
    row = tuple(name for name, _ in positions_of(made))
    return row or tuple(
        dict.fromkeys(name for column in scene_columns(made) for name, _ in column.at)
    )


def cells(made: DrawnScene) -> Mapping[Key, Cell]:
    """Return every figure that a scene has; of a scene as drawn they are found once."""
    return _kept(made, "cells", _cells)


def _kept(made: DrawnScene, name: str, find: Callable[[DrawnScene], T]) -> T:
    """Return what is found of a scene; it is kept beside its first board, while the others are the same."""
    if not made.boards:
        return find(made)
    cache, now = made.boards[0].cache, tuple(map(id, made.boards))
    if cache.get(name, ((), None))[0] != now:
        # with the boards themselves, so that no other can be at their place
        cache[name] = now, made.boards, find(made)
    found: T = cache[name][-1]
    return found


def _cells(made: DrawnScene) -> Mapping[Key, Cell]:
    found: dict[Key, Cell] = {}
    for names, column in _columns(made):
        for name, mm, value in zip(names, *column.first_figures, strict=True):
            if mm is not None or value is not None:
                found[column.plan, column.segment, name] = Cell(mm, value, column.unit)
    directions = frozenset(_directions(made))
    for name, (value, unit) in single(scene_results(made)).items():
        there = value if math.isfinite(value) else None
        found[RESULTS, name, ""] = Cell(None, there, unit, direction=name in directions)
    return found


def _directions(made: DrawnScene) -> Iterator[str]:
    """Yield the results that are directions, read off with the protractor."""
    for drawn in made.boards:
        for chapter in drawn.project.chapters:
            marks = Tabled.of(chapter).marks(drawn)
            yield from (name for name, mark in marks.items() if mark.role == roles.READ_OFF)


def turned_near(angle: Any, due: float) -> Any:
    """Return an angle, degrees, by as many whole turns more or less as bring it next to what is due."""
    return due + (angle - due + 180.0) % 360.0 - 180.0


def figures(made: DrawnScene, *, in_mm: bool) -> dict[Key, Reals]:
    """Return every figure of many drawings, mm or the quantity; each (trial,), NaN where there is none.

    Of a single trial where all drawings are alike.
    """
    found: dict[Key, Reals] = {}
    for names, column in _columns(made):
        rows = column.mm if in_mm else column.value
        found |= {(column.plan, column.segment, name): rows[:, k] for k, name in enumerate(names)}
    if not in_mm:
        found |= {(RESULTS, name, ""): row for name, (row, _) in scene_results(made).items()}
    return found


def _columns(made: DrawnScene) -> Iterator[tuple[Sequence[str], Column]]:
    names = position_names(made)
    for column in scene_columns(made):
        yield [name for name, _ in column.at] or names, column


def longest(
    found: Mapping[Key, Cell], spots: Mapping[Key, complex]
) -> dict[tuple[str, str], float]:
    """Return the longest vector of every plan and position, mm: to a point where no segment is measured."""
    most: dict[tuple[str, str], float] = {}
    for (plan, _, position), cell in found.items():
        if cell.mm is not None:
            at = (plan, position)
            most[at] = max(most.get(at, 0.0), abs(cell.mm))
    reach: dict[tuple[str, str], float] = {}
    for (plan, _, position), spot in spots.items():
        at = (plan, position)
        reach[at] = max(reach.get(at, 0.0), abs(spot))
    return reach | most


def points(made: DrawnScene) -> Mapping[Key, complex]:
    """Return where every point of a mechanism's plans stands, mm from the pole (or the crank's pivot).

    Of a scene as drawn they are found once.
    """
    return _kept(made, "points", _points)


def _points(made: DrawnScene) -> Mapping[Key, complex]:
    found = ((key, complex(row[0])) for key, row in spots(made).items())
    return {key: spot for key, spot in found if cmath.isfinite(spot)}


def spots(made: DrawnScene) -> dict[Key, Complexes]:
    """Return where points stand in many drawings, as `points`; each (trial,), NaN where it is not drawn."""
    drawn, plans = made.mechanism, pointed()
    found: dict[Key, Complexes] = {}
    for step in drawn.construction.steps if drawn is not None else ():
        plan = step.it.view
        if drawn is None or plan not in plans or step.it.kind is not Point or step.op.across:
            continue
        reading = drawn.of(plan)
        if reading is None:
            continue
        rows = reading[step.it]
        for k, place in enumerate(drawn.row(plan)):
            found[(*step.it.key, drawn.names[place])] = rows[:, k if rows.shape[1] > 1 else 0]
    return found


def taken_figure(taken: Taken, cell: Cell) -> float:
    """Return a reading in mm, or as a quantity in the unit of its figure.

    Raises
    ------
    ValueError
        If its unit is not known or measures something else.
    """
    if taken.mm is not None:
        return taken.mm
    assert taken.value is not None
    value = taken.value * _factor(taken, cell)
    return turned_near(value, cell.value) if cell.direction and cell.value is not None else value


def due_figure(cell: Cell, taken: Taken) -> float:
    """Return the figure that a reading is compared with: mm where it is given in mm."""
    due = cell.mm if taken.mm is not None else cell.value
    assert due is not None
    return due


def half_of(taken: Taken, cell: Cell) -> float:
    """Return half a unit of the last digit that was written of a reading, in the unit of its figure."""
    return taken.last.mm if taken.mm is not None else taken.last.value * _factor(taken, cell)


def _factor(taken: Taken, cell: Cell) -> float:
    if taken.unit in ("", "1", cell.unit):
        return 1.0
    own, other = UNITS.get(plain_unit(taken.unit)), UNITS.get(plain_unit(cell.unit))
    if own is None or (other is not None and own.dimension != other.dimension):
        raise ValueError(
            said(
                'the unit "{unit}" does not fit; write it in {due}',
                unit=taken.unit[:20],
                due=cell.unit or said("plain numbers"),
            )
        )
    return float(own.factor) / (float(other.factor) if other is not None else 1.0)


GREEK = {"omega": "ω", "epsilon": "ε"}
"""The letters of rates, by what code calls them."""


def segment_text(segment: str, language: str) -> str:
    """Return a segment, or a quantity by its letter as sheets of a language have it.

    >>> segment_text("P_bal_forces", "ru"), segment_text("omega2", "en"), segment_text("pb", "ru")
    ('P_ур', 'ω_2', 'pb')
    """
    name = segment.rstrip("0123456789")
    if name in GREEK and name != segment:
        return f"{GREEK[name]}_{segment.removeprefix(name)}"
    called = captions(language).get(segment, "")
    return plain(called) if "_" in called else segment
