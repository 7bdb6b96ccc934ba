"""What a survey of course tasks wished for and could not say, as it is said now; judged by virtual work."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from support.boards import drawn_of
from support.each import each
from support.force_views import views_of
from support.plate_by_hand import TRIAD

import graphic_tmm
from graphic_tmm.errors import SceneError, TmmError
from graphic_tmm.readers.task_sheet import given_rows

Reals = NDArray[np.float64]
STEP = 1e-6
HEAD = 'title = "T"\nlanguage = "en"\n'
SWINGING = f"""{HEAD}[frame]
O = [0, 0]
C = [0.16, 0]
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.04, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], S2 = [0.06, 0] }}
slides = {{ on = 3, along = "z", side = "-" }}
[[link]]
number = 3
points = {{ C = [0, 0], S3 = [-0.02, 0] }}
guides = {{ z = {{ through = [0, 0], angle = "0 deg" }} }}
[drive]
link = 1
speed = 15
positions = 8
[forces]
positions = "all"
"""
IN_LINE = f"""{HEAD}[frame]
O = [0, 0]
x = {{ through = [0, 0], angle = "0 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.1, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [0.3, 0] }}
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "right" }}
[drive]
link = 1
speed = 1
"""
PUSHED = '[[load]]\nlink = 3\npoint = "B"\nforce = "1 N"\ndirection = "0 deg"\n'
V = f"""{HEAD}[frame]
O = [0, 0]
x = {{ through = [0, 0], angle = "135 deg" }}
y = {{ through = [0, 0], angle = "45 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.05, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [0.2, 0] }}
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "+" }}
[[link]]
number = 4
points = {{ A = [0, 0], C = [0.2, 0] }}
[[link]]
number = 5
points = {{ C = [0, 0] }}
slides = {{ on = "frame", along = "y", side = "+" }}
[drive]
link = 1
speed = "100 rad/s"
zero = {{ point = "B", at = "top" }}
[forces]
positions = "all"
balance = "moment"
"""
WORDS = {
    "force along a link": '[[load]]\nlink = 2\npoint = "S2"\nforce = "500 N"\ndirection = "along z"\n',
    "gas in a swinging cylinder": "[effects]\ngas = true\n[indicator]\npoint = 'A'\nbore = 0.05\n"
    f"cover = {[3e5] * 8}\n",
    "spring": '[[spring]]\nbetween = ["A", "C"]\nrate = "1 kN/m"\nfree = "100 mm"\n',
}


def forces(text: str) -> dict[str, Reals]:
    table = graphic_tmm.draw(graphic_tmm.read(text), exact=True).table("forces")
    return {name: table[name].value[0] for name in table.columns}


def slope(way: Any, phi: Reals) -> Reals:
    """Of a way by the angle of the crank, m."""
    return np.asarray((way(phi + STEP) - way(phi - STEP)) / (2 * STEP))


def slid(phi: Reals, r: float = 0.1, rod: float = 0.3, along: float = 0.0) -> Reals:
    """How far a slider stands along its guide, m."""
    turned = phi - math.radians(along)
    return np.asarray(r * np.cos(turned) + np.sqrt(rod**2 - (r * np.sin(turned)) ** 2))


@each("name", WORDS)
@pytest.mark.slow
def test_along_a_swinging_line(name: str) -> None:
    """S2 lies from A towards C; the gas pushes A away from C, the spring draws it there."""
    phi = np.radians(45.0 * np.arange(8))
    length = lambda turn: np.abs(0.04 * np.exp(1j * turn) - 0.16)  # noqa: E731
    push = {
        "force along a link": np.full(8, -500.0),
        "gas in a swinging cylinder": np.full(8, 3e5 * np.pi / 4 * 0.05**2),
        "spring": -1000.0 * (length(phi) - 0.1),
    }[name]
    found = forces(SWINGING + WORDS[name])
    for way in ("forces", "lever"):
        wanted = -push * slope(length, phi) / 0.04
        np.testing.assert_allclose(found[f"P_bal_{way}"], wanted, atol=1e-6)


def test_a_force_that_no_guide_holds_is_given_no_place() -> None:
    """500 N along the guide leave nothing across it: no sheet divides nothing by nothing."""
    work = drawn_of(graphic_tmm.read(SWINGING + WORDS["force along a link"]))
    told = [label.text for view in views_of(work) for label in view.labels]
    assert "ΣM_{A}^{(2)} = 0 N·m" in told
    assert not any("= 0/(0" in text for text in told)


def test_the_gas_of_forces_gives_the_bore() -> None:
    rows = given_rows(graphic_tmm.read(SWINGING + WORDS["gas in a swinging cylinder"]))
    assert [row.value for row in rows if row.symbol == "D"] == [50.0]


@each("positions", ["[1]", '["1"]', '"all"', '["all"]'])
@pytest.mark.slow
def test_positions_at_a_stand(positions: str) -> None:
    text = (
        IN_LINE.replace("speed = 1", "speed = 0") + PUSHED + f"[forces]\npositions = {positions}\n"
    )
    due = -float(slope(slid, np.radians(np.array([30.0])))[0]) / 0.1
    assert forces(text)["P_bal_forces"][1] == pytest.approx(due, rel=1e-6)
    assert forces(text)["P_bal_lever"][1] == pytest.approx(due, rel=1e-6)


def test_inches_and_pounds() -> None:
    text = IN_LINE.replace("[0.1, 0]", '["2 in", 0]').replace("[0.3, 0]", '["8 in", 0]')
    text = text.replace("speed = 1", 'speed = "600 rpm"')
    pushed = PUSHED.replace("1 N", "100 lbf").replace("0 deg", "against velocity")
    found = forces(text + pushed + "[forces]\npositions = [2]\n")
    assert found["F3"][2] == pytest.approx(444.822, abs=1e-3)
    own = slope(lambda turn: slid(turn, 0.0508, 0.2032), np.radians(np.array([60.0])))
    assert found["P_bal_lever"][2] == pytest.approx(444.822 * -own[0] / 0.0508, rel=1e-5)


def test_the_force_at_the_slider_that_a_moment_holds() -> None:
    loaded = '[[load]]\nlink = 1\nmoment = "10 N*m"\n[forces]\npositions = [1]\n'
    sought = 'unknown = { link = 3, point = "B", direction = "along x" }\n'
    found = forces(IN_LINE + loaded + sought)["P_tool"][1]
    assert abs(found) == pytest.approx(
        10 / abs(slope(slid, np.radians(np.array([30.0])))[0]), rel=1e-6
    )


def test_a_coordinate_that_is_nothing_but_rounding() -> None:
    noisy = IN_LINE.replace("A = [0.1, 0]", "A = [0.1, 5.551115123125783e-17]")
    tables = [
        graphic_tmm.draw(graphic_tmm.read(text)).table("velocities") for text in (noisy, IN_LINE)
    ]
    for name in tables[1].columns:
        np.testing.assert_array_equal(tables[0][name].value, tables[1][name].value)


def way(along: float) -> Any:
    return lambda turn: slid(turn, 0.05, 0.2, along)


@pytest.mark.slow
def test_a_load_over_two_turns() -> None:
    load = '[[load]]\nlink = 5\npoint = "C"\ndirection = "225 deg"\n'
    found = forces(f'{V}{load}by_angle = [[0, "0 N"], [360, "4000 N"], [720, "0 N"]]\n')
    turned = 30.0 * np.arange(24)
    size = np.interp(turned, [0, 360, 720], [0, 4000, 0])
    due = size * slope(way(45.0), np.radians(135.0 + turned))
    np.testing.assert_allclose(found["M_bal_forces"], due, atol=1e-4)
    np.testing.assert_allclose(found["M_bal_lever"], due, atol=1e-4)


@pytest.mark.slow
def test_two_cylinders() -> None:
    pressures = f"bore = 0.08\ncover = {[1e5] * 12}\n"
    gas = "".join(f'[[indicator]]\npoint = "{piston}"\n{pressures}' for piston in "BC")
    found = forces(f"{V}[effects]\ngas = true\n{gas}")
    phi = np.radians(135.0 + 30.0 * np.arange(12))
    due = 1e5 * np.pi / 4 * 0.08**2 * (slope(way(135.0), phi) + slope(way(45.0), phi))
    np.testing.assert_allclose(found["M_bal_forces"], due, atol=1e-4)


@pytest.mark.slow
def test_a_v_compressor_by_angles() -> None:
    tables = {
        3: (315, 135.0, [[0, 4000], [60, 0], [180, 200], [300, 3800], [360, 4000]]),
        5: (225, 45.0, [[0, 300], [90, 5000], [150, 0], [270, 200], [360, 300]]),
    }
    text, turned, due = V, 30.0 * np.arange(12), np.zeros(12)
    for number, (angle, along, rows) in tables.items():
        point = "B" if number == 3 else "C"
        text += f'[[load]]\nlink = {number}\npoint = "{point}"\ndirection = "{angle} deg"\nby_angle = {rows}\n'
        due += np.interp(turned, *zip(*rows, strict=True)) * slope(
            way(along), np.radians(135.0 + turned)
        )
    np.testing.assert_allclose(forces(text)["M_bal_lever"], due, atol=1e-4)


def test_the_places_of_a_plate_are_listed() -> None:
    text = HEAD + TRIAD.replace('near = "-114 deg"\n', "")
    with pytest.raises(
        TmmError, match=r"group 2-3-4-5 can be assembled in 4 ways .* near = one of"
    ):
        graphic_tmm.draw(graphic_tmm.read(text)).table("velocities")


def test_an_older_wish_is_answered_by_what_can_be_said() -> None:
    with pytest.raises(SceneError, match='it is one of "force", "moment"'):
        graphic_tmm.read(IN_LINE + '[forces]\nbalance = "force at B"\n')
