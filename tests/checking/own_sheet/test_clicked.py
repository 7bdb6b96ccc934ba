"""A student's own scale factors, turns and scene, as clicked plans tell them."""

from __future__ import annotations

import functools
from pathlib import Path

import numpy as np
import pytest

from graphic_tmm.checking.cells import points
from graphic_tmm.checking.own_sheet.clicked import (
    ClickedPlan,
    ClickedScale,
    first_letter,
    own_scales,
    plans_of,
    scene_in,
    turn_notes,
)
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SheetError
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

CASES = Path(__file__).parents[2] / "cases" / "check"


@functools.cache
def slider_crank() -> DrawnScene:
    return make(read(CASES / "sc.toml"), exact=True)


def clicked(times: float, turn: complex = 1.0, off: float = 0.0) -> list[ClickedPlan]:
    """All velocity plans as somebody clicks them, so many times as large, some mm off."""
    random = np.random.default_rng(3)
    due = points(slider_crank())
    found = []
    for k in range(8):
        pole = complex(*random.uniform(50, 400, 2))
        slip = off * complex(*random.standard_normal(2))
        first = pole + times * turn * due["velocities", "a", str(k)] + slip
        found.append(ClickedPlan("velocities", str(k), pole, first))
    return found


def test_plans_are_read_as_they_are_clicked() -> None:
    assert plans_of(["velocities:3=10,20.5,30,40", "accelerations:1*=1,2"]) == (
        ClickedPlan("velocities", "3", 10 + 20.5j, 30 + 40j),
        ClickedPlan("accelerations", "1*", 1 + 2j),
    )


@pytest.mark.parametrize(
    "text",
    ["", "velocities:3", "velocities:3=1", "velocities:3=1,2,3", "velocities=1,2", "a:1=x,2"],
)
def test_a_plan_that_says_too_little_is_refused(text: str) -> None:
    with pytest.raises(SheetError, match="--plan: write plan, position"):
        plans_of([text])


@pytest.mark.parametrize("times", [0.5, 0.625, 1.25, 2.0])
def test_a_round_scale_factor_is_told_through_the_slips_of_clicks(times: float) -> None:
    scale = own_scales(slider_crank(), clicked(times, off=0.4))["velocities"]
    assert scale.another
    assert scale.mu == pytest.approx(0.025 / times, rel=1e-9)


def test_one_that_is_not_round_is_told_to_a_share_of_a_percent() -> None:
    scale = own_scales(slider_crank(), clicked(0.905, off=0.2))["velocities"]
    assert scale.mu == pytest.approx(0.025 / 0.905, rel=5e-3)
    assert scale.mu != pytest.approx(0.025 / 0.905, rel=1e-9)


@pytest.mark.parametrize("times", [1.0, 1.002, 0.998])
def test_the_scenes_own_is_nothing_to_be_told(times: float) -> None:
    scales = own_scales(slider_crank(), clicked(times, off=0.2))
    assert not scales["velocities"].another
    assert scene_in(slider_crank(), scales) is slider_crank()
    assert turn_notes(scales.values(), "en") == ()


def test_a_pole_alone_tells_no_scale_factor() -> None:
    plan = clicked(2.0)[0]._replace(first=None)
    assert own_scales(slider_crank(), [plan])["velocities"].mu == 0.025


def test_of_one_wrong_first_vector_the_others_tell() -> None:
    some = clicked(1.25)
    wrong = some[2]._replace(first=some[2].pole + 0.4 * (some[2].first - some[2].pole))
    scale = own_scales(slider_crank(), [*some[:2], wrong, *some[3:]])["velocities"]
    assert scale.mu == pytest.approx(0.02, rel=1e-9)


@pytest.mark.parametrize(
    ("turn", "due"), [(1, (1,)), (1j, (1, 1j)), (-1j, (1, -1j)), (-1, (1,)), (np.exp(0.5j), (1,))]
)
def test_plans_may_be_turned_by_a_quarter_and_by_nothing_else(
    turn: complex, due: tuple[complex, ...]
) -> None:
    assert own_scales(slider_crank(), clicked(1.25, turn))["velocities"].turns == due


def test_the_scene_is_drawn_again_in_the_students_scale_factor() -> None:
    scales = own_scales(slider_crank(), clicked(1.25))
    own = scene_in(slider_crank(), scales)
    due, found = points(slider_crank()), points(own)
    key = ("velocities", "s2", "3")
    assert found[key] == pytest.approx(1.25 * due[key])
    assert found["accelerations", "b", "3"] == pytest.approx(due["accelerations", "b", "3"])
    turned = scales["velocities"]._replace(turns=(1j,))
    assert "turned by 90°" in turn_notes([turned], "en")[0]


def test_a_scene_that_is_read_off_a_ruler_is_drawn_again_in_the_scale_factors_that_were_clicked() -> (
    None
):
    made = make(read(CASES / "fb.toml"))
    assert not made.exact
    assert made.mechanism is not None
    due = {plan: made.mechanism.scales[plan].value for plan in ("velocities", "accelerations")}
    scales = {plan: ClickedScale(plan, 1.25 * mu, mu, "") for plan, mu in due.items()}
    own = scene_in(made, scales).mechanism
    assert own is not None
    for plan, mu in due.items():
        assert own.scales[plan].value == pytest.approx(1.25 * mu, rel=1e-6)


@pytest.mark.parametrize("machine", ["sc", "fb", "rpr"])
def test_a_plan_begins_with_the_crank_s_pin_and_not_with_a_pivot(machine: str) -> None:
    made = make(read(CASES / f"{machine}.toml"), exact=True)
    letters = [first_letter(made, plan) for plan in ("positions", "velocities", "accelerations")]
    assert letters == ["A", "a", "a"]
