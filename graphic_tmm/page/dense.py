"""A mechanism at every degree of its crank, or at as many steps of a row that is no whole turn.

It is the same log, executed by the exact hand at so many places more.

Chapters tell what their givens are there (`Turning.between`). What is drawn across positions, a curve, an
extreme, is the sheet's own and is not drawn again. What follows from something else that belongs to the
positions of the sheet alone (a chord between two of them) is left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.findings import examine, step_number
from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Construction, Mark, Step, again, kept
from graphic_tmm.board.values import Number, Reals
from graphic_tmm.drawn import Drawn, Findings, Numbers
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.units import unit
from graphic_tmm.mechanism.records import TURN, Sweep
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Turn, Turning, in_row, open_row
from graphic_tmm.readers.findings import reason

WHOLE = 360.0
"""Degrees of a turn; so many angles are drawn of it."""
FRAMES = 360
"""So many places, its ends among them, are drawn of a row that does not come back to where it began."""
ON_GRID = 1e-6
"""A position that is off a whole degree, or step, by more than this has a place of its own."""


@dataclass(frozen=True)
class Dense:
    """A mechanism at every degree of its crank; at equal steps between the ``ends`` of a row that has them.

    ``drawn``: as drawn there, by the exact hand; its positions are the angles. ``sheet``: the same at the
    positions of the sheet. ``turned``: how far the crank has turned at each angle, degrees, all whole degrees
    of the row's turns in order, behind them what positions are not among them; ``frames``: the same in steps,
    ``numbers``: in intervals of the row; ``angles``: its direction; of what slides all of this is m.
    ``whole``: how many steps these are, each of so many degrees or m ``per`` step; ``at``: the index of each
    position of the sheet. ``why``: by index the reason why an angle is not drawn. ``log``: what is executed
    there, ``given``: from what.
    """

    drawn: Drawn
    sheet: Drawn
    turned: Reals
    frames: Reals
    numbers: Reals
    angles: Reals
    whole: int
    per: float
    at: tuple[int, ...]
    ends: bool
    why: Mapping[int, str]
    log: Construction
    given: Mapping[Mark, Any]

    @property
    def sweep(self) -> Sweep:
        """What the drive goes through."""
        return self.sheet.project.sweep or TURN

    def named(self, k: int, language: str) -> str:
        """Return what a place is called: 137,5°, 612,3 mm."""
        return place_name(float(self.angles[k]), self.sweep, language)


def place_name(value: float, sweep: Sweep, language: str) -> str:
    """Return what a place of a drive is called, to a tenth of a degree or millimetre."""
    if sweep.turns:
        return f"{fixed(value % WHOLE, 1, language)}°"
    return f"{fixed(1000.0 * value, 1, language)} {unit('mm', language)}"


class _Frames(NamedTuple):
    """Where a mechanism is drawn; see `Dense`. ``span``: how far the drive goes over the row, with its sign."""

    turned: Reals
    frames: Reals
    span: float
    whole: int
    per: float
    at: tuple[int, ...]


def dense(drawn: Drawn) -> Dense | None:
    """Return a mechanism at every degree; None of a board whose positions are no places of a drive."""
    log = drawn.construction
    sheet = drawn_exactly(drawn)
    by = next((mark for mark in log.given if mark.role == roles.ROW), None)
    if by is None:
        return None
    row = np.asarray(drawn.given[by], dtype=float)[0]
    steps = open_row(drawn.scene, row)
    if steps is not None and not np.ptp(steps) > 0.0:
        return None
    found = _turned(drawn, row) if steps is None else _along(drawn, row, steps)
    turned = found.turned
    known = kept(sheet.construction, sheet.given, sheet.numbers.drawn.values)

    def read(marks: Iterable[Mark]) -> Reading:
        return execute(again(log, known), known, marks)

    turn = Turn(turned, found.span, drawn.project.count, read, row=steps)
    count = drawn.project.count
    numbers = np.abs(turned) * count / found.whole if steps is None else turn.numbers
    known |= {mark: numbers[None, :] for mark in log.given if mark.role == roles.STATION}
    place = Mark(log.size, "i", Number, "", role=roles.STATION)
    anew: dict[Mark, Step] = {}
    for chapter in drawn.project.chapters:
        known |= Turning.of(chapter).between(sheet, turn)
        anew |= {step.it: step for step in Turning.of(chapter).read_off(sheet, place)}
    if anew:
        redrawn = tuple(anew.get(step.it, step) for step in log.steps)
        log = log._replace(given=(*log.given, place), steps=redrawn, size=log.size + 1)
        known[place] = numbers[None, :]
    following = again(log, known)
    reading = execute(following, known)
    angles = np.array(drawn.project.coordinates[0] or 0.0) + turned
    sweep = drawn.project.sweep or TURN
    names = tuple(_name(angle, sweep) for angle in angles)
    everywhere = tuple(range(turned.size))
    rows = {plan: everywhere if some else () for plan, some in drawn.project.rows.items()}
    within = angles % WHOLE if sweep.turns else angles
    project = replace(drawn.project, names=names, coordinates=tuple(map(float, within)), rows=rows)
    bad, why = _undrawn(project, following, reading, known)
    own = {plan: reading for plan, some in rows.items() if some}
    numbers_there = Numbers(reading, own, reading)
    scales = {view: scale._replace(own=()) for view, scale in drawn.scales.items()}
    there = replace(
        sheet, project=project, numbers=numbers_there, hand=EXACT, undrawn=bad, scales=scales
    )
    there.cache.update(sheet.cache)
    where = (
        turned,
        found.frames,
        numbers,
        angles,
        found.whole,
        found.per,
        found.at,
        steps is not None,
    )
    return Dense(there, sheet, *where, why, following, known)


def _name(value: float, sweep: Sweep) -> str:
    return f"{value % WHOLE:g}°" if sweep.turns else f"{1000.0 * value:g} mm"


def drawn_exactly(drawn: Drawn) -> Drawn:
    """Return a board drawn by the exact hand, without a ruler."""
    hand = drawn.hand
    exact = hand.ruler is None and not hand.slips and hand.digits is None
    return drawn if exact else drawn.drawn_by(EXACT)


def _turned(drawn: Drawn, row: Reals) -> _Frames:
    """Return every degree of whole turns; ``row``: how far the crank has turned in each position."""
    count = drawn.project.count
    assert drawn.scene.mechanism is not None
    sense = drawn.scene.mechanism.drive.sense
    degrees = round(abs(float(row[1])) * count) if count > 1 else round(WHOLE)
    zero = float(drawn.project.coordinates[0] or 0.0)
    own = [
        abs(float(row[k])) if k < count else (sense * (float(angle or 0.0) - zero)) % WHOLE
        for k, angle in enumerate(drawn.project.coordinates)
    ]
    frames, at = _placed(own, degrees)
    return _Frames(sense * frames, frames, sense * degrees, degrees, float(sense), at)


def _along(drawn: Drawn, row: Reals, steps: Reals) -> _Frames:
    """Return equal steps between the ends of a row; ``row``: how far each position is from the first."""
    own = row[: steps.size]
    first, last = sorted((float(own.min()), float(own.max())), reverse=bool(own[-1] < own[0]))
    per = (last - first) / (FRAMES - 1)
    zero = float(drawn.project.coordinates[0] or 0.0)
    span = math.copysign(float(steps[-1]), float(own[-1]))
    extra = np.array([float(one or 0.0) - zero for one in drawn.project.coordinates[steps.size :]])
    if (drawn.project.sweep or TURN).turns:
        extra = in_row(extra, span)
    frames, at = _placed([(one - first) / per for one in (*own, *extra)], FRAMES)
    return _Frames(first + per * frames, frames, span, FRAMES, per, at)


def _placed(own: Iterable[float], whole: int) -> tuple[Reals, tuple[int, ...]]:
    """Return all steps, behind them what is between two, and the index of each place ``own``, in steps."""
    frames, at = [float(k) for k in range(whole)], list[int]()
    for one in own:
        near = round(one)
        if abs(one - near) < ON_GRID and 0 <= near < whole:
            at.append(near)
        else:
            at.append(len(frames))
            frames.append(one)
    return np.array(frames), tuple(at)


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


def first_asked(drawn: Drawn, plans: Sequence[str]) -> int:
    """Return the position that the crank stands in first: the author's, or that of which most plans are drawn.

    ``plans``: the position of each plan that is drawn for one. Forces are asked for in few; the main position
    comes first of several with as many plans.
    """
    if drawn.scene.main in drawn.names:
        return drawn.main
    there = [k for k in (drawn.main, *drawn.all) if k not in drawn.undrawn] or [drawn.main]
    return max(there, key=lambda k: plans.count(drawn.names[k]))
