"""Differentials that wheels close onto one shaft: all meshes as linear equations, books, what is refused."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction as F
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from support import train_oracle as oracle
from support.scenes import calling

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.trains.closed_torques import draw_closed_torques
from graphic_tmm.chapters.trains.plan import draw_planetary
from graphic_tmm.chapters.trains.task import SCHEMES, PlanetaryTask
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.table import results_of
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

Closed = tuple[tuple[str, tuple[int, ...]], ...]


def chained(closed: Closed) -> F:
    """How fast the second member turns by the first: along the wheels from shaft to shaft."""
    (_, one), (_, other) = closed
    turn = F(1)
    for row in (one, other[::-1]):
        for driving, driven in pairwise(row):
            turn = -turn * driving / driven
    return turn


def moving(
    scheme: str, teeth: tuple[int, ...], closed: Closed, driving: str
) -> dict[str, F] | None:
    """All angular velocities where ``driving`` turns by 1; None where it cannot, or both wheels turn alike."""
    (one, _), (other, _) = closed
    free = oracle.solved(scheme, teeth, {"1": F(1), "H": F(0)})
    if free is None or free[SCHEMES[scheme].meshes[-1].wheel] == 1:
        return None
    found = oracle.solved(scheme, teeth, {one: F(1), other: chained(closed)})
    if found is None or found[driving] == 0:
        return None
    return {body: omega / found[driving] for body, omega in found.items()}


def measured(order: PlanetaryTask) -> tuple[dict[str, float], float, float]:
    draft = Draft()
    made = draw_planetary(draft, order)
    reading = execute(draft.board.construction(), draft.given)
    values = {body: reading[mark].item() for body, mark in made.rates.values.items()}
    return values, reading[made.rates.due].item(), reading[made.rates.drawn].item()


@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_random_closed_differentials_roll(scheme: str, many: Callable[[int, int], int]) -> None:
    """Whatever drives, whatever is closed, with idlers or none: ω of all bodies, U by Willis and as drawn."""
    draw, refused, cases = random.Random(scheme + " closed"), 0, set()
    for _ in range(many(150, 25)):
        teeth = oracle.random_teeth(draw, scheme)
        driving, one, other = draw.choice("123"), *draw.sample(SCHEMES[scheme].members, 2)
        driving = SCHEMES[scheme].members[int(driving) - 1]
        rows = [tuple(draw.randint(12, 60) for _ in range(draw.choice((2, 2, 3)))) for _ in "12"]
        closed = ((one, rows[0]), (other, rows[1]))
        speed = draw.choice((-1, 1)) * draw.uniform(1.0, 300.0)
        order = PlanetaryTask(
            scheme, 0.004, speed, driving, teeth=teeth, satellites=(1,), closed=closed
        )
        due = moving(scheme, teeth, closed, driving)
        (left,) = {*SCHEMES[scheme].members} - {one, other}
        driven = left if driving in (one, other) else one
        if due is None or due[driven] == 0:
            with pytest.raises(StructureError):
                draw_planetary(Draft(), order)
            refused += 1
            continue
        cases.add((driving in (one, other), driven))
        values, willis, drawn = measured(order)
        most = max(abs(float(one)) for one in due.values()) * abs(speed)
        assert set(values) == set(due)
        for body, omega in values.items():
            assert omega == pytest.approx(speed * float(due[body]), abs=1e-8 * most), (order, body)
        assert willis == pytest.approx(float(1 / due[driven]), rel=1e-9)
        assert drawn == pytest.approx(willis, rel=1e-6)
    assert refused < many(150, 25) // 3
    assert len({closed for closed, _ in cases}) == 2


def ways(
    scheme: str, teeth: tuple[int, ...], closed: Closed, driving: str, eta: float
) -> list[dict[str, float]]:
    """Torques for each way power may flow that keeps itself up; "0": on the shaft of the first that is joined.

    That of 1 N·m comes in. A mesh hands on the share η of what it gets: with the carrier held from wheel 1 to
    the last or back, in the closing wheels from shaft to shaft. All as linear equations.
    """
    omega = {
        name: float(one) for name, one in (moving(scheme, teeth, closed, driving) or {}).items()
    }
    last = SCHEMES[scheme].meshes[-1].wheel
    inside = driving in (closed[0][0], closed[1][0])
    (one, row), (other, back) = (
        sorted(closed, key=lambda side: side[0] != driving) if inside else closed
    )
    meshes, found = len(row) + len(back) - 2, []
    names = ["1", last, "H", "0"]
    seen = {name: omega[name] - omega["H"] for name in ("1", last)}
    for held in (eta**2, eta**-2):
        for chain in (eta**meshes, eta**-meshes):
            balance = dict.fromkeys(("1", last, "H"), 1.0)
            mesh = {"1": seen["1"] * held, last: seen[last]}
            # what comes out of the wheels at the other member came from the shaft of the first one
            shaft = {"0": omega[one], one: -omega[one], other: -omega[other] / chain}
            comes = {"0" if inside else driving: 1.0}
            rows = [[of.get(name, 0.0) for name in names] for of in (balance, mesh, shaft, comes)]
            loads = dict(
                zip(names, np.linalg.solve(rows, [0.0, 0.0, 0.0, 1.0]).tolist(), strict=True)
            )
            power = loads["1"] * seen["1"], loads[other] * omega[other]
            if all(
                (one > 0) == (share < 1) for one, share in zip(power, (held, chain), strict=True)
            ):
                found.append(loads)
    return found


@pytest.mark.parametrize("eta", [1.0, 0.92])
def test_torques_are_those_of_all_meshes_in_balance(
    eta: float, many: Callable[[int, int], int]
) -> None:
    """Torques on all members and on the shared shaft, efficiency; what locks is said to hand on nothing."""
    draw, outcomes = random.Random("closed torques"), list[bool]()
    doubtful = 0
    for _ in range(many(300, 60)):
        scheme = draw.choice([*oracle.SENSES])
        teeth = oracle.random_teeth(draw, scheme)
        driving, one, other = (
            draw.choice(SCHEMES[scheme].members),
            *draw.sample(SCHEMES[scheme].members, 2),
        )
        rows = [tuple(draw.randint(12, 60) for _ in range(draw.choice((2, 2, 3)))) for _ in "12"]
        closed = ((one, rows[0]), (other, rows[1]))
        due = moving(scheme, teeth, closed, driving)
        (left,) = {*SCHEMES[scheme].members} - {one, other}
        inside = driving in (one, other)
        driven = left if inside else one
        if due is None or due[driven] == 0 or float(abs(due[driven])) < 1e-3:
            continue
        order = PlanetaryTask(
            scheme,
            0.004,
            50.0,
            driving,
            teeth=teeth,
            closed=closed,
            moment=1.0,
            mesh_efficiency=eta,
        )
        draft = Draft()
        made = draw_planetary(draft, order)
        assert made.motion.closing is not None
        _, marks, share = draw_closed_torques(draft, made, made.motion.closing)
        reading = execute(draft.board.construction(), draft.given)
        assert share is not None
        found, handed = (
            {name: reading[mark].item() for name, mark in marks.items()},
            reading[share].item(),
        )
        kept = ways(scheme, teeth, closed, driving, eta if eta < 1.0 else 1 - 1e-12)
        out = [-loads["0" if not inside else driven] * float(due[driven]) for loads in kept]
        good = [loads for loads, power in zip(kept, out, strict=True) if power > 0]
        outcomes.append(bool(good))
        if not good:
            assert handed <= 0.0
            continue
        # with large losses two ways may keep themselves up at once: it is one of them
        doubtful += len(good) > 1
        loads = min(good, key=lambda loads: abs(found["1"] - loads["1"]))
        most = max(map(abs, loads.values()))
        for name, load in loads.items():
            assert found[name] == pytest.approx(load, abs=1e-6 * most), (order, name)
        power = -loads["0" if not inside else driven] * float(due[driven])
        assert handed == pytest.approx(power, rel=1e-6)
    assert doubtful <= len(outcomes) // 50
    assert sum(outcomes) > len(outcomes) / 2
    assert all(outcomes) == (eta == 1.0)


HEAD = 'title = "T"\nlanguage = "en"\n'
TRAIN = '[planetary]\nscheme = "ring"\nmodule = "4 mm"\nspeed = "960 rpm"\nteeth = [24, 24, 72]\n'
WHEELS = 'closed = [["1", 20, 60], ["3", 60, 20, 30]]\n'


def test_power_circulates_where_one_member_gives_what_the_other_takes(tmp_path: Path) -> None:
    """24-24-72, ring by 20/60 and 30-20-60 from the sun: u = −1/6, U = 4/(1 − 3/6) = 8, no losses.

    M_3 = 3·M_1, M_0 = M_1·(1 − 3/6): of the power put in the sun gets twice as much, the ring gives half back.
    """
    scene = read(calling(tmp_path, TRAIN + WHEELS + 'moment = "20 N m"\n', sheet="", head=HEAD))
    (board,) = make(scene, exact=True).boards
    found = {name: value[0].item() for name, value in results_of(board).items()}
    assert found["planetary_ratio"] == pytest.approx(8.0)
    turns = {
        name: found[f"planetary_n_{name}"] for name in ("1", "3", "H", "4", "5", "6", "7", "8")
    }
    due = {"1": 960, "3": -160, "H": 120, "4": 960, "5": -320, "8": -320, "7": 480, "6": -160}
    assert turns == pytest.approx(due)
    torques = {name: found[f"planetary_M_{name}"] for name in ("0", "1", "3", "H")}
    assert torques == pytest.approx({"0": 20.0, "1": 40.0, "3": 120.0, "H": -160.0})
    assert found["planetary_N_1"] == pytest.approx(2.0 * found["planetary_N_0"])
    assert found["planetary_circulating"] == pytest.approx(1.0)
    assert found["planetary_efficiency"] == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("more", "says"),
    [
        (WHEELS + 'fixed = "3"\n', "leave fixed out"),
        (WHEELS + "behind = [15, 25]\n", "behind a differential no pair is drawn"),
        (WHEELS + "ratio = 4\n", "no ratio that teeth are sought by"),
        (WHEELS.replace('["3"', '["1"'), "two shafts are wanted"),
        (WHEELS.replace("20, 60", "20"), "two shafts are wanted"),
        ("closed = [20, 60]\n", "two shafts are wanted"),
        ('closed = "H"\n', "two shafts are wanted"),
        (WHEELS.replace("60, 20, 30", "60, 0"), "tooth numbers"),
        (WHEELS.replace('"3"', '"5"'), "two members are closed: of 1, 3, H"),
        (WHEELS.replace('"3"', "3"), "closed"),
        ('closed = [["H", 40, 20], ["3", 36, 24]]\n', "U_1H = 0: a shaft stands"),
    ],
)
def test_what_cannot_be_closed_is_refused(more: str, says: str, tmp_path: Path) -> None:
    with pytest.raises((SceneError, StructureError), match=says):
        make(read(calling(tmp_path, TRAIN + more, sheet="", head=HEAD)))


@pytest.mark.parametrize(
    ("scheme", "more"),
    [
        ("3K", "teeth = [24, 36, 96, 20, 80]\n"),
        ("bevel", "teeth = [20, 12, 20]\n"),
        ("external", "teeth = [40, 20]\n"),
    ],
)
def test_no_other_scheme_is_closed(scheme: str, more: str, tmp_path: Path) -> None:
    text = TRAIN.replace("ring", scheme).replace("teeth = [24, 24, 72]\n", more) + WHEELS
    with pytest.raises((SceneError, StructureError), match="leave closed out"):
        make(read(calling(tmp_path, text, sheet="", head=HEAD)))


@pytest.mark.parametrize(("teeth", "told"), [((20, 54, 50, 24), True), ((20, 57, 50, 27), False)])
def test_a_shaft_through_the_train_is_told(
    teeth: tuple[int, ...], told: bool, tmp_path: Path
) -> None:
    """To the roots of its teeth the ring takes 72 + 2.5 modules; the shaft stands off by half of 74, or 77."""
    one, two, three, four = teeth
    wheels = f'closed = [["1", {one}, {two}], ["3", {three}, {four}]]\n'
    (board,) = make(read(calling(tmp_path, TRAIN + wheels, sheet="", head=HEAD)), exact=True).boards
    says = [one for one in map(str, warnings(board)) if "through the wheels" in one]
    assert bool(says) == told
