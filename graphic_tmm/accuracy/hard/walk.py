"""How many digits are left of each result along the turn, and close to its hard places.

Digits are those of the figure itself, off the bounds by which the board judges its own figures (`board.doubt`):
each step is shaken by some units in the last place. Of the place of a point they are counted against the extent
of the plan, of a figure that is nothing but rounding (a speed at a dead centre) against what such figures are
computed from.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.accuracy.hard.hard_places import AnyAngle, HardPlace, degrees_apart, hard_places
from graphic_tmm.board.doubt import DOUBTFUL, Doubts
from graphic_tmm.board.execute import needed
from graphic_tmm.board.findings import Finding, examine, step_number
from graphic_tmm.board.record import Construction, Mark, again
from graphic_tmm.board.sizes import DIGIT
from graphic_tmm.board.values import Reals, undefined
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said
from graphic_tmm.readers.any_angles.motion import Recorded, recorded
from graphic_tmm.readers.any_angles.ready import in_si
from graphic_tmm.readers.any_angles.turn import Plan, TurnQuantity
from graphic_tmm.scene.records import Scene

COARSE = 2.5
"""Degrees between the angles of the even row."""
OFFS = tuple(10.0 ** (1 - k) for k in range(11))
"""How close to a hard place it is walked, degrees, to both sides; and at it."""
MOST = 15.0
"""No more digits are counted: a number of the machine has not sixteen."""
FEW = 3.0
"""A figure that is so many powers of ten smaller than the largest of its kind is small."""
PLANS: tuple[Plan, ...] = get_args(Plan)
_LETTERS = {"places": "", "velocities": "v_", "accelerations": "a_", "omega": "ω_", "epsilon": "ε_"}

Mask = NDArray[np.bool_]


class Result(NamedTuple):
    """A result: its plan, its letter; ``row``: where the log has it, ``mark``: it in SI."""

    plan: Plan
    letter: str
    row: TurnQuantity
    mark: Mark


@dataclass(frozen=True, eq=False)
class Walk:
    """The digits of results at angles of the crank.

    ``turning``: the log; ``angles``: degrees, in order; ``whole``: degrees that the row turns through.
    ``sizes``: what the digits of each result are counted against, (result, angle); ``bounds``: how far it is
    off. ``missing``: where it cannot be drawn; ``lost``: where it can, and no digit is sure; ``small``: where
    it is so much smaller than the largest of its kind that it has few digits for that alone. ``findings``:
    what cannot be drawn, by indices of angles.
    """

    sheet: Drawn
    turning: AnyAngle
    results: tuple[Result, ...]
    angles: Reals
    sizes: Reals
    bounds: Reals
    missing: Mask
    lost: Mask
    small: Mask
    places: tuple[HardPlace, ...]
    findings: tuple[Finding, ...]
    whole: float

    @cached_property
    def digits(self) -> Reals:
        """The digits that are left, (result, angle); NaN where a result is left out."""
        with np.errstate(all="ignore"):
            share = np.where(self.bounds > 0.0, self.bounds / self.sizes, 0.0)
            digits = np.clip(-np.log10(share), 0.0, MOST)
        return np.where(self.missing | self.lost, np.nan, digits)

    @cached_property
    def even(self) -> Mask:
        """Which angles are of the even row, more than a degree from every hard place."""
        row = np.isin(self.angles, np.arange(0.0, self.whole, COARSE))
        near = [np.abs((self.angles - one.angle + 180.0) % 360.0 - 180.0) for one in self.places]
        return np.asarray(row & np.all([far > 1.0 for far in near], axis=0)) if near else row

    def at(self, angle: float) -> int:
        """Return the index of an angle that was walked, degrees."""
        return int(np.argmin(np.abs(self.angles - angle % self.whole)))

    def nearest(self, angle: float) -> HardPlace | None:
        """Return the hard place nearest to an angle."""
        return min(self.places, key=lambda one: degrees_apart(one.angle, angle), default=None)


def walk(scene: Scene) -> Walk:
    """Walk the crank over its turn, and close in on each hard place.

    Raises
    ------
    SceneError
        If the scene has no mechanism, or none that turns by its drive.
    StructureError
        If it cannot be drawn.
    """
    if scene.mechanism is None:
        says = said(
            "--hard walks the crank of a mechanism through its turn, and this scene has none; where a cam is "
            "undercut or a tooth is pointed, the command draw says"
        )
        raise SceneError(scene.source, (Fault("", 0, says),))
    plans = frozenset(plan for plan in PLANS if plan in scene.called or plan in PLANS[:2])
    of = recorded(scene, plans, exact=True)
    if not of.sweep.turns:
        says = said(
            "--hard walks a crank through its turn, and here link {link} is driven along a length: leave "
            "--hard out",
            link=scene.mechanism.drive.link,
        )
        raise SceneError(scene.source, (Fault("", 0, says),))
    log, turning, results = _in_si(of)
    drawn = {step.it for step in turning.log.steps}
    marks = [_of(results, quantity) for quantity in ("places", "velocities")]
    points, images = ([mark for mark in some if mark in drawn] for some in marks)
    places = hard_places(turning, points, images)
    whole = 360.0 * max(1, round(abs(of.whole) / 360.0))
    angles = _angles(places, whole)
    wanted = [mark for one in results for mark in _marks(one)]
    given = turning.given(angles)
    begun = {mark: given[mark] for mark in turning.log.given if mark in given}
    doubts = Doubts(needed(turning.log, wanted), begun, to_scale=False)
    found = examine(turning.log, given, wanted, doubts=doubts)
    undrawn = tuple(
        one._replace(number=step_number(log, one.step)) for one in found if one.kind == "undrawn"
    )
    judged = _judged(results, doubts, angles.size)
    return Walk(of.sheet, turning, results, angles, *judged, places, undrawn, whole)


def _in_si(of: Recorded) -> tuple[Construction, AnyAngle, tuple[Result, ...]]:
    """Return the whole log in SI, what of it varies with the angle, and the results that do."""
    log, marks, origins = in_si(of.sheet.construction, of.told, of.sheet.given)
    known = of.known(np.zeros((1, 1)))
    still = {**of.still, **origins}
    turning = AnyAngle(again(log, {**still, **known}), still, of.known)
    varying = _varying(turning, [*known])
    results: dict[tuple[str, int], Result] = {}
    for row in of.told:
        if row.mark in varying or marks[row] in varying:
            results.setdefault(
                (row.quantity, marks[row].slot), Result(row.plan, _letter(row), row, marks[row])
            )
    return log, turning, tuple(results.values())


def _varying(turning: AnyAngle, known: Sequence[Mark]) -> set[Mark]:
    varying = set(known)
    for step in turning.log.steps:
        if not varying.isdisjoint(step.uses):
            varying.add(step.it)
    return varying


def _letter(row: TurnQuantity) -> str:
    owner = row.key[0] if isinstance(row.key, tuple) else row.key
    return f"{_LETTERS.get(row.quantity, '')}{owner}"


def _of(results: Sequence[Result], quantity: str) -> list[Mark]:
    return [one.row.mark for one in results if one.row.quantity == quantity]


def _marks(one: Result) -> Iterator[Mark]:
    """Yield the marks that tell how sure a result is."""
    yield from (one.mark, one.row.mark)
    if one.row.known is not None:
        yield one.row.known


def _angles(places: Sequence[HardPlace], whole: float) -> Reals:
    """Return the even row, and the angles that close in on each hard place, in order."""
    turns = np.arange(0.0, whole, 360.0)
    offs = np.array([0.0, *OFFS, *(-off for off in OFFS)])
    near = [place.angle + turn + offs for place in places for turn in turns]
    return np.unique(np.concatenate([np.arange(0.0, whole, COARSE), *near]) % whole)


def _judged(
    results: Sequence[Result], doubts: Doubts, count: int
) -> tuple[Reals, Reals, Mask, Mask, Mask]:
    """Return sizes and bounds of results, where they are missing, lost and small; each (result, angle)."""
    shape = len(results), count
    values, bounds, natural = np.zeros(shape), np.zeros(shape), np.zeros(shape)
    missing, lost, nothing = np.zeros((3, *shape), dtype=bool)
    with np.errstate(all="ignore"):
        for k, one in enumerate(results):
            values[k] = np.abs(doubts.drawn[one.mark.slot][0])
            placed = one.row.mark if one.row.quantity == "places" else one.mark
            bounds[k], natural[k] = doubts.bound(placed)[0], doubts.size(one.row.mark)[0]
            missing[k] = undefined(doubts.drawn[one.mark.slot])[0]
            if one.row.known is not None:
                missing[k] |= undefined(doubts.drawn[one.row.known.slot])[0]
            lost[k], nothing[k] = _left(one, doubts, values[k], bounds[k], natural[k])
        kinds = [one.row.quantity for one in results]
        largest = np.stack([_largest(values, bounds, kinds, kind) for kind in kinds])
        places = np.array([kind == "places" for kind in kinds])[:, None]
        sizes = np.where(nothing | places, natural, values)
        small = np.asarray(np.log10(largest / sizes) >= FEW)
    return sizes, bounds, missing, lost & ~missing, small & ~places


def _left(
    one: Result, doubts: Doubts, value: Reals, bound: Reals, natural: Reals
) -> tuple[Mask, Mask]:
    """Return where no digit of a result is sure, and where it is nothing but rounding: as in the tables."""
    if one.row.scale is None:
        lost = doubts.lost.get(one.mark.slot, np.zeros((1, 1), bool))[0]
        return lost, doubts.nothing(one.mark)[0] & ~lost
    if one.row.quantity == "places":
        return bound > DIGIT * natural, np.zeros(1, bool)
    none, clean = ~(bound <= DIGIT * value), ~(bound > DOUBTFUL * natural)
    return np.asarray(none & ~clean), np.asarray(none & clean)


def _largest(values: Reals, bounds: Reals, kinds: Sequence[str], kind: str) -> Reals:
    """Return the largest figure of a kind at each angle, no less than half of the angles have it."""
    rows = [k for k, one in enumerate(kinds) if one == kind]
    known = np.where(bounds[rows] <= DIGIT * values[rows], values[rows], 0.0)
    largest = np.max(known, axis=0)
    there = largest[largest > 0.0]
    return np.asarray(np.fmax(largest, np.median(there) if there.size else 0.0))
