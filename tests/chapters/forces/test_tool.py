"""An unknown force at a tool: against the judge of all links, by its power, at a dead place, in words."""

from __future__ import annotations

import random
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.against_judge import clear, page_is_right, parameter, reactions, ways
from support.boards import drawn_of
from support.free_bodies import Judge
from support.free_forces import statics
from support.random_mechanisms import KINDS, Random, drawn
from support.words_of_drives import FIVE_BAR, OPEN_CRANK, TURNS

import graphic_tmm
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.views import force_table, lever_views
from graphic_tmm.errors import TmmError

HEAD = 'title = "T"\nlanguage = "en"\n'
CLAMP = """
title = "Clamp"
language = "en"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = 1
extra = ["1 deg"]
[[load]]
link = 1
moment = "10 N*m"
[forces]
positions = "all"
balance = "moment"
unknown = { link = 3, point = "B", direction = "along x" }
"""


RUBS = "[effects]\nfriction = true\n[friction]\nf = 0.1\nradius = 0.01\n[forces]"


FAR = 100.0
"""A force that many times the others stands next to a dead place of the tool: rounding grows with it."""


def with_tool(found: Random, seed: int) -> dict[str, Any]:
    """The scene of a random mechanism with an unknown force somewhere on a moving link."""
    pick = random.Random(seed)
    body = pick.choice([b for b in found.judge.words.bodies if f"S{b.number}" in b.points])
    way = pick.choice((f"{pick.uniform(-180, 180)!r} deg", f"along S{body.number}{_fixed(found)}"))
    unknown = {"link": body.number, "point": f"S{body.number}", "direction": way}
    scene = found.row(found.walked[0][0], found.walked[-1][0], 6)
    kind = {} if found.judge.drives[0].kind == "turn" else {"balance": "force"}
    return scene | {"forces": scene["forces"] | {"unknown": unknown} | kind}


def _fixed(found: Random) -> str:
    return next(x for x, told in found.scene["frame"].items() if isinstance(told, list))


def loaded(scene: Mapping[str, Any], size: float) -> Judge:
    """The judge of a scene with a given force in place of the unknown one."""
    force = {**scene["forces"]["unknown"], "force": size}
    return Judge({**scene, "load": [*scene.get("load", ()), force]})


def judged(kinds: tuple[str, ...], drive: str, seed: int) -> int:
    """Compare all that is told in some places; return how many were."""
    found = next(r for k in range(9) if (r := drawn(seed + 1000 * k, (drive,), len(kinds), kinds)))
    scene, row, compared = with_tool(found, seed), ways(found, 4), 0
    zero = found.walked[0 if found.judge.drives[0].rate > 0 else -1][0]
    at = [parameter(found, way) for way in row]
    motion = graphic_tmm.motion(graphic_tmm.read(scene), at, exact=True, plans=("forces",))
    for k, way in enumerate(row):
        state = found.solved(way)
        if not clear(found, state):
            continue
        turned = float(np.degrees(way - zero) * np.sign(found.judge.drives[0].rate))
        none = statics(loaded(scene, 0.0), state, turned)
        size = none.largest or 1.0  # as large as the others, or the difference is lost in them
        per_newton = (statics(loaded(scene, size), state, turned).drives[0] - none.drives[0]) / size
        if abs(none.drives[0]) >= FAR * none.largest * abs(per_newton):
            continue
        due = -none.drives[0] / per_newton
        right = statics(loaded(scene, due), state, turned)
        assert abs(right.power) < 1e-9
        largest = max(right.largest, abs(due))
        assert abs(motion.balance["P_tool"][k] - due) <= 1e-8 * largest, (seed, k)
        for name, force in reactions(found.judge, right, motion.forces).items():
            assert abs(motion.forces[name][k] - force) <= 1e-8 * largest, (seed, name)
        (left,) = (values for name, values in motion.balance.items() if name.endswith("_bal_left"))
        assert abs(left[k]) <= 1e-8 * largest * max(1.0, found.judge.size)
        compared += 1
    return compared


@pytest.mark.parametrize("drive", ["crank", "slider", "rod"])
@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_group(kind: str, drive: str) -> None:
    assert judged((kind,), drive, 1) > 0


@pytest.mark.slow
@pytest.mark.parametrize("drive", ["crank", "slider", "rod"])
def test_random_chains_of_groups(drive: str) -> None:
    pick = random.Random(5)
    compared = [
        judged(tuple(pick.choices(KINDS, k=1 + seed % 4)), drive, seed) for seed in range(40)
    ]
    assert sum(compared) > 80


@pytest.mark.slow
def test_power_and_advantage_and_a_dead_place() -> None:
    sheet = graphic_tmm.draw(graphic_tmm.read(CLAMP), exact=True)
    table, speeds = sheet.table("forces"), sheet.table("velocities")
    force, gain = table["P_tool"].value[0], table["advantage"].value[0]
    v = speeds["pb"].value[0]
    k = [*range(1, 6), *range(7, 13)]
    np.testing.assert_allclose(np.abs(force[k]) * v[k], 10.0, rtol=1e-9)
    np.testing.assert_allclose(gain[k], 0.1 / v[k], rtol=1e-9)
    np.testing.assert_allclose(np.abs(table["M_bal_left"].value[0][k]), 0.0, atol=1e-9)
    assert force[1] > 0
    assert force[7] < 0
    assert abs(force[12]) > 4000
    assert np.isnan(force[[0, 6]]).all()
    says = "the point of the unknown force does not move along it"
    assert any(says in warning and "0, 6" in warning for warning in sheet.warnings)


