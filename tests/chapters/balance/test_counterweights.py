"""Counterweights found by replacing masses: full balance leaves nothing, partial is the closed form."""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.shaken import (
    HEAD,
    Put,
    drawn,
    four_bar_text,
    link_text,
    masses_of,
    shaken,
    slider_crank_text,
    states,
    vectors,
)

from graphic_tmm.chapters.balance.masses import Unbalance
from graphic_tmm.chapters.balance.plan import BALANCE_PLAN
from graphic_tmm.chapters.balance.table import balance_results
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.readers.findings import warnings

NOTHING = 1e-9
FULL = '[balance]\nmethod = "full"\n'


def sizes(made: Drawn, one: Unbalance) -> tuple[float, float, float]:
    """Return mass, radius and angle of a counterweight as it came out."""
    assert one.held is not None
    mass, radius, angle = (made.value(mark) for mark in one.held)
    return mass, radius, angle


def found(made: Drawn) -> list[Put]:
    """Return the counterweights as they came out, at their places in the links' own axes."""
    plans, mechanism = KINEMATICS_PLAN.on(made), KINEMATICS_PLAN.on(made).mechanism
    puts = []
    held = [one for one in BALANCE_PLAN.on(made).unbalances if one.held is not None]
    for one, weight in zip(held, BALANCE_PLAN.on(made).weights, strict=True):
        assert one.link == weight.link
        mass, radius, angle = sizes(made, one)
        body = plans.positions.bodies[one.link]
        pivot = mechanism.by_number[one.link].points[body.letter_of(weight.pivot)]
        place = pivot + cmath.rect(radius, math.radians(body.angle + angle))
        puts.append(Put(one.link, mass, place))
    return puts


def centres(made: Drawn, puts: list[Put]) -> np.ndarray:
    """Return the common centre of all masses in every position by vector loops, m."""
    mechanism, places = KINEMATICS_PLAN.on(made).mechanism, []
    whole = [*masses_of(mechanism), *puts]
    for state in states(made):
        total = 0j
        for link, mass, at in whole:
            x, y, angle = state.pose[link]
            total += mass * (complex(x, y) + at * cmath.rect(1.0, angle))
        places.append(total / sum(one.mass for one in whole))
    return np.array(places)


def check_full(made: Drawn) -> None:
    balance = BALANCE_PLAN.on(made)
    assert balance.weighted is not None
    (bare, _), (left, _) = (vectors(made, one) for one in balance.wholes)
    assert np.abs(left).max() < NOTHING * np.abs(bare).max()
    puts = found(made)
    mechanism = KINEMATICS_PLAN.on(made).mechanism
    due = [shaken(state, [*masses_of(mechanism), *puts], "O") for state in states(made)]
    assert max(abs(force) for force, _ in due) < NOTHING * np.abs(bare).max()
    without, held = centres(made, []), centres(made, puts)
    assert np.ptp(held.real) + np.ptp(held.imag) < NOTHING
    assert np.ptp(without.real) + np.ptp(without.imag) > 1e-3


