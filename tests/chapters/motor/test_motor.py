"""Machines that a motor drives, against the equation of motion in time: run-up, steady cycle, δ, stalling."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of, in_usual_size
from support.flywheels import crank
from support.motion_laws import Catalogue, Machine, driven, machine, motion, written

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.motion_law.plan import LAW_PLAN
from graphic_tmm.chapters.motion_law.table import law_results
from graphic_tmm.chapters.motion_law.views import law_views
from graphic_tmm.chapters.motor.task import MOTOR, RUN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError
from graphic_tmm.fitting.absent import without_absent
from graphic_tmm.language.symbols import symbol
from graphic_tmm.note.section_conclusions import conclusions
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read

TURN = 2.0 * np.pi


def drawn(
    folder: Path, of: Machine, count: int, turns: int = 1, *, more: str = "", step: int = 1
) -> Drawn:
    file = folder / "scene.toml"
    text = written(of, count, turns, gas=turns == 1, more=more)
    file.write_text(text.replace("step = 1\n", f"step = {step}\n"), encoding="utf-8")
    return drawn_of(read(file), exact=True)


def speeds(of: Drawn) -> np.ndarray:
    """ω at the positions and at the end of the base."""
    law = LAW_PLAN.on(of)
    return np.append(
        of.reading[law.omega.row][0, : of.project.count], of.reading[law.omega.end][0, 0]
    )


def angles(count: int, turns: int = 1) -> np.ndarray:
    return np.arange(count * turns + 1) * TURN / count


def value(of: Drawn, mark: Mark | None) -> float:
    assert mark is not None
    return of.value(mark)


def off(found: np.ndarray, due: np.ndarray, least: float = 0.05) -> float:
    """The greatest error as a share of the speed, of the ``least`` share of the greatest where it is less.

    Only a position in which the machine is about as slow may be reached by one and not by the other.
    """
    slow = least * max(np.nanmax(due), 1e-9)
    only = np.isfinite(found) != np.isfinite(due)
    assert (np.nan_to_num(found) + np.nan_to_num(due))[only].max(initial=0.0) < slow
    return float(np.nanmax(np.abs(found - due) / np.maximum(due, slow)))


@pytest.mark.slow
def test_a_run_up_is_that_of_the_equation_of_motion(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    """Kloss's and straight characteristics, from rest and from a speed: below 0.1 % at 360 positions."""
    for seed in range(many(200, 3)):
        of, _ = driven(seed)
        count = 360 if seed % 10 < 2 else 36
        made = drawn(tmp_path, of, count)
        told = value(made, LAW_PLAN.on(made).error) / 100.0
        least = 1e-3 if count == 360 else 1.6 * told + 2e-5
        assert off(speeds(made), motion(of, angles(count)).omega, 0.2) < least, seed


