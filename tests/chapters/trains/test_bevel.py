"""Trains of bevel wheels: all contacts roll in space, cones touch, published speeds; what is refused."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray
from support.scenes import calling

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.trains.motion import motion_of
from graphic_tmm.chapters.trains.plan import draw_planetary
from graphic_tmm.chapters.trains.task import SCHEMES, PlanetaryTask, Train
from graphic_tmm.chapters.trains.tooth_verdicts import check
from graphic_tmm.chapters.trains.torques import draw_torques
from graphic_tmm.errors import StructureError
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.table import columns_of, results_of
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

BEVEL = ("bevel", "bevel-double")


def half_angles(z1: int, z2: int, z3: int) -> tuple[float, float, float] | None:
    """Half angles of the cones of a single row: one length of all cones, which fill half a turn (halved).

    None where no cone is that short: the larger central wheel would be more than flat.
    """

    def left(cone: float) -> float:
        rest = math.pi - 2.0 * math.asin(z2 / cone)
        one, other = math.asin(min(z1 / cone, 1.0)), math.asin(min(z3 / cone, 1.0))
        return one + other - rest

    low, high = float(max(z1, z2, z3)), 1e6
    if left(low) < -1e-9:
        return None
    for _ in range(200):
        low, high = (m, high) if left(m := (low + high) / 2) > 0.0 else (low, m)
    return math.asin(z1 / low), math.asin(z2 / low), math.asin(z3 / low)


def placed(scheme: str, z: tuple[int, ...]) -> tuple[complex, complex, complex]:
    """A, C and the direction of the satellites' axis, in half modules, by the angles of the cones."""
    if scheme == "bevel-double":
        return complex(-z[1], z[0]), complex(z[2], z[3]), 1j
    angles = half_angles(*z)
    assert angles is not None
    one, half, _ = angles
    cone = z[1] / math.sin(half)
    turn = math.pi - one
    at = (turn, turn - half, turn - 2.0 * half)
    a, axis, c = (complex(math.cos(t), math.sin(t)) for t in at)
    return cone * a, cone * c, axis


def rolled(scheme: str, z: tuple[int, ...], given: dict[str, float]) -> dict[str, float]:
    """Solve rolling in space at A and C, and the axis carried along: ω × r of both bodies alike.

    Sought: ω of 1, of the last wheel and H about x; of the satellite both components in the plane.
    """
    a, c, axis = placed(scheme, z)
    last = SCHEMES[scheme].meshes[-1].wheel

    def speed(r: complex) -> NDArray[np.float64]:
        """Out of the plane, of ω = (x, y) there: x·r_y − y·r_x."""
        return np.array([r.imag, -r.real])

    names = ["1", last, "H", "x", "y"]
    rows = [np.zeros(5) for _ in range(5)]
    due = np.zeros(5)
    for row, wheel, r in ((0, "1", a), (1, last, c), (2, "H", axis)):
        rows[row][3:] = speed(r)
        rows[row][names.index(wheel)] = -r.imag
    for row, (name, value) in enumerate(given.items(), 3):
        rows[row][names.index(name)], due[row] = 1.0, value
    found = dict(zip(names, np.linalg.solve(np.array(rows), due).tolist(), strict=True))
    x, y = found.pop("x"), found.pop("y")
    own = complex(x - found["H"], y)
    assert abs((own * axis.conjugate()).imag) < 1e-6 * (1.0 + abs(own)), "about its axis"
    return found | {"2": math.hypot(x, y), "2H": (own * axis.conjugate()).real}


def measured(order: PlanetaryTask) -> tuple[dict[str, float], float, dict[str, complex]]:
    draft = Draft()
    made = draw_planetary(draft, order)
    reading = execute(draft.board.construction(), draft.given)
    values = {body: reading[mark].item() for body, mark in made.rates.values.items()}
    points = {at: complex(reading[mark].item()) for at, mark in made.end.points.items()}
    lines = [step.it for step in draft.board.construction().steps if step.it.letter == "(23)"]
    for mark in lines:
        foot, way = (complex(np.ravel(part)[0]) for part in reading[mark])
        tip = complex(reading[made.rates.ends["2"]].item())
        assert abs(((tip - foot) * way.conjugate()).imag) < 1e-6, "all three lines meet in 2"
    mu = reading[made.mu].item()
    return values, reading[made.rates.due].item(), {k: z * mu for k, z in points.items()}


