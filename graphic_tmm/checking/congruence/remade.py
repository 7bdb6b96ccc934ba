"""A scene drawn again in other scale factors: they are givens of its log."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.checking.cells import Key, cells, points
from graphic_tmm.checking.congruence.lengths import Group, per_mm
from graphic_tmm.drawn import Drawn, DrawnScene, read_log, view_scales
from graphic_tmm.readers.columns import unit_of_value

STEP, BASE, MOST, TOGETHER = 1e-9, 5, 2, 8
"""So many scale factors are varied together, by e to so small powers of a base that the change of a length
tells the exponent of each of them, MOST at the most."""
WHOLE, FEW = 0.1, 3
"""What goes to no whole power of scale factors, or to many, is drawn to none: a distance between views."""

Times = Mapping[Group, float]
"""How many times as large as due what is drawn to a scale factor is."""


def is_scale(mark: Mark) -> bool:
    """Whether a mark is a scale factor."""
    return mark.kind is Number and mark.unit.endswith("/mm")


@dataclass(frozen=True)
class Remaking:
    """A scene as due, and how its lengths depend on its scale factors."""

    made: DrawnScene

    @cached_property
    def factors(self) -> list[tuple[int, Mark]]:
        """The scale factors, and the lengths that are chosen as they are, each with its board (an index)."""
        boards = enumerate(self.made.boards)
        given = ((k, mark, value) for k, drawn in boards for mark, value in drawn.given.items())
        return [
            (k, mark)
            for k, mark, value in given
            if is_scale(mark) or (mark.kind is Length and np.all(np.asarray(value, float) != 0.0))
        ]

    @cached_property
    def groups(self) -> Mapping[tuple[str, str], Group]:
        """To what each segment is drawn, by plan and segment."""
        return groups_of(self.made, self.factors)

    def factor(self, group: Group) -> Mark | None:
        """Return the scale factor that a group is drawn to; None of several."""
        own = [mark for (_, mark), power in zip(self.factors, group.powers, strict=True) if power]
        return own[0] if len(own) == 1 else None

    def symbol(self, group: Group) -> str:
        """Return the letter of the scale factor of a group, or of one that follows from it; "μ" of several."""
        mark = self.factor(group)
        if mark is None or not is_scale(mark):
            return "μ"
        scales = [item for drawn in self.made.boards for item in drawn.scales.items()]
        follow = [
            scale.symbol
            for view, scale in scales
            if view == f"{group.plan} {scale.symbol}"
            and scale.unit == per_mm(group.unit) != mark.unit
        ]
        return follow[0] if follow else mark.name

    @cached_property
    def symbols(self) -> Mapping[str, Mapping[str, Group]]:
        """What is drawn to each scale factor, by plan and letter."""
        found: dict[str, dict[str, Group]] = {}
        for group in dict.fromkeys(self.groups.values()):
            found.setdefault(group.plan, {}).setdefault(self.symbol(group), group)
        return found

    def of(self, times: Times, places: Mapping[Group, Mapping[str, float]]) -> DrawnScene:
        """Return the scene drawn exactly, plans so many times as large; ``places``: in single positions.

        Of several scale factors that a length depends on those change that leave the other plans as they are.
        Plans of the same scale factors are alike, where nothing is told of one of them.
        """
        used = [group for group in dict.fromkeys(self.groups.values()) if any(group.powers)]
        alike = {group.powers: own for group, own in times.items()}
        wanted = np.array([np.log(times.get(k, alike.get(k.powers, 1.0))) for k in used])
        by = np.array([group.powers for group in used], dtype=float)
        changes = np.linalg.lstsq(by, wanted, rcond=None)[0]
        boards = list(self.made.boards)
        for j, ((k, mark), change) in enumerate(zip(self.factors, changes, strict=True)):
            drawn = boards[k]
            due = np.asarray(drawn.given[mark], dtype=float)
            row = np.exp(change) * due
            for group, own in places.items():
                if power := group.powers[j]:
                    row = np.broadcast_to(np.atleast_2d(row), (1, len(drawn.names))).copy()
                    for name, share in own.items():
                        at = drawn.names.index(name)
                        row[0, at] *= (share / times.get(group, 1.0)) ** (1.0 / power)
            if row.shape != due.shape or not np.allclose(row, due, rtol=1e-9, atol=0.0):
                boards[k] = replace(drawn, given={**drawn.given, mark: _plain(row)})
        pairs = zip(boards, self.made.boards, strict=True)
        return self.made._replace(
            boards=tuple(one if one is old else _executed(one) for one, old in pairs)
        )


def _plain(row: Any) -> Any:
    return float(row) if np.ndim(row) == 0 else row


def _executed(drawn: Drawn) -> Drawn:
    numbers = read_log(drawn.project, drawn.given, drawn.hand, drawn.doubts)
    return replace(drawn, numbers=numbers, scales=view_scales(drawn.project, numbers.drawn))


def groups_of(
    made: DrawnScene, factors: Sequence[tuple[int, Mark]]
) -> dict[tuple[str, str], Group]:
    """Return to what each segment, and each plan of points (segment ""), is drawn, by plan and segment.

    Where positions have scale factors of their own it is that of the first.
    """
    due, there = _sizes(made), cells(made)
    found: dict[tuple[str, str], tuple[int, ...]] = {}
    for first in range(0, len(factors), TOGETHER):
        some = factors[first : first + TOGETHER]
        moved = _sizes(_varied(made, some))
        changes: defaultdict[tuple[str, str], list[float]] = defaultdict(list)
        for key, size in due.items():
            if size and moved.get(key):
                changes[key[:2]].append(float(np.log(moved[key] / size)))
        for name, row in changes.items():
            change = float(np.median(row)) / STEP
            if abs(change - round(change)) < WHOLE:
                found[name] = (*found.get(name, ()), *_powers(round(change), len(some)))
    found = {
        name: powers
        for name, powers in found.items()
        if len(powers) == len(factors) and sum(map(abs, powers)) <= FEW
    }
    groups: dict[tuple[str, str], Group] = {}
    known: dict[tuple[str, tuple[int, ...]], Group] = {}
    for (plan, segment, _), cell in there.items():
        if (plan, segment) in found and cell.mm and cell.value:
            powers = found[plan, segment]
            mu = float(f"{abs(cell.value / cell.mm):.5g}")
            group = known.setdefault((plan, powers), Group(plan, mu, cell.unit, powers))
            groups.setdefault((plan, segment), group)
    for (plan, segment), powers in found.items():
        if not segment:
            groups[plan, ""] = known.get((plan, powers)) or _of_points(made, factors, plan, powers)
    return groups


def _of_points(
    made: DrawnScene, factors: Sequence[tuple[int, Mark]], plan: str, powers: tuple[int, ...]
) -> Group:
    """Return to what a plan is drawn of which only points are read."""
    (k, mark), *_ = [one for one, power in zip(factors, powers, strict=True) if power] or factors
    mu = float(np.ravel(np.asarray(made.boards[k].given[mark], dtype=float))[0])
    return Group(plan, mu, unit_of_value(mark), powers)


def _sizes(made: DrawnScene) -> dict[Key, float]:
    """Return how long segments are, mm, and of points (segment "") how far they are from the pole."""
    sizes = {key: abs(cell.mm) for key, cell in cells(made).items() if cell.mm and cell.value}
    far: dict[Key, float] = {}
    for (plan, _, place), spot in points(made).items():
        far[plan, "", place] = max(far.get((plan, "", place), 0.0), abs(spot))
    return sizes | far


def _varied(made: DrawnScene, factors: Sequence[tuple[int, Mark]]) -> DrawnScene:
    boards = list(made.boards)
    for j, (k, mark) in enumerate(factors):
        row = np.asarray(boards[k].given[mark], dtype=float) * np.exp(STEP * BASE**j)
        boards[k] = replace(boards[k], given={**boards[k].given, mark: _plain(row)})
    return made._replace(boards=tuple(map(_executed, boards)))


def _powers(rest: int, count: int) -> Iterator[int]:
    """Yield the exponents that a change tells, in steps, digit by digit."""
    for _ in range(count):
        digit = (rest + MOST) % BASE - MOST
        yield digit
        rest = (rest - digit) // BASE