def test_the_error_of_a_step_goes_with_its_square(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    """From a speed on, four times as many positions err by a sixteenth; half of that is left to the curves."""
    for seed in range(0, many(200, 8), 2):
        of, _ = driven(seed)
        due = motion(of, angles(96)).omega
        few, more = (off(speeds(drawn(tmp_path, of, n)), due[:: 96 // n]) for n in (24, 96))
        assert more < few / 8.0 + 1e-6
        assert few < 0.01


def test_the_error_that_is_told_holds(tmp_path: Path, many: Callable[[int, int], int]) -> None:
    """What the number of positions allows, of a fifth of the greatest speed where it is less."""
    shares = []
    for seed in range(many(40, 4)):
        for of in (machine(seed), driven(seed)[0]):
            made = drawn(tmp_path, of, 24)
            error = off(speeds(made), motion(of, angles(24)).omega, 0.2)
            told = value(made, LAW_PLAN.on(made).error) / 100.0
            assert error < 1.6 * told + 2e-5
            shares.append(error / told)
    assert np.median(shares) > 0.15


def test_the_error_is_that_of_positions_that_are_reached(tmp_path: Path) -> None:
    """What is behind a rest does not count; where nothing is compared none is told, nor of a prime number."""
    jag = weak().crank._replace(pressure=lambda phi: 1e5 * (np.asarray(phi) > 5.0))
    # it stands after three radians
    light = weak()._replace(crank=jag, motor=lambda omega: 0.0, moment=-12.0, start=6.0)
    made = drawn(tmp_path, light, 24)
    assert not np.isfinite(value(made, LAW_PLAN.on(made).omega.end))
    assert value(made, LAW_PLAN.on(made).error) < 0.01
    made = drawn(tmp_path, light._replace(moment=-400.0), 24)
    assert np.isnan(value(made, LAW_PLAN.on(made).error))
    assert "motion_error" not in law_results(made)
    for count, some in ((23, False), (4, False), (8, True)):
        made = drawn(tmp_path, driven(0)[0], count)
        assert (LAW_PLAN.on(made).error is not None) == some
        says = [one for one in warnings(made, "en") if "take an even number" in one]
        assert bool(says) != some


def test_the_turns_of_a_run_up_are_counted(tmp_path: Path) -> None:
    """Until one changes the speed by less than 0.1 %: by the equation of motion, at few positions and many."""
    for seed, count in ((1, 24), (3, 12), (5, 72)):
        of, _ = driven(seed)
        made = drawn(tmp_path, of, count)
        turns = int(value(made, LAW_PLAN.on(made).run_up))
        omega = motion(of, np.arange(turns + 2) * TURN).omega
        change = np.abs(np.diff(omega)) / omega[1:]
        assert turns == np.argmax(change < 1e-3), change


def test_the_turns_of_a_run_up_do_not_hang_on_those_drawn(tmp_path: Path) -> None:
    of, _ = driven(5)
    both = [drawn(tmp_path, of, 24, turns) for turns in (1, 3)]
    told = [value(one, LAW_PLAN.on(one).run_up) for one in both]
    assert told[0] == told[1]
    assert told[0] % 3


def test_the_crossing_that_is_drawn_is_that_of_the_run(tmp_path: Path) -> None:
    for seed, step in ((1, 0), (1, 5), (2, 11), (0, 3)):
        made = drawn(tmp_path, driven(seed)[0], 12, step=step)
        law = LAW_PLAN.on(made)
        assert law.step is not None
        assert made.value(law.step.omega) == pytest.approx(speeds(made)[step + 1], rel=1e-7)


def test_no_two_moments_of_a_motor_have_one_letter(tmp_path: Path) -> None:
    """Kloss's greatest is M_k; works at both ends of an interval are called alike."""
    made = drawn(tmp_path, driven(0)[0], 12)
    steps = [one for one in made.construction.steps if one.it.view in (MOTOR, RUN)]
    letters = [symbol(one.it.letter, "en") for one in steps if one.it.letter[0] in "AM"]
    assert sum(one in ("M_k", "M_{k}") for one in letters) == 1
    assert {"A_{k}", "A_{k+1}"} <= {*letters}


def test_the_characteristic_goes_through_its_nominal_point(tmp_path: Path) -> None:
    """The catalogue's point, the greatest moment, none at the synchronous speed; by the number on the crank."""
    of, motor = driven(0)
    made = drawn(tmp_path, of, 12)
    own = LAW_PLAN.on(made).motor
    assert own is not None
    curve = made.reading[own.curve]
    omega, moment = (part * made.value(mu) for part, mu in
                     ((curve.knots[0].real, own.mu_omega), (curve.knots[0].imag, own.mu_M)))  # fmt: skip
    assert moment == pytest.approx([motor(one) for one in omega], rel=1e-9, abs=1e-9)
    nominal = motor.power / motor.nominal * motor.ratio
    assert np.interp(motor.nominal / motor.ratio, omega, moment) == pytest.approx(nominal, rel=2e-3)
    assert np.max(moment) == pytest.approx(motor.overload * nominal, rel=2e-3)


STEADY = "steady = true\n"


@pytest.mark.parametrize("seed", [0, 5])
def test_a_steady_cycle_is_what_turn_after_turn_comes_to(tmp_path: Path, seed: int) -> None:
    of, motor = driven(seed)
    of = of._replace(start=0.0)
    made = drawn(tmp_path, of, 120, more=STEADY)
    law, found = LAW_PLAN.on(made), speeds(made)
    assert found[0] == pytest.approx(found[-1], rel=1e-6)
    many = motion(
        of._replace(start=0.9 * motor.synchronous / motor.ratio), np.arange(121 * 12) * TURN / 120
    )
    due = many.omega[-122:-1]
    assert due[0] == pytest.approx(due[-1], rel=2e-3)
    at = (np.arange(121 * 12)[-122:-1] % 120).argmin()
    due = np.roll(due[:-1], -at)
    assert found[:-1] == pytest.approx(due, rel=2e-3)
    delta = 2.0 * (due.max() - due.min()) / (due.max() + due.min())
    assert value(made, law.delta) == pytest.approx(delta, rel=5e-3, abs=2e-4)


def test_the_flywheel_keeps_the_given_irregularity(tmp_path: Path) -> None:
    of = driven(0)[0]._replace(start=0.0)
    alone = value(made := drawn(tmp_path, of, 24, more=STEADY), LAW_PLAN.on(made).delta)
    made = drawn(tmp_path, of, 24, more=f"{STEADY}delta = {alone / 3.0!r}\n")
    law = LAW_PLAN.on(made)
    assert value(made, law.delta) == pytest.approx(alone / 3.0, rel=1e-5)
    heavier = of._replace(inertia=of.inertia + value(made, law.flywheel))
    again = drawn(tmp_path, heavier, 24, more=STEADY)
    assert value(again, LAW_PLAN.on(again).delta) == pytest.approx(alone / 3.0, rel=1e-5)


@pytest.mark.parametrize(
    ("more", "share", "says"),
    [
        (f"{STEADY}delta = 1.5\n", 1.0, "no flywheel is needed"),
        (STEADY, 0.05, "the motor is too weak"),
        (f"{STEADY}delta = 0.01\n", 0.05, "the motor is too weak"),
    ],
)
def test_why_there_is_no_steady_cycle_is_told(
    tmp_path: Path, more: str, share: float, says: str
) -> None:
    """The mechanism assembles all round: it is not what is wrong."""
    of, motor = driven(0)
    of = of._replace(start=0.0, motor=motor._replace(power=share * motor.power))
    file = tmp_path / "scene.toml"
    file.write_text(written(of, 12, more=more), encoding="utf-8")
    without = without_absent(read(file))
    assert without is not None
    assert says in without.left_out["motion_law"]


def test_a_motor_that_always_drives_has_no_steady_cycle(tmp_path: Path) -> None:
    of, motor = driven(0)
    points = [[0.0, 1e3 * motor.power], [motor.nominal, 1e3 * motor.power]]
    file = tmp_path / "scene.toml"
    of = of._replace(start=0.0, motor=lambda omega: 0.0)
    text = written(of, 12, more=f"{STEADY}[motor]\npoints = {points}\n")
    file.write_text(text, encoding="utf-8")
    without = without_absent(read(file))
    assert without is not None
    assert "ever faster" in without.left_out["motion_law"]


def test_a_motor_alone_runs_up(tmp_path: Path) -> None:
    """Without a load there is a moment of nothing."""
    of, motor = driven(0)
    light = crank(3)._replace(masses=(1e-9, 1e-9), inertia=1e-12, pressure=lambda phi: 0.0 * phi)
    of = of._replace(crank=light, moment=0.0, start=0.5 * motor.nominal / motor.ratio)
    head, _, tail = written(of, 48).partition("[indicator]")
    file = tmp_path / "scene.toml"
    file.write_text(head + tail[tail.index("[motion_law]") :], encoding="utf-8")
    made = drawn_of(read(file), exact=True)
    assert off(speeds(made), motion(of, angles(48)).omega) < 1e-3


def test_a_table_is_gone_through_straight(tmp_path: Path) -> None:
    """A soft engine by five points, against the equation of motion with the moment read between them."""
    table = ((0.0, 30.0), (60.0, 42.0), (110.0, 40.0), (140.0, 20.0), (150.0, -10.0))
    of, motor = driven(0)
    scale = motor.power / motor.nominal / 40.0 * 1.2
    speed = motor.synchronous / 145.0
    points = [(omega * speed, moment * scale) for omega, moment in table]
    x, y = np.array(points).T

    def moment(omega: float) -> float:
        return float(motor.ratio * np.interp(omega * motor.ratio, x, y))

    told = f"[motor]\npoints = {[list(one) for one in points]}\nratio = {motor.ratio!r}\n"
    made = drawn(tmp_path, of._replace(motor=moment), 180, more=told)
    assert off(speeds(made), motion(of._replace(motor=moment), angles(180)).omega) < 1e-3


@pytest.mark.parametrize(("seed", "times"), [(0, 1.5), (4, 3.2), (2, 3.2)])
def test_a_motor_brakes_above_its_drawn_end(tmp_path: Path, seed: int, times: float) -> None:
    """Kloss's brakes by its formula, less and less; a straight one more and more."""
    of, motor = driven(seed)
    assert motor.straight == (seed == 2)
    of = of._replace(start=times * motor.synchronous / motor.ratio)
    assert off(speeds(drawn(tmp_path, of, 48)), motion(of, angles(48)).omega) < 5e-3


def test_a_table_goes_on_level_above_its_end(tmp_path: Path) -> None:
    of, motor = driven(0)
    idle, most = motor.synchronous, motor.overload * motor.power / motor.nominal
    x, y = (0.0, 0.9 * idle, idle), (most, most, -most / 2.0)
    of = of._replace(
        start=2.0 * idle / motor.ratio,
        motor=lambda omega: float(motor.ratio * np.interp(omega * motor.ratio, x, y)),
    )
    points = [list(one) for one in zip(x, y, strict=True)]
    made = drawn(tmp_path, of, 48, more=f"[motor]\npoints = {points}\nratio = {motor.ratio!r}\n")
    assert off(speeds(made), motion(of, angles(48)).omega) < 5e-3


def weak() -> Machine:
    """A motor that its load stops within the turn."""
    light = crank(3)._replace(masses=(1e-9, 1e-9), inertia=1e-12, pressure=lambda phi: 0.0 * phi)
    motor = Catalogue(100.0, 9.5, 10.0, 2.0, 1.0, straight=False)
    return Machine(light, -60.0, 2.0, 9.0, motor)


def test_a_motor_that_is_too_weak_is_stopped_by_its_load(tmp_path: Path) -> None:
    of = weak()
    made = drawn(tmp_path, of, 48, step=47)
    due, law, found = motion(of, angles(48)), LAW_PLAN.on(made), speeds(made)
    # the last position that is reached is nearly at rest: a tenth of a joule is a fiftieth of its speed
    assert off(found, due.omega) < 0.03
    assert np.isnan(found[-1])
    assert made.value(law.angle) == pytest.approx(due.rest[0], rel=0.01)
    assert made.value(law.time) == pytest.approx(due.rest[1], rel=0.02)
    assert law.step is not None
    assert not np.isfinite(made.value(law.step.omega))
    says = warnings(made, "en")
    assert any("comes to rest at φ" in one for one in says)
    assert not [one for one in says if ", step " in one], "one sentence says it all"
    noted = repr(list(conclusions(in_usual_size(read(tmp_path / "scene.toml"), exact=True), "en")))
    assert "Law of motion: the machine" in noted
    assert "Motion" not in noted


def test_a_crossing_that_cannot_be_drawn_is_left_out(tmp_path: Path) -> None:
    of = driven(0)[0]
    for times, there in ((1.0, True), (4.0, False)):
        made = drawn(tmp_path, of._replace(start=times * of.start), 12)
        assert ("motion-step" in [one.name for one in law_views(made, False)]) == there
        left = [one for one in warnings(made, "en") if "write another step" in one]
        assert bool(left) != there


def test_a_machine_that_is_held_at_first_does_not_start(tmp_path: Path) -> None:
    """Over the first interval its loads would drive it, but in the first position they hold it."""
    of, motor = driven(31)
    assert of.M(0.0) + motor(0.0) < 0.0 < of.M(TURN / 24) + motor(0.0)
    made = drawn(tmp_path, of, 24)
    assert np.isnan(speeds(made)[1:]).all()
    assert any("the machine does not start" in one for one in warnings(made, "en"))


POUND_INCH = 0.1129848


@pytest.mark.parametrize(
    ("load", "start", "end", "seconds"), [(0.0, 117.81, 124.41, 9.5), (1560.0, 124.41, 117.81, 0.5)]
)
def test_a_published_punch_press(
    tmp_path: Path, load: float, start: float, end: float, seconds: float
) -> None:
    """Budynas and Nisbett's punch press: in 9.5 s its motor lifts the flywheel to 124.41 rad/s, δ = 0.0545.

    T = 2690.4 − 21.41·ω lbf·in, I = 110.72 lbf·in·s²; a hole of 1560 lbf·in and 0.5 s brings it down again.
    """
    slope, most, inertia = 21.41, 2690.4, 110.72
    level, decay = (most - load) / slope, inertia / slope
    way = level * seconds - (level - start) * decay * (1.0 - np.exp(-seconds / decay))
    ratio = float(way / TURN)
    own = f"[motor]\nno_load = {most / slope!r}\nstarting = {most * POUND_INCH!r}\nratio = {ratio!r}\n"
    of = weak()._replace(
        moment=-load * POUND_INCH * ratio,
        inertia=inertia * POUND_INCH * ratio**2,
        start=start / ratio,
        motor=lambda omega: 0.0,
    )
    made = drawn(tmp_path, of, 48, more=own)
    found, law = speeds(made) * ratio, LAW_PLAN.on(made)
    assert found[-1] == pytest.approx(end, abs=0.02)
    assert made.value(law.time) == pytest.approx(seconds, rel=1e-3)
    assert 2.0 * np.ptp(found) / (found[0] + found[-1]) == pytest.approx(0.0545, abs=2e-4)


def test_too_few_positions_for_a_stiff_motor_are_told(tmp_path: Path) -> None:
    of, motor = driven(1)
    stiff = of._replace(inertia=0.02 * of.inertia, motor=motor)
    says = [one for one in warnings(drawn(tmp_path, stiff, 12), "en") if "positions a turn" in one]
    assert len(says) == 1
    assert not [one for one in warnings(drawn(tmp_path, of, 24), "en") if "positions a turn" in one]


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (
            "synchronous",
            "no_load = 3.0\nsynchronous",
            "asynchronous, has a straight characteristic or a table",
        ),
        ("synchronous = ", "#", "nothing says what motor it is"),
        ("synchronous = ", "points = [[3, 1], [2, 1]]\n#", "grow from point to point"),
        ("power = ", "#", "motor.power: it is missing"),
        ("nominal = ", "nominal = 1e3 #", "under load a motor turns more slowly"),
        ("step = 1", "step = 12", "there are 12 intervals"),
        ("turns = 1", "turns = 1\ndelta = 0.05", "write steady = true"),
        ("turns = 1", "turns = 1\nsteady = true\nstart = 2.0", "begins with a speed of its own"),
    ],
)
def test_what_is_no_motor_is_refused(tmp_path: Path, old: str, new: str, says: str) -> None:
    file = tmp_path / "scene.toml"
    text = written(driven(1)[0], 12)
    assert old in text
    file.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(SceneError) as caught:
        read(file)
    assert says in str(caught.value)