@pytest.mark.parametrize("scheme", BEVEL)
def test_random_bevel_trains_roll(scheme: str, many: Callable[[int, int], int]) -> None:
    """ω of all bodies from picture and triangle, and by Willis, against contacts that roll in space."""
    draw, count, wide = random.Random(scheme), many(200, 30), 0
    for _ in range(count):
        z = [draw.randint(8, 60) for _ in range(4)]
        if scheme == "bevel":
            z = [z[0], z[1], draw.choice((z[0], max(6, z[0] + draw.randint(-2 * z[1], 2 * z[1]))))]
        teeth = tuple(z)
        members = draw.sample(SCHEMES[scheme].members, 2)
        speeds = [draw.choice((-1, 1)) * draw.uniform(1.0, 400.0) for _ in range(2)]
        order = PlanetaryTask(scheme, 0.004, speeds[0], members[0], members[1], teeth=teeth)
        if draw.random() < 0.5:
            order = replace(order, speed=tuple(speeds), driving=tuple(members), fixed="")
        else:
            speeds[1] = 0.0
        if scheme == "bevel" and half_angles(*z) is None:
            wide += 1
            with pytest.raises(StructureError, match="is more than 2·z2²"):
                draw_planetary(Draft(), order)
            continue
        due = rolled(scheme, teeth, dict(zip(members, speeds, strict=True)))
        values, willis, points = measured(order)
        most = max(map(abs, due.values()))
        assert set(values) == set(due) - ({members[1]} if not speeds[1] else set())
        for body, omega in values.items():
            assert omega == pytest.approx(due[body], abs=1e-6 * most), (teeth, body)
        driven = motion_of(order).driven
        wanted = due[members[0]] / due[driven] if not speeds[1] else due[driven]
        assert willis == pytest.approx(wanted, rel=1e-6, abs=1e-6)
        a, c, _ = placed(scheme, teeth)
        assert points["A"] == pytest.approx(0.002 * a, abs=1e-7)
        assert points["C"] == pytest.approx(0.002 * c, abs=1e-7)
    assert wide < count // 2
    assert bool(wide) == (scheme == "bevel")


def test_a_motor_car_of_the_book() -> None:
    """Khurmi, ch. 13: pinion 12 on crown 60 at 1000 rpm; one road wheel at 210 rpm, the other at 190."""
    order = PlanetaryTask("bevel", 0.004, (200.0, 210.0), ("H", "3"), None, teeth=(20, 12, 20))
    values, _, _ = measured(order)
    assert values["1"] == pytest.approx(190.0, rel=1e-12)
    # of 20 teeth on 12: each turn of wheel 3 past the carrier turns the satellite by 20/12
    assert abs(values["2H"]) == pytest.approx(10.0 * 20 / 12, rel=1e-12)


def test_unequal_wheels_of_the_book() -> None:
    """Khurmi, ch. 13: bevel wheels 40 and 30 on coaxial shafts, 50 between; X −100, arm 100: Y 366.7 rpm."""
    order = PlanetaryTask("bevel", 0.004, (-100.0, 100.0), ("1", "H"), None, teeth=(40, 50, 30))
    values, willis, _ = measured(order)
    assert values["3"] == pytest.approx(366.7, abs=0.05)
    assert willis == pytest.approx(366.7, abs=0.05)


def test_wheels_that_turn_alike_do_not_turn_the_satellite() -> None:
    """Straight on: all at one speed; on the spot: the carrier stands."""
    values, _, _ = measured(
        PlanetaryTask("bevel", 0.004, (30.0, 30.0), ("1", "H"), None, teeth=(20, 12, 20))
    )
    assert values["3"] == pytest.approx(30.0)
    assert values["2H"] == pytest.approx(0.0, abs=1e-9)
    order = PlanetaryTask("bevel", 0.004, (30.0, -30.0), ("1", "3"), None, teeth=(20, 12, 20))
    values, _, _ = measured(order)
    assert values["H"] == pytest.approx(0.0, abs=1e-9)
    assert values["2"] == pytest.approx(abs(values["2H"])) == pytest.approx(50.0)


@pytest.mark.parametrize("scheme", BEVEL)
def test_torques_balance_and_keep_the_power(scheme: str) -> None:
    """Without losses all power that is put in comes out."""
    draw = random.Random(scheme + " torques")
    for _ in range(12):
        z1, z2, z3 = (draw.randint(12, 40) for _ in range(3))
        teeth = (z1, z2, z1) if scheme == "bevel" else (z1, z2, z3, draw.randint(12, 40))
        first, fixed = draw.sample(SCHEMES[scheme].members, 2)
        order = PlanetaryTask(scheme, 0.004, 50.0, first, fixed, teeth=teeth, moment=20.0)
        due = rolled(scheme, teeth, {first: 50.0, fixed: 0.0})
        driven = motion_of(order).driven
        draft = Draft()
        made = draw_planetary(draft, order)
        _, marks, share = draw_torques(draft, made)
        assert share is not None
        reading = execute(draft.board.construction(), draft.given)
        torques = {name: reading[mark].item() for name, mark in marks.items()}
        assert sum(torques.values()) == pytest.approx(0.0, abs=1e-9)
        assert torques[first] == 20.0
        assert torques[driven] * due[driven] == pytest.approx(-20.0 * 50.0, rel=1e-6)
        assert reading[share].item() == pytest.approx(1.0, rel=1e-6)


