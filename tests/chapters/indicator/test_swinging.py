"""Gas in a cylinder that swings: the stroke is the change of its length; judged by closed form and power."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.each import each
from support.scenes import written

import graphic_tmm
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import ASKED
from graphic_tmm.chapters.indicator.given import LONG, OFF, acting
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import TmmError
from graphic_tmm.readers.task_sheet import Posed
from graphic_tmm.scene.read import read

R, C, COUNT, ZERO = 0.04, 0.15 - 0.06j, 16, 20.0
AREA = np.pi * 0.05**2 / 4
GAS = """bore = "50 mm"
cover_points = { out = [[0, 600e3], [0.3, 600e3], [1, 200e3]], back = [[1, 110e3], [0, 150e3]] }
"""
OUT, BACK = ((0.0, 0.3, 1.0), (600e3, 600e3, 200e3)), ((0.0, 1.0), (150e3, 110e3))


def text(omega: float, side: str, *, offset: str = "0") -> str:
    way = "counterclockwise" if omega > 0 else "clockwise"
    sliding = f'slides = {{ on = 3, along = "z", side = "{side}" }}\n'
    guide = f'guides = {{ z = {{ through = [0, {offset}], angle = "0 deg" }} }}\n'
    return f"""title = "T"
language = "en"
[frame]
O = [0, 0]
C = [{C.real}, {C.imag}]
[[link]]
number = 1
points = {{ O = [0, 0], A = [{R}, 0] }}
J = 0.01
centre = "O"
[[link]]
number = 2
points = {{ A = [0, 0] }}
{sliding}[[link]]
number = 3
points = {{ C = [0, 0] }}
{guide}[drive]
link = 1
speed = "{abs(omega)} 1/s"
turns = "{way}"
positions = {COUNT}
zero = "{ZERO} deg"
[effects]
gas = true
[indicator]
point = "A"
{GAS}[forces]
positions = [1]
balance = "moment"
[flywheel]
constant = "resisting"
J = 5
tangents = "none"
"""


def length(phi: np.ndarray) -> np.ndarray:
    return np.abs(R * np.exp(1j * phi) - C)


def push(phi: np.ndarray, omega: float) -> np.ndarray:
    """The force on the piston, away from the pin."""
    least = abs(C) - R
    share, step = (length(phi) - least) / (2 * R), 1e-6 * np.sign(omega)
    growing = length(phi + step) > length(phi - step)
    return np.where(growing, np.interp(share, *OUT), np.interp(share, *BACK)) * AREA


def moment(phi: np.ndarray, omega: float) -> np.ndarray:
    """What drives the crank the way that it turns, by power alone."""
    step = 1e-5
    rate = (length(phi + step) - length(phi - step)) / (2 * step)
    return push(phi, omega) * rate * np.sign(omega)


def drawing(folder: Path, scene: str) -> Drawn:
    return drawn_of(read(written(folder, scene)), exact=True)


def angles(omega: float) -> np.ndarray:
    return np.radians(ZERO) + np.sign(omega) * 2 * np.pi * np.arange(COUNT) / COUNT


@each("omega", [30.0, -30.0])
@each("side", ["+", "-"])
def test_the_gas_pushes_as_the_length_tells(omega: float, side: str, tmp_path: Path) -> None:
    made = drawing(tmp_path, text(omega, side))
    phi = angles(omega)
    feet, of = INDICATOR_PLAN.on(made).indicator, made.reading
    share = of[feet.feet][0].real / of[feet.end][0, 0].real
    np.testing.assert_allclose(share, (length(phi) - abs(C) + R) / (2 * R), atol=1e-9)
    np.testing.assert_allclose(of[feet.force][0], push(phi, omega), rtol=1e-8)
    wanted = moment(phi, omega)
    np.testing.assert_allclose(of[FLYWHEEL_PLAN.on(made).moment][0], wanted, rtol=1e-6, atol=1e-6)
    forces = FORCES_PLAN.on(made)
    for mark in (forces.first.balance, forces.first.lever.balance):
        np.testing.assert_allclose(of[mark][0], -wanted * np.sign(omega), rtol=1e-6, atol=1e-6)


def test_it_pushes_the_cylinder_as_much_the_other_way(tmp_path: Path) -> None:
    made = drawing(tmp_path, text(30.0, "-"))
    phi = angles(30.0)
    way = (R * np.exp(1j * phi) - C) / length(phi)
    found = [f for f in FORCES_PLAN.on(made).loads.forces if f.letter[0] == "P"]
    assert [one.link for one in found] == [2, 3]
    for one, sign in zip(found, (1, -1), strict=True):
        vector = made.reading[one.line].along[0] * made.reading[one.value][0]
        np.testing.assert_allclose(vector, sign * push(phi, 30.0) * way, rtol=1e-8)
    # the pin of the cylinder bears it whole, the guide nothing
    reactions = {one.letter: made.reading[one.value][0] for one in FORCES_PLAN.on(made).reactions}
    np.testing.assert_allclose(np.abs(reactions["R_{03}"]), push(phi, 30.0), rtol=1e-8)


def test_any_angle_is_read_off_the_diagram(tmp_path: Path) -> None:
    scene = read(written(tmp_path, text(30.0, "-")))
    at = ZERO + 360.0 * np.arange(COUNT) / COUNT
    found = graphic_tmm.motion(scene, at, plans=["forces"], exact=True).balance["M_bal_forces"]
    np.testing.assert_allclose(found, -moment(np.radians(at), 30.0), rtol=1e-6, atol=1e-6)


def test_a_rod_beside_the_pin_is_refused(tmp_path: Path) -> None:
    with pytest.raises(TmmError, match="both lie in one line; A is another"):
        drawing(tmp_path, text(30.0, "-", offset="0.01"))


SECOND = """[[link]]
number = 4
points = { A = [0, 0] }
slides = { on = 5, along = "w", side = "-" }
[[link]]
number = 5
points = { D = [0, 0] }
guides = { w = { through = [0, 0], angle = "0 deg" } }
[drive]"""


def test_two_rods_on_one_pin_are_refused(tmp_path: Path) -> None:
    scene = text(30.0, "-").replace("[frame]", "[frame]\nD = [-0.05, -0.16]", 1)
    with pytest.raises(TmmError, match="several cylinders that swing are pinned at A"):
        drawing(tmp_path, scene.replace("[drive]", SECOND, 1))


BEHIND_A_PISTON = f"""title = "T"
language = "en"
[frame]
O = [0, 0]
D = [0.35, -0.2]
x = {{ through = [0, 0], angle = "0 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [{R}, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [0.2, 0] }}
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "right" }}
{SECOND.replace("A =", "B =")}
link = 1
speed = 10
positions = 12
[effects]
gas = true
[indicator]
point = "B"
{GAS}[forces]
positions = [2]
"""


def test_a_piston_of_the_frame_keeps_its_gas_where_a_stone_is_pinned_to_it(tmp_path: Path) -> None:
    made = drawing(tmp_path, BEHIND_A_PISTON)
    assert [one.link for one in FORCES_PLAN.on(made).loads.forces if one.letter[0] == "P"] == [3]


def test_a_task_sheet_shows_the_push_away_from_the_pin(tmp_path: Path) -> None:
    """The arrow ends before the rod's pin, on the side of the cylinder's."""
    scene = read(written(tmp_path, text(30.0, "-")))
    spots = {"A": 100 + 50j, "C": 300 + 20j, "O": 0j}
    posed = Posed(lambda letter, link: (spots[letter], 1j), 5.0, lambda link: 1 + 0j)
    ((strokes, (wanted,), _),) = acting(ASKED.of(scene).gas, scene, posed)
    assert strokes
    away = (spots["A"] - spots["C"]) / abs(spots["A"] - spots["C"])
    assert (spots["A"] - wanted.at) / away == pytest.approx(LONG + OFF)
