"""Torques on the shafts of a train, and its efficiency, by balance of power in the meshes."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from fractions import Fraction as F
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from support import train_oracle as oracle
from support.boards import usual_part
from support.scenes import calling

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.trains.motion import motion_of
from graphic_tmm.chapters.trains.plan import draw_planetary
from graphic_tmm.chapters.trains.table import train_results
from graphic_tmm.chapters.trains.task import SCHEMES, PlanetaryTask
from graphic_tmm.chapters.trains.torques import draw_torques
from graphic_tmm.chapters.trains.views import planetary_views
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make


def shares(teeth: tuple[int, ...], eta: float, driving: str, fixed: str, scheme: str) -> set[float]:
    """Efficiencies of a train by balance of power, for each way power may flow through the meshes.

    Seen from the carrier wheel 1 has the torque t and the rate x, the last one −t·i·k and x/i: k is η₀ where
    t·x > 0, that is, where wheel 1 drives in that motion, and 1/η₀ where it is driven.
    """
    omegas = oracle.solved(scheme, teeth, {driving: F(1), fixed: F(0)})
    assert omegas is not None
    last = "3" if scheme == "ring" else "4"
    omega = {name: float(one) for name, one in omegas.items()}
    seen = {name: omega[name] - omega["H"] for name in ("1", last)}
    found = set()
    for lost in (eta**2, eta**-2):
        loads = {"1": 1.0, last: -seen["1"] / seen[last] * lost}
        loads["H"] = -sum(loads.values())
        sign = math.copysign(1.0, loads[driving] * omega[driving])
        if (sign * loads["1"] * seen["1"] > 0.0) != (lost < 1.0):
            continue
        (driven,) = {"1", "H", last} - {driving, fixed}
        found.add(-loads[driven] * omega[driven] / (loads[driving] * omega[driving]))
    return found


def of_torques(order: PlanetaryTask) -> tuple[dict[str, float], float]:
    draft = Draft()
    made = draw_planetary(draft, order)
    _, torques, share = draw_torques(draft, made)
    reading = execute(draft.board.construction(), draft.given)
    assert share is not None
    return {name: reading[one].item() for name, one in torques.items()}, reading[share].item()


@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_torques_balance_and_losses_are_those_of_the_meshes(
    scheme: str, many: Callable[[int, int], int]
) -> None:
    draw, last = random.Random(scheme + " torques"), SCHEMES[scheme].wheels[-1]
    locked = 0
    for _ in range(many(100, 20)):
        teeth, eta = oracle.random_teeth(draw, scheme), draw.uniform(0.9, 0.999)
        driving, fixed = draw.sample(["1", last, "H"], 2)
        speed = draw.choice((-50.0, 50.0))
        order = PlanetaryTask(
            scheme, 0.004, speed, driving, fixed, teeth=teeth, moment=20.0, mesh_efficiency=eta
        )
        due = oracle.solved(scheme, teeth, {driving: F(1), fixed: F(0)})
        if due is None or due[motion_of(order).driven] == 0:
            continue
        torques, share = of_torques(order)
        assert sum(torques.values()) == pytest.approx(
            0.0, abs=1e-9 * max(map(abs, torques.values()))
        )
        assert torques[driving] == math.copysign(20.0, speed)
        expected = {one for one in shares(teeth, eta, driving, fixed, scheme) if one > 0.0}
        if not expected:
            # no way of the power keeps itself up: driven so the train does not move
            assert share <= 0.0
            locked += 1
        else:
            assert len(expected) == 1
            assert share == pytest.approx(*expected, rel=1e-6)
    assert locked < many(100, 20) // 4


@pytest.mark.parametrize(
    ("driving", "fixed", "share"),
    [
        ("1", "3", (1 + 3 * 0.9409) / 4),
        ("H", "3", 4 / (1 + 3 / 0.9409)),
        ("1", "H", 0.9409),
        ("3", "H", 0.9409),
    ],
)
def test_the_efficiency_of_the_book(driving: str, fixed: str, share: float) -> None:
    """(1 + u·η₀)/(1 + u) and (1 + u)/(1 + u/η₀) with u = z₃/z₁ = 3, η₀ = 0.97²."""
    order = PlanetaryTask(
        "ring", 0.005, 10.0, driving, fixed, teeth=(24, 24, 72), moment=20.0, mesh_efficiency=0.97
    )
    assert of_torques(order)[1] == pytest.approx(share, rel=1e-9)


@pytest.mark.parametrize(
    ("scheme", "teeth", "due"),
    [
        ("ring", (24, 24, 72), {"1": 10.0, "3": 30.0, "H": -40.0}),
        ("3K", (15, 20, 55, 15, 50), {"1": 10.0, "3": 770 / 3, "5": -800 / 3}),
    ],
)
def test_where_all_turn_as_one_nothing_is_lost(
    scheme: str, teeth: tuple[int, ...], due: dict[str, float]
) -> None:
    """Both shafts of a differential alike: no tooth slides, so the torques are those without losses."""
    drivers = [name for name in due if name != SCHEMES[scheme].wheels[-1]][:2]
    order = PlanetaryTask(
        scheme, 0.005, (10.0, 10.0), tuple(drivers), teeth=teeth, moment=10.0, mesh_efficiency=0.95
    )
    draft = Draft()
    _, torques, _ = draw_torques(draft, draw_planetary(draft, order))
    reading = execute(draft.board.construction(), draft.given)
    found = {name: reading[one].item() for name, one in torques.items()}
    assert found == pytest.approx(due, rel=1e-9)


def kept_up(teeth: tuple[int, ...], eta: float, driving: str, fixed: str) -> set[float]:
    """Efficiencies of a train of three central wheels, for each way power may flow and keep itself up.

    Seen from the carrier each wheel gives the satellite a share of its power: the mesh takes a part of what
    comes and asks for more than goes. These shares cancel, and so do the torques.
    """
    omegas = oracle.solved("3K", teeth, {driving: F(1), fixed: F(0)})
    assert omegas is not None
    (driven,) = {"1", "3", "5"} - {driving, fixed}
    seen = {name: float(omegas[name] - omegas["H"]) for name in (driving, driven, fixed)}
    found = set()
    for shares in product((eta, 1 / eta), repeat=3):
        worth = {name: one * share for (name, one), share in zip(seen.items(), shares, strict=True)}
        rows = [[1.0, 1.0], [worth[driven], worth[fixed]]]
        loads = [1.0, *np.linalg.solve(rows, [-1.0, -worth[driving]])]
        powers = [load * one for load, one in zip(loads, seen.values(), strict=True)]
        if all((power > 0) == (share < 1) for power, share in zip(powers, shares, strict=True)):
            found.add(-loads[1] * float(omegas[driven]))
    return found


def test_losses_of_three_central_wheels_are_those_of_their_meshes(
    many: Callable[[int, int], int],
) -> None:
    draw, locked = random.Random("three wheels"), 0
    for _ in range(many(150, 40)):
        teeth, eta = oracle.random_teeth(draw, "3K"), draw.uniform(0.9, 0.999)
        driving, fixed = draw.sample(["1", "3", "5"], 2)
        due = oracle.solved("3K", teeth, {driving: F(1), fixed: F(0)})
        order = PlanetaryTask(
            "3K", 0.004, 50.0, driving, fixed, teeth=teeth, moment=20.0, mesh_efficiency=eta
        )
        if due is None or due[motion_of(order).driven] == 0:
            continue
        torques, share = of_torques(order)
        assert sum(torques.values()) == pytest.approx(
            0.0, abs=1e-9 * max(map(abs, torques.values()))
        )
        expected = {one for one in kept_up(teeth, eta, driving, fixed) if one > 0.0}
        if not expected:
            assert share <= 0.0
            locked += 1
        else:
            assert len(expected) == 1
            assert share == pytest.approx(*expected, rel=1e-6)
    assert 0 < locked < many(150, 40) // 2


def test_the_machine_shaft_of_the_book() -> None:
    """Khurmi, ch. 13: 100 N·m on the motor's pinion of 15 teeth; no losses: 26.67 times as much on ring 5."""
    order = PlanetaryTask("3K", 0.005, 100.0, teeth=(15, 20, 55, 15, 50), moment=100.0)
    torques, share = of_torques(order)
    assert share == pytest.approx(1.0, rel=1e-9)
    assert torques == pytest.approx({"1": 100.0, "5": -8000 / 3, "3": 7700 / 3}, rel=1e-9)


