"""How a scene's mechanism moves wherever its drive stands, in SI: recorded once, run a million times."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cache, cached_property, partial
from itertools import chain
from types import MappingProxyType
from typing import Any, get_args

import numpy as np
from numpy.typing import ArrayLike

from graphic_tmm.board import roles
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Program, Reading, execute, prepare, translator
from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Mark, again, kept
from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import Drawn, Numbers, doubted, hand_of
from graphic_tmm.errors import ConstructionError, TmmError
from graphic_tmm.fitting.scales import chosen, reach_of
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.language.said import joined, said
from graphic_tmm.mechanism.records import TURN, Sweep
from graphic_tmm.paper.formats import USUAL
from graphic_tmm.project import draws
from graphic_tmm.project import record as record_project
from graphic_tmm.readers.any_angles.ready import Ready, made_ready
from graphic_tmm.readers.any_angles.results import Motion, NotAsked
from graphic_tmm.readers.any_angles.turn import (
    PLAN_OF,
    Plan,
    Turn,
    Turning,
    TurnQuantity,
    in_row,
    open_row,
)
from graphic_tmm.scene.chapter import MECHANISM, chapters
from graphic_tmm.scene.misfits import meant
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import make

WHOLE = 360.0
"""Degrees of a turn."""
EMPTY: Mapping[Mark, Any] = MappingProxyType({})


@dataclass(frozen=True)
class Recorded:
    """A log to be run at any angles by a hand: its quantities, and the drawing at the positions of its scene.

    ``whole``: how far the crank turns over the row of positions, degrees, signed; ``row``: of one that does not
    close, how far each of its positions is from the first.
    """

    sheet: Drawn
    told: tuple[TurnQuantity, ...]
    whole: float
    row: Reals | None = None
    slices: dict[object, Ready] = field(default_factory=dict)
    readers: dict[tuple[Mark, ...], Program] = field(default_factory=dict)

    @cached_property
    def plans(self) -> frozenset[str]:
        """Of which plans there is anything."""
        return frozenset(row.plan for row in self.told)

    @property
    def sweep(self) -> Sweep:
        """What the drive goes through."""
        return self.sheet.project.sweep or TURN

    @property
    def still(self) -> dict[Mark, Any]:
        """What is given, or drawn across the positions of the sheet, and is the same at all angles."""
        return _still(self.sheet, self.known(np.zeros((1, 1))))

    def known(self, angles: Reals) -> dict[Mark, Any]:
        """Return what is given at coordinates of the drive (degrees or m; (1, angle)), and nowhere else."""
        project = self.sheet.project
        row = self.sheet.scene.row
        first = row.ends or row.places
        # as the scene says it, and not from 0 to 360°: over two turns −100° is none of 260°
        zero = row.zero if isinstance(row.zero, float) else project.coordinates[0]
        turned = angles[0] - float((first[0] if first else zero) or 0.0)
        mechanism = self.sheet.scene.mechanism
        if self.row is not None and self.sweep.turns and mechanism and not mechanism.further:
            turned = in_row(turned, self.whole)
        found: dict[Mark, Any] = {}

        def read(marks: Iterable[Mark], more: Mapping[Mark, Any] = EMPTY) -> Reading:
            return self._read(tuple(marks), {**found, **more})

        turn = Turn(turned, self.whole, project.count, read, angles, self.row)
        for chapter in project.chapters:
            found |= Turning.of(chapter).values(self.sheet, turn)
        return found

    def _read(self, marks: tuple[Mark, ...], known: Mapping[Mark, Any]) -> Reading:
        given = {**_still(self.sheet, known), **known}
        if marks not in self.readers:
            self.readers[marks] = prepare(again(self.sheet.construction, given), marks)
        return self.readers[marks].run(given, hand=self.sheet.hand)

    def ready(self, name: object, rows: Callable[[], Sequence[TurnQuantity]]) -> Ready:
        """Return the slice of the log that gives some rows, without further steps; it is cached by name."""
        if name not in self.slices:
            self.slices[name] = made_ready(self.sheet, self.still, self.known, rows())
        return self.slices[name]


def at_angles(drawn: Drawn, angles: Reals) -> Mapping[Mark, Any]:
    """Return what chapters know of a board of its own, as drawn, at angles of what drives it, degrees."""
    return Recorded(drawn, (), WHOLE).known(angles[None, :])


@cache
def _boards() -> Mapping[str, str]:
    """Return the plans of boards other than the mechanism's, each with its board."""
    return {of.plan: one.board for one in chapters() if (of := Turning.of(one)).plan}


