"""A mechanism at every degree of its crank: the same log, executed by the exact hand at so many angles more.

Chapters tell what their givens are there (`Turning.between`). What is drawn across positions, a curve, an
extreme, is the sheet's own and is not drawn again. What follows from something else that belongs to the
positions of the sheet alone (a chord between two of them) is left out.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.findings import examine, step_number
from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Construction, Mark, again, kept
from graphic_tmm.board.values import Angle, Reals
from graphic_tmm.drawn import Drawn, Findings, Numbers
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Turn, Turning, open_row
from graphic_tmm.readers.findings import reason

WHOLE = 360.0
"""Degrees of a turn; so many angles are drawn of it."""
ON_GRID = 1e-6
"""A position that is off a whole degree by more than this has an angle of its own."""


@dataclass(frozen=True)
class Dense:
    """A mechanism at every degree of its crank.

    ``drawn``: as drawn there, by the exact hand; its positions are the angles. ``sheet``: the same at the
    positions of the sheet. ``turned``: how far the crank has turned at each angle, degrees, all whole degrees
    of the row's turns in order, behind them what positions are not among them; ``angles``: its direction.
    ``whole``: how many these are; ``at``: the index of each position of the sheet. ``why``: by index the reason
    why an angle is not drawn. ``log``: what is executed there, ``given``: from what.
    """

    drawn: Drawn
    sheet: Drawn
    turned: Reals
    angles: Reals
    whole: int
    at: tuple[int, ...]
    why: Mapping[int, str]
    log: Construction
    given: Mapping[Mark, Any]


def dense(drawn: Drawn) -> Dense | None:
    """Return a mechanism at every degree; None of a board whose positions are no angles of a crank."""
    log = drawn.construction
    sheet = drawn if _exact(drawn) else drawn.drawn_by(EXACT)
    by = next((mark for mark in log.given if mark.role == roles.ROW), None)
    if by is None or by.kind is not Angle:
        return None
    turned, span, whole, at = _turned(drawn, by)
    numbers = np.abs(turned) * drawn.project.count / whole
    known = kept(sheet.construction, sheet.given, sheet.numbers.drawn.values)
    known |= {mark: numbers[None, :] for mark in log.given if mark.role == roles.STATION}

    def read(marks: Iterable[Mark]) -> Reading:
        return execute(again(log, known), known, marks)

    steps = open_row(drawn.scene, np.asarray(drawn.given[by], dtype=float)[0])
    turn = Turn(turned, span, drawn.project.count, read, row=steps)
    for chapter in drawn.project.chapters:
        known |= Turning.of(chapter).between(sheet, turn)
    following = again(log, known)
    reading = execute(following, known)
    angles = np.array(drawn.project.coordinates[0] or 0.0) + turned
    names = tuple(f"{angle % WHOLE:g}°" for angle in angles)
    everywhere = tuple(range(turned.size))
    rows = {plan: everywhere if some else () for plan, some in drawn.project.rows.items()}
    project = replace(
        drawn.project, names=names, coordinates=tuple(float(a) for a in angles % WHOLE), rows=rows
    )
    bad, why = _undrawn(project, following, reading, known)
    own = {plan: reading for plan, some in rows.items() if some}
    numbers_there = Numbers(reading, own, reading)
    scales = {view: scale._replace(own=()) for view, scale in drawn.scales.items()}
    there = replace(
        sheet, project=project, numbers=numbers_there, hand=EXACT, undrawn=bad, scales=scales
    )
    there.cache.update(sheet.cache)
    return Dense(there, sheet, turned, angles, whole, at, why, following, known)


def _exact(drawn: Drawn) -> bool:
    hand = drawn.hand
    return hand.ruler is None and not hand.slips and hand.digits is None


def _turned(drawn: Drawn, by: Mark) -> tuple[Reals, float, int, tuple[int, ...]]:
    """Return how far the crank has turned at every angle, how far over the row; see `Dense` for the others."""
    count = drawn.project.count
    row = np.asarray(drawn.given[by], dtype=float)[0]
    assert drawn.scene.mechanism is not None
    sense = drawn.scene.mechanism.drive.sense
    degrees = round(abs(float(row[1])) * count) if count > 1 else round(WHOLE)
    turned = list(sense * np.arange(degrees, dtype=float))
    zero = float(drawn.project.coordinates[0] or 0.0)
    at = []
    for k, angle in enumerate(drawn.project.coordinates):
        own = abs(row[k]) if k < count else (sense * (float(angle or 0.0) - zero)) % WHOLE
        near = round(own)
        if abs(own - near) < ON_GRID and near < degrees:
            at.append(near)
        else:
            at.append(len(turned))
            turned.append(sense * own)
    return np.array(turned), sense * degrees, degrees, tuple(at)


def _undrawn(
    project: Project, following: Construction, reading: Reading, known: Mapping[Mark, Any]
) -> tuple[tuple[int, ...], dict[int, str]]:
    """Return the angles at which the mechanism cannot be drawn, and of each the sentence that tells why."""
    found: set[int] = set()
    for chapter in project.chapters:
        found |= set(Findings.of(chapter).undrawn(project, reading))
    bad, why = tuple(sorted(found)), dict[int, str]()
    if bad:
        marks = [step.it for step in following.steps]
        for run in _runs(bad):
            told = examine(following, known, marks, positions=run)
            first = next((one for one in told if one.kind == "undrawn"), None)
            if first is not None:
                first = first._replace(number=step_number(project.construction, first.step))
                why |= dict.fromkeys(run, reason(first, project, project.scene.language))
    return bad, why


def _runs(places: Sequence[int]) -> Iterator[list[int]]:
    """Yield the runs of neighbours among places in order."""
    run: list[int] = []
    for place in places:
        if run and place != run[-1] + 1:
            yield run
            run = []
        run.append(place)
    yield run
