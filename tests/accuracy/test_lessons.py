"""Lessons drawn from runs that are known: slopes, least errors, fronts."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from graphic_tmm.accuracy.cost import Work
from graphic_tmm.accuracy.lessons import best_of, fitted, optima
from graphic_tmm.accuracy.measure import Errors, Run, Seconds


def run(
    n: int, error: float, *, hand: str = "student", spread: float = 0.0, axis: str = "positions"
) -> Run:
    errors = Errors(error, error / 2, spread, 0.0)
    seconds = Seconds(1e-3 * n**0.5, 0.0, 1.0)
    return Run(axis, f"{n}", "V", n, hand, 1.0, 100, errors, Work({}, {}, 5.0 * n), seconds)


def test_powers_of_the_number_of_positions_are_found() -> None:
    runs = [run(n, 300.0 / n**2, hand="exact") for n in (4, 8, 12, 24, 48, 96)]
    runs[0] = run(4, 1e6, hand="exact")  # too few positions to follow the power
    (found,) = fitted(runs)
    assert found.error.slope == pytest.approx(-2.0, abs=1e-9)
    assert found.minutes.slope == pytest.approx(1.0, abs=1e-9)
    assert found.seconds.slope == pytest.approx(0.5, abs=1e-9)


def test_an_optimum_is_told_with_what_is_as_good_and_what_twice_the_work_gives() -> None:
    errors = {6: 30.0, 8: 12.0, 10: 10.2, 12: 10.0, 16: 14.0, 24: 20.0, 48: 50.0}
    (found,) = optima([run(n, e, spread=0.2) for n, e in errors.items()], ["student"])
    assert (found.best.value, found.sure) == ("12", (10, 12))
    assert found.finer is not None
    assert found.finer.value == "24"
    assert (found.inside, found.flat) == (True, False)


def test_an_optimum_at_the_end_is_not_inside_and_a_flat_row_is_told_so() -> None:
    (falling,) = optima([run(n, 100.0 / n) for n in (6, 12, 24)], ["student"])
    assert (falling.best.value, falling.inside, falling.finer) == ("24", False, None)
    (level,) = optima([run(n, 4.0 + 0.001 * n) for n in (6, 12, 24)], ["student"])
    assert level.flat


def test_a_setting_that_could_not_be_drawn_is_no_optimum() -> None:
    runs = [run(n, e) for n, e in ((6, 5.0), (8, 3.0), (12, 4.0), (16, float("nan")))]
    (found,) = optima(runs, ["student"])
    assert found.best.value == "8"


def test_the_front_is_what_no_other_setting_of_the_hand_beats() -> None:
    rng = np.random.default_rng(11)
    runs = [
        run(int(n), float(e)) for n, e in zip(rng.permutation(40) + 1, rng.random(40), strict=True)
    ]
    runs += [run(int(n), 0.01, hand="exact") for n in (3, 5)]
    runs += [run(1, 0.001, axis="ruler"), run(1, 0.001, axis="trials")]
    found = best_of(runs)
    for one in runs[:40]:
        beaten = any(
            o.work.minutes <= one.work.minutes
            and o.error <= one.error
            and (o.work.minutes, o.error) != (one.work.minutes, one.error)
            for o in runs[:40]
        )
        assert (one in found) == (not beaten)
    assert [r.value for r in runs[40:] if r in found] == ["3"]


def test_fronts_of_quantities_and_hands_do_not_mix() -> None:
    runs = [run(n, e, hand=h) for (n, e), h in product([(4, 2.0), (8, 1.0)], ["student", "cad"])]
    assert best_of(runs) == frozenset(runs) == best_of(runs, machine=True)