def recorded(scene: Scene, plans: frozenset[str], *, exact: bool) -> Recorded:
    """Record the wanted plans of a scene, all of one board, once.

    Raises
    ------
    SceneError
        If the scene has no mechanism.
    StructureError
        If it cannot be drawn.
    """
    key = ("motion", plans, exact)
    if key not in scene.cache:
        scene.cache[key] = _recorded(scene, plans, exact=exact)
    found: Recorded = scene.cache[key]
    return found


def _recorded(scene: Scene, plans: frozenset[str], *, exact: bool) -> Recorded:
    board = _board_of(plans)
    if board == MECHANISM and scene.mechanism is not None:
        for chapter in chapters(MECHANISM):
            if chapter.always or plans & {place.name for place in chapter.places}:
                scene = Turning.of(chapter).free(scene)
    sheet = None if exact or board == MECHANISM else _on_its_sheet(scene, board, plans)
    sheet = sheet or _on_usual_sheet(scene, board, plans, exact=exact)
    project, log = sheet.project, sheet.construction
    told = chain.from_iterable(Turning.of(chapter).told(project) for chapter in project.chapters)
    rows = tuple(row for row in told if row.plan in plans)
    if board != MECHANISM:
        outside = dict.fromkeys(row.mark for row in rows if row.mark.slot < 0)
        log = log._replace(given=(*log.given, *outside))
        sheet = replace(sheet, project=replace(project, construction=log))
        return Recorded(sheet, rows, WHOLE)
    by = next(mark for mark in log.given if mark.role == roles.ROW)
    row = np.asarray(sheet.given[by], dtype=float)[0]
    steps = open_row(scene, row)
    if steps is not None:
        whole = math.copysign(float(steps[-1]), float(row[steps.size - 1]))
    else:
        whole = float(round(float(row[1]) * project.count)) if project.count > 1 else WHOLE
    return Recorded(sheet, rows, whole, steps)


def _on_its_sheet(scene: Scene, board: str, plans: frozenset[str]) -> Drawn | None:
    """Return a board of its own as its sheet has it; None where none of its sheets can be drawn.

    What is chosen of readings, a radius in whole millimetres, hangs on the scales to which they are read.
    """
    with suppress(TmmError):
        return next((one for one in make(scene, wanted=plans).boards if one.board == board), None)
    return None


def _on_usual_sheet(scene: Scene, board: str, plans: frozenset[str], *, exact: bool) -> Drawn:
    """Return a board to the scales of an A1 that shows the plans alone."""
    scene = replace(scene, sheets=(SheetOrder(USUAL, tuple(sorted(plans))),))
    project = record_project(scene, board, wanted=plans)
    hand = EXACT if exact else hand_of(scene)
    given = dict.fromkeys(project.construction.given, 1.0) | project.given
    if not exact or board != MECHANISM:
        # read exactly, the same comes out to any scale, and to 1 SI unit a millimetre it is in SI
        reach = reach_of(project, doubted(project))
        given |= chosen(project, usual(scene), reach)[0]
    reading = execute(project.construction, given, hand=hand)
    return Drawn(
        project,
        given,
        {},
        Numbers(reading, {}, reading),
        hand,
        Doubts((), {}),
        undrawn=(),
        sizes={},
        reach={},
    )


def _board_of(plans: Collection[str]) -> str:
    """Return the board on which plans are drawn.

    Raises
    ------
    ConstructionError
        If they are of several.
    """
    found = dict.fromkeys(_boards().get(plan, MECHANISM) for plan in plans) or {MECHANISM: None}
    if len(found) > 1:
        says = said(
            "motion: {plans} turn with shafts of their own: ask for one of them at a time, plans=[{first}]",
            plans=", ".join(sorted(plans)),
            first=f'"{min(plans)}"',
        )
        raise ConstructionError(says)
    return next(iter(found))


