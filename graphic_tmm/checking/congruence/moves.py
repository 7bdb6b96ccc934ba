"""How the points of a plan were counted: turned, mirrored, x and y exchanged, from an origin of their own."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Collection, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.records import Taken
from graphic_tmm.language.said import said

NEAR, MUCH = 3.0, 0.35
"""A plan whose points are so near their due, mm in the median, is as it should be; another move must leave no
more than this share of what is left. Where other plans were moved so, half of the first is enough."""
FEWEST, FAR = 3, 0.12
"""Fewer points of a plan tell no move; what is left may be such a share of the plan's size at the most."""
ASIDE = 0.4
"""An origin of their own is so far from the pole (a share of the size) at least: a mistake, by which some
points stand elsewhere, looks like one that is nearer."""


class Move(NamedTuple):
    """A turn by quarters, and whether mirrored in the axis of x before: spot = i^turns · due, or its mirror."""

    turns: int
    mirrored: bool = False

    def moved(self, spot: complex) -> complex:
        """Return where a due point was counted."""
        return complex(1j**self.turns * (spot.conjugate() if self.mirrored else spot))

    def back(self, spot: complex) -> complex:
        """Return where a point that was counted stands on the plan."""
        turned = spot * (-1j) ** self.turns
        return complex(turned.conjugate() if self.mirrored else turned)


NONE, HALF = Move(0), Move(2)
MOVES: Mapping[Move, object] = {
    NONE: said("as it is"),
    Move(1): said("turned by 90°"),
    Move(3): said("turned by −90°"),
    Move(2): said("turned by 180°"),
    Move(0, mirrored=True): said("y counted downwards"),
    Move(2, mirrored=True): said("x counted leftwards"),
    Move(1, mirrored=True): said("x and y exchanged"),
    Move(3, mirrored=True): said("x and y exchanged, both with the other sign"),
}
"""The moves, and what is said of them."""


class Placed(NamedTuple):
    """How a plan's points were counted: the move, how many times as large, its pole (mm) by position."""

    move: Move
    times: float
    origins: Mapping[str, complex]


def placed(
    rows: Sequence[Taken],
    spots: Mapping[Key, complex],
    plan: str,
    moves: Collection[Move],
    within: float = NEAR,
) -> Placed | None:
    """Return how the points of a plan were counted; None where they stand as they should, or as nothing tells.

    ``moves`` are tried; a plan whose points are ``within`` so many mm of their due in the median stands right.
    """
    there: defaultdict[str, list[tuple[complex, complex]]] = defaultdict(list)
    for taken in rows:
        if taken.pointed and taken.plan == plan and taken.key in spots:
            there[taken.position].append((taken.spot, spots[taken.key]))
    pairs = {
        name: np.array(some) for name, some in there.items() if sum(abs(z[1]) > NEAR for z in some)
    }
    if sum(len(some) for some in pairs.values()) < FEWEST:
        return None
    tried = {
        (move, own): _left(pairs, move, own=own)
        for move in dict.fromkeys((NONE, *moves))
        for own in (False, True)
        if not own or all(len(some) > 2 for some in pairs.values())
    }
    as_is, size = tried[NONE, False], _size(pairs)
    if as_is[0] <= max(within, 0.03 * size * as_is[1] * within / NEAR):
        return None
    (move, own), best = min(tried.items(), key=lambda one: (one[1][0] / one[1][1], one[0][1]))
    plain = min(
        (one for one in tried.items() if not one[0][1]), key=lambda one: one[1][0] / one[1][1]
    )
    origins = {name: _origin(some, move, best[1]) for name, some in pairs.items()}
    near = own and float(np.median(np.abs([*origins.values()]))) < ASIDE * size * best[1]
    if near or plain[1][0] / plain[1][1] < max(NEAR, 1.5 * best[0] / best[1]):
        (move, own), best = plain
    left, times = best
    if left > MUCH * as_is[0] * NEAR / within or left > FAR * size * times:
        return None
    origins = origins if own else dict.fromkeys(pairs, 0j)
    return Placed(move, times, origins)


def turned_back(found: Mapping[str, Placed | None]) -> dict[str, Placed]:
    """Return plans that are turned by 180° against most others, counted as these: a mistake turned them."""
    moves = Counter(one.move for one in found.values() if one)
    if len(moves) != 2 or any(any(one.origins.values()) for one in found.values() if one):
        return {}
    (most, count), (other, fewer) = moves.most_common()
    opposite = (most.turns - other.turns) % 4 == 2 and most.mirrored == other.mirrored
    if count <= fewer or not opposite:
        return {}
    return {p: Placed(most, one.times, {}) for p, one in found.items() if one and one.move == other}


def _size(pairs: Mapping[str, np.ndarray]) -> float:
    return float(np.median([np.abs(some[:, 1]).max() for some in pairs.values()]))


def _turned(move: Move, due: np.ndarray) -> np.ndarray:
    return np.asarray(1j**move.turns * (due.conj() if move.mirrored else due))


def _left(pairs: Mapping[str, np.ndarray], move: Move, *, own: bool) -> tuple[float, float]:
    """Return how far points are off in the median after a move, and how many times as large the plan is."""
    read, due = [], []
    for some in pairs.values():
        at, to = some[:, 0], _turned(move, some[:, 1])
        read.append(at - at.mean() if own else at)
        due.append(to - to.mean() if own else to)
    a, b = np.concatenate(read), np.concatenate(due)
    far = np.abs(b) > NEAR
    if not far.any():
        return float("inf"), 1.0
    times = float(np.median((a[far] * b[far].conj()).real / np.abs(b[far]) ** 2))
    if times <= 0.0:
        return float("inf"), 1.0
    return float(np.median(np.abs(a - times * b))), times


def _origin(some: np.ndarray, move: Move, times: float) -> complex:
    """Return where the pole of a plan stands in one position, by its points."""
    off = some[:, 0] - times * _turned(move, some[:, 1])
    return complex(np.median(off.real), np.median(off.imag))
