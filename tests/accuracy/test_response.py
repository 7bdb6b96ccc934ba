"""Errors that are expected against errors measured by 1000 other drawings; quantiles against sampling."""

from __future__ import annotations

from math import erf

import numpy as np
import pytest
from support.switched_off import FRESH
from support.tasks import by, measure, scales, scene

from graphic_tmm.accuracy.drawing import References, draw
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.response import Drawing, Response, _erf, responses
from graphic_tmm.accuracy.settings import Setting
from graphic_tmm.accuracy.ways import wanted
from graphic_tmm.board.hand import HANDS, Hand
from graphic_tmm.readers.position_count import at_count

JUMPS = {"J_fly", "J_fly_energy_mass"}
"""Differences of the largest and the least: no sum of small slips."""


def agree(name: str, counts: tuple[int, ...], hands: tuple[str, ...]) -> None:
    references, task = References(scene(name), scales(name)), measure(name)
    for count in counts:
        changed = at_count(scene(name), count)
        (drawing,) = draw(changed, scales(name))
        asked = [q for q in quantities(drawing) if wanted(scene(name), q) and q.name not in JUMPS]
        found = responses(drawing, asked, references)
        for hand in hands:
            for times in (1.0, 2.0):
                one = by(name, hand, 1000, changed)
                fresh = Setting(changed, hand, one.who._replace(seed=FRESH), times)
                runs = task.runs(fresh, "", "", [*found])
                due = {run.quantity: run.error for run in runs}
                told = {
                    k: float(answer.errors([Drawing(HANDS[hand], times)])[0])
                    for k, answer in found.items()
                }
                assert told == pytest.approx(due, rel=0.1), (name, count, hand, times)


@pytest.mark.parametrize("name", ["slider-diagrams", "crank-rocker"])
def test_an_expected_error_is_the_one_measured(name: str) -> None:
    agree(name, (6, 12), ("student", "careful"))


@pytest.mark.turns(1, "expected")
@pytest.mark.slow
@pytest.mark.parametrize("name", ["windrower", "engine", "shaper", "oscillating-cylinder"])
def test_an_expected_error_of_a_careful_hand_is_the_one_measured(name: str) -> None:
    agree(name, (6, 12, 24), ("careful",))


def test_an_error_is_what_nine_readings_of_ten_keep_within() -> None:
    rng = np.random.default_rng(3)
    for wide in (1, 2, 12):
        method, sizes = rng.normal(size=wide), rng.uniform(0.1, 2.0, wide)
        answer = Response(method, {"swing": 0.5 * sizes**2, "prick": 2.0 * sizes**2})
        who = Hand(swing=0.6, prick=0.4)
        spread = sizes * np.sqrt(0.5 * 0.6**2 + 2.0 * (0.4 / 2.0) ** 2)
        readings = np.abs(method + spread * rng.normal(size=(400_000, wide)))
        due = np.quantile(readings, 0.9)
        assert answer.errors([Drawing(who, 2.0)]) == pytest.approx([due], rel=0.005)


def test_without_a_slip_nine_values_of_ten_keep_within_the_methods_own() -> None:
    answer = Response(np.array([*range(1, 20), 1000.0]), {})
    assert answer.errors([Drawing(Hand())]) == pytest.approx([18.0], rel=1e-4)


def test_the_error_function_is_that_of_mathematics() -> None:
    x = np.linspace(-6.0, 6.0, 1201)
    assert _erf(x) == pytest.approx([erf(one) for one in x], abs=2e-7)
    assert _erf(np.array([1e19, -1e19])).tolist() == [1.0, -1.0]


def test_only_what_slips_in_mm_is_less_on_a_larger_drawing() -> None:
    student = HANDS["student"]
    own, large = Drawing(student), Drawing(student, 2.0)
    assert large.slip("swing") == own.slip("swing") == 0.6
    for sort in ("prick", "compass", "reading"):
        assert large.slip(sort) == pytest.approx(own.slip(sort) / 2.0)
    assert own.slip("reading") == pytest.approx(np.hypot(0.75, 0.5 / np.sqrt(12.0)))
