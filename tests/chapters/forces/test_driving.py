"""What balances each drive, against the power of all loads; what stands, against the same in slow motion."""

from __future__ import annotations

import numpy as np
import pytest
from support.boards import drawn_of
from support.driven_scenes import BOOM, OUT, ROCKER, SLIDER, TORQUE, scene
from support.gallery import drawn

import graphic_tmm
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.views import vectors_of
from graphic_tmm.errors import TmmError

WEIGHT = 'mass = "40 kg"\ncentre = "C"\nJ = 0\n'
STATIC = "[effects]\ngravity = true\n[forces]\n"


def forces(text: str, drive: str, loaded: str = "") -> graphic_tmm.Table:
    return graphic_tmm.draw(scene(text, drive, loaded), exact=True).table("forces")


def test_a_rod_bears_what_the_power_says() -> None:
    """P·v_r = m·g·v_C upwards, in every position."""
    table = forces(BOOM, OUT + STATIC, WEIGHT)
    lengths = np.linspace(0.6, 0.85, 6)
    motion = graphic_tmm.motion(scene(BOOM, OUT), lengths, exact=True)
    due = 40.0 * 9.81 * motion.velocities["C", 1].imag / 0.05
    for name in ("P_bal_forces", "P_bal_lever"):
        np.testing.assert_allclose(table[name].value[0], due, rtol=1e-9)


def test_a_slider_bears_what_the_power_says() -> None:
    drive = 'speed = "0.5 m/s"\nfrom = "250 mm"\nto = "350 mm"\npositions = 2\n'
    table = forces(SLIDER, drive + TORQUE)
    motion = graphic_tmm.motion(scene(SLIDER, drive), [0.35], exact=True)
    due = -10.0 * motion.omega[3][0] / 0.5
    for name in ("P_bal_forces", "P_bal_lever"):
        np.testing.assert_allclose(table[name].value[0, 1], due, rtol=1e-9)


@pytest.mark.parametrize(
    ("text", "slow", "stands"),
    [
        (BOOM, OUT, OUT.replace("0.05", "0")),
        (ROCKER, "speed = 1\npositions = 4\n", "speed = 0\npositions = 4\n"),
    ],
)
def test_what_stands_is_held_as_in_slow_motion(text: str, slow: str, stands: str) -> None:
    loads = (STATIC, WEIGHT) if text is BOOM else (TORQUE, "")
    own, due = (forces(text, drive + loads[0], loads[1]) for drive in (stands, slow))
    for name in ("P_bal_forces", "P_bal_lever"):
        np.testing.assert_allclose(own[name].value, due[name].value, rtol=1e-9)


@pytest.mark.slow
def test_a_damper_bears_nothing_where_its_ends_stand() -> None:
    stands = "speed = 0\npositions = 4\n" + TORQUE
    damper = '[[spring]]\nbetween = ["A", "C"]\ndamping = "80 N*s/m"\n'
    spring = damper + 'rate = "2 kN/m"\nfree = "100 mm"\n'
    alone = spring.replace('damping = "80 N*s/m"\n', "")
    for own, due in ((damper, ""), (spring, alone)):
        found, wanted = (forces(ROCKER, stands + told) for told in (own, due))
        for name in ("P_bal_forces", "P_bal_lever"):
            np.testing.assert_array_equal(found[name].value, wanted[name].value)


def test_of_what_stands_a_starting_drive_asks_for_its_own_acceleration_alone() -> None:
    """At rest a point gains only ε·l: no normal acceleration, none of Coriolis."""
    starts = 'speed = 0\nacceleration = "3 rad/s^2"\npositions = 4\naccelerations = "all"\n'
    table = graphic_tmm.draw(scene(ROCKER, starts), exact=True).table("accelerations")
    moving = graphic_tmm.motion(scene(ROCKER, "speed = 1\n"), [90.0], exact=True)
    for link in (2, 3):
        due = 3.0 * moving.omega[link][0]
        np.testing.assert_allclose(table[f"epsilon{link}"].value[0, 1], due, rtol=1e-9)


def test_two_cranks_do_the_work_of_all_loads_together() -> None:
    text = ROCKER.format(drive="speed = 1\npositions = 4\n", loaded="")
    text = text.replace("[drive]", "[[drive]]").replace(
        "points = { C = [0, 0], B = [0.2, 0] }", "points = { D = [0, 0], B = [0.2, 0] }"
    )
    text = text.replace('side = "left of AC"', 'side = "left of AD"')
    fourth = "[[link]]\nnumber = 4\npoints = { C = [0, 0], D = [0.08, 0] }\n[[drive]]\nlink = 1"
    further = '\n[[drive]]\nlink = 4\nspeed = "2 rad/s"\nat = "40 deg"\n'
    text = text.replace("[[drive]]\nlink = 1", fourth) + further
    made = graphic_tmm.read(text + TORQUE.replace("[1]", '"all"'))
    table = graphic_tmm.draw(made, exact=True).table("forces")
    assert (table["P_bal_difference"].value == 0.0).all()
    driven = FORCES_PLAN.on(drawn_of(made)).driven
    assert [one.letter for one in driven] == ["P_{b1}", "P_{b4}"]
    motion = graphic_tmm.motion(graphic_tmm.read(text), [0.0, 90.0, 180.0, 270.0], exact=True)
    power = 10.0 * motion.omega[3]
    power += table["P_bal_forces"].value[0] * 0.1 * 1.0 + table["P_bal_4"].value[0] * 0.08 * 2.0
    np.testing.assert_allclose(power, 0.0, atol=1e-9 * np.abs(10.0 * motion.omega[3]).max())
    np.testing.assert_allclose(table["P_bal_lever"].value, table["P_bal_forces"].value, rtol=1e-9)
    balance = graphic_tmm.motion(
        made, [0.0, 90.0, 180.0, 270.0], plans=["forces"], exact=True
    ).balance
    for name in ("P_bal_forces", "P_bal_lever", "P_bal_4"):
        np.testing.assert_allclose(balance[name], table[name].value[0], rtol=1e-9)


