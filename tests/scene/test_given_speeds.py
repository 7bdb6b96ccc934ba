"""Plans drawn with the speeds that the law of motion gives: as it has them, in equilibrium, refusals."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.gallery import SHEETS

import graphic_tmm as tmm
from graphic_tmm.chapters.kinematics.task_sheet import speeds_listed
from graphic_tmm.chapters.motion_law.plan import LAW_PLAN
from graphic_tmm.errors import SceneError
from graphic_tmm.fitting.fit import fitted
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

PRESS = """title = "T"
language = "en"
[frame]
O = [0, 0]
v = { through = ["8 mm", 0], angle = "90 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = ["60 mm", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["240 mm", 0], S2 = ["90 mm", 0] }
mass = "14 kg"
centre = "S2"
J = "0.09 kg*m^2"
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "v", side = "below" }
mass = "35 kg"
centre = "B"
[drive]
link = 1
speed = "motion law"
turns = "TURNS"
positions = 72
accelerations = [7, 30, 55]
zero = "20 deg"
[effects]
gravity = true
inertia = true
[[load]]
link = 3
point = "B"
direction = "against velocity"
force = "2 kN"
[forces]
positions = [7, 30, 55]
[motion_law]
start = "12 rad/s"
M = "80 N*m"
J = "6 kg*m^2"
turns = 2
[hand]
ruler = "0.001 mm"
[[sheet]]
format = "A1"
place = ["positions", "velocities", "accelerations", "force table"]
"""


def scene(folder: Path, *changes: tuple[str, str], turns: str = "clockwise") -> Scene:
    text = PRESS.replace("TURNS", turns)
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    (folder / "scene.toml").write_text(text, encoding="utf-8")
    return read(folder)


@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_plans_take_the_last_turn_of_the_law(tmp_path: Path, turns: str) -> None:
    own = scene(tmp_path, turns=turns).mechanism
    law = scene(tmp_path, ('"motion law"', '"1 rad/s"'), turns=turns)
    drawn = fitted(law)
    omega = drawn.reading[LAW_PLAN.on(drawn).omega.row][0, 72:144]
    assert own is not None
    sense = -1 if turns == "clockwise" else 1
    # as it is read off the graph of ω, by a tenth of a millimetre
    assert sense * np.array(own.drive.rates) == pytest.approx(omega, rel=0.01)
    epsilon = sense * np.array(own.drive.gains)
    # ε·dφ = ω·dω, by the differences of the same row
    middle = (omega[2:] ** 2 - omega[:-2] ** 2) / (8.0 * np.pi / 72.0)
    assert epsilon[1:-1] == pytest.approx(middle, abs=0.05 * np.abs(epsilon).max())


@pytest.mark.slow
@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_forces_are_in_equilibrium_with_what_drives_the_law(tmp_path: Path, turns: str) -> None:
    """The balancing force on the crank is what the moment M leaves of speeding the flywheel up: M − J·ε."""
    own = scene(tmp_path, turns=turns)
    assert own.mechanism is not None
    sense = -1 if turns == "clockwise" else 1
    column = tmm.draw(own).table("forces")["P_bal_forces"]
    drawn = [7, 30, 55]
    due = np.abs(80.0 - 6.0 * sense * np.array(own.mechanism.drive.gains)[drawn]) / 0.06
    assert np.abs(column.value[0][drawn]) == pytest.approx(due, abs=0.02 * due.max())


@pytest.mark.parametrize(
    ("old", "new", "key", "words"),
    [
        ("turns = 2", "turns = 1", "drive.speed", "turns = 2 or more"),
        ('M = "80 N*m"', 'M = "-200 N*m"', "drive.speed", "does not come through"),
        ("turns = 2", "", "drive.speed", "turns = 2 or more"),
        ('zero = "20 deg"', 'acceleration = "2 rad/s^2"', "drive.acceleration", "leave it out"),
        ('"force table"', '"motion_law"', "sheet 1, place", "of a scene that writes the speed"),
        ("[motion_law]", "[engine_law]", "drive.speed", "[motion_law] gives this speed"),
    ],
)
def test_what_cannot_give_speeds_is_refused(
    tmp_path: Path, old: str, new: str, key: str, words: str
) -> None:
    with pytest.raises(SceneError) as wrong:
        scene(tmp_path, (old, new))
    assert any(key in one.key and words in one.message and one.line for one in wrong.value.faults)


def test_a_fault_of_the_scene_is_told_with_its_line(tmp_path: Path) -> None:
    with pytest.raises(SceneError) as wrong:
        scene(tmp_path, ('"14 kg"', '"14 m"'))
    (fault,) = wrong.value.faults
    assert fault.line == PRESS[: PRESS.index('mass = "14')].count("\n") + 1


def test_other_values_are_taken_and_the_law_sought_again(tmp_path: Path) -> None:
    own = scene(tmp_path)
    other = own.with_({"motion_law.J": "12 kg*m^2"})
    assert own.mechanism is not None
    assert other.mechanism is not None
    assert np.ptp(other.mechanism.drive.rates) < 0.7 * np.ptp(own.mechanism.drive.rates)


def test_a_task_gives_the_speeds_position_by_position() -> None:
    own = read(SHEETS / "press-by-law" / "scene.toml")
    assert own.mechanism is not None
    tables = [*speeds_listed(own, "en")]
    names = [name for one in tables for name in one.heads[1:]]
    assert names == [str(n) for n in range(12)]
    rows = [sum((one.rows[k][1:] for one in tables), ()) for k in (0, 1)]
    for row, due in zip(rows, (own.mechanism.drive.rates, own.mechanism.drive.gains), strict=True):
        figures = [float(one.replace("−", "-")) for one in row]
        assert figures == pytest.approx(due, rel=1e-4, abs=1e-9)


def test_the_press_of_the_gallery_keeps_its_cycle() -> None:
    own = read(SHEETS / "press-by-law" / "scene.toml").mechanism
    assert own is not None
    rates, gains = np.array(own.drive.rates), np.array(own.drive.gains)
    # over a cycle nothing is gained: ∫ε·dφ = 0
    assert abs(gains.mean()) < 0.02 * np.abs(gains).max()
    assert rates.min() > 0.9 * rates.max()
