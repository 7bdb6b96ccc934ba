"""Drawings by the hundred: honest ones, ones with one ray that slipped.

The tests run some hundreds, `python tests/benchmarks/hands.py` runs ten thousand.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.hand import HANDS
from graphic_tmm.board.operations.instruments import lay_off, meet
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.checking.cells import Cell, Key, cells, points
from graphic_tmm.checking.check import TRIALS, Checker
from graphic_tmm.checking.judging.judge import judge
from graphic_tmm.checking.judging.residuals import sharpened
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.judging.yardstick import Yardstick, Yardsticks
from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG, Report, Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import drawings
from support.boards import parts
from support.gallery import exact

Figures = Mapping[Key, Cell]
FRESH = 1 << 20
"""A seed that no yardstick is drawn with."""
SLIP = 4.0
LONG = 40.0
"""A ray turned by so many degrees, where it is at least so many mm long."""


def checks(
    scene: Scene, files: Iterable[tuple[str, Sequence[Taken]]], **by: Any
) -> Iterator[Report]:
    """Yield the reports on the readings of many drawings, each with its source, by one checker."""
    checker = Checker(scene, **by)
    return (checker.of(rows, source).report for source, rows in files)


def cells_and_points(made: DrawnScene) -> dict[Key, Cell]:
    """Return every figure that a scene has, and every point of its plans."""
    spots = {key: Cell(None, None, "mm", spot) for key, spot in points(made).items()}
    return {**spots, **cells(made)}


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
    return Yardsticks(exact(name), drawing, Limits(), points).of(rows)


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
        judged, _ = sharpened(exact(name), judge(exact(name), readings(cells(drawn), due), by), by)
        count += len(judged)
        doubtful += sum(one.verdict == DOUBTFUL for one in judged)
        broken += any(one.verdict == WRONG for one in judged)
    return Honest(count, doubtful, trials, broken)


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
    places = (
        KINEMATICS_PLAN.on(project).accelerated if accelerated else tuple(range(len(project.names)))
    )
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
