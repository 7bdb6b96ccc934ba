"""The law of motion against the equation of motion in time; rest, several turns, closed forms, refusals."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.flywheels import crank
from support.motion_laws import Machine, machine, motion, written

import graphic_tmm as tmm
from graphic_tmm.chapters.motion_law.plan import LAW_PLAN, Both
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

SLOW = 0.05
"""Below this share of the greatest speed an error is told of that speed: near rest any is large of its own."""


def scene_at(folder: Path, text: str) -> Scene:
    file = folder / "scene.toml"
    file.write_text(text, encoding="utf-8")
    return read(file)


def drawn(folder: Path, of: Machine, count: int, turns: int = 1, *, gas: bool = True) -> Drawn:
    return drawn_of(scene_at(folder, written(of, count, turns, gas=gas)), exact=True)


def series(of: Drawn, both: Both) -> np.ndarray:
    """Return what is known at the positions and at the end of the base."""
    row = of.reading[both.row][0, : of.project.count]
    return np.append(row, of.reading[both.end][0, 0])


def chart(of: Drawn, symbol: str) -> np.ndarray:
    """Return what a graph shows, in SI."""
    law = LAW_PLAN.on(of)
    one = next(one for one in law.charts if one.symbol == symbol)
    rows = [of.reading[mark][0] * of.value(one.mu) for mark in one.ordinates]
    return np.concatenate([rows[0][: of.project.count], *(row[:1] for row in rows[1:])])


def angles(count: int, turns: int = 1) -> np.ndarray:
    return np.arange(count * turns + 1) * 2.0 * np.pi / count


def apart(found: np.ndarray, due: np.ndarray) -> np.ndarray:
    """Return by what share speeds are off."""
    there = np.isfinite(due)
    assert (np.isfinite(found) == there).all(), "the same positions are reached"
    least = SLOW * np.max(due[there])
    return np.asarray(np.abs(found - due)[there] / np.maximum(due[there], least))


def allowed(of: Machine, count: int, turns: int = 1) -> float:
    """What the number of positions allows of the energy, J.

    Between ordinates h apart the moment is off its chord by h²/8·M″ at most, the area below by h³/12·M″; the
    curve that is drawn leaves its chord by as much as its tangents do, that is by two second differences of
    the row, h³/6·M″: h³/4·M″ for every interval.
    """
    h, phi = 2.0 * np.pi / count, np.arange(1440) * np.pi / 720
    moment = of.M(phi)
    bend = np.max(np.abs(np.diff(moment, 2, append=moment[:2]))) / (np.pi / 720) ** 2
    return float(turns * 2.0 * np.pi * h**2 * bend / 4.0)


def test_the_speed_is_that_of_the_equation_of_motion(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    """From rest, running, braked to rest: with gas and with loads, at 12 and 360 positions."""
    for seed in range(many(200, 6)):
        of = machine(seed)
        for count in (12, 360) if seed % 5 == 0 else (24,):
            due = motion(of, angles(count))
            made = drawn(tmp_path, of, count, gas=bool(seed % 2))
            found = series(made, LAW_PLAN.on(made).omega)
            if count == 360:
                assert np.max(apart(found, due.omega)) < 1e-3
            there = np.isfinite(due.omega)
            assert (np.isfinite(found) == there).all()
            energy = of.J(angles(count)) * (found**2 - due.omega**2) / 2.0
            assert np.max(np.abs(energy[there])) < allowed(of, count) + 1e-6 * of.J(0.0)


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_time_acceleration_and_the_end_of_the_motion(tmp_path: Path, seed: int) -> None:
    of, count = machine(seed), 360
    made = drawn(tmp_path, of, count)
    law, due = LAW_PLAN.on(made), motion(of, angles(count))
    far, late = due.rest if np.isfinite(due.rest[0]) else (2.0 * np.pi, due.time[-1])
    assert made.value(law.angle) == pytest.approx(far, rel=1e-4)
    assert made.value(law.time) == pytest.approx(late, rel=1e-3)
    time, there = chart(made, "t"), np.isfinite(due.time)
    assert time[there] == pytest.approx(due.time[there], abs=1e-3 * late)
    # an interval's mean is the value in its middle but for the bend of the curve there
    middle = (angles(count)[1:] + angles(count)[:-1]) / 2.0
    omega = np.sqrt((due.omega[1:] ** 2 + due.omega[:-1] ** 2) / 2.0)
    gain = np.array([of.gain(*one) for one in zip(middle, omega, strict=True)])
    found, there = chart(made, "ε"), np.isfinite(gain)
    assert found[there] == pytest.approx(gain[there], abs=5e-3 * np.max(np.abs(gain[there])))


def test_the_second_turn_goes_on_where_the_first_ended(tmp_path: Path) -> None:
    of = machine(0)
    made = drawn(tmp_path, of, 120, 3, gas=False)
    due = motion(of, angles(120, 3))
    assert np.max(apart(series(made, LAW_PLAN.on(made).omega), due.omega)) < 1e-3
    assert chart(made, "t") == pytest.approx(due.time, rel=1e-3, abs=1e-3 * due.time[-1])


def disc(moment: float, start: float) -> Machine:
    """A crank with a flywheel beside which its links are nothing, under a constant moment."""
    light = crank(3)._replace(masses=(1e-9, 1e-9), inertia=1e-12, pressure=lambda phi: 0.0 * phi)
    return Machine(light, moment, 2.0, start)


@pytest.mark.parametrize(("moment", "start"), [(40.0, 0.0), (25.0, 3.0), (-9.0, 6.0)])
def test_an_even_acceleration_is_exact(tmp_path: Path, moment: float, start: float) -> None:
    """ω² = ω_0² + 2εφ, ω = ω_0 + εt: the chords of a parabola have its slopes in their middles."""
    made = drawn(tmp_path, disc(moment, start), 12)
    law, gain, phi = LAW_PLAN.on(made), moment / 2.0, angles(12)
    square = start**2 + 2.0 * gain * phi
    omega = np.where(square >= 0.0, np.sqrt(np.maximum(square, 0.0)), np.nan)
    assert series(made, law.omega) == pytest.approx(omega, rel=1e-7, abs=1e-7, nan_ok=True)
    found = chart(made, "ε")
    assert found[np.isfinite(found)] == pytest.approx(gain, rel=1e-6)
    late = (omega[-1] - start) / gain if moment > 0.0 else start / -gain
    far = phi[-1] if moment > 0.0 else start**2 / (-2.0 * gain)
    assert made.value(law.time) == pytest.approx(late, rel=1e-6)
    assert made.value(law.angle) == pytest.approx(far, rel=1e-6)


def told(folder: Path, text: str) -> str:
    return "\n".join(warnings(drawn_of(scene_at(folder, text), exact=True), "en"))


def test_a_machine_that_stops_says_where_and_when(tmp_path: Path) -> None:
    of = disc(-9.0, 6.0)
    says = told(tmp_path, written(of, 12))
    assert "comes to rest at φ = 229.2° after 1.33 s" in says
    made = drawn(tmp_path, of, 12)
    law = LAW_PLAN.on(made)
    omega = series(made, law.omega)
    assert np.isfinite(omega[:8]).all()
    assert np.isnan(omega[8:]).all()


def test_a_machine_that_does_not_start_says_so(tmp_path: Path) -> None:
    of = disc(-9.0, 0.0)
    assert "the machine does not start" in told(tmp_path, written(of, 12))
    assert np.isnan(series(made := drawn(tmp_path, of, 12), LAW_PLAN.on(made).omega)[1:]).all()


def test_every_honest_hand_comes_to_the_end(tmp_path: Path) -> None:
    scene = scene_at(tmp_path, written(machine(0), 12))
    found = tmm.draw(scene, hand="student", trials=60).results["motion_time"].trials
    exact = tmm.draw(scene, hand="exact").results["motion_time"].value
    assert np.isfinite(found).all()
    assert abs(np.median(found) - exact) < 0.05 * exact


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ("turns = 2\n[flywheel]\ndelta = 0.04\n", "a flywheel is drawn over one cycle"),
        ("turns = 3\n", "an indicator diagram is drawn over one cycle"),
        ("start = -1\n", "motion_law.start"),
        (
            '[[spring]]\nbetween = ["A", "B"]\ndamping = "150 N*s/m"\n[forces]\n',
            "the force of a damper depends on the speed",
        ),
    ],
)
def test_what_it_cannot_take_is_refused(tmp_path: Path, more: str, says: str) -> None:
    text = written(machine(0), 12)
    at = text.index("turns = 1")
    lines = text.replace("turns = 1\n", "") if "turns" in more else text
    with pytest.raises(SceneError) as caught:
        scene_at(tmp_path, lines[:at] + more + lines[at:].removeprefix("turns = 1\n"))
    assert says in str(caught.value)


def test_without_a_moment_there_is_nothing_to_draw(tmp_path: Path) -> None:
    text = written(disc(40.0, 0.0), 12)
    text = text.replace("M = 40.0\n", "").replace("[indicator]", "[[cylinder]]")
    head, _, tail = text.partition("[[cylinder]]")
    with pytest.raises(SceneError, match="nothing drives or resists"):
        scene_at(tmp_path, head + tail[tail.index("[motion_law]") :])


def test_a_base_whose_end_is_read_with_a_ruler_is_gone_to_its_end(tmp_path: Path) -> None:
    """On 133.33 mm a ruler of 0.1 mm reads 133.3: that is no rest."""
    text = written(disc(40.0, 0.0), 12)
    rough = text.replace("turns = 1\n", 'turns = 1\nbase = "133.33 mm"\n')
    made = drawn_of(scene_at(tmp_path, rough.replace('ruler = "exact"', 'ruler = "0.1 mm"')))
    assert made.value(LAW_PLAN.on(made).angle) < 2.0 * np.pi * (1.0 - 1e-4)
    assert not [one for one in warnings(made, "en") if "comes to rest" in one]
