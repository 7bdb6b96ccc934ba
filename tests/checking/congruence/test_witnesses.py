"""Witnesses of a scale factor, by lengths of a hand that is written here."""

from __future__ import annotations

import math

import numpy as np
import pytest

from graphic_tmm.checking.congruence.lengths import Group, Rate, Read
from graphic_tmm.checking.congruence.witnesses import of_siblings, rounded, unit_of, verdict

GROUP = Group("velocities", 0.025, "m/s", (1,))
DUE = {"ab": (40.0, 62.0, 55.0, 31.0, 20.0), "pb": (70.0, 35.0, 12.0, 48.0, 66.0)}
LONG = 80.0


def lengths(times: float, slip: float = 0.8, *, mu: float | None = None) -> list[Read]:
    rng, found = np.random.default_rng(11), []
    for place in range(5):
        for name, due in (("pa", LONG), *((name, row[place]) for name, row in DUE.items())):
            mm = times * due if name == "pa" else times * due + slip * rng.standard_normal()
            value = math.nan if mu is None else mu * mm
            found.append(Read(str(place), name, mm, due, value, laid=name == "pa"))
    return found


def rates(some: list[Read], times: float) -> list[Rate]:
    """Return ω as somebody calculates it from ab whose scale factor is 1/times of the due one."""
    return [
        Rate(one.position, "omega2", one.mm / times, one.due) for one in some if one.segment == "ab"
    ]


@pytest.mark.parametrize("times", [0.5, 0.625, 1.25, 2.0])
def test_lengths_alone_say_a_round_one(times: float) -> None:
    found = verdict(GROUP, lengths(times), ())
    assert found.times == pytest.approx(times)
    assert found.by == "round"


def test_rates_say_it_exactly() -> None:
    some = lengths(1.137)
    found = verdict(GROUP, some, rates(some, 1.137))
    assert (found.by, found.agree) == ("rates", 5)
    assert found.times == pytest.approx(1.137, rel=1e-9)


def test_rates_by_the_due_scale_factor_speak_against_it() -> None:
    some = lengths(0.5)
    found = verdict(GROUP, some, rates(some, 1.0))
    assert (found.by, found.times) == ("", 1.0)
    assert found.against == pytest.approx((0.5, 1.0))


def test_rows_say_it_even_where_lengths_are_wrong() -> None:
    some = [one._replace(mm=one.mm * (1.4 if one.segment == "pb" else 1.0)) for one in lengths(1.0)]
    rows = [one._replace(value=0.02 * one.mm) for one in some]
    found = verdict(GROUP, rows, ())
    assert found.by == "rows"
    assert found.times == pytest.approx(1.25)


def test_one_segment_that_is_longer_is_no_scale_factor() -> None:
    """Neither pa alone, nor all but pa."""
    own = [one._replace(mm=1.25 * one.mm) if one.laid else one for one in lengths(1.0)]
    assert verdict(GROUP, own, ()).times == 1.0
    others = [one if one.laid else one._replace(mm=1.25 * one.mm) for one in lengths(1.0)]
    assert verdict(GROUP, others, ()).times == 1.0


def test_a_hand_in_the_due_scale_factor_is_never_told_another() -> None:
    for seed in range(200):
        rng = np.random.default_rng(seed)
        some = [one._replace(mm=abs(one.due + 1.2 * rng.standard_normal())) for one in lengths(1.0)]
        assert verdict(GROUP, some, ()).times == 1.0, seed


def test_a_few_lengths_share_the_scale_factor_of_others() -> None:
    other = Group("forces", 4.0, "N", (0, 1))
    by = verdict(GROUP, lengths(1.25), ())
    single = [Read("1", "R01", 121.0, 93.9)]
    found = of_siblings(other, single, 4.0 / 1.28, by)
    assert found is not None
    assert found.times == pytest.approx(1.28)
    assert of_siblings(other, [Read("1", "R01", 94.5, 93.9)], 4.0 / 1.28, by) is None


@pytest.mark.parametrize(
    ("mu", "near"), [(0.01994, 0.02), (0.0251, 0.025), (7.4, 7.5), (9.6, 10.0)]
)
def test_the_nearest_round_number(mu: float, near: float) -> None:
    assert rounded(mu) == pytest.approx(near)


def test_a_short_first_vector_is_known_no_better_than_it_can_be_read() -> None:
    """26 mm long, and read off the drawing with the slip of all others: these say it more exactly."""
    rng = np.random.default_rng(2)
    first = [
        one._replace(due=26.0, mm=1.25 * 26.0 + off, laid=True)
        for one, off in zip(lengths(1.25)[::3], (1.3, -0.9, 1.0, -1.2, 0.2), strict=True)
    ]
    rest = [one for one in lengths(1.25) if not one.laid for _ in range(4)]
    some = [one._replace(mm=one.mm + 0.7 * rng.standard_normal()) for one in rest]
    found = verdict(GROUP, [*first, *some], ())
    assert found.times == pytest.approx(1.25, rel=1e-6)


@pytest.mark.parametrize(
    ("times", "unit"),
    [
        (1.0 / 25.4, "inch"),
        (2.0 / 25.4, "inch"),
        (0.1, "cm"),
        (0.08, "cm"),
        (0.0637, "cm"),
        (1.0, ""),
    ],
)
def test_inches_are_told_where_they_alone_make_a_scale_factor_round(
    times: float, unit: str
) -> None:
    assert unit_of([(GROUP, math.log(times))]) == unit
