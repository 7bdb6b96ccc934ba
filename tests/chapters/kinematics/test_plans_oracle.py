"""Every plan against vector loops that know nothing of plans."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from support.compare import errors
from support.examples import most
from support.mechanisms import KINDS, Sampled, mechanisms, sample

RATIO = 1e-9


def _within(drawn: Sampled, turned: bool) -> None:
    found = errors(drawn, turned=turned)
    assert max(found.values()) <= RATIO, (found, drawn.kinds)


def test_accelerations_of_stones_on_guides_that_turn() -> None:
    """In chains of groups, every day: a wrong Coriolis term is seen here."""
    for turned in (False, True):
        for drawn in sample(12, seed=1000 + turned, dyads=(1, 3), kinds=["RPR", "PRP", "RPP"]):
            _within(drawn, turned)


@pytest.mark.slow
@pytest.mark.parametrize("turned", [False, True])
@settings(max_examples=most(60), deadline=None, suppress_health_check=list(HealthCheck))
@given(drawn=mechanisms())
def test_all_plans_equal_the_vector_loops(turned: bool, drawn: Sampled) -> None:
    _within(drawn, turned)


@pytest.mark.parametrize("kind", KINDS)
def test_one_group_of_each_kind(kind: str) -> None:
    for drawn in sample(60, seed=KINDS.index(kind), dyads=(1, 1), kinds=[kind]):
        _within(drawn, turned=False)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_chains_of_groups(seed: int) -> None:
    for drawn in sample(100, seed=1000 + seed, dyads=(2, 3)):
        _within(drawn, turned=bool(seed % 2))
