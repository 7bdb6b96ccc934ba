"""Forces of plates on three legs (class III) against Newton's and Euler's equations of all links at once."""

from __future__ import annotations

import cmath
import math
import random
import re
import tomllib
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from chapters.forces.test_force_sheets import check as check_sheet
from chapters.forces.test_force_sheets import sheet
from support.boards import drawn_of
from support.free_bodies import Judge, State
from support.free_forces import statics
from support.held_plates import held_plate
from support.loaded import RATIO, errors, order_of, solve, weighed
from support.sheet_reader import lines
from support.wrenches import StaticsError

import graphic_tmm
from graphic_tmm.chapters.forces.table import force_columns
from graphic_tmm.chapters.forces.task import Friction
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.structure import dissect

TRIAD = """
title = "Triad"
language = "en"
[frame]
O = [0, 0]
D = [0.3, -0.05]
E = [0.42, 0.12]
[[link]]
number = 1
points = { O = [0, 0], A = [0.05, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.2, 0], S2 = [0.1, 0.01] }
mass = "1.2 kg"
centre = "S2"
J = 0.004
[[link]]
number = 3
points = { B = [0, 0], C = [0.12, 0], F = [0.07, 0.08], S3 = [0.063, 0.027] }
mass = "2 kg"
centre = "S3"
J = 0.006
near = "-114 deg"
[[link]]
number = 4
points = { C = [0, 0], D = [0.18, 0], S4 = [0.09, 0] }
mass = "1 kg"
centre = "S4"
J = 0.003
LEG
[effects]
gravity = true
inertia = true
[[load]]
link = 3
point = "S3"
force = "60 N"
direction = "-70 deg"
[[load]]
link = 3
moment = "4 N*m"
[[load]]
link = 4
moment = "-2 N*m"
[forces]
positions = [2]
"""
TURNS = TRIAD.replace(
    "LEG",
    """
[[link]]
number = 5
points = { F = [0, 0], E = [0.2, 0], S5 = [0.1, 0] }
mass = "1.1 kg"
centre = "S5"
J = 0.004
[drive]
link = 1
speed = 10
positions = 6
from = "0 deg"
to = "100 deg"
accelerations = "all"
""",
)
PUSHED = (
    TRIAD.replace("O = [0, 0]\nD", "A = [0.04, 0.05]\nD", 1)
    .replace("[[link]]\nnumber = 1\npoints = { O = [0, 0], A = [0.05, 0] }\n", "")
    .replace(
        "LEG",
        """
[[link]]
number = 5
points = { E = [0, 0], S5 = [0.05, 0.01] }
mass = "1.1 kg"
centre = "S5"
J = 0.004
guides = { z = { through = [0, 0], angle = 0 } }
[[link]]
number = 6
points = { F = [0, 0], S6 = [-0.05, 0] }
mass = "0.5 kg"
centre = "S6"
J = 0.001
slides = { on = 5, along = "z", side = "+" }
[drive]
link = 6
speed = "0.1 m/s"
from = "0.18 m"
to = "0.22 m"
positions = 3
accelerations = "all"
[[load]]
link = 6
point = "S6"
force = "25 N"
direction = "20 deg"
[[load]]
link = 5
moment = "1.5 N*m"
""",
    )
)