def test_a_moment_balances_only_what_turns() -> None:
    with pytest.raises(TmmError, match="link 3 slides: it is balanced by a force"):
        forces(BOOM, OUT + STATIC + 'balance = "moment"\n', WEIGHT)


ROUGH = "[effects]\ngravity = true\nfriction = true\n[friction]\n"


@pytest.mark.parametrize(
    ("text", "drive", "loaded", "friction"),
    [
        (BOOM, OUT, WEIGHT, "f = 0.1\nradius = 0.02\n"),
        (
            SLIDER,
            'speed = "0.5 m/s"\nfrom = "250 mm"\nto = "350 mm"\npositions = 4\n',
            "",
            "f = 0.1\nradius = 0.02\n",
        ),
    ],
    ids=["rod", "slider"],
)  # fmt: skip
@pytest.mark.slow
def test_friction_takes_more_of_what_drives(
    text: str, drive: str, loaded: str, friction: str
) -> None:
    """Groups and lever agree, and the efficiency is what is done without friction to what is done with it."""
    loads = TORQUE.replace("[1]", '"all"') if text is SLIDER else "[forces]\n"
    smooth = forces(text, drive + "[effects]\ngravity = true\n" + loads, loaded)
    rough = forces(text, drive + ROUGH + friction + "passes = 8\n" + loads, loaded)
    own, due = (table["P_bal_forces"].value[0] for table in (rough, smooth))
    np.testing.assert_allclose(rough["P_bal_lever"].value[0], own, rtol=1e-5)
    pushed = due > 0.0
    share = np.where(pushed, due / own, own / due)
    assert ((share < 1.0) & (share > 0.5)).all()
    np.testing.assert_allclose(rough["efficiency"].value[0], 100.0 * share, atol=0.006)


def test_a_chapter_of_a_turning_crank_refuses_another_drive_in_one_sentence() -> None:
    with pytest.raises(
        TmmError, match="one crank drives all round; here link 3 slides: leave"
    ) as refused:
        graphic_tmm.draw(scene(BOOM, OUT + TORQUE + "[flywheel]\ndelta = 0.05\n")).table(
            "velocities"
        )
    assert "\n" not in str(refused.value)


SLOWLY = 'speed = "0.5 m/s"\nfrom = "250 mm"\nto = "350 mm"\npositions = 2\n'


@pytest.mark.parametrize(
    ("text", "drive", "closing"),
    [
        (ROCKER, "speed = 1\npositions = 4\n", [r"\bar{R}_{01}"]),
        (SLIDER, SLOWLY, [r"\u{\bar{P}_b}", r"\u{\bar{R}_{01}}"]),
        (SLIDER, SLOWLY + ROUGH + "f = 0.1\n", [r"\u{\bar{P}_b}", r"\u{\bar{R}_{01}}"]),
    ],
    ids=["crank", "slider", "rough slider"],
)
def test_a_line_stands_under_each_force_that_is_known_by_its_direction(
    text: str, drive: str, closing: list[str]
) -> None:
    work = drawn_of(scene(text, drive + TORQUE))
    group, link = (
        vectors_of(work, one, "en")[0].removesuffix(" = 0").split(" + ")
        for one in FORCES_PLAN.on(work).polygons
    )
    assert [term[:3] == r"\u{" for term in group] == [False] * (len(group) - 2) + [True, True]
    assert link[-len(closing) :] == closing
    assert all(term.startswith(r"\uu{") for term in (*group[:-2], *link[: -len(closing)]))


def test_what_holds_a_stone_has_a_direction_of_its_own_if_nothing_else_acts_on_the_stone() -> None:
    for name, closing in (
        ("windrower", [r"\u{\bar{R}_{63}^{n}}", r"\u{\bar{R}_{12}}"]),
        ("shock-absorber", [r"\u{\bar{R}_{03}^{n}}", r"\bar{R}_{12}"]),
    ):
        work = drawn(name)
        groups = FORCES_PLAN.on(work).groups
        (of_stone,) = (one.polygon for one in groups if one.closing.group.links == (2, 3))
        terms = vectors_of(work, of_stone, "en")[0].removesuffix(" = 0").split(" + ")
        assert terms[-2:] == closing