HEAD = 'title = "T"\nlanguage = "en"\n'
GIVEN = '[planetary]\nscheme = "bevel"\nmodule = "4 mm"\n'


def test_the_table_has_every_wheel_and_the_findings_what_cannot_be(tmp_path: Path) -> None:
    """No condition of cylindrical wheels is told of bevel ones; 21 + 20 teeth do not go on two satellites."""
    section = GIVEN + 'speed = "100 rpm"\nteeth = [21, 12, 20]\nmoment = "10 N m"\n'
    scene = read(calling(tmp_path, section, sheet="", head=HEAD))
    (board,) = make(scene, exact=True).boards
    found = {name: value[0].item() for name, value in results_of(board).items()}
    assert found["planetary_satellites"] == 2.0
    assert found["planetary_n_1"] == pytest.approx(100.0)
    assert found["planetary_n_H"] == pytest.approx(100.0 * 21 / 41)
    assert found["planetary_n_2H"] == pytest.approx(100.0 * 20 / 41 * 21 / 12)
    assert found["planetary_M_H"] == pytest.approx(-10.0 * 41 / 21)
    assert "planetary_most" not in found
    assert "n" in {column.segment for column in columns_of(board)}
    (only,) = [str(one) for one in warnings(board)]
    assert "assembly" in only
    assert "20.5" in only


def _sides(z: tuple[int, ...]) -> dict[str, shapely.LineString]:
    """The mean diameters of all wheels of two rims as they are seen from the side, in half modules."""
    z1, z2, z3, z4 = z
    return {
        "1": shapely.LineString([(-z2, -z1), (-z2, z1)]),
        "2": shapely.LineString([(-z2, z1), (z2, z1)]),
        "3": shapely.LineString([(-z3, z4), (z3, z4)]),
        "4": shapely.LineString([(z3, -z4), (z3, z4)]),
    }


def _touch(scheme: str, z: tuple[int, ...], k: int) -> bool:
    """Whether a point of the tips of one satellite lies in the tip cone of its neighbour."""
    a, c, axis = placed(scheme, z)
    around = np.exp(2j * np.pi * np.arange(20000) / 20000)
    turn = 2.0 * np.pi / k
    for end in {a, c} if scheme == "bevel-double" else {a}:
        far = abs(end)
        angle = abs(math.atan2((end / axis).imag, (end / axis).real)) + math.atan(2.0 / far)
        # unit vectors: x along the main axis, the neighbour turned about it
        one = np.array([axis.real, axis.imag, 0.0])
        side, up = np.array([-axis.imag, axis.real, 0.0]), np.array([0.0, 0.0, 1.0])
        tips = math.cos(angle) * one[:, None] + math.sin(angle) * (
            side[:, None] * around.real + up[:, None] * around.imag
        )
        next_axis = np.array([axis.real, axis.imag * math.cos(turn), axis.imag * math.sin(turn)])
        if (next_axis @ tips).max() > math.cos(angle) + 1e-12:
            return True
    return False


def test_bevel_satellites_that_touch_and_rims_that_cut_are_told(
    many: Callable[[int, int], int],
) -> None:
    """Tips of satellites laid out in space; mean diameters of two rims as segments that meet or do not."""
    draw, touched, cut = random.Random("bevel rims"), set(), set()
    for _ in range(many(400, 60)):
        scheme, k = draw.choice(BEVEL), draw.randint(1, 6)
        z = tuple(draw.randint(8, 40) for _ in range(3 if scheme == "bevel" else 4))
        if scheme == "bevel" and half_angles(*z) is None:
            continue
        order = PlanetaryTask(scheme, 0.004, 10.0, "1", teeth=z, satellites=(k,))
        broken = {
            one.condition for one in check(order, Train(SCHEMES[scheme], z, k)) if not one.holds
        }
        due = k > 1 and _touch(scheme, z, k)
        touched.add(due)
        assert ("neighbours" in broken) == due, (z, k)
        meets = False
        if scheme == "bevel-double" and (z[0], z[1]) != (z[3], z[2]):
            sides = _sides(z)
            meets = sides["2"].intersects(sides["4"]) or sides["3"].intersects(sides["1"])
        cut.add(meets)
        assert ("interference" in broken) == meets, z
    assert touched == cut == {True, False}


@pytest.mark.parametrize(
    ("keys", "says"),
    [
        ({"teeth": (40, 10, 20)}, "its cone would be wider than 90°"),
        ({"teeth": (), "ratio": 2.0}, "leave ratio out"),
        ({"behind": ((15, 25),)}, "leave behind out"),
        ({"pole": 30.0}, "leave pole out"),
        ({"module_2": 0.005}, "leave module_2 out"),
    ],
)
def test_what_no_bevel_train_can_be_is_refused(keys: dict[str, Any], says: str) -> None:
    order = replace(PlanetaryTask("bevel", 0.004, 10.0, "1", "3", teeth=(20, 12, 20)), **keys)
    with pytest.raises(StructureError, match=says):
        draw_planetary(Draft(), order)