GUIDED = TURNS.replace(
    "points = { F = [0, 0], E = [0.2, 0], S5 = [0.1, 0] }",
    'points = { F = [0, 0], S5 = [0.02, 0.03] }\nslides = { on = "frame", along = "u" }',
).replace("E = [0.42, 0.12]", 'u = { through = [0.2375, 0.038], angle = "114 deg" }', 1)
"""Its third leg is a slider whose weight, off its pin, its guide holds by a couple."""
HUNG = (
    TURNS.replace("S3 = [0.063, 0.027] }", "S3 = [0.063, 0.027], G = [0.05, -0.06] }")
    .replace("E = [0.42, 0.12]\n", "E = [0.42, 0.12]\nK = [0.05, 0.25]\n", 1)
    .replace(
        "[drive]",
        """[[link]]
number = 6
points = { G = [0, 0], H = [0.13, 0], S6 = [0.06, 0] }
mass = "0.7 kg"
centre = "S6"
J = 0.001
side = "left of GK"
[[link]]
number = 7
points = { H = [0, 0], K = [0.12, 0] }
[[load]]
link = 7
moment = "3 N*m"
[drive]""",
    )
)
"""A dyad hangs on its plate."""
TWO_DRIVES = (
    PUSHED.replace("A = [0.04, 0.05]\nD", "O = [0, 0]\nD")
    .replace(
        "[[link]]\nnumber = 2",
        "[[link]]\nnumber = 1\npoints = { O = [0, 0], A = [0.05, 0] }\n[[link]]\nnumber = 2",
        1,
    )
    .replace(
        "[drive]",
        """[[drive]]
link = 1
speed = 10
from = "30 deg"
to = "60 deg"
positions = 3
accelerations = "all"
[[drive]]""",
    )
    .replace('from = "0.18 m"\nto = "0.22 m"\npositions = 3\naccelerations = "all"', 'at = "0.2 m"')
)
"""A crank and a cylinder drive it."""
ROUGH = """
[friction]
f = 0.1
radius = "10 mm"
passes = 3
"""


def rough(text: str) -> str:
    return text.replace("inertia = true", "inertia = true\nfriction = true") + ROUGH


TWO_GUIDES = (
    GUIDED.replace(
        "points = { C = [0, 0], D = [0.18, 0], S4 = [0.09, 0] }",
        'points = { C = [0, 0], S4 = [0.03, -0.02] }\nslides = { on = "frame", along = "w" }',
    )
    .replace("D = [0.3, -0.05]", 'w = { through = [0.143, 0.038], angle = "240.7 deg" }', 1)
    .replace('to = "100 deg"', 'to = "60 deg"')
)
"""Two of its legs are sliders."""
GUIDE = """near = "{} deg"
near_at = "0 deg"
guides = {{ z = {{ through = [0.07, 0.03], angle = "80 deg" }} }}"""
STONE = """points = { E = [0, 0], S5 = [0.05, 0.01] }
slides = { on = 3, along = "z" }"""
ALONG, THIRD_ALONG = (
    TURNS.replace("points = { F = [0, 0], E = [0.2, 0], S5 = [0.1, 0] }", STONE)
    .replace("C = [0.12, 0], F = [0.07, 0.08]", "C = [0.12, 0]")
    .replace("E = [0.42, 0.12]", "E = [0.2, 0.12]")
    .replace('near = "-114 deg"', GUIDE.format(near))
    for near in (-20.891, 69.632)
)
"""A leg slides along its plate: in the special point its line crosses another's, or it is the third."""
SHEETS = {
    "turns": TURNS,
    "pushed": PUSHED,
    "guided": GUIDED,
    "hung": HUNG,
    "two drives": TWO_DRIVES,
    "rough": rough(GUIDED),
    "two rough guides": rough(TWO_GUIDES),
    "along it": ALONG,
    "third along it": THIRD_ALONG,
}


def check(seed: int, guides: int, behind: int, slots: int = 0) -> None:
    drawn = (held := held_plate(seed, guides, behind, slots)).drawn
    loaded, pick = weighed(drawn, seed), random.Random(seed)
    gravity, inertia, turned = (bool(pick.randint(0, 3)) for _ in range(3))
    order = order_of(
        loaded,
        gravity=gravity,
        inertia=inertia,
        balance=pick.choice(("force", "moment")),
        couples=pick.choice(("moment", "pair")),
    )
    frame = drawn.mechanism.frame.number
    poses = {number: pose for number, pose in drawn.poses.items() if number != frame}
    solved = solve(loaded, drawn.phi, poses, order, turned=turned, branches=held.branches)
    found = errors(solved)
    assert max(found.values()) <= RATIO, (seed, guides, behind, slots, found)


