"""How many digits are left of each result along what a drive goes through, and close to its hard places.

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

from graphic_tmm.accuracy.hard.hard_places import AnyPlace, HardPlace, hard_places
from graphic_tmm.accuracy.hard.span import Coordinates, Span, span_of
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

MOST = 15.0
"""No more digits are counted: a number of the machine has not sixteen."""
FEW = 3.0
"""A figure that is so many powers of ten smaller than the largest of its kind is small."""
PLANS: tuple[Plan, ...] = get_args(Plan)
_LETTERS = {"places": "", "velocities": "v_", "accelerations": "a_", "omega": "ω_", "epsilon": "ε_"}

Mask = NDArray[np.bool_]


class Result(NamedTuple):
    """A result: its plan, its letter; ``row``: where the log has it, ``mark``: it in SI."""

    plan: str
    letter: str
    row: TurnQuantity
    mark: Mark


@dataclass(frozen=True, eq=False)
class Walk:
    """The digits of results wherever a drive stands.

    ``moving``: the log; ``row``: the coordinates of its span that are walked, degrees or mm, in order.
    ``sizes``: what the digits of each result are counted against, (result, place); ``bounds``: how far it is
    off. ``missing``: where it cannot be drawn; ``lost``: where it can, and no digit is sure; ``small``: where
    it is so much smaller than the largest of its kind that it has few digits for that alone. ``findings``:
    what cannot be drawn, by indices of the row.
    """

    sheet: Drawn
    moving: AnyPlace
    results: tuple[Result, ...]
    row: Coordinates
    sizes: Reals
    bounds: Reals
    missing: Mask
    lost: Mask
    small: Mask
    places: tuple[HardPlace, ...]
    findings: tuple[Finding, ...]

    @property
    def span(self) -> Span:
        """What the drive is walked through."""
        return self.moving.span

    @cached_property
    def digits(self) -> Reals:
        """The digits that are left, (result, place); NaN where a result is left out."""
        with np.errstate(all="ignore"):
            share = np.where(self.bounds > 0.0, self.bounds / self.sizes, 0.0)
            digits = np.clip(-np.log10(share), 0.0, MOST)
        return np.where(self.missing | self.lost, np.nan, digits)

    @cached_property
    def even(self) -> Mask:
        """Which places are of the even row, farther than 1° of a turn from every hard place."""
        row = np.isin(self.row, self.span.even)
        far = self.span.offs[1]
        near = [np.abs(self.span.off(self.row, one.at)) <= far for one in self.places]
        return np.asarray(row & ~np.any(near, axis=0)) if near else row

    def index(self, place: float) -> int:
        """Return the index of a place that was walked, degrees or mm; of the nearest."""
        return int(np.argmin(np.abs(self.row - _put(self.span, np.asarray(place)))))

    def nearest(self, place: float) -> HardPlace | None:
        """Return the nearest hard place."""
        return min(self.places, key=lambda one: self.span.apart(one.at, place), default=None)


def walk(scene: Scene) -> Walk:
    """Walk a drive through its turn, or as far as it reaches, and close in on each hard place.

    Raises
    ------
    SceneError
        If the scene has no mechanism.
    StructureError
        If it cannot be drawn.
    """
    if scene.mechanism is None:
        says = said(
            "--hard walks the drive of a mechanism through its range, and this scene has none; where a cam is "
            "undercut or a tooth is pointed, the command draw says"
        )
        raise SceneError(scene.source, (Fault("", 0, says),))
    plans = frozenset(plan for plan in PLANS if plan in scene.called or plan in PLANS[:2])
    of = recorded(scene, plans, exact=True)
    log, moving, results = _in_si(of)
    points, images = (_of(results, moving.log, name) for name in ("places", "velocities"))
    places = hard_places(moving, points, images)
    row = _row(places, moving.span)
    wanted = [mark for one in results for mark in _marks(one)]
    given = moving.given(row)
    begun = {mark: given[mark] for mark in moving.log.given if mark in given}
    doubts = Doubts(needed(moving.log, wanted), begun, to_scale=False)
    found = examine(moving.log, given, wanted, doubts=doubts)
    undrawn = tuple(
        one._replace(number=step_number(log, one.step)) for one in found if one.kind == "undrawn"
    )
    judged = _judged(results, doubts, row.size)
    return Walk(of.sheet, moving, results, row, *judged, places, undrawn)


def _in_si(of: Recorded) -> tuple[Construction, AnyPlace, tuple[Result, ...]]:
    """Return the whole log in SI, what of it varies with the drive, and the results that do."""
    log, marks, origins = in_si(of.sheet.construction, of.told, of.sheet.given)
    known = of.known(np.zeros((1, 1)))
    still = {**of.still, **origins}
    varying_log = again(log, {**still, **known})
    varying = _varying(varying_log, [*known])
    results: dict[tuple[str, int], Result] = {}
    for row in of.told:
        if row.mark in varying or marks[row] in varying:
            results.setdefault(
                (row.quantity, marks[row].slot), Result(row.plan, _letter(row), row, marks[row])
            )
    found = tuple(results.values())
    points = _of(found, varying_log, "places")

    mechanism = of.sheet.scene.mechanism

    def there(span: Span) -> Mask:
        if mechanism is not None and mechanism.further:
            # beyond the row others would go on as they went: a crank that follows a rod, through many turns
            return np.zeros(span.tried.size, dtype=bool)
        return AnyPlace(varying_log, still, of.known, span).there(span.tried, points)

    at = np.array([q for q in of.sheet.project.coordinates if q is not None])
    span = span_of(of.sweep, of.whole, at, there)
    return log, AnyPlace(varying_log, still, of.known, span), found


def _varying(log: Construction, known: Sequence[Mark]) -> set[Mark]:
    varying = set(known)
    for step in log.steps:
        if not varying.isdisjoint(step.uses):
            varying.add(step.it)
    return varying


def _letter(row: TurnQuantity) -> str:
    owner = row.key[0] if isinstance(row.key, tuple) else row.key
    return f"{_LETTERS.get(row.quantity, '')}{owner}"


def _of(results: Sequence[Result], log: Construction, quantity: str) -> list[Mark]:
    """Return the marks of results of one kind that a log draws."""
    drawn = {step.it for step in log.steps}
    marks = [one.row.mark for one in results if one.row.quantity == quantity]
    return [mark for mark in marks if mark in drawn]


def _marks(one: Result) -> Iterator[Mark]:
    """Yield the marks that tell how sure a result is."""
    yield from (one.mark, one.row.mark)
    if one.row.known is not None:
        yield one.row.known


def _row(places: Sequence[HardPlace], span: Span) -> Coordinates:
    """Return the even row, and what closes in on each hard place, in order."""
    turns = np.arange(0.0, span.high - span.low, span.once)
    offs = np.array([0.0, *span.offs, *(-off for off in span.offs)])
    near = [place.at + turn + offs for place in places for turn in turns]
    return np.unique(_put(span, np.concatenate([span.even, *near])))


def _put(span: Span, row: Coordinates) -> Coordinates:
    """Return coordinates within a span; over a turn what is behind its end is at its beginning."""
    return np.asarray(row % span.high if span.period else np.clip(row, span.low, span.high))


def _judged(
    results: Sequence[Result], doubts: Doubts, count: int
) -> tuple[Reals, Reals, Mask, Mask, Mask]:
    """Return sizes and bounds of results, where they are missing, lost and small; each (result, place)."""
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
    none = ~(bound <= DIGIT * value)
    clean = ~(bound > DOUBTFUL * natural) & ~np.isinf(bound)
    return np.asarray(none & ~clean), np.asarray(none & clean)


def _largest(values: Reals, bounds: Reals, kinds: Sequence[str], kind: str) -> Reals:
    """Return the largest figure of a kind at each place, no less than half of the places have it."""
    rows = [k for k, one in enumerate(kinds) if one == kind]
    known = np.where(bounds[rows] <= DIGIT * values[rows], values[rows], 0.0)
    largest = np.max(known, axis=0)
    there = largest[largest > 0.0]
    return np.asarray(np.fmax(largest, np.median(there) if there.size else 0.0))
