"""How a drawing is congruent to what is due: the scale factor, the move and the unit of each of its plans.

It comes before the grammar of mistakes: a plan that is right in another scale factor, or turned, is right.
What is decided is used; what only lengths say is used, too, and asked.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Length
from graphic_tmm.checking.cells import Cell, Key, cells, points
from graphic_tmm.checking.congruence.lengths import (
    SHORT,
    Group,
    Read,
    lengths_of,
    middle,
    per_mm,
    rates_of,
    spread_of,
    values_of,
)
from graphic_tmm.checking.congruence.moves import (
    HALF,
    MOVES,
    NEAR,
    NONE,
    Move,
    Placed,
    placed,
    turned_back,
)
from graphic_tmm.checking.congruence.remade import Remaking
from graphic_tmm.checking.congruence.stated import SCENE, Stated
from graphic_tmm.checking.congruence.supposed import settled, supposed
from graphic_tmm.checking.congruence.together import (
    not_copied,
    not_spoilt,
    of_other_polygons,
    with_siblings,
)
from graphic_tmm.checking.congruence.witnesses import (
    EXACT,
    NEARLY,
    OWN,
    PLENTY,
    UNITS,
    WRITTEN,
    Verdict,
    unit_of,
    verdict,
)
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.checking.records import Last, OwnScale, Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.symbols import plain


class Agreed(NamedTuple):
    """A drawing as it is to be judged: its readings, how many times larger its plans are, what is said."""

    rows: tuple[Taken, ...]
    times: Mapping[Group, float]
    places: Mapping[Group, Mapping[str, float]]
    scales: tuple[OwnScale, ...]
    moves: Mapping[str, Move]
    units: Mapping[str, str]
    free: frozenset[Group] = frozenset()
    """Plans in the task's scale factor, which nobody states."""
    others: tuple[Agreed, ...] = ()
    """As it may be judged, too, if there is a mistake in it: the likelier first."""


