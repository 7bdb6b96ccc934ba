"""Drawings by the hundred: every kind of mistake, two at once, honest ones by six hands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import count, islice, product
from typing import Any

import numpy as np

from support.another_hand import MODES
from support.students.kinds import AtStep, Kind
from support.students.pairs import two
from support.students.planting import Planted, honest_drawings, plant
from support.students.writing import ALL

MACHINES = tuple(ALL)
RULERS = (0.5, 1.0, 0.5, 0.1)
HANDS: dict[str, dict[str, Any]] = {
    "fitted hand": {},
    "ruler of 1 mm": {"ruler": 1.0},
    "compass +2 %": {"compass": 1.02},
    "copy at 98 %": {"copy": 0.98},
    "pole 2 mm off": {"pole": 1.6 + 1.2j},
    "tails of t, 3 degrees": {"tails": 3},
}
"""Honest hands; the first two are what a student is taken for."""


def planted(
    kinds: Sequence[Kind],
    wanted: int,
    seed: int,
    machines: Sequence[str] = MACHINES,
    modes: Sequence[str] = MODES,
) -> Iterator[Planted]:
    """Yield so many drawings with one mistake: the kinds take turns, each over the mechanisms that have it.

    What does not show is yielded too.
    """
    order = np.random.default_rng(seed).permutation(len(kinds))
    at = {k: k for k in range(len(kinds))}

    def each() -> Iterator[Planted]:
        for turn in range(wanted):
            for k in order:
                for _ in machines:
                    at[k] += 1
                    own = seed + 100_000 * turn + 100 * int(k) + at[k] % 100
                    mode, ruler = modes[(k + turn) % len(modes)], RULERS[(k + turn) % len(RULERS)]
                    one = plant(kinds[k], machines[at[k] % len(machines)], own, mode, ruler)
                    if one is not None:
                        yield one
                        break

    return islice(each(), wanted)


def pairs(
    kinds: Sequence[Kind],
    wanted: int,
    seed: int,
    machines: Sequence[str] = MACHINES,
    modes: Sequence[str] = MODES,
) -> Iterator[Planted]:
    """Yield so many drawings with two mistakes that show."""
    steps = [kind for kind in kinds if isinstance(kind, AtStep)]
    rng = np.random.default_rng(seed)

    def each() -> Iterator[Planted]:
        for turn in count():
            a, b = rng.choice(len(steps), 2, replace=False)
            machine, mode = machines[(turn // 4) % len(machines)], modes[turn % len(modes)]
            one = two(steps[a], steps[b], machine, seed + turn, mode)
            if one is not None:
                yield one

    return islice(each(), wanted)


def honest(
    hand: str,
    wanted: int,
    seed: int,
    machines: Sequence[str] = MACHINES,
    modes: Sequence[str] = MODES,
) -> Iterator[Planted]:
    """Yield so many honest drawings by a hand, over all mechanisms and modes."""
    turns = list(product(machines, modes))
    for k in range(wanted):
        machine, mode = turns[k % len(turns)]
        yield from honest_drawings(machine, mode, range(seed + k, seed + k + 1), **HANDS[hand])
