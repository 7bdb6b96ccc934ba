"""Drawings by the hundred: honest ones, ones with a mistake planted, ones with one ray that slipped.

The tests run some hundreds, `python tests/benchmarks/hands.py` runs ten thousand.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.hand import HANDS
from graphic_tmm.board.operations.instruments import lay_off, meet
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.kinematics.plan import KINEMATICS
from graphic_tmm.checking.cells import Cell, Key, cells, cells_and_points
from graphic_tmm.checking.check import TRIALS
from graphic_tmm.checking.judging.judge import judge
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.judging.yardstick import Yardstick, yardstick
from graphic_tmm.checking.mistakes.alterations import Figures
from graphic_tmm.checking.mistakes.catalogue import CATALOGUE, EVERYWHERE, READING
from graphic_tmm.checking.mistakes.likely import Alternatives, likely
from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG, Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.studio import drawings
from support.boards import parts
from support.gallery import exact

FRESH = 1 << 20
"""A seed that no yardstick is drawn with."""
SLIP = 4.0
LONG = 40.0
"""A ray turned by so many degrees, where it is at least so many mm long."""


def readings(found: Figures, due: Figures, *, valued: bool = False) -> list[Taken]:
    """Return the readings of a drawing: mm where something is drawn, else the quantity; where points stand.

    ``valued``: the quantity of what is drawn too, as a table of results gives it.
    """
    rows = []
    for line, (key, cell) in enumerate(due.items(), start=2):
        own = found.get(key)
        if own is None:
            continue
        plan, segment, position = key
        taken = Taken(plan, position, segment, line=line)
        if cell.mm is not None and own.mm is not None and not valued:
            rows.append(taken._replace(mm=abs(own.mm)))
        elif (cell.mm is None or valued) and own.value is not None:
            rows.append(taken._replace(value=own.value, unit=cell.unit))
        elif own.spot is not None:
            rows.append(taken._replace(x=own.spot.real, y=own.spot.imag))
    return rows


@cache
def usual(
    name: str, hand: str, *, pointed: bool = False, valued: bool = False, points: str = "paper"
) -> Yardstick:
    due = cells_and_points(exact(name)) if pointed else cells(exact(name))
    rows = readings(due, due, valued=valued)
    drawing = HANDS[hand]._replace(trials=TRIALS)
    return yardstick(exact(name), rows, drawing, Limits(), points)


WRITTEN = frozenset(mistake.name for mistake in CATALOGUE if mistake.reach == READING)
"""Mistakes of single figures: made when what was read is written down."""


class Honest(NamedTuple):
    """How many readings there were, how many doubtful; how many drawings, how many with a wrong reading."""

    readings: int
    doubtful: int
    drawings: int
    broken: int


def honest(name: str, hand: str, trials: int, seed: int = FRESH) -> Honest:
    """Judge honest drawings of a scene."""
    due, by = cells(exact(name)), usual(name, hand)
    count = doubtful = broken = 0
    for drawn in drawings(exact(name), HANDS[hand]._replace(trials=trials, seed=seed)):
        judged = judge(exact(name), readings(cells(drawn), due), by)
        count += len(judged)
        doubtful += sum(one.verdict == DOUBTFUL for one in judged)
        broken += any(one.verdict == WRONG for one in judged)
    return Honest(count, doubtful, trials, broken)


class Planted(NamedTuple):
    """Drawings in which a mistake moved a reading beyond the limit; in how many it was named first, or any."""

    seen: int = 0
    first: int = 0
    some: int = 0

    def __add__(self, other: Planted) -> Planted:  # type: ignore[override]
        return Planted(*(a + b for a, b in zip(self, other, strict=True)))


def planted(name: str, trials: int, seed: int = FRESH, only: str = "") -> Mapping[str, Planted]:
    """Plant every mistake there is, or one, in honest student drawings; return by mistake what was named."""
    due = cells_and_points(exact(name))
    hand = HANDS["student"]._replace(trials=trials, seed=seed)
    slipped = [cells_and_points(drawn) for drawn in drawings(exact(name), hand)]
    found: dict[str, Planted] = defaultdict(Planted)
    others = Alternatives(exact(name))
    for label, called, figures in plants(name):
        if only and called != only:
            continue
        valued = all(cell.mm == due[key].mm for key, cell in figures.items() if key in due)
        by = usual(name, "student", pointed=True, valued=valued)
        for drawn in slipped:
            rows = readings(_noisy(figures, drawn, due, called in WRITTEN), due, valued=valued)
            judged = judge(exact(name), rows, by)
            if not any(one.verdict == WRONG for one in judged):
                continue
            told = likely(others, judged, by.spread, "en")
            named = bool(told) and called in (told[0].name, *told[0].like)
            found[label] += Planted(1, named, bool(told))
    return found


def plants(name: str) -> Iterator[tuple[str, str, Figures]]:
    """Yield mistakes as planted: what is planted, how it should be named, the figures it leads to.

    Each of the catalogue in the whole drawing; those that may befall one position or one reading, there only;
    a segment measured for another; a pole distance taken for another.
    """
    due = cells_and_points(exact(name))
    for mistake in CATALOGUE:
        for figures in mistake.figures(exact(name)):
            yield mistake.name, mistake.name, figures
            only = _only(mistake.reach, due, figures)
            if only:
                yield f"{mistake.name}, one {mistake.reach}", mistake.name, due | only
    yield from _other_segment(due)
    poled = {key: _times(cell, key) for key, cell in due.items() if key[0] == "diagrams"}
    if poled:
        yield "pole distance", "wrong scale or pole distance", due | poled


def _only(reach: str, due: Figures, figures: Figures) -> dict[Key, Cell]:
    """Return the figures of the middle one of the positions, or of the readings, that a mistake changes."""
    changed = [key for key, cell in figures.items() if cell != due.get(key)]
    if reach == EVERYWHERE or not changed:
        return {}
    if reach == READING:
        key = changed[len(changed) // 2]
        return {key: figures[key]}
    places = list(dict.fromkeys(key[2] for key in changed))
    place = places[len(places) // 2]
    return {key: figures[key] for key in changed if key[2] == place}


def _other_segment(due: Figures) -> Iterator[tuple[str, str, Figures]]:
    """In every plan the segment after it is measured for one segment, at the middle position."""
    for plan in ("velocities", "accelerations"):
        drawn = [key for key, cell in due.items() if key[0] == plan and cell.mm is not None]
        places = list(dict.fromkeys(key[2] for key in drawn))
        at = [key for key in drawn if places and key[2] == places[len(places) // 2]]
        if len(at) > 1:
            swapped = {at[0]: due[at[-1]]}
            yield "another segment", "another segment", due | swapped


def _times(cell: Cell, key: Key) -> Cell:
    """V is 1.6 times too large, a 1.6 times as often as V: H was taken for another."""
    factor = {"V": 1.6, "a": 1.6}.get(key[1], 1.0)
    mm, value = (None if x is None else x * factor for x in (cell.mm, cell.value))
    return cell._replace(mm=mm, value=value)


def _noisy(figures: Figures, drawn: Figures, due: Figures, written: bool) -> dict[Key, Cell]:
    """What a hand reads whose figures are those of a mistake: with its own deviations from what is due.

    ``written``: what was read is written down wrongly, and its deviation with it.
    """

    def plus(a: Any, b: Any, c: Any) -> Any:
        if a is None or b is None or c is None:
            return None
        return a + (b - c) * (abs(a / c) if written and c else 1.0)

    found = {}
    for key, cell in due.items():
        own, slipped = figures.get(key), drawn.get(key)
        if own is not None and slipped is not None:
            parts = zip(
                (own.mm, own.value, own.spot),
                (slipped.mm, slipped.value, slipped.spot),
                (cell.mm, cell.value, cell.spot),
                strict=True,
            )
            mm, value, spot = (plus(*part) for part in parts)
            found[key] = Cell(mm, value, cell.unit, spot)
    return found


class Blamed(NamedTuple):
    """Drawings with one ray turned; in how many that very ray was blamed, in how many anything was."""

    drawings: int
    ray: int
    some: int


def blamed(name: str, trials: int, seed: int = FRESH) -> Blamed:
    """Turn every ray of the plans of velocities and accelerations in honest student drawings.

    Their points are read as they stand, as by a cursor on a screen.
    """
    total = ray = some = 0
    by = usual(name, "student", pointed=True, points="screen")
    for step in _rays(exact(name)):
        for drawn in drawings(
            _turned(exact(name), step),
            HANDS["student"]._replace(trials=trials, seed=seed),
        ):
            figures = cells_and_points(drawn)
            rows = [taken for taken in readings(figures, figures) if taken.pointed]
            for position in _long(drawn, step):
                at = [taken for taken in rows if taken.position == position]
                judged = [one for one in judge(exact(name), at, by) if one.verdict != FINE]
                total += 1
                some += bool(judged)
                ray += any(one.step.split(" ", 1)[-1] == step.it.letter for one in judged)
    return Blamed(total, ray, some)


def _rays(scene: DrawnScene) -> Iterator[Step]:
    if scene.mechanism is None:
        return
    for step in scene.mechanism.project.construction.steps:
        if step.it.view in ("velocities", "accelerations") and step.op.name in (
            "parallel",
            "square",
        ):
            yield step


def _turned(scene: DrawnScene, step: Step) -> DrawnScene:
    """Return the scene whose log turns one ray by the slip."""
    assert scene.mechanism is not None
    project, right = scene.mechanism.project, step.op.run

    def run(*values: Any, **choice: Any) -> Line:
        line = right(*values, **choice)
        return Line(line.at, line.along * np.exp(1j * np.radians(SLIP)))

    wrong = step._replace(op=step.op._replace(run=run))
    log = project.construction
    log = log._replace(steps=tuple(wrong if one is step else one for one in log.steps))
    board = replace(scene.mechanism, project=replace(project, construction=log))
    return scene._replace(boards=(board, *parts(scene)))


def _long(drawn: DrawnScene, step: Step) -> Iterable[str]:
    """Yield the positions where a point marked on a ray is far from where the ray begins."""
    assert drawn.mechanism is not None
    work = drawn.mechanism
    project = work.project
    accelerated = step.it.view == "accelerations"
    reading = work.of("accelerations") if accelerated else work.reading
    places = KINEMATICS.on(project).accelerated if accelerated else tuple(range(len(project.names)))
    ends = [
        one.it
        for one in project.construction.steps
        if step.it in one.uses and one.op in (meet, lay_off)
    ]
    if reading is None:
        return
    for k, place in enumerate(places):
        line = reading[step.it]
        for mark in ends:
            spot, start = (np.ravel(z)[k if z.size > 1 else 0] for z in (reading[mark], line.at))
            if abs(spot - start) >= LONG:
                yield project.names[place]
                break
