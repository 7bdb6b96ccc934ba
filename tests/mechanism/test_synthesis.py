"""Mechanisms found from a task: the published figures, and the mechanism drawn gives the task back."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.boards import recorded
from support.examples import most

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.errors import TmmError
from graphic_tmm.mechanism.records import Drive, Extreme, Guide, Link, Mechanism, Row, Side, Slide
from graphic_tmm.mechanism.synthesis import rocker, rocker_lengths
from graphic_tmm.project import Project


def coulisse(OA: float, BC: float, OB: float, *, speed: float = 1.0) -> Mechanism:
    """The crank, the stone, the rocker ABC and a slider D on the rocker's arm by a rod as long."""
    along = Guide("BC", 0j, 0.0)
    y = Guide("y", complex(0, -OB - 1.25 * BC), 0.0)
    return Mechanism(
        Link(6, {"O": 0j, "B": complex(0, -OB)}, (y,)),
        (
            Link(1, {"O": 0j, "A": complex(OA, 0)}),
            Link(2, {"A": 0j}, (), (Slide(3, along, side=Side(1)),)),
            Link(3, {"B": 0j, "C": complex(-BC, 0)}, (along,)),
            Link(4, {"C": 0j, "D": complex(BC, 0)}),
            Link(5, {"D": 0j}, (), (Slide(6, y, side=Side(1)),)),
        ),
        Drive(1, speed),
    )


def drawn(lengths: dict[str, float], *, speed: float = 1.0) -> Project:
    row = Row(12, 0, Extreme("C", "left"), (Extreme("C", "right"),))
    return recorded(coulisse(**lengths, speed=speed), row, plans=["positions"])


def ratio_and_stroke(project: Project) -> tuple[float, float]:
    """K_v from the crank's angles at the two extremes of C, and the stroke of C, m."""
    from graphic_tmm.board.execute import execute

    log = project.construction
    mark = KINEMATICS_PLAN.on(project).positions.point("C")
    reading = execute(log, project.given | {KINEMATICS_PLAN.on(project).mu_l: 1.0}, [mark])
    places = np.ravel(reading[mark]).real
    stroke = abs(places[-1] - places[0])
    travelled = (project.coordinates[-1] - project.coordinates[0]) % 360.0
    slow = max(travelled, 360.0 - travelled)
    return slow / (360.0 - slow), float(stroke)


def test_the_windrower_has_the_exact_lengths_of_its_task() -> None:
    found = rocker_lengths(1.45, 0.095, 0.48)
    theta = math.radians(180 * 0.45 / 2.45)
    assert math.isclose(math.degrees(theta), 33.06, abs_tol=5e-3)
    assert math.isclose(found["OA"], 0.48 * math.sin(theta / 2), rel_tol=1e-14)
    assert math.isclose(found["BC"], 0.095 / (2 * math.sin(theta / 2)), rel_tol=1e-14)
    assert round(found["OA"], 5) == 0.13657
    assert round(found["BC"], 5) == 0.16694
    assert found["OB"] == 0.48
    assert round(found["OA"] / 0.004, 2) == 34.14
    assert math.isclose(found["BC"] / 0.004, 41.74, abs_tol=0.006)


def test_the_published_lengths_keep_the_stroke_but_not_the_ratio() -> None:
    ratio, stroke = ratio_and_stroke(drawn({"OA": 0.1176, "BC": 0.1938, "OB": 0.48}))
    theta = 2 * math.degrees(math.asin(0.1176 / 0.48))
    assert round(theta, 2) == 28.36
    assert round(ratio, 3) == 1.374
    assert abs(stroke - 0.095) < 5e-5


def test_the_steps_of_the_synthesis_are_recorded() -> None:
    found = rocker(1.45, 0.095, 0.48)
    assert [step.it.letter for step in found.construction.steps] == ["θ", "l_{OA}", "l_{BC}"]
    assert all(step.op.formula for step in found.construction.steps)
    assert sorted(found.lengths) == ["BC", "OA", "OB"]


@pytest.mark.slow
@settings(max_examples=most(40), deadline=None)
@given(
    K_v=st.floats(1.02, 3.0),
    stroke=st.floats(0.01, 0.3),
    OB=st.floats(0.2, 1.0),
    speed=st.sampled_from([3.0, -3.0]),
)
def test_the_mechanism_found_gives_back_stroke_and_ratio(
    K_v: float, stroke: float, OB: float, speed: float
) -> None:
    lengths = rocker_lengths(K_v, stroke, OB)
    along = Guide("BC", 0j, 0.0)
    small = Mechanism(
        Link(0, {"O": 0j, "B": complex(0, -OB)}),
        (
            Link(1, {"O": 0j, "A": complex(lengths["OA"], 0)}),
            Link(2, {"A": 0j}, (), (Slide(3, along, side=Side(1)),)),
            Link(3, {"B": 0j, "C": complex(-lengths["BC"], 0)}, (along,)),
        ),
        Drive(1, speed),
    )
    project = recorded(
        small, Row(12, 0, Extreme("C", "left"), (Extreme("C", "right"),)), plans=["positions"]
    )
    ratio, found = ratio_and_stroke(project)
    assert math.isclose(ratio, K_v, rel_tol=1e-9)
    assert math.isclose(found, stroke, rel_tol=1e-9)


@pytest.mark.parametrize("K_v", [1.0, 0.5, 0.0])
def test_a_ratio_of_one_or_less_gives_no_crank(K_v: float) -> None:
    """No rocker mechanism swings back no quicker; whatever comes out is no usable pair of lengths."""
    try:
        found = rocker_lengths(K_v, 0.095, 0.48)
    except (TmmError, ValueError):
        return
    assert not (found["OA"] > 0 and math.isfinite(found["BC"]))