def check_all(seeds: list[int], guides: int, behind: Callable[[int], int], slots: int = 0) -> None:
    """Check machines of seeds but for those that are refused: they are elsewhere after a turn of the drive."""
    left = 0
    for seed in seeds:
        try:
            check(seed, guides, behind(seed), slots)
        except StructureError as error:
            assert "another of its places after a turn" in str(error)  # noqa: PT017
            left += 1
    assert left <= len(seeds) // 3


@pytest.mark.parametrize("behind", range(3))
@pytest.mark.parametrize("guides", range(4))
def test_a_plate_on_any_legs_bears_as_newton_and_euler_say(
    guides: int, behind: int, many: Callable[[int, int], int]
) -> None:
    """Reactions, what balances the crank, the lever; legs on the frame, the crank, links of another dyad."""
    check_all(
        [9000 + 100 * behind + seed for seed in range(many(150, 4))], guides, lambda _: behind
    )


@pytest.mark.parametrize(("guides", "slots"), [(0, 1), (1, 1), (2, 1), (0, 2), (1, 2), (0, 3)])
def test_a_plate_with_legs_along_it_bears_as_newton_and_euler_say(
    guides: int, slots: int, many: Callable[[int, int], int]
) -> None:
    """What such a leg does to the plate is square to the guide, with what turns it about its pivot."""
    check_all([9500 + seed for seed in range(many(150, 6))], guides, lambda seed: seed % 3, slots)


@pytest.mark.parametrize(
    ("guides", "slots"),
    [(0, 0), (1, 0), (2, 0), (3, 0), (0, 1), (1, 1), (2, 1), (0, 2), (1, 2), (0, 3)],
)
def test_friction_of_a_plate_settles_at_the_judges_equilibrium(
    guides: int, slots: int, many: Callable[[int, int], int]
) -> None:
    """What holds a rough guide leans, so the special point stands elsewhere in each pass."""
    count, refused = many(40, 4), 0
    for seed in range(700, 700 + count):
        drawn = (held := held_plate(seed, guides, seed % 2, slots)).drawn
        links = drawn.mechanism.links
        size = max(abs(point) for link in links for point in link.points.values())
        names = [pair.name for pair in dissect(drawn.mechanism).pairs]
        rough = Friction(dict.fromkeys(names, 0.03), dict.fromkeys(names, 0.02 * size), 25)
        loaded = weighed(drawn, seed)
        order = order_of(loaded, gravity=True, inertia=True, friction=rough)
        frame = drawn.mechanism.frame.number
        poses = {number: pose for number, pose in drawn.poses.items() if number != frame}
        try:
            solved = solve(loaded, drawn.phi, poses, order, branches=held.branches)
        except StructureError as error:
            assert "another of its places after a turn" in str(error)  # noqa: PT017
            continue
        except StaticsError:
            refused += 1
            continue
        assert max(errors(solved).values()) <= RATIO, (seed, errors(solved))
    assert refused <= count // 10


def judged(text: str, at: list[float]) -> None:
    """Compare forces of a scene at coordinates of its drive with the judge, who begins from its places."""
    scene: dict[str, Any] = tomllib.loads(text)
    judge = Judge(scene)
    found = graphic_tmm.motion(text, at, plans=("positions", "forces"), exact=True)
    for k, coordinate in enumerate(at):
        turn = math.radians(coordinate) if judge.drives[0].kind == "turn" else coordinate
        state: State = judge.solve([turn], near(scene, found, k))
        due = statics(judge, state)
        assert due.power < 1e-12
        for name, row in found.forces.items():
            pair = int(name[1]), int(name[2])
            assert abs(row[k] - due.reactions[pair]) <= 1e-8 * due.largest, (name, coordinate)
        for name, balance in found.balance.items():
            assert abs(balance[k] - due.drives[0]) <= 1e-8 * due.largest, (name, coordinate)


