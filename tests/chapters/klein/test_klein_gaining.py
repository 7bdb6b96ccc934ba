"""A crank that gains or loses speed: the pentagons of both constructions, the vector loop and the plans."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from chapters.klein.test_klein import STEP, drawn_of, loop, sizes_at_random, speeds, values
from support.boards import in_usual_size

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.klein.record import KLEIN_PLAN
from graphic_tmm.chapters.klein.table import columns
from graphic_tmm.chapters.klein.task import KLEIN, RITTERHAUS, VIEWS
from graphic_tmm.checking.template import rows_of
from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.read import read


def due(phi: float, omega: float, epsilon: float, told: dict[str, Any]) -> dict[str, float]:
    """Return lengths of a_A, a_B, a_C (SI) by the loop: a = ω²·d²r/dφ² + ε·dr/dφ."""
    sizes = told["r"], told["rod"], told["e"], told["c"]
    first = np.array([np.imag(x) / STEP for x in loop(phi + 1j * STEP, *sizes)])
    second = np.array([np.imag(x) / STEP for x in speeds(phi + 1j * STEP, *sizes)])
    a = omega**2 * second + epsilon * first
    pin = told["r"] * math.hypot(omega**2, epsilon)
    return {"a_A": pin, "a_B": math.hypot(*a[:2]), "a_{C}": math.hypot(*a[2:])}


def held(drawn: Drawn, told: dict[str, Any], rates: list[tuple[float, float]]) -> None:
    """Hold both constructions against the loop and the plans; ``rates``: ω, ε in the sense of turning."""
    plans = KINEMATICS_PLAN.on(drawn)
    motion = plans.accelerations
    assert motion is not None
    plan, scale = drawn.of(motion.mu.view), drawn.scales[motion.mu.view]
    assert plan is not None
    images = {
        "a_A": motion.images.by_letter[1]["A"],
        "a_B": motion.images.by_letter[2]["B"],
        "a_{C}": motion.images.by_letter[2]["C"],
    }
    for k, (phi, (omega, epsilon)) in enumerate(zip(drawn.project.coordinates, rates, strict=True)):
        assert phi is not None
        exact = due(math.radians(phi - told["tilt"]), omega, told["sense"] * epsilon, told)
        for letter, value in exact.items():
            within = 1e-9 * max(value, exact["a_A"])
            by_plan = abs(plan[images[letter]][0, k]) * scale.at(k).value
            assert by_plan == pytest.approx(value, abs=within)
            for view in VIEWS:
                found = values(drawn, view)[letter][k]
                assert found == pytest.approx(value, abs=within), (view, letter)
                assert found == pytest.approx(by_plan, abs=within), (view, letter)


@pytest.mark.parametrize("seed", range(24))
def test_both_are_the_loop_and_the_plans(tmp_path: Path, seed: int) -> None:
    """In line and offset, turned guides, both senses, ε either way and up to 3·ω²: to 1e-9."""
    rng = np.random.default_rng(seed + 500)
    told = sizes_at_random(rng)
    epsilon = float(rng.uniform(-3.0, 3.0)) * told["omega"] ** 2
    drawn = drawn_of(tmp_path, **told, drive=f'acceleration = "{epsilon!r} rad/s^2"')
    held(drawn, told, [(told["omega"], epsilon)] * 12)
    for column in columns(drawn):
        if column.unit == "%":
            assert np.all(np.nan_to_num(column.value) == 0.0), column.letter


def test_omega_and_epsilon_may_be_listed_by_positions(tmp_path: Path) -> None:
    """Each position has its own μ_v, μ_a; a position without ε is the quadrilateral."""
    told = sizes_at_random(np.random.default_rng(7)) | {"sense": 1}
    rng = np.random.default_rng(8)
    rates = [(float(rng.uniform(5.0, 40.0)), float(rng.uniform(-900.0, 900.0))) for _ in range(12)]
    rates[4] = rates[4][0], 0.0
    gains = ", ".join(f'"{e!r} rad/s^2"' for _, e in rates)
    path = tmp_path / "drawn"
    path.mkdir()
    drawn_of(path, **told)
    text = (path / "scene.toml").read_text(encoding="utf-8")
    listed = ", ".join(f'"{w!r} rad/s"' for w, _ in rates)
    text = text.replace(f'"{told["omega"]!r} rad/s"\nturns = "counterclockwise"', f"[{listed}]")
    text = text.replace("[klein]", f"acceleration = [{gains}]\n[klein]")
    held(_read(path, text), told, rates)


def _read(folder: Path, text: str) -> Drawn:
    (folder / "scene.toml").write_text(text, encoding="utf-8")
    (found,) = in_usual_size(read(folder / "scene.toml"), exact=True).boards
    return found


@pytest.mark.parametrize("epsilon", [130.0, -420.0])
def test_the_pentagon_is_the_plan_of_accelerations_turned_by_half_a_turn(
    tmp_path: Path, epsilon: float
) -> None:
    """O, A, A′, Q′, N stand to each other as π, n1, a, n2, b."""
    drive = f'acceleration = "{epsilon!r} rad/s^2"'
    drawn = drawn_of(tmp_path, r=0.12, rod=0.3, e=0.04, tilt=35.0, drive=drive)
    plans = KINEMATICS_PLAN.on(drawn)
    assert plans.accelerations is not None
    plan, images = drawn.of("accelerations"), plans.accelerations.images
    assert plan is not None
    for view in VIEWS:
        made, reading = KLEIN_PLAN.on(drawn).figures[view], drawn.of(view)
        assert reading is not None
        pin, _ = made.moved
        for mark, image in ((pin, images.by_letter[1]["A"]), (made.N, images.by_letter[2]["B"])):
            turned = reading[mark] / plan[image]
            assert np.allclose(turned / np.abs(turned), -1.0, rtol=0, atol=1e-9)
            share = drawn.scales["accelerations"].value / (20.0**2 * drawn.scales[view].value)
            assert np.allclose(np.abs(turned), share, rtol=1e-9, atol=0)


def test_where_the_rod_is_square_to_the_crank_the_sides_lie_in_one_line(tmp_path: Path) -> None:
    """AA′ is parallel to the rod there; lengths laid off need no crossing of both."""
    told: dict[str, Any] = {
        "r": 0.1, "rod": 0.3, "e": 0.0, "tilt": 0.0, "c": 0.15 + 0j, "omega": 8.0,
        "sense": 1,
    }  # fmt: skip
    square = math.degrees(math.atan2(0.3, 0.1))
    drawn = drawn_of(tmp_path, **told, at=[square, 200.0], drive='acceleration = "90 rad/s^2"')
    held(drawn, told, [(8.0, 90.0)] * 2)


def test_without_epsilon_nothing_is_recorded_for_it(tmp_path: Path) -> None:
    drawn = drawn_of(tmp_path, r=0.1, rod=0.4, drive='acceleration = "0 rad/s^2"')
    for view in (KLEIN, RITTERHAUS):
        assert KLEIN_PLAN.on(drawn).figures[view].moved == ()
    names = {step.it.name for step in drawn.construction.steps if step.it.view in VIEWS}
    assert not names & {"A′", "Q′", "AA′"}


def test_a_template_states_the_scale_by_its_own_letter(tmp_path: Path) -> None:
    """Sides of the figure are told as velocities first: to μ_v, which follows from μ_l and ω."""
    drawn = drawn_of(tmp_path, r=0.1, rod=0.4, drive='acceleration = "90 rad/s^2"')
    rows = [one for one in rows_of(read(tmp_path / "scene.toml")) if one.plan == KLEIN]
    (stated,) = (one for one in rows if one.segment.startswith("μ"))
    assert (stated.segment, stated.unit) == ("μ_v", "(m/s)/mm")
    scales = drawn.scales
    assert scales["klein μ_v"].value == pytest.approx(20.0 * scales[KLEIN].value, rel=1e-12)


def test_dead_centres_are_right_or_not_there(tmp_path: Path) -> None:
    """Klein's pentagon is there in all of them; Ritterhaus has no Q in one line, so no N either."""
    told: dict[str, Any] = {"r": 0.1, "rod": 0.4, "e": 0.0, "tilt": 0.0, "c": 0.15 + 0j}
    at = [0.0, 90.0, 180.0, 270.0]
    drive = 'acceleration = "-70 rad/s^2"'
    drawn = drawn_of(tmp_path, **told, omega=10.0, at=at, drive=drive)
    klein, other = values(drawn, KLEIN), values(drawn, RITTERHAUS)
    for k, phi in enumerate(at):
        exact = due(math.radians(phi), 10.0, -70.0, told)
        for letter, value in exact.items():
            assert klein[letter][k] == pytest.approx(value, abs=1e-8)
            lost = letter != "a_A" and k in (0, 2)
            assert np.isnan(other[letter][k]) if lost else other[letter][k] == pytest.approx(value)