def test_readings_leave_little_at_the_drive() -> None:
    table = graphic_tmm.draw(graphic_tmm.read(CLAMP.replace('"all"', "[1, 2, 4]"))).table("forces")
    apart = table["M_bal_difference"].value[0]
    assert 0.0 < np.nanmax(apart) < 2.0
    due = 100.0 * np.abs(table["M_bal_left"].value[0]) / 10.0  # N·m, of the crank
    np.testing.assert_allclose(apart, due, atol=0.051)  # told to a tenth
    made = drawn_of(graphic_tmm.read(CLAMP))
    one = FORCES_PLAN.on(made).first
    apart, left, whole = (
        made.reading[mark][0] for mark in (one.difference, one.balance, one.lever.balance)
    )
    np.testing.assert_allclose(apart, 100.0 * np.abs(left / whole), rtol=1e-12)
    np.testing.assert_allclose(np.abs(whole), 10.0, rtol=0.01)


@pytest.mark.slow
def test_the_page_works_its_steps(tmp_path: Path) -> None:
    page_is_right(tomllib.loads(CLAMP.replace('"all"', "[1, 2]")), tmp_path)


@pytest.mark.parametrize(
    ("put", "instead", "says"),
    [
        ("unknown = { link = 3", "unknown = { link = 0", "link 0 is the frame"),
        ("unknown = { link = 3", "unknown = { link = 9", "there is no link 9"),
        ('point = "B", d', 'point = "C", d', "is no letter of link 3"),
        ('"along x" }', '"against velocity" }', "either way along its line"),
        ('"along x" }', '"along q" }', "neither two letters"),
        ("link = 3, point = \"B\"", "link = 1, point = \"O\"", "O stands still"),
        ("[forces]", RUBS, "leave friction or unknown out"),
        ("[forces]", "[flywheel]\ndelta = 0.02\n[forces]", r"\[flywheel\] want all loads known"),
        ("[forces]", '[diagrams]\npoint = "B"\n[forces]', r"\[diagrams\] want all loads known"),
    ],
)  # fmt: skip
def test_what_cannot_be_sought_is_refused(put: str, instead: str, says: str) -> None:
    assert put in CLAMP
    with pytest.raises(TmmError, match=says):
        graphic_tmm.draw(graphic_tmm.read(CLAMP.replace(put, instead))).table("forces")


def test_one_force_balances_no_two_drives() -> None:
    further = '[[drive]]\nlink = 4\nspeed = 10\nat = "60 deg"\n'
    sought = (
        CLAMP[CLAMP.index("[forces]") :]
        .replace("link = 3", "link = 2")
        .replace("along x", "along OB")
    )
    text = "".join((HEAD, FIVE_BAR, OPEN_CRANK.replace("[drive]", "[[drive]]"), TURNS, further))
    with pytest.raises(TmmError, match="of one drive, here are 2: leave unknown out"):
        graphic_tmm.draw(graphic_tmm.read(text + sought)).table("forces")


def test_a_toggle_joint_of_a_page_for_engineers() -> None:
    """engineeringtoolbox.com/toggle-joint-d_2077: F = 883 N, a = 1983 mm, h = 258 mm; P = 3393 N, 3.8 F."""
    arm = abs(complex(1.983, 0.258))
    shut = f"{float(np.degrees(np.arcsin(0.258 / arm)))} deg"
    joint = (
        CLAMP.replace("[0.1, 0]", f"[{arm}, 0]")
        .replace("[0.3, 0]", f"[{arm}, 0]")
        .replace('extra = ["1 deg"]', f'from = "{shut}"\nto = "40 deg"\npositions = 3')
        .replace('side = "right"', 'side = "right", flips_at = []')
        .replace("link = 1\nmoment", 'link = 1\npoint = "A"\ndirection = "-90 deg"\nforce')
        .replace("10 N*m", "883 N")
    )
    value = graphic_tmm.draw(graphic_tmm.read(joint), exact=True).table("forces")["P_tool"].value
    assert abs(value[0, 0]) == pytest.approx(3393, abs=1)


def test_the_clamp_of_a_textbook() -> None:
    """Hibbeler, Engineering Mechanics: Statics, 14th ed., 6-80: link CD 10.93 F, at the arm's end 3.64 F."""
    table = graphic_tmm.draw(graphic_tmm.read("hand-clamp"), exact=True).table("forces")
    assert table["R12"].value[0, 0] == pytest.approx(1093, abs=0.5)
    assert table["P_tool"].value[0, 0] == pytest.approx(364, abs=0.5)
    assert abs(table["P_bal_left"].value[0, 0]) < 1e-9


def test_what_is_left_at_the_drive_keeps_its_sign() -> None:
    """In the table and under the lever: it is an error, whose sense no figure shows."""
    shown = '[[sheet]]\nformat = "A1"\nplace = ["lever"]\n'
    made = drawn_of(graphic_tmm.read(CLAMP.replace('"all"', "[1, 4]") + shown))
    one = FORCES_PLAN.on(made).first
    (above, below), (known, _) = (
        made.reading[mark][0][[1, 4]] for mark in (one.balance, one.lever.balance)
    )
    assert above > 0.0 > below
    assert known < 0.0
    table, *levers = (*force_table(made, lettered=True), *lever_views(made, lettered=True))
    assert {f"{above:.4f}", f"−{-below:.4f}"} <= {label.text for label in table.labels}
    verdicts = [label.text.rpartition(", ")[2] for view in levers for label in view.labels]
    for figure in (f"{above:.4g}", f"−{-below:.4g}"):
        assert f"M_{{b}} = {figure} N·m" in verdicts