@pytest.mark.parametrize(("eta", "moves"), [(0.95, False), (0.999, True)])
def test_of_a_train_that_locks_no_torques_are_given(
    eta: float, moves: bool, tmp_path: Path
) -> None:
    """3K 24-36-96, 35-95, driven by ring 5, U = -36: with 5 % lost in a mesh it stands."""
    text = (
        '[planetary]\nscheme = "3K"\nmodule = "5 mm"\nspeed = "100 rpm"\ndriving = "5"\nfixed = "3"\n'
        'teeth = [24, 36, 96, 35, 95]\nmoment = "10 N m"\n'
        f'mesh_efficiency = {eta}\n[[sheet]]\nplace = ["planetary"]\n'
    )
    head = 'title = "T"\nlanguage = "en"\n'
    drawn = usual_part("planetary", read(calling(tmp_path, text, sheet="", head=head)))
    told = {
        name for name in train_results(drawn) if name.startswith(("planetary_M", "planetary_eff"))
    }
    lines = [label.text for view in planetary_views(drawn, True) for label in view.labels]
    assert bool(told) == moves
    assert any(line.startswith("M_") for line in lines) == moves
    assert any("locks itself" in one for one in warnings(drawn, "en")) != moves


@pytest.mark.parametrize(("ruler", "told"), [("1 mm", True), ("0.01 mm", False)])
def test_an_efficiency_above_one_is_told(ruler: str, told: bool, tmp_path: Path) -> None:
    """Nothing is lost, angular velocities are read off: a coarse ruler makes more of it than 1."""
    text = (
        '[planetary]\nscheme = "ring"\nmodule = "5 mm"\nspeed = "97 rpm"\ndriving = "1"\nfixed = "H"\n'
        'teeth = [18, 40, 98]\nmoment = "10 N m"\nsatellites = 2\n'
        f'[hand]\nruler = "{ruler}"\n[[sheet]]\nplace = ["planetary"]\n'
    )
    scene = read(calling(tmp_path, text, sheet="", head='title = "T"\nlanguage = "en"\n'))
    (board,) = make(scene).boards
    says = [one for one in warnings(board, "en") if "more than 1" in one]
    assert bool(says) == told
