"""Any member of a train fixed, driving, driven, or two of them driven: against rolling contacts."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction as F
from pathlib import Path
from typing import Any

import pytest
from support import train_oracle as oracle
from support.scenes import calling

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.trains.motion import motion_of
from graphic_tmm.chapters.trains.plan import draw_planetary
from graphic_tmm.chapters.trains.task import SCHEMES, PlanetaryTask
from graphic_tmm.chapters.trains.tooth_search import choose, search
from graphic_tmm.chapters.trains.tooth_verdicts import check
from graphic_tmm.errors import StructureError
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.table import results_of
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make


@pytest.mark.parametrize("scheme", oracle.MESHES)
def test_random_trains_of_any_member_roll(scheme: str, many: Callable[[int, int], int]) -> None:
    """ω of all bodies as measured on the plan, and by Willis, to 1e-9 of the largest; or it is refused."""
    draw = random.Random(scheme)
    refused = 0
    for _ in range(many(100, 15)):
        teeth = oracle.random_teeth(draw, scheme)
        members = draw.sample(SCHEMES[scheme].members, 2)
        speeds = [draw.choice((-1, 1)) * draw.randint(1, 400) for _ in range(2)]
        order = PlanetaryTask(
            scheme, 0.004, float(speeds[0]), members[0], members[1], teeth=teeth,
            satellites=(draw.randint(1, 4),),
        )  # fmt: skip
        if draw.random() < 0.5:
            order = replace(
                order, speed=tuple(map(float, speeds)), driving=tuple(members), fixed=""
            )
        else:
            speeds[1] = 0
        due = oracle.solved(scheme, teeth, dict(zip(members, map(F, speeds), strict=True)))
        driven = motion_of(order).driven
        draft = Draft()
        if due is None or (0 in speeds and due[driven] == 0):
            with pytest.raises(StructureError):
                draw_planetary(draft, order)
            refused += 1
            continue
        made = draw_planetary(draft, order)
        reading = execute(draft.board.construction(), draft.given)
        most = float(max(abs(one) for one in due.values()))
        found = {body: float(reading[mark].item()) for body, mark in made.rates.values.items()}
        assert set(found) == {body for body in due if body != motion_of(order).fixed}
        for body, omega in found.items():
            assert abs(omega - float(due[body])) <= 1e-9 * most
        ratio = made.sizes.ratio is not None
        assert ratio == (0 in speeds and driven != "2")
        wanted = due[members[0]] / due[driven] if ratio else due[driven]
        assert reading[made.rates.due].item() == pytest.approx(float(wanted), rel=1e-9)
    assert refused < many(100, 15) // 4


@pytest.mark.parametrize("scheme", oracle.MESHES)
def test_the_table_shows_as_broken_what_is_told(scheme: str) -> None:
    """Conditions of the log, worked out by their numbers, break where the verdicts on the teeth say so."""
    draw, broken = random.Random(scheme + " conditions"), 0
    for _ in range(20):
        teeth, k = oracle.random_teeth(draw, scheme), draw.randint(1, 5)
        driving, fixed = SCHEMES[scheme].usual
        if scheme == "3K" and teeth[1] == teeth[3]:
            continue  # one ring stands as the other does
        order = PlanetaryTask(scheme, 0.004, 100.0, driving, fixed, teeth=teeth, satellites=(k,))
        draft = Draft()
        made = draw_planetary(draft, order)
        reading = execute(draft.board.construction(), draft.given)
        found: dict[str, list[bool]] = {}
        for one in made.sizes.conditions:
            left = reading[one.left].item()
            right = left if one.right is None else reading[one.right].item()
            holds = (
                left == round(left)
                if one.relation == "whole"
                else RELATIONS[one.relation](left, right)
            )
            found.setdefault(one.name, []).append(holds)
        told: dict[str, list[bool]] = {}
        for verdict in check(order, made.train):
            told.setdefault(verdict.condition, []).append(verdict.holds)
        assert {name: all(some) for name, some in found.items()} == {
            name: all(told[name]) for name in found
        }, (teeth, k)
        broken += not all(map(all, found.values()))
    assert broken > 5


RELATIONS: dict[str, Callable[[float, float], bool]] = {
    "=": lambda a, b: abs(a - b) <= 1e-12 * abs(b),
    ">": lambda a, b: a > b,
    "≥": lambda a, b: a >= b,
    "≤": lambda a, b: a <= b,
}


def test_a_differential_of_the_book() -> None:
    """Sun 100, ring −20 rpm, 24-24-72: carrier 10, satellite −80."""
    order = PlanetaryTask("ring", 0.005, (100.0, -20.0), teeth=(24, 24, 72))
    draft = Draft()
    made = draw_planetary(draft, order)
    reading = execute(draft.board.construction(), draft.given)
    found = {body: reading[mark].item() for body, mark in made.rates.values.items()}
    assert found == pytest.approx({"1": 100.0, "2": -80.0, "3": -20.0, "H": 10.0}, rel=1e-12)


@pytest.mark.parametrize(
    ("given", "member"),
    [
        ('scheme = "ring"\nspeed = ["72 rpm", "-24 rpm"]\nteeth = [24, 24, 72]', "H"),
        ('scheme = "ring"\ndriving = ["H", "1"]\nspeed = ["25 rpm", "100 rpm"]\nteeth = [24, 24, 72]', "3"),
        ('scheme = "bevel"\ndriving = ["1", "3"]\nspeed = ["70 rpm", "-70 rpm"]\nteeth = [20, 14, 20]', "H"),
        ('scheme = "external"\nspeed = ["20 rpm", "40 rpm"]\ndriving = ["H", "1"]\nteeth = [20, 20]', "2"),
    ],
)  # fmt: skip
def test_a_driven_shaft_that_stands_still_is_told(given: str, member: str, tmp_path: Path) -> None:
    """72·24 = 24·72 and the like; no share of nothing is calculated, in numbers or in words."""
    section = f'[planetary]\nmodule = "5 mm"\n{given}\n'
    scene = read(calling(tmp_path, section, sheet="", head='title = "T"\nlanguage = "en"\n'))
    (board,) = make(scene, exact=True).boards
    (only,) = [str(one) for one in warnings(board)]
    assert f"{member}, which is driven, stands still" in only
    found = {name: value[0].item() for name, value in results_of(board).items()}
    assert found["planetary_omega"] == pytest.approx(0.0, abs=1e-9)
    assert found[f"planetary_n_{member}"] == pytest.approx(0.0, abs=1e-7)
    assert "planetary_omega_difference" not in found


def test_what_cannot_be_made_is_told_and_drawn(tmp_path: Path) -> None:
    """18-12-42 and four satellites: speeds of 18-12-42 are carrier 0.3 and satellite −0.75 of the sun."""
    section = (
        '[planetary]\nscheme = "ring"\nmodule = "5 mm"\nspeed = "100 1/s"\nteeth = [18, 12, 42]\n'
        "satellites = [7]\n"
    )
    scene = read(calling(tmp_path, section, sheet="", head='title = "T"\nlanguage = "en"\n'))
    (board,) = make(scene, exact=True).boards
    told = [str(one) for one in warnings(board)]
    for says in (
        "undercut: z2 = 12 is less than 17",
        "roots of 12 teeth",
        "is not whole",
        "satellites touch",
    ):
        assert any(says in one for one in told), told
    turns = {
        name[-1]: value[0].item() for name, value in results_of(board).items() if "_n_" in name
    }
    assert turns["H"] / turns["1"] == pytest.approx(0.3, abs=1e-9)
    assert turns["2"] / turns["1"] == pytest.approx(-0.75, abs=1e-9)


@pytest.mark.parametrize(
    ("driving", "fixed", "ratio"),
    [("3", "1", 1.25), ("H", "1", 0.8), ("1", "H", -4.0), ("3", "H", -0.25), ("H", "3", 0.2)],
)
def test_teeth_are_found_for_any_member(driving: str, fixed: str, ratio: float) -> None:
    order = PlanetaryTask("ring", 0.005, 100.0, driving, fixed, ratio=ratio, tolerance=0.02)
    found = search(order)
    assert len(found) > 5
    teeth = choose(order).teeth
    due = oracle.solved("ring", teeth, {driving: F(1), fixed: F(0)})
    assert due is not None
    assert abs(float(1 / due[motion_of(order).driven]) - ratio) <= 0.021 * abs(ratio)


@pytest.mark.parametrize(
    ("scheme", "teeth", "given", "due"),
    [
        # Khurmi, Theory of Machines, ch. 13, example 4: an arm with wheels of 36 and 45 teeth
        ("external", (36, 45), {"H": 150, "1": 0}, {"2": 270}),
        ("external", (36, 45), {"H": 150, "1": -300}, {"2": 510}),
        # worked examples of epicyclic gears (studylib.net/doc/26184123), 1: annulus 72 fixed, wheel 32
        ("ring", (32, 20, 72), {"H": 18, "3": 0}, {"1": 58.5, "2": -46.8}),
        # Cardano: in a ring twice as large a wheel turns backwards as fast as its arm
        ("internal", (60, 30), {"H": 100, "1": 0}, {"2": -100}),
        # Khurmi, ch. 13: motor on 15 teeth, compound wheels 20 and 15, rings 55 (stands) and 50
        ("3K", (15, 20, 55, 15, 50), {"1": 1000, "3": 0}, {"5": 37.5, "H": 3000 / 14}),
        # the same: wheels 12, 30 and 14, in rad/s: A backwards at 1 rps, D forwards at 5 rps
        ("3K", (12, 30, 72, 14, 56), {"1": -1, "5": 5}, {"H": 4.4545, "3": 5.3636}),
    ],
)  # fmt: skip
def test_trains_of_the_books(
    scheme: str, teeth: tuple[int, ...], given: dict[str, float], due: dict[str, float]
) -> None:
    moving = {name: one for name, one in given.items() if one}
    (fixed,) = given.keys() - moving.keys() or {None}
    speeds: Any = tuple(moving.values()) if len(moving) > 1 else next(iter(moving.values()))
    drivers = tuple(moving) if len(moving) > 1 else next(iter(moving))
    order = PlanetaryTask(scheme, 0.005, speeds, drivers, fixed, teeth=teeth)
    draft = Draft()
    made = draw_planetary(draft, order)
    reading = execute(draft.board.construction(), draft.given)
    found = {body: reading[mark].item() for body, mark in made.rates.values.items()}
    assert {body: found[body] for body in due} == pytest.approx(due, rel=1e-4)
