"""Pairs of forces and moments between two links: against Newton's and Euler's equations, on sheets, refused."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.loaded import RATIO, errors, solve, weighed
from support.mechanisms import KINDS, Sampled, sample
from support.oracle import State, solve_fast

from graphic_tmm.board.record import TALLY
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.forces.given import given, stated
from graphic_tmm.chapters.forces.kinds import Along
from graphic_tmm.chapters.forces.load_diagrams import letters, with_opposites
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import ForcesTask, Load
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError
from graphic_tmm.readers.task_sheet import SIZE, Posed, TaskSheet
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.read import read


class Pairs:
    """Loads between links, and what of them acts on moving links, as the judge takes it."""

    def __init__(self, drawn: Sampled, state: State, seed: int) -> None:
        self.links, self.state, self.pick = drawn.mechanism.by_number, state, random.Random(seed)
        self.frame = drawn.mechanism.frame.number
        self.loads: list[Load] = []
        self.forces: list[tuple[int, str, complex]] = []
        self.moments: list[tuple[int, float]] = []
        for _ in range(self.pick.randint(1, 3)):
            self.pick.choice((self.force, self.between, self.moment))()

    def two(self) -> tuple[int, int]:
        """A moving link with a letter, and any other, the frame too."""
        bearer = self.pick.choice(
            [n for n, link in self.links.items() if n != self.frame and link.points]
        )
        return bearer, self.pick.choice([n for n in self.links if n != bearer])

    def act(self, link: int, other: int, at: tuple[str, str], force: complex) -> None:
        self.forces += [
            (n, letter, f)
            for n, letter, f in ((link, at[0], force), (other, at[1], -force))
            if n != self.frame
        ]

    def force(self) -> None:
        """A force at a letter; its opposite at the point of the other link that lies under it."""
        (link, other), size = self.two(), self.pick.uniform(-300.0, 300.0)
        letter, by = self.pick.choice(list(self.links[link].points)), self.pick.uniform(-180, 180)
        self.loads.append(Load(link, letter, size, by, opposite=other))
        self.act(link, other, (letter, letter), size * np.exp(1j * np.radians(by)))

    def between(self) -> None:
        """A force along the line of two letters, one of each link."""
        (link, other), size = self.two(), self.pick.uniform(-300.0, 300.0)
        own, others = (list(self.links[n].points) for n in (link, other))
        ends = [(a, b) for a in own for b in others if self.apart(a, b)]
        if ends:
            first, last = self.pick.choice(ends)
            along = self.apart(first, last)
            self.loads.append(
                Load(link, first, size, Along(first + last), opposite=other, opposite_at=last)
            )
            self.act(link, other, (first, last), size * along / abs(along))

    def apart(self, first: str, last: str) -> complex:
        way = self.state.points[last].r - self.state.points[first].r
        return way if abs(way) > 1e-3 * self.state.size else 0j

    def moment(self) -> None:
        (link, other), size = self.two(), self.pick.uniform(-30.0, 30.0)
        self.loads.append(Load(link, None, size, 0.0, opposite=other))
        self.moments += [(n, m) for n, m in ((link, size), (other, -size)) if n != self.frame]


def check(drawn: Sampled, seed: int) -> None:
    loaded = weighed(drawn, seed)
    state = solve_fast(drawn.mechanism, drawn.phi, drawn.poses)
    pairs = Pairs(drawn, state, seed)
    if not pairs.loads:
        return
    one = loaded._replace(forces=pairs.forces, moments=pairs.moments)
    order = ForcesTask(
        ("all",),
        tuple(pairs.loads),
        gravity=seed % 2 == 0,
        inertia=seed % 3 == 0,
        couples=("moment", "pair")[seed % 2],
    )
    solved = solve(one, drawn.phi, drawn.poses, order, turned=seed % 4 == 0)
    found = errors(solved)
    assert max(found.values()) <= RATIO, (found, drawn.kinds, seed, pairs.loads)


@pytest.mark.parametrize("kind", KINDS)
def test_one_group_of_each_kind(kind: str, many: Callable[[int, int], int]) -> None:
    count = many(60, 8)
    for k, drawn in enumerate(sample(count, seed=KINDS.index(kind), dyads=(1, 1), kinds=[kind])):
        check(drawn, k)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_chains_of_groups(seed: int) -> None:
    for k, drawn in enumerate(sample(50, seed=8000 + seed, dyads=(2, 3))):
        check(drawn, 100 * seed + k)


SCENE = """
title = "Cylinder"
language = "en"
[frame]
O = [0, 0]
C = [0.16, 0]
[[link]]
number = 1
points = { O = [0, 0], A = [0.04, 0] }
[[link]]
number = 2
points = { A = [0, 0], D = [0.06, 0] }
slides = { on = 3, along = "z", side = "-" }
[[link]]
number = 3
points = { C = [0, 0], E = [-0.02, 0] }
guides = { z = { through = [0, 0], angle = "0 deg" } }
[drive]
link = 1
speed = 15
positions = 8
[effects]
friction = FRICTION
[friction]
f = 0.1
radius = "5 mm"
passes = 8
[forces]
positions = "all"
"""
PUSH = """
[[load]]
link = 2
point = "D"
force = "500 N"
"""


def scene_of(tmp_path: Path, more: str, friction: str = "false") -> Path:
    file = tmp_path / "scene.toml"
    file.write_text(SCENE.replace("FRICTION", friction) + more, encoding="utf8")
    return file


def drawn(tmp_path: Path, more: str, friction: str = "false") -> Drawn:
    return drawn_of(read(scene_of(tmp_path, more, friction)), exact=True)


@pytest.mark.parametrize("friction", ["false", "true"])
def test_oil_between_piston_and_cylinder(tmp_path: Path, friction: str) -> None:
    """The power of oil is its force times the rate of AC, which is known in closed form."""
    made = drawn(tmp_path, PUSH + 'from = 3\ndirection = "along z"', friction)
    angles = np.arange(8) * np.pi / 4
    apart = 0.04 * np.exp(1j * angles) - 0.16
    turning = 0.04j * np.exp(1j * angles)
    rate = (apart.conj() * turning).real / np.abs(apart)  # of the length by the angle
    forces = FORCES_PLAN.on(made)
    lever = made.reading[forces.first.lever.balance][0]
    if friction == "false":
        np.testing.assert_allclose(lever * 0.04, 500.0 * rate, atol=1e-9)
    np.testing.assert_allclose(lever, made.reading[forces.first.balance][0], rtol=1e-4, atol=1e-6)
    carried = [one.letter for one in forces.first.lever.forces]
    assert len(set(carried)) == len(carried)
    assert {"F_{32}", "F_{23}"} <= set(carried)
    assert ("F_{f32}" in carried) == (friction == "true")


def test_a_pair_on_the_frame_is_a_load(tmp_path: Path) -> None:
    pair = drawn(tmp_path, PUSH + 'from = 0\nfrom_point = "C"\ndirection = "along DC"')
    load = drawn(tmp_path, PUSH + 'direction = "along DC"')
    both = (made.reading[FORCES_PLAN.on(made).first.balance][0] for made in (pair, load))
    np.testing.assert_allclose(*both, rtol=1e-12)


def test_letters_as_in_the_log(tmp_path: Path) -> None:
    loads = (
        Load(2, "D", 1.0, 0.0, opposite=3),
        Load(3, "E", 1.0, 0.0, opposite=2),
        Load(2, None, 1.0, 0.0, opposite=1),
        Load(2, "D", 1.0, 0.0),
        Load(2, "D", 1.0, 0.0, opposite=3),
    )
    made = drawn_of(read(scene_of(tmp_path, "")).asking(forces=ForcesTask(("1",), loads)))
    told = [one for pair in with_opposites(loads) for one in pair if one]
    acting = FORCES_PLAN.on(made).loads
    found = [one.letter for one in acting.on_lever] + [c.letter for c in acting.couples_on_lever]
    assert sorted(told) == sorted(found)
    assert letters(loads) == ["F_{32}", "F_{23(2)}", "M_{12}", "F_2", "F_{32(3)}"]


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ('from = 3\ndirection = "against velocity"', "push each other along a line"),
        ("from = 3", "along AC"),
        ('from = 2\ndirection = "along z"', "bears the load itself"),
        ('from = 7\ndirection = "along z"', "link 7"),
        ('from_point = "C"\ndirection = "along z"', "of which link"),
        ('from = 3\nfrom_point = "O"\ndirection = "along DO"', "no letter of link 3"),
        ('from = 3\nfrom_point = "C"\ndirection = "along z"', "along DC"),
        ('from = 3\nfrom_point = "C"\ndirection = "20 deg"', "along DC"),
        ('from = 3\nfrom_point = "C"\ndirection = "along DA"', "along DC"),
        ('from = 3\nfrom_point = "C"\ndirection = "square to DC"', "along DC"),
        ('of = "Q"\nout = [[0, 1], [1, 1]]', '"Q" is no moving point'),
    ],
)
def test_what_is_refused(tmp_path: Path, more: str, says: str) -> None:
    with pytest.raises(SceneError, match=says):
        read(scene_of(tmp_path, PUSH + more))


def test_a_moment_has_no_line_of_action(tmp_path: Path) -> None:
    with pytest.raises(SceneError, match="no line of action; leave the direction out"):
        read(scene_of(tmp_path, '[[load]]\nlink = 2\nmoment = 3\ndirection = "along z"\n'))


def test_a_force_and_its_opposite_may_be_told_from_either_end(tmp_path: Path) -> None:
    pair = 'from = 3\nfrom_point = "C"\ndirection = "{}"\n'
    values = [
        made.reading[FORCES_PLAN.on(made).first.balance][0]
        for way in ("along DC", "180 deg to CD", "along CD")
        for made in [drawn(tmp_path, PUSH + pair.format(way))]
    ]
    np.testing.assert_allclose(values[1], values[0], rtol=1e-12)
    np.testing.assert_allclose(values[2], -values[0], rtol=1e-12)


@pytest.mark.parametrize("more", ['from_point = "C"', 'direction = "against rotation"'])
def test_a_moment_between_links_has_neither_point_nor_sense(tmp_path: Path, more: str) -> None:
    with pytest.raises(SceneError, match="leave the"):
        read(scene_of(tmp_path, f"[[load]]\nlink = 2\nmoment = 3\nfrom = 3\n{more}"))


def test_what_a_task_gives_of_loads_springs_and_friction(tmp_path: Path) -> None:
    sizes = "[-300, 100, 0, 0, 0, 0, 0, 200]"
    more = f'[[load]]\nlink = 2\npoint = "D"\nby_position = {sizes}\ndirection = "square to DC"\n'
    more += '[[spring]]\nbetween = ["A", "C"]\nrate = 2000\nfree = 0.1\ndamping = 30\n'
    text = scene_of(tmp_path, more, "true").read_text("utf-8")
    (tmp_path / "scene.toml").write_text(
        text.replace("passes = 8", 'radii = { C = "8 mm" }'), encoding="utf-8"
    )
    scene = read(tmp_path / "scene.toml")
    told = {one.symbol: (one.value, one.unit) for one in given(scene)}
    assert told == {
        "F_{2max}": (-300.0, "N"),
        "c": (2000.0, "N/m"),
        "l_0": (0.1, SIZE),
        "b": (30.0, "N·s/m"),
        "f": (0.1, ""),
        "r": (0.005, SIZE),
        "r_{C}": (0.008, SIZE),
    }
    assert any("DC turned by 90° counter-clockwise" in one for one in stated(scene, "en"))


def test_both_arrows_of_a_task_sheet(tmp_path: Path) -> None:
    more = 'from = 3\nfrom_point = "C"\ndirection = "along DC"'
    scene = read(scene_of(tmp_path, PUSH + more))
    spots = {"D": 0j, "C": 3 + 4j}
    posed = Posed(lambda letter, link: (spots[letter], 1j), 5.0, lambda link: 1 + 0j)
    shown = [one for part in chapters() for one in TaskSheet.of(part).acting(scene, posed)]
    (first,), (second,) = (one.wanted for one in shown)
    assert abs(first.at / (3 + 4j) - abs(first.at) / 5.0) < 1e-12
    assert abs((second.at - 3 - 4j) + first.at) < 1e-12


def test_the_image_of_a_point_over_the_rocker_is_drawn_once(tmp_path: Path) -> None:
    push = PUSH.replace('"D"', '"A"') + 'from = 3\ndirection = "along z"'
    log = drawn(tmp_path, push).construction
    images = [s.it.letter for s in log.steps if s.it.view == "velocities" and s.it.kind is Point]
    assert sorted(images) == sorted(set(images))
    assert not any(TALLY in letter for letter in images)