@pytest.mark.parametrize("text", [four_bar_text, slider_crank_text])
@pytest.mark.parametrize("in_line", [True, False])
def test_full_balance_leaves_nothing_and_holds_the_centre(
    text: Callable[..., str], in_line: bool, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    for seed in range(many(30, 4)):
        pick = random.Random(seed)
        told = pick.choice(("", "[[counterweight]]\nlink = 1\nradius = 0.07\n"))
        told += pick.choice(("", "[[counterweight]]\nlink = {}\nmass = 5.5\n"))
        other = 3 if text is four_bar_text else 2
        check_full(drawn(tmp_path, text(pick, in_line=in_line) + told.format(other) + FULL))


SIX = (
    link_text(4, {"D": 0j, "E": 0.7 + 0j, "S4": 0.1 + 0.03j}, 1.1, 0.01)
    + link_text(5, {"E": 0j, "S5": 0.01 + 0j}, 0.9)
    + 'slides = { on = "frame", along = "y", side = "+" }\n'
)


def test_full_balance_of_two_groups(tmp_path: Path, many: Callable[[int, int], int]) -> None:
    """A slider on a rod that hangs on the rocker: its rod's counterweight makes it a mass at the pin."""
    for seed in range(many(20, 3)):
        text = four_bar_text(random.Random(seed))
        text = text.replace("[frame]\n", '[frame]\ny = { through = [0.5, 0], angle = "60 deg" }\n')
        head, drive = text.split("[drive]")
        pin = "S3 = "
        head = head.replace(pin, f"D = [0.15, 0.05], {pin}")
        check_full(drawn(tmp_path, f"{head}{SIX}[drive]{drive}{FULL}"))


SHAPER = f"""{HEAD}[frame]
O = [0, 0]
C = [0, -0.25]
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.1, 0], S1 = [0.03, 0.01] }}
mass = 2.0
centre = "S1"
[[link]]
number = 2
points = {{ A = [0, 0] }}
slides = {{ on = 3, along = "CB", side = "+" }}
mass = 0.7
centre = "A"
[[link]]
number = 3
points = {{ C = [0, 0], B = [0.5, 0], S3 = [0.26, 0.02] }}
mass = 5.0
centre = "S3"
J = 0.1
[drive]
link = 1
speed = "90 rpm"
turns = "clockwise"
positions = 8
"""


def test_full_balance_of_a_slotted_rocker(tmp_path: Path) -> None:
    check_full(drawn(tmp_path, SHAPER + FULL + '[[counterweight]]\nlink = 3\nradius = "0.2 m"\n'))


@pytest.mark.parametrize("letter", ["B", "D"])
def test_a_slotted_rocker_has_no_pin_to_take_a_radius_from(letter: str, tmp_path: Path) -> None:
    """Whether its letters come before or behind that of its pivot makes no difference."""
    text = SHAPER.replace("CB", f"C{letter}").replace("B = [0.5, 0]", f"{letter} = [0.5, 0]")
    with pytest.raises(StructureError, match=r'link = 3 and radius = "100 mm"') as error:
        drawn(tmp_path, text + FULL)
    assert error.value.keys == ("counterweight",)


@pytest.mark.parametrize("share", [None, 0.0, 0.3, 1.0])
def test_partial_balance_is_the_closed_form(share: float | None, tmp_path: Path) -> None:
    """In line, m_c·r_c = m_1·s_1 + (m_2A + k·(m_3 + m_2B))·r, opposite the pin."""
    for seed in range(3):
        text = slider_crank_text(random.Random(seed), in_line=True)
        told = "" if share is None else f"share = {share}\n"
        made = drawn(
            tmp_path,
            f'{text}[balance]\nmethod = "partial"\n{told}[[counterweight]]\nlink = 1\nradius = 0.05\n',
        )
        first, second, third = KINEMATICS_PLAN.on(made).mechanism.links
        r, s = abs(first.points["A"]), first.points["S1"].real
        rod, at = abs(second.points["B"]), second.points["S2"].real
        assert first.mass is not None
        assert second.mass is not None
        assert third.mass is not None
        sliding = third.mass + second.mass * at / rod
        kept = 0.5 if share is None else share
        due = first.mass * s + (second.mass * (rod - at) / rod + kept * sliding) * r
        (one,) = BALANCE_PLAN.on(made).unbalances
        mass, radius, angle = sizes(made, one)
        assert mass * radius == pytest.approx(due, rel=1e-12)
        assert radius == pytest.approx(0.05)
        assert abs(angle) == pytest.approx(180.0)
        # what is left along and across the guide: (1 − k)·m_B·a_B, less k·m_B of what turns
        weighted = BALANCE_PLAN.on(made).weighted
        assert weighted is not None
        forces, _ = vectors(made, weighted)
        for force, state in zip(forces, states(made), strict=True):
            left = -sliding * (state.points["B"].a - kept * state.points["A"].a)
            assert abs(force - left) < 1e-9 * np.abs(forces).max()


def test_partial_balance_of_a_four_bar_is_on_the_crank_alone(tmp_path: Path) -> None:
    text = four_bar_text(random.Random(5), in_line=True)
    made = drawn(tmp_path, f'{text}[balance]\nmethod = "partial"\n')
    first, second, _ = KINEMATICS_PLAN.on(made).mechanism.links
    (one,) = BALANCE_PLAN.on(made).unbalances
    r, rod, at = abs(first.points["A"]), abs(second.points["B"]), second.points["S2"].real
    assert first.mass is not None
    assert second.mass is not None
    due = first.mass * first.points["S1"].real + second.mass * (rod - at) / rod * r
    mass, radius, _ = sizes(made, one)
    assert mass * radius == pytest.approx(due, rel=1e-12)
    assert radius == pytest.approx(r)


def test_a_crank_that_is_balanced_already_is_told(tmp_path: Path) -> None:
    text = slider_crank_text(random.Random(2), in_line=True)
    made = drawn(tmp_path, f'{text}[balance]\nmethod = "partial"\nshare = 1\n')
    first = KINEMATICS_PLAN.on(made).mechanism.links[0]
    (one,) = BALANCE_PLAN.on(made).unbalances
    assert first.mass
    mass, radius, _ = sizes(made, one)
    whole = mass * radius
    at = first.points["S1"].real - whole / first.mass
    old = f"S1 = [{first.points['S1'].real!r}, {first.points['S1'].imag!r}]"
    assert old in text
    made = drawn(
        tmp_path,
        f'{text.replace(old, f"S1 = [{at!r}, 0]")}[balance]\nmethod = "partial"\nshare = 1\n',
    )
    assert any("link 1 is balanced already" in line for line in warnings(made, "en"))
    assert {"counterweight_mass_1", "shaking_removed"}.isdisjoint(single(balance_results(made)))
    assert not BALANCE_PLAN.on(made).weights


def test_what_the_method_does_not_treat_is_refused(tmp_path: Path) -> None:
    text = slider_crank_text(random.Random(1))
    with pytest.raises(
        StructureError, match="link 3 bears no counterweight; the links that do: 1, 2"
    ):
        drawn(tmp_path, f"{text}[[counterweight]]\nlink = 3\nradius = 0.1\n{FULL}")
    with pytest.raises(StructureError, match="link 3 does not turn about a pin"):
        drawn(tmp_path, f"{text}[[counterweight]]\nlink = 3\nradius = 0.1\nmass = 1\n[balance]\n")
    off = SHAPER.replace("points = { A = [0, 0] }", "points = { A = [0, 0], S2 = [0.01, 0] }")
    with pytest.raises(StructureError, match='centre = "A"'):
        drawn(tmp_path, off.replace('centre = "A"', 'centre = "S2"') + FULL)


TWICE = 2 * "[[counterweight]]\nlink = 1\nradius = 0.1\n"


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ("[[counterweight]]\nlink = 1\nradius = 0.1\n[balance]\n", "nothing finds it"),
        (f"[[counterweight]]\nlink = 1\nradius = 0.1\nmass = 1\n{FULL}", "leave one of them out"),
        (f'[[counterweight]]\nlink = 1\nradius = 0.1\nangle = "9 deg"\n{FULL}', "finds the angle"),
        (f"{FULL}share = 0.5\n", "only the partial method"),
        ('[balance]\nabout = "A"\n', "write one of O"),
        (
            TWICE + FULL,
            "has a counterweight already",
        ),
        (f"[[counterweight]]\nlink = 9\nradius = 0.1\n{FULL}", "9"),
    ],
)
def test_contradictions_of_a_scene(more: str, says: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=says):
        drawn(tmp_path, slider_crank_text(random.Random(1)) + more)
