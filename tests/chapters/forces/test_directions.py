"""Loads whose direction turns with the links: against Newton's and Euler's equations, on sheets, refused."""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.loaded import RATIO, errors, solve, weighed
from support.mechanisms import KINDS, Sampled, sample
from support.oracle import State, solve_fast

from graphic_tmm.chapters.forces.kinds import Along
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import ForcesTask, Load
from graphic_tmm.errors import SceneError
from graphic_tmm.readers.task_sheet import Posed, TaskSheet
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.read import read

ANGLES = (0.0, 90.0, -90.0, 180.0, 30.0, -72.5)


def lines_of(drawn: Sampled, state: State, pick: random.Random) -> tuple[Along, complex]:
    """A direction of two letters (of any links, the frame's too) or of a guide, and where it points."""
    letters = [one for one in state.points if isinstance(one, str)]
    guides = [(n, g) for n, link in drawn.mechanism.by_number.items() for g in link.guides]
    by = pick.choice(ANGLES)
    if guides and pick.randint(0, 1):
        number, guide = pick.choice(guides)
        turned = state.pose[number][2] + math.radians(guide.angle + by)
        return Along(guide.name, by), cmath.rect(1.0, turned)
    for _ in range(100):
        first, last = pick.sample(letters, 2)
        apart = state.points[last].r - state.points[first].r
        if abs(apart) > 1e-3 * state.size:
            return Along(first + last, by), apart / abs(apart) * cmath.rect(1.0, math.radians(by))
    raise AssertionError("all letters lie in one point")


def check(drawn: Sampled, seed: int) -> None:
    loaded, pick = weighed(drawn, seed), random.Random(seed)
    state = solve_fast(drawn.mechanism, drawn.phi, drawn.poses)
    forces, loads = [], []
    for _ in range(pick.randint(1, 4)):
        link = pick.choice([one for one in drawn.mechanism.links if one.points])
        letter, size = pick.choice(list(link.points)), pick.uniform(-500.0, 500.0)
        along, way = lines_of(drawn, state, pick)
        loads.append(Load(link.number, letter, size, along))
        forces.append((link.number, letter, size * way))
    one = loaded._replace(forces=forces, moments=())
    order = ForcesTask(
        ("all",),
        tuple(loads),
        gravity=bool(pick.randint(0, 1)),
        inertia=bool(pick.randint(0, 1)),
        balance=pick.choice(("force", "moment")),
    )
    solved = solve(one, drawn.phi, drawn.poses, order, turned=bool(pick.randint(0, 1)))
    found = errors(solved)
    assert max(found.values()) <= RATIO, (found, drawn.kinds, seed, solved.judge.condition)


@pytest.mark.parametrize("kind", KINDS)
def test_one_group_of_each_kind(kind: str, many: Callable[[int, int], int]) -> None:
    count = many(60, 6)
    for k, drawn in enumerate(sample(count, seed=KINDS.index(kind), dyads=(1, 1), kinds=[kind])):
        check(drawn, k)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_chains_of_groups(seed: int) -> None:
    for k, drawn in enumerate(sample(50, seed=7000 + seed, dyads=(2, 3))):
        check(drawn, 100 * seed + k)


SCENE = """
title = "Slider"
language = "en"
[frame]
O = [0, 0]
C = [0.04, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = [0.04, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.12, 0] }
guides = { z = { through = [0, 0], angle = "20 deg" } }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = 15
positions = 8
[forces]
positions = "all"
[[load]]
link = 2
point = "B"
force = "500 N"
direction = DIRECTION
"""


def scene_of(tmp_path: Path, direction: str) -> Path:
    file = tmp_path / "scene.toml"
    file.write_text(SCENE.replace("DIRECTION", f'"{direction}"'), encoding="utf8")
    return file


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("along AC", Along("AC")),
        ("вдоль z", Along("z")),
        ("square to OB", Along("OB", 90.0)),
        ("перпендикулярно OB", Along("OB", 90.0)),
        ("-30 deg to AB", Along("AB", -30.0)),
        ("0.5 rad к AB", Along("AB", math.degrees(0.5))),
        ("-30 deg", -30.0),
    ],
)
def test_what_is_written(tmp_path: Path, written: str, meant: object) -> None:
    order = read(scene_of(tmp_path, written)).tasks["forces"]
    assert isinstance(order, ForcesTask)
    found = order.loads[0].direction
    assert found == meant or math.isclose(found.by, meant.by)  # type: ignore[union-attr, attr-defined]


@pytest.mark.parametrize(
    ("written", "says"),
    [
        ("along AX", "neither two letters"),
        ("along AA", "one letter twice"),
        ("along y", "neither two letters"),
        ("sideways to AB", "along AC"),
    ],
)
def test_what_is_refused(tmp_path: Path, written: str, says: str) -> None:
    with pytest.raises(SceneError, match=says):
        read(scene_of(tmp_path, written))


def test_a_moment_has_no_line(tmp_path: Path) -> None:
    file = scene_of(tmp_path, "along AC")
    told = file.read_text(encoding="utf8").replace('point = "B"\nforce = "500 N"', "moment = 3")
    file.write_text(told, encoding="utf8")
    with pytest.raises(SceneError, match="no line of action"):
        read(file)


def test_a_guide_of_two_links_is_refused(tmp_path: Path) -> None:
    file = scene_of(tmp_path, "along z")
    told = file.read_text(encoding="utf8").replace("x = {", "z = {").replace('"x"', '"z"')
    file.write_text(told, encoding="utf8")
    with pytest.raises(SceneError, match="links 0, 2 have guides"):
        read(file)


def test_a_line_of_no_length_leaves_that_position_out(tmp_path: Path) -> None:
    made = drawn_of(read(scene_of(tmp_path, "along AC")), exact=True)
    balance = made.reading[FORCES_PLAN.on(made).first.balance][0]
    assert np.isnan(balance[0])  # there A stands on C
    assert np.isfinite(balance[1:]).all()
    told = {(one.step.it.view, one.step.it.name): one.positions for one in made.findings()}
    assert told["loads", "(AC)"] == (0,)


@pytest.mark.parametrize("by", [0.0, 90.0, 25.0])
@pytest.mark.parametrize("line", ["AC", "z", "x"])
def test_the_arrow_of_a_task_sheet(tmp_path: Path, line: str, by: float) -> None:
    scene = read(scene_of(tmp_path, f"{by} deg to {line}"))
    spots = {"O": 0j, "A": 3 + 4j, "B": 40 + 1j, "C": 4 + 0j}
    rod = cmath.rect(1.0, 0.3)
    posed = Posed(lambda letter, link: (spots[letter], 1j), 5.0, {0: 1 + 0j, 2: rod}.__getitem__)
    way = {"AC": (1 - 4j) / abs(1 - 4j), "z": rod * cmath.rect(1.0, math.radians(20)), "x": 1}[line]
    (shown,) = (one for part in chapters() for one in TaskSheet.of(part).acting(scene, posed))
    (letter,) = shown.wanted
    due = way * cmath.rect(1.0, math.radians(by))
    gone = letter.at - spots["B"]
    assert abs(gone / abs(gone) - due) < 1e-12