def near(scene: dict[str, Any], found: graphic_tmm.Motion, k: int) -> list[tuple[complex, float]]:
    """The poses of all links in a position, from two of their points each."""
    poses = []
    for link in scene["link"]:
        own = {letter: complex(*at) for letter, at in link["points"].items()}
        (a, at_a), (b, at_b) = list(own.items())[:2]
        places = [found.places[letter, link["number"]][k] for letter in (a, b)]
        turn = cmath.phase((places[1] - places[0]) / (at_b - at_a))
        poses.append((places[0] - at_a * cmath.rect(1.0, turn), turn))
    return poses


def test_the_triad_of_the_book_bears_as_newton_and_euler_say() -> None:
    judged(TURNS, [0.0, 20.0, 60.0, 100.0])


def test_a_cylinder_under_a_plate_pushes_as_newton_and_euler_say() -> None:
    """A rod driven out of its cylinder is a leg of the plate: its force is read off the group's polygon."""
    judged(PUSHED, [0.18, 0.2, 0.22])


def test_a_dyad_hands_its_reactions_on_to_a_plate() -> None:
    judged(HUNG, [0.0, 40.0, 80.0])


def test_each_of_two_drives_has_its_lever() -> None:
    """On the lever of one the other is held: the plate and its legs turn as that one alone moves them."""
    ways = [30.0, 45.0, 60.0]
    balance = graphic_tmm.motion(TWO_DRIVES, ways, plans="forces", exact=True).balance
    for groups, lever in (("P_bal_forces", "P_bal_lever"), ("P_bal_6", "P_bal_6_lever")):
        np.testing.assert_allclose(balance[groups], balance[lever], rtol=1e-10)


def test_a_slider_under_a_plate_bears_as_newton_and_euler_say() -> None:
    judged(GUIDED, [0.0, 40.0, 80.0])
    judged(TWO_GUIDES, [10.0, 40.0, 55.0])


@pytest.mark.parametrize("name", ["along it", "third along it"])
def test_a_stone_on_a_plate_bears_as_newton_and_euler_say(name: str) -> None:
    judged(SHEETS[name], [0.0, 20.0, 40.0])


def test_where_the_legs_meet_in_one_point_nothing_is_told() -> None:
    """Up to there the lever agrees with the groups, however large forces grow; behind it there are none."""
    ways = [121.0, 122.0, 122.2, 122.25, 122.3, 200.0]
    with np.errstate(all="raise"):
        found = graphic_tmm.motion(TURNS, ways, plans="forces", exact=True)
    groups, lever = found.balance["P_bal_forces"], found.balance["P_bal_lever"]
    assert list(np.isnan(groups)) == list(np.isnan(lever)) == [False] * 4 + [True] * 2
    np.testing.assert_allclose(groups[:4], lever[:4], rtol=1e-8)
    assert np.all(np.diff(np.abs(groups[:4])) > 0)


def test_a_plate_that_bears_nothing_is_told_to_bear_nothing() -> None:
    bare = re.sub(r"^(mass|J|centre) = .*$", "", TURNS[: TURNS.index("[effects]")], flags=re.M)
    drawn = drawn_of(graphic_tmm.read(bare + "[forces]\npositions = [2]\n"))
    told = {column.segment: column.value[0, 2] for column in force_columns(drawn)}
    assert told["R12"] == told["R53"] == told["P_bal_forces"] == told["P_bal_lever"] == 0.0


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("name", SHEETS)
def test_the_sheet_of_a_plate_is_recomputed_from_itself(name: str, language: str) -> None:
    """Moments about the pins of the legs and about the special point, by the arms and arrows that are drawn."""
    text = SHEETS[name].replace('language = "en"', f'language = "{language}"')
    drawn = drawn_of(graphic_tmm.read(text))
    assert check_sheet(drawn) >= 30
    (equations,) = (one for name, one in sheet(drawn).items() if name == "equations-2-3-4-5-2")
    headings = [line for line in lines(equations) if line.startswith("ΣM_W3 = ")]
    assert len(headings) == 1, headings
    figure = sheet(drawn)["group-2-3-4-5-2"]
    assert "W₃" in figure.words or "W3" in figure.words, figure.words
