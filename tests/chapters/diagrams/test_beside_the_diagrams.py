"""What is calculated beside kinematic diagrams: the time of a turn, the place of the extra position."""

from __future__ import annotations

import math

import numpy as np
import pytest
from support.gallery import asking, drawn, in_usual

from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN
from graphic_tmm.chapters.diagrams.record import BESIDE
from graphic_tmm.chapters.diagrams.task import CALCULATED
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.readers.protocol import protocol


@pytest.mark.parametrize("name", asking("diagrams"))
def test_it_moves_no_mark_of_the_drawing(name: str) -> None:
    log = in_usual(name).construction
    beside = {step.it for step in log.steps if step.it.view == CALCULATED}
    others = [step for step in log.steps if step.it.view != CALCULATED]
    assert beside
    assert not beside & {mark for step in others for mark in step.uses}


def test_a_turn_of_250_rpm_takes_60_over_250_seconds() -> None:
    made = drawn("slider-diagrams", exact=True)
    found = BESIDE.on(made)
    assert made.reading[found.time].item() == pytest.approx(60 / 250, rel=1e-12)
    assert found.places == ()


@pytest.mark.parametrize("name", asking("diagrams"))
def test_extra_positions_stand_as_the_chords_of_the_crank_circle_divide_their_intervals(
    name: str,
) -> None:
    """Chords are as the sines of half the angles; the angle itself divides the base nearly so."""
    made = in_usual(name)
    plans, found = KINEMATICS_PLAN.on(made), BESIDE.on(made)
    numbers = np.ravel(plans.numbers)
    extra = [k for k in range(plans.count, numbers.size) if abs(numbers[k] % 1.0) > 1e-9]
    assert [one.extra for one in found.places] == extra
    base = made.reading[DIAGRAMS_PLAN.on(made).base.length].item()
    step = math.pi / plans.count
    for one in found.places:
        share = numbers[one.extra] - one.before
        assert 0.0 < share < 1.0
        due = math.sin(share * step) / math.sin(step) * base / plans.count
        value = made.reading[one.distance].item()
        assert value == pytest.approx(due, rel=1e-6)
        assert value == pytest.approx(share * base / plans.count, rel=0.02)


def test_some_scene_has_such_a_position_and_tells_it() -> None:
    """Document 003: [6÷*] = [6A*]·[6÷7]/[6A7]."""
    told = [name for name in asking("diagrams") if BESIDE.on(in_usual(name)).places]
    assert told
    for name in told:
        text = "\n".join(protocol(in_usual(name), ("diagrams",), None, "ru"))
        one = BESIDE.on(in_usual(name)).places[0]
        assert f"{one.distance.name} = " in text
        assert "t = 2π/ω_1" in text
