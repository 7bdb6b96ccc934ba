"""Every reaction, the balancing force and the lever against Newton's and Euler's equations."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest
from support.loaded import RATIO, errors, order_of, solve, weighed
from support.mechanisms import KINDS, Sampled, sample


def check(drawn: Sampled, seed: int) -> None:
    one = weighed(drawn, seed)
    pick = random.Random(seed)
    gravity, inertia, turned = (bool(pick.randint(0, 3)) for _ in range(3))
    order = order_of(
        one,
        gravity=gravity,
        inertia=inertia,
        balance=pick.choice(("force", "moment")),
        couples=pick.choice(("moment", "pair")),
    )
    solved = solve(one, drawn.phi, drawn.poses, order, turned=turned)
    found = errors(solved)
    assert max(found.values()) <= RATIO, (found, drawn.kinds, seed, solved.judge.condition)


@pytest.mark.parametrize("kind", KINDS)
def test_one_group_of_each_kind(kind: str, many: Callable[[int, int], int]) -> None:
    count = many(60, 6)
    for k, drawn in enumerate(sample(count, seed=KINDS.index(kind), dyads=(1, 1), kinds=[kind])):
        check(drawn, k)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_chains_of_groups(seed: int) -> None:
    for k, drawn in enumerate(sample(50, seed=1000 + seed, dyads=(2, 3))):
        check(drawn, 100 * seed + k)
