"""A mechanism at every degree: at positions it is the sheet's, between them that of vector loops."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support import gallery
from support.boards import drawn_of
from support.command import invoke
from support.drives import BOOM, LEVER, SLIDER, scene
from support.linkages import four_bar
from support.mechanisms import Sampled, sample
from support.oracle import OracleError, solve_fast
from support.scenes import calling

import graphic_tmm as tmm
from graphic_tmm.board.values import Curve, arrays
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import PLANS
from graphic_tmm.drawn import Drawn
from graphic_tmm.mechanism.records import Mechanism, Row
from graphic_tmm.page.dense import Dense, dense
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import make


def _dense(drawn: Drawn) -> Dense:
    found = dense(drawn)
    assert found is not None
    return found


def _scene(mechanism: Mechanism, zero: float, language: str = "en") -> Scene:
    row = Row(12, 0, zero, (), ("all",))
    sheets = (SheetOrder("A1", PLANS),)
    return Scene("random", "random", language, mechanism, row, sheets=sheets)


@pytest.mark.parametrize("name", gallery.NAMES)
def test_marks_at_the_positions_are_those_of_the_exact_hand(name: str) -> None:
    found = _dense(gallery.in_usual(name))
    own, due = found.drawn.reading, found.sheet.numbers.drawn
    seen, at, row = 0, list(found.at), found.sheet.project.count
    for step in found.sheet.construction.steps:
        mark = step.it
        if mark not in own or mark not in due or mark.kind is Curve or mark.view == "extremes":
            continue
        seen += 1
        for dense_, exact in zip(arrays(own[mark]), arrays(due[mark]), strict=True):
            told = dense_[0, at] if dense_.shape[1] > 1 else dense_[0]
            size = np.nanmax(np.abs(exact), initial=1.0)
            # a load given by position is known at the extras too, where the sheet has none
            there = np.isfinite(exact[0]) | (np.arange(exact.shape[1]) < row)
            apart = np.broadcast_to(np.abs(told - exact[0]), there.shape)[there]
            assert np.all((apart <= 1e-9 * size) | np.isnan(apart)), mark
            assert not np.any(
                np.isnan(apart) & np.isfinite(np.broadcast_to(exact[0], there.shape)[there])
            )
    assert seen > 20


def _follows(one: Sampled, found: Dense) -> int:
    """Compare places and velocities with vector loops from degree to degree; how many were compared."""
    made, reading, poses = KINEMATICS_PLAN.on(found.drawn), found.drawn.reading, one.poses
    mu_l, mu_v = (found.drawn.scales[plan].value for plan in PLANS[:2])
    origin = one.mechanism.frame.points[made.structure.origin]
    speed, compared = abs(one.mechanism.drive.speed), 0
    assert made.velocities is not None
    for k in range(found.whole):
        if k in found.drawn.undrawn:
            break
        try:
            state = solve_fast(one.mechanism, float(found.angles[k]), poses)
        except OracleError:
            break
        if state.condition > 1e5 or not np.isfinite(state.condition):
            break  # near a change point either assembly may follow
        poses = state.pose
        for link in one.mechanism.links:
            for letter in link.points:
                due = state.points[letter, link.number]
                mark = made.positions.bodies[link.number].marks[letter]
                image = made.velocities.images.by_letter[link.number][letter]
                for value, wanted, size in (
                    (origin + _at(reading[mark], k) * mu_l, due[0], state.size),
                    (_at(reading[image], k) * mu_v, due[1], state.size * speed),
                ):
                    assert abs(value - wanted) <= 1e-8 * state.condition * max(size, abs(wanted))
        compared += 1
    return compared


def _at(value: np.ndarray, k: int) -> complex:
    return complex(value[0, k if value.shape[1] > 1 else 0])


@pytest.mark.turns(1)
@pytest.mark.parametrize("seed", range(3))
def test_between_positions_marks_are_what_vector_loops_say(seed: int) -> None:
    """Mechanisms with groups of every kind, one to three of them."""
    assert_follows(seed)


@pytest.mark.slow
def test_between_positions_more_are_what_vector_loops_say(many: Callable[[int, int], int]) -> None:
    for seed in range(3, many(20, 5)):
        assert_follows(seed)


def assert_follows(seed: int) -> None:
    compared = 0
    for one in sample(4, seed=seed):
        if any(link.side is not None and link.side.flips_at for link in one.mechanism.links):
            continue
        found = _dense(drawn_of(_scene(one.mechanism, one.phi), exact=True))
        compared += _follows(one, found)
    assert compared > 40


def test_a_mechanism_that_does_not_assemble_has_its_gap_and_its_reason() -> None:
    """A four-bar: where its pins A and C are farther apart than rod and rocker together reach, no arcs meet."""
    r, rod, rocker, base = 0.3, 0.3, 0.25, 0.4
    drawn = drawn_of(_scene(four_bar(r, rod, rocker, complex(base)), 60.0), exact=True)
    found = _dense(drawn)
    angles = np.radians(found.angles)
    apart = np.abs(r * np.exp(1j * angles) - base)
    due = {int(k) for k in np.flatnonzero(apart > rod + rocker)}
    assert due
    assert set(found.drawn.undrawn) == due
    assert set(found.why) == due
    assert all("'B'" in says for says in found.why.values())
    russian = _dense(
        drawn_of(_scene(four_bar(r, rod, rocker, complex(base)), 60.0, "ru"), exact=True)
    )
    assert all("шаг" in says for says in russian.why.values())


def test_positions_off_whole_degrees_have_angles_of_their_own() -> None:
    found = _dense(gallery.in_usual("windrower"))
    names = found.sheet.names
    assert found.at[:12] == tuple(range(0, 360, 30))
    assert found.turned.size == found.whole + 1
    assert found.at[names.index(next(n for n in names if "*" in n))] == found.whole


def test_a_cycle_of_two_turns_goes_over_both() -> None:
    found = _dense(gallery.in_usual("four-stroke"))
    assert found.whole == 720
    assert found.at[1] == 30


def test_loads_and_pressures_stand_on_what_is_drawn() -> None:
    """The pressure between two positions is read off the diagram drawn: it stays between their pressures."""
    found = _dense(gallery.in_usual("engine"))
    log, reading, exact = found.sheet.construction, found.drawn.reading, found.sheet.numbers.drawn
    high = next(s.it for s in log.steps if s.it.view == "indicator" and s.it.letter == "h_k")
    told, given = reading[high][0], exact[high][0]
    np.testing.assert_allclose(told[::30], given, rtol=1e-9)
    for k in range(12):
        low, high = sorted((given[k], given[(k + 1) % 12]))
        between = told[30 * k : 30 * (k + 1)]
        assert np.all((between >= low * (1 - 1e-9)) & (between <= high * (1 + 1e-9)))
        assert low == high or np.ptp(between) > 0.5 * (high - low)


@pytest.mark.slow
def test_a_plan_of_no_position_is_drawn_at_no_degree(tmp_path: Path) -> None:
    """Forces of inertia need accelerations; a page shows no plan of them that the sheets do not have."""
    path = calling(tmp_path, "effects", "load", "forces")
    drawn = make(read(path)).mechanism
    assert drawn is not None
    assert drawn.project.rows["accelerations"] == ()
    there = _dense(drawn).drawn
    assert there.of("accelerations") is None
    assert there.of("velocities") is not None
    assert invoke("page", path, "-o", tmp_path / "out").exit_code == 0


@pytest.mark.parametrize("outside", [False, True])
@pytest.mark.parametrize("text", [BOOM, SLIDER, LEVER])
def test_a_row_with_ends_is_drawn_from_one_to_the_other(text: str, outside: bool) -> None:
    extra = {BOOM: '"655 mm"', SLIDER: '"0.3011 m"', LEVER: '"33.3 deg"'}[text]
    text, plain = f"{text}extra = [{extra}]\n" if outside else text, text
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        made = tmm.draw(scene(text), exact=True)._work.drawn_scene
        assert made.mechanism is not None
        found = _dense(made.mechanism)
    ends = [
        one for one in (made.mechanism.project.coordinates[k] for k in (0, 5)) if one is not None
    ]
    assert found.ends
    assert [found.angles[0], found.angles[found.whole - 1]] == pytest.approx(ends, abs=1e-12)
    assert np.ptp(np.diff(found.angles[: found.whole])) < 1e-12 * abs(ends[1])
    own = found.angles[list(found.at)]
    assert own == pytest.approx(
        [one or 0.0 for one in made.mechanism.project.coordinates], abs=1e-12
    )
    motion = tmm.motion(scene(text), found.angles, exact=True)
    reading, plans = found.drawn.reading, KINEMATICS_PLAN.on(found.drawn)
    assert plans.velocities is not None
    for link, rate in plans.velocities.rates.items():
        own = np.broadcast_to(reading[rate][0], found.angles.shape)
        np.testing.assert_allclose(own, motion.omega[link], rtol=1e-9)
    assert found.named(0, "en") == {BOOM: "600.0 mm", SLIDER: "250.0 mm", LEVER: "20.0°"}[plain]
    assert found.drawn.names[0] == {BOOM: "600 mm", SLIDER: "250 mm", LEVER: "20°"}[plain]