@dataclass(frozen=True)
class Congruence:
    """What drawings of a scene, which is drawn exactly, are compared with."""

    made: DrawnScene

    @cached_property
    def due(self) -> Mapping[Key, Cell]:
        """The figures that are due."""
        return cells(self.made)

    @cached_property
    def spots(self) -> Mapping[Key, complex]:
        """Where points are due, mm from the pole."""
        return points(self.made)

    @cached_property
    def groups(self) -> Mapping[tuple[str, str], Group]:
        """To what each segment is drawn, by plan and segment."""
        return self.remaking.groups

    @cached_property
    def remaking(self) -> Remaking:
        """How the scene is drawn in other scale factors."""
        return Remaking(self.made)

    @cached_property
    def _steps(self) -> Mapping[tuple[str, str], Step]:
        return steps_of(self.made.mechanism)

    @cached_property
    def _laid(self) -> Mapping[str, str]:
        """By plan, the segment that is laid off first, the same in all positions."""
        found: dict[str, tuple[int, str]] = {}
        for (plan, segment), step in self._steps.items():
            at = [
                cell.mm or 0.0 for (p, s, _), cell in self.due.items() if (p, s) == (plan, segment)
            ]
            steady = at and max(at) - min(at) < 1e-6 * max(map(abs, at))
            if step.it.kind is Length and not step.op.reads and steady:
                found[plan] = min(found.get(plan, (step.it.slot, segment)), (step.it.slot, segment))
        return {plan: segment for plan, (_, segment) in found.items()}

    @cached_property
    def _first(self) -> Mapping[str, str]:
        """By plan, the point that is laid off first: as far from the pole in all positions."""
        found: dict[str, str] = {}
        for plan, letter in dict.fromkeys(key[:2] for key in self.spots):
            far = [abs(z) for (p, s, _), z in self.spots.items() if (p, s) == (plan, letter)]
            if max(far) - min(far) < 1e-6 * max(far) and min(far) > SHORT and len(far) > 1:
                found.setdefault(plan, letter)
        return found

    @cached_property
    def _plan_groups(self) -> Mapping[str, Group]:
        """To what each plan of points is drawn."""
        return {plan: group for (plan, segment), group in self.groups.items() if not segment}

    def of(
        self,
        rows: Sequence[Taken],
        stated: Sequence[Stated] = (),
        turns: Mapping[str, Move] = {},
    ) -> Agreed:
        """Return how a drawing is to be judged; ``stated``: scale factors that somebody gives; ``turns``."""
        if not stated and not turns and self._is_due(rows):
            return Agreed(tuple(rows), {}, {}, (), {}, {})
        rows, units = self._in_mm(rows)
        moves = self._moves(rows, turns)
        rows = tuple(_moved(one, moves) for one in rows)
        lengths = self._lengths(rows)
        rates = rates_of(rows, self.due, self._steps)
        given = self._given(stated)
        alone: dict[Group, Verdict] = {}
        for group, read in sorted(lengths.items(), key=lambda one: self._order(one[0])):
            others = self._of_positions(group, lengths, alone)
            alone[group] = verdict(group, read, rates.get(group.plan, ()), others)
        plain = not_copied(alone, self._plans)
        found = with_siblings(not_spoilt(plain, lengths, self._plans), lengths)
        found = of_other_polygons(found, lengths, self._left(stated))
        found |= {g: _as_stated(s, found.get(g, Verdict())) for g, s in given.items()}
        agreed = self._agreed(found, rows, moves, units)
        if any(plain[group].times != one.times for group, one in alone.items()):
            return agreed  # a copy
        some = supposed(found, plain, lengths, given)
        more = tuple(self._agreed(one, rows, moves, units) for one in some)
        free = frozenset(g for g, v in found.items() if v.times == 1.0 and g not in given)
        return agreed._replace(free=free, others=more)

    def _given(self, stated: Sequence[Stated]) -> dict[Group, Stated]:
        """Return what is stated, by groups: one letter of a plan is of all that bear it, as polygons do.

        A scale factor of the scene itself is of those that are due in it.
        """
        return {
            group: one._replace(group=group)
            for one, group in self._lettered(stated)
            if group.mu == one.group.mu or not one.due
        }

    def _left(self, stated: Sequence[Stated]) -> dict[Group, float]:
        """Return the scene's own scale factors that are stated, by groups of that letter due in another."""
        return {
            group: one.mu
            for one, group in self._lettered(stated)
            if group.mu != one.group.mu and one.due
        }

    def _lettered(self, stated: Sequence[Stated]) -> Iterator[tuple[Stated, Group]]:
        symbol = self.remaking.symbol
        for one in stated:
            for group in dict.fromkeys(self.groups.values()):
                if group.of == one.group.of and symbol(group) == symbol(one.group):
                    yield one, group

    def supposing(self, agreed: Agreed, k: Mapping[Group, float]) -> Agreed:
        """Return how a drawing is judged if plans are so many times as large (logarithms) as was agreed."""
        lengths = self._lengths(agreed.rows)
        found = {g: settled(g, lengths[g], math.exp(one), NEARLY) for g, one in k.items()}
        times = {**agreed.times, **{group: one.times for group, one in found.items()}}
        scales = tuple(self._scale(group, one) for group, one in found.items())
        return agreed._replace(times=times, scales=(*agreed.scales, *scales))

    def _agreed(
        self,
        found: Mapping[Group, Verdict],
        rows: tuple[Taken, ...],
        moves: Mapping[str, Placed],
        units: Mapping[str, str],
    ) -> Agreed:
        """Return how readings are judged in scale factors that are found."""
        times = {group: one.times for group, one in found.items() if one.times != 1.0}
        places = {group: dict(one.places) for group, one in found.items() if one.places}
        scales = tuple(self._scale(g, one) for g, one in found.items() if one.by or one.against)
        turned = {p: one.move for p, one in moves.items() if one.move != NONE or one.origins}
        return Agreed(rows, times, places, scales, turned, units)

    def _is_due(self, rows: Sequence[Taken]) -> bool:
        """Whether lengths, and what they stand for, are as long as due in every plan: nothing is to be told.

        Lengths go by the scale factor that they seem to be drawn to: which it is takes drawing the scene again.
        """
        ratios: defaultdict[tuple[str, float, str], list[float]] = defaultdict(list)
        values = values_of(rows, self.due)
        for one in rows:
            if one.pointed:
                return False
            cell = self.due[one.key]
            if one.mm and cell.mm and cell.value and abs(cell.mm) > SHORT:
                mu = abs(cell.value / cell.mm)
                of = (one.plan, float(f"{mu:.5g}"))
                ratios[*of, ""].append(math.log(abs(one.mm / cell.mm)))
                if values.get(one.key):
                    own = mu * abs(one.mm) / values[one.key]
                    ratios[*of, one.position].append(math.log(own))
        least = {of: WRITTEN if of[2] else OWN for of in ratios}
        return all(float(np.median(np.abs(ratios[of]))) < one for of, one in least.items())

    def stated_rows(self) -> Iterator[Taken]:
        """Yield a row for each scale factor of the scene, as the template has them."""
        for plan, symbols in self.remaking.symbols.items():
            for symbol, group in symbols.items():
                yield Taken(plan, "", plain(symbol), value=group.mu, unit=per_mm(group.unit))

    def _order(self, group: Group) -> tuple[int, str, float]:
        plans = [*dict.fromkeys(plan for plan, _, _ in (*self.spots, *self.due))]
        return plans.index(group.plan), group.unit, group.mu

    def _in_mm(self, rows: Sequence[Taken]) -> tuple[tuple[Taken, ...], dict[str, str]]:
        """Return readings in mm, and by plan the unit that its lengths were written in, if it is another."""
        plans: dict[str, list[tuple[Group, float]]] = {}
        lengths = lengths_of(rows, self.due, self.groups, self._laid)
        for group, some in lengths.items():
            if len(some) >= PLENTY:
                ratio = middle([one.ratio for one in some])
                plans.setdefault(group.plan, []).append((group, ratio))
        units = {plan: unit for plan, ratios in plans.items() if (unit := unit_of(ratios))}
        read = (_times(one, UNITS[units[one.plan]]) if one.plan in units else one for one in rows)
        return tuple(read), units

    def _moves(self, rows: Sequence[Taken], turns: Mapping[str, Move]) -> dict[str, Placed]:
        plans = [plan for plan in self._plan_groups if any(one.plan == plan for one in rows)]
        stated = {plan: Placed(turns[plan], 1.0, {}) for plan in plans if plan in turns}
        free = [plan for plan in plans if plan not in stated]
        found = {plan: placed(rows, self.spots, plan, MOVES) for plan in free}
        halves = {plan: one for plan, one in found.items() if one and one.move == HALF}
        if len(halves) > 1 and 2 * len(halves) > len(found):
            # one that is not was turned by a mistake
            found = {plan: halves.get(plan, Placed(HALF, 1.0, {})) for plan in found}
        else:
            # a plan of another position looks like one that is turned by 180°
            others = [move for move in MOVES if move != HALF]
            found = {plan: placed(rows, self.spots, plan, others) for plan in free}
        found |= turned_back(found)
        common = {one.move for one in found.values() if one} - {NONE}
        if len(common) == 1:
            again = [plan for plan in free if found[plan] is None]
            found |= {p: placed(rows, self.spots, p, common, 0.5 * NEAR) for p in again}
        mirrored = {one.move.mirrored for one in found.values() if one}
        if True in mirrored and (len(free) < 2 or not all(found.values()) or len(common) > 1):
            # a single plan that is mirrored is a mistake: the mechanism was drawn so
            upright = [move for move in MOVES if not move.mirrored and move != HALF]
            found = {plan: placed(rows, self.spots, plan, upright) for plan in free}
        return stated | {plan: one for plan, one in found.items() if one}

    def _lengths(self, rows: Sequence[Taken]) -> dict[Group, list[Read]]:
        lengths = dict(lengths_of(rows, self.due, self.groups, self._laid))
        for group, some in spread_of(rows, self.spots, self._plan_groups, self._first).items():
            lengths[group] = [*lengths.get(group, []), *some]
        return lengths

    def _of_positions(
        self, group: Group, lengths: Mapping[Group, list[Read]], found: Mapping[Group, Verdict]
    ) -> list[Read]:
        """Return the lengths of the plan of positions, by which rates may be calculated, as they are due."""
        return [
            one._replace(mm=one.mm / found[other].times)
            for other, some in lengths.items()
            if other.plan != group.plan
            and other in found
            and other.unit == "m"
            and other.plan in self._plans
            for one in some
        ]

    @cached_property
    def _plans(self) -> Collection[str]:
        return {plan for plan, _, _ in self.spots}

    def _scale(self, group: Group, one: Verdict) -> OwnScale:
        symbol, mark = self.remaking.symbol(group), self.remaking.factor(group)
        own = tuple((place, group.mu / times) for place, times in one.places)
        first = self._laid.get(group.plan, "")
        against = one.against or (1.0, 1.0)
        return OwnScale(
            group.plan,
            group.plan if mark is None else mark.view,
            symbol,
            group.mu if one.times == 1.0 else float(f"{group.mu / one.times:.4g}"),
            group.mu,
            per_mm(group.unit),
            one.by,
            one.agree,
            one.among,
            first,
            own,
            against,
        )