def _usual(scene: Scene) -> Collection[str]:
    """Return the plans of a scene where nobody says which: its mechanism's, else all that it calls for."""
    if scene.mechanism is not None:
        return PLANS
    return [plan for plan, board in _boards().items() if draws(scene, board)] or PLANS


def _still(sheet: Drawn, known: Mapping[Mark, Any]) -> dict[Mark, Any]:
    """Return what is given, or drawn across the positions of the sheet, and is not known at any angle."""
    found = kept(sheet.construction, sheet.given, sheet.numbers.drawn.values)
    return {mark: value for mark, value in found.items() if mark not in known}


PLANS: tuple[Plan, ...] = ("positions", "velocities", "accelerations")
"""What `motion` returns by default."""
ALL: tuple[str, ...] = get_args(Plan)
OF_POINTS = frozenset({"places", "velocities", "accelerations"})


def motion(
    scene: Scene,
    at: ArrayLike,
    points: Collection[str] | None = None,
    *,
    plans: str | Collection[str] | None = None,
    exact: bool = False,
    fast: bool | None = None,
    threads: int | None = None,
) -> Motion:
    """Draw plans of a scene where its drive stands and return what they say, in SI; see `face.motion`.

    Raises
    ------
    SceneError
        If the scene has no mechanism.
    StructureError
        If it cannot be drawn, or a load is not known at any angle.
    ConstructionError
        If a point or a plan is unknown, the angles are no row of numbers, or ``fast`` is wanted and not
        available.
    """
    row = _row(at)
    plans = _usual(scene) if plans is None else plans
    asked = frozenset((plans,) if isinstance(plans, str) else plans)
    there = (*ALL, *_boards())
    if not asked <= {*there}:
        says = said(
            "motion: there is no plan {name}; there are {known}",
            name=min(asked - {*there}),
            known=", ".join(there),
        )
        raise ConstructionError(says)
    of = recorded(scene, asked, exact=exact)
    if not asked <= of.plans:
        plan = min(asked - of.plans)
        raise ConstructionError(
            said("motion: the scene asks for no {plan}: write [{plan}]", plan=plan)
            if plan in _boards()
            else said(
                "motion: the scene asks for no {plan}: write [forces] with what acts, [[load]], [effects]",
                plan=plan,
            )
        )
    letters = (
        None if points is None else frozenset((points,) if isinstance(points, str) else points)
    )
    ready = of.ready(letters, lambda: _wanted(of.told, letters))
    # a product of the row with itself tells in one pass whether all of it can be turned by
    known = row if math.isfinite(row.dot(row)) else np.where(np.isinf(row), np.nan, row)
    fast = translator() if fast is None else fast
    told = ready.results(known, of.known, fast=fast, threads=threads)
    return Motion(row, of.sweep, *map(partial(_unless, asked), PLAN_OF.values(), told))


def _unless(asked: frozenset[str], plan: Plan | None, told: dict[Any, Any]) -> Mapping[Any, Any]:
    return told if plan is None or plan in asked else NotAsked(plan)


def _row(at: ArrayLike) -> Reals:
    """Return angles, or lengths, as a row of numbers."""
    try:
        row = np.asarray(at, dtype=np.float64)
    except (TypeError, ValueError) as error:
        says = said("motion: angles are numbers, degrees; lengths are numbers, m")
        raise ConstructionError(says) from error
    if row.ndim == 0:
        return row[None]
    if row.ndim != 1:
        raise ConstructionError(
            said(
                "motion: angles or lengths are a number or a row, not {shape}",
                shape=str(row.shape),
            )
        )
    return row


def _wanted(told: Sequence[TurnQuantity], asked: frozenset[str] | None) -> Sequence[TurnQuantity]:
    """Return the wanted rows; of points only the wanted ones."""
    if asked is None:
        return told
    known = dict.fromkeys(_letter(row) for row in told if row.quantity in OF_POINTS)
    if known and (unknown := sorted(asked - known.keys())):
        says = said(
            "motion: no link has a point {listed}; there are {known}",
            listed=", ".join(unknown),
            known=", ".join(known),
        )
        like = meant(unknown[0], known)
        raise ConstructionError(joined("; ", (says, like)) if like else says)
    return [row for row in told if row.quantity not in OF_POINTS or _letter(row) in asked]


def _letter(row: TurnQuantity) -> str:
    assert isinstance(row.key, tuple)
    return row.key[0]
