"""Any member of a train fixed, driving, driven, or two of them driven: against rolling contacts."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction as F
from pathlib import Path

import pytest
from support import train_oracle as oracle
from support.scenes import calling

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.planetary.motion import motion_of
from graphic_tmm.chapters.planetary.plan import draw_planetary
from graphic_tmm.chapters.planetary.task import SCHEMES, PlanetaryTask
from graphic_tmm.chapters.planetary.tooth_search import choose, search
from graphic_tmm.chapters.planetary.torques import draw_torques
from graphic_tmm.errors import StructureError
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.table import results_of
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make


def solved(scheme: str, teeth: tuple[int, ...], given: dict[str, F]) -> dict[str, F] | None:
    """ω of all four bodies from two of them, by pure rolling at A and C; None if there is no one answer.

    ω_1·y_A = ω_H·y_B + ω_2·(y_A − y_B), ω_last·y_C = ω_H·y_B + ω_2·(y_C − y_B), and both givens.
    """
    a, b, c = oracle.radii(scheme, oracle.four(scheme, teeth), F(1))
    last = "3" if scheme == "ring" else "4"
    names = ["1", last, "H", "2"]
    rows = [[a, F(0), -b, b - a, F(0)], [F(0), c, -b, b - c, F(0)]]
    rows += [[F(int(name == one)) for one in names] + [value] for name, value in given.items()]
    for k in range(4):
        pivot = next((n for n in range(k, 4) if rows[n][k] != 0), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [one / rows[k][k] for one in rows[k]]
        for n in range(4):
            if n != k:
                rows[n] = [x - rows[n][k] * y for x, y in zip(rows[n], rows[k], strict=True)]
    return {name: row[4] for name, row in zip(names, rows, strict=True)}


def random_teeth(draw: random.Random, scheme: str) -> tuple[int, ...]:
    """Tooth numbers of one distance of axes, whether or not they can be made."""
    first, second = oracle.SENSES[scheme]
    while True:
        z1, z2, z3 = (draw.randint(6, 60) for _ in range(3))
        z4 = z1 + first * z2 - second * z3
        if scheme == "ring":
            return z1, z2, z1 + 2 * z2
        if z4 > 0 and z1 + first * z2 > 0:
            return z1, z2, z3, z4


@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_random_trains_of_any_member_roll(scheme: str, many: Callable[[int, int], int]) -> None:
    """ω of all bodies as measured on the plan, and by Willis, to 1e-9 of the largest; or it is refused."""
    draw = random.Random(scheme)
    last = SCHEMES[scheme].wheels[-1]
    refused = 0
    for _ in range(many(100, 15)):
        teeth = random_teeth(draw, scheme)
        members = draw.sample(["1", last, "H"], 2)
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
        due = solved(scheme, teeth, dict(zip(members, map(F, speeds), strict=True)))
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
        wanted = due[driven] if 0 not in speeds else due[members[0]] / due[driven]
        assert reading[made.rates.due].item() == pytest.approx(float(wanted), rel=1e-9)
    assert refused < 8


def test_a_differential_of_the_book() -> None:
    """Sun 100, ring −20 rpm, 24-24-72: carrier 10, satellite −80."""
    order = PlanetaryTask("ring", 0.005, (100.0, -20.0), teeth=(24, 24, 72))
    draft = Draft()
    made = draw_planetary(draft, order)
    reading = execute(draft.board.construction(), draft.given)
    found = {body: reading[mark].item() for body, mark in made.rates.values.items()}
    assert found == pytest.approx({"1": 100.0, "2": -80.0, "3": -20.0, "H": 10.0}, rel=1e-12)


def test_what_cannot_be_made_is_told_and_drawn(tmp_path: Path) -> None:
    """18-12-42 and four satellites: speeds of 18-12-42 are carrier 0.3 and satellite −0.75 of the sun."""
    section = (
        '[planetary]\nscheme = "ring"\nmodule = "5 mm"\nspeed = "100 1/s"\nteeth = [18, 12, 42]\n'
        "satellites = [7]\n"
    )
    scene = read(calling(tmp_path, section, sheet="", head='title = "T"\nlanguage = "en"\n'))
    (board,) = make(scene).boards
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
    assert turns["H"] / turns["1"] == pytest.approx(0.3, abs=2e-3)
    assert turns["2"] / turns["1"] == pytest.approx(-0.75, abs=2e-3)


@pytest.mark.parametrize(
    ("driving", "fixed", "ratio"),
    [("3", "1", 1.25), ("H", "1", 0.8), ("1", "H", -4.0), ("3", "H", -0.25), ("H", "3", 0.2)],
)
def test_teeth_are_found_for_any_member(driving: str, fixed: str, ratio: float) -> None:
    order = PlanetaryTask("ring", 0.005, 100.0, driving, fixed, ratio=ratio, tolerance=0.02)
    found = search(order)
    assert len(found) > 5
    teeth = choose(order).teeth
    due = solved("ring", teeth, {driving: F(1), fixed: F(0)})
    assert due is not None
    assert abs(float(1 / due[motion_of(order).driven]) - ratio) <= 0.021 * abs(ratio)


def shares(teeth: tuple[int, ...], eta: float, driving: str, fixed: str, scheme: str) -> set[float]:
    """Efficiencies of a train by balance of power, for each way power may flow through the meshes.

    Seen from the carrier wheel 1 has the torque t and the rate x, the last one −t·i·k and x/i: k is η₀ where
    t·x > 0, that is, where wheel 1 drives in that motion, and 1/η₀ where it is driven.
    """
    omegas = solved(scheme, teeth, {driving: F(1), fixed: F(0)})
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
        teeth, eta = random_teeth(draw, scheme), draw.uniform(0.9, 0.999)
        driving, fixed = draw.sample(["1", last, "H"], 2)
        speed = draw.choice((-50.0, 50.0))
        order = PlanetaryTask(
            scheme, 0.004, speed, driving, fixed, teeth=teeth, moment=20.0, mesh_efficiency=eta
        )
        due = solved(scheme, teeth, {driving: F(1), fixed: F(0)})
        if due is None or due[motion_of(order).driven] == 0:
            continue
        torques, share = of_torques(order)
        assert sum(torques.values()) == pytest.approx(
            0.0, abs=1e-9 * max(map(abs, torques.values()))
        )
        assert torques[driving] == math.copysign(20.0, speed)
        expected = shares(teeth, eta, driving, fixed, scheme)
        if not expected:
            # no way of the power keeps itself up: driven so the train does not move
            assert share <= 0.0
            locked += 1
        else:
            assert any(share == pytest.approx(one, rel=1e-6) for one in expected)
    assert locked < 15


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