def _as_stated(stated: Stated, found: Verdict) -> Verdict:
    """Return the verdict on a plan whose scale factor is stated; ``found``: what readings say by themselves.

    A row of the template that was left as it was is no statement, where readings decide otherwise.
    """
    mu = stated.group.mu if stated.mu is SCENE else stated.mu
    times = stated.group.mu / mu
    decided = found.by in ("rows", "rates") and abs(math.log(found.times / times)) > OWN
    if decided and stated.line and abs(math.log(times)) < EXACT:
        return found
    against = (times, found.times) if decided else None
    return Verdict(times if abs(math.log(times)) > 1e-4 else 1.0, "stated", against=against)


def _times(taken: Taken, unit: float) -> Taken:
    """Return a reading that was written in another unit in mm."""
    x, y, mm = (None if one is None else unit * one for one in (taken.x, taken.y, taken.mm))
    last = Last(unit * taken.last.mm, taken.last.value, unit * taken.last.x, unit * taken.last.y)
    return taken._replace(mm=mm, x=x, y=y, last=last)


def _moved(taken: Taken, moves: Mapping[str, Placed]) -> Taken:
    """Return a reading of a point as its plan stands on the sheet, from its pole."""
    if not taken.pointed or taken.plan not in moves:
        return taken
    one = moves[taken.plan]
    spot = one.move.back(taken.spot - one.origins.get(taken.position, 0j))
    last = taken.last
    if one.move.turns % 2:
        last = last._replace(x=last.y, y=last.x)
    return taken._replace(x=spot.real, y=spot.imag, last=last)
