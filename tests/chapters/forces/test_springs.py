"""Springs and dampers: against Newton's and Euler's equations, against energy, on sheets, refused."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.loaded import RATIO, errors, solve, weighed
from support.mechanisms import KINDS, Sampled, sample
from support.oracle import State, solve_fast

import graphic_tmm as tmm
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.spring_diagrams import laws, spring_views
from graphic_tmm.chapters.forces.spring_signs import letter_of
from graphic_tmm.chapters.forces.task import ForcesTask, Spring
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError
from graphic_tmm.fitting.choice import choices
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.readers.task_sheet import Given, Posed, TaskSheet
from graphic_tmm.scene.chapter import Chapter, chapters
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

Acts = list[tuple[int, str, complex]]


def spring_of(drawn: Sampled, state: State, pick: random.Random) -> tuple[Spring, Acts]:
    """A spring or a damper between letters of two links, and how it acts on those that move."""
    links = drawn.mechanism.by_number
    frame = drawn.mechanism.frame.number
    for _ in range(200):
        (i, one), (j, two) = pick.sample(sorted(links.items()), 2)
        if not one.points or not two.points:
            continue
        ends = pick.choice(list(one.points)), pick.choice(list(two.points))
        (first, last) = (state.points[letter] for letter in ends)
        apart = last.r - first.r
        if abs(apart) < 1e-3 * state.size:
            continue
        rate = pick.uniform(10.0, 500.0) if pick.randint(0, 2) else None
        free = pick.uniform(0.1, 2.0) * state.size if rate is not None else None
        damping = pick.uniform(1.0, 50.0) if rate is None or pick.randint(0, 1) else None
        preload = pick.choice((0.0, pick.uniform(-50.0, 50.0)))
        along = apart / abs(apart)
        pull = preload + (rate or 0.0) * (abs(apart) - (free or 0.0))
        pull += (damping or 0.0) * ((last.v - first.v) * along.conjugate()).real
        if abs(pull) < 1e-6:  # a damper along a link
            continue
        acts = [(i, ends[0], pull * along), (j, ends[1], -pull * along)]
        spring = Spring(ends, rate, free, preload, damping, links=(i, j))
        return spring, [act for act in acts if act[0] != frame]
    raise AssertionError("no two letters are apart")


def check(drawn: Sampled, seed: int) -> None:
    loaded, pick = weighed(drawn, seed), random.Random(seed)
    state = solve_fast(drawn.mechanism, drawn.phi, drawn.poses)
    found = [spring_of(drawn, state, pick) for _ in range(pick.randint(1, 3))]
    forces = [act for _, acts in found for act in acts]
    order = ForcesTask(
        ("all",),
        springs=tuple(spring for spring, _ in found),
        gravity=seed % 2 == 0,
        inertia=seed % 3 == 0,
        balance=("force", "moment")[seed % 2],
    )
    one = loaded._replace(forces=forces, moments=())
    solved = solve(one, drawn.phi, drawn.poses, order, turned=bool(pick.randint(0, 1)))
    off = errors(solved)
    assert max(off.values()) <= RATIO, (off, drawn.kinds, seed, order.springs)


@pytest.mark.parametrize("kind", KINDS)
def test_one_group_of_each_kind(kind: str, many: Callable[[int, int], int]) -> None:
    count = many(60, 8)
    for k, drawn in enumerate(sample(count, seed=KINDS.index(kind), dyads=(1, 1), kinds=[kind])):
        check(drawn, k)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_chains_of_groups(seed: int) -> None:
    for k, drawn in enumerate(sample(50, seed=9000 + seed, dyads=(2, 3))):
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
[forces]
positions = "all"
[[sheet]]
format = "A1"
place = ["positions", "velocities", "forces", "lever"]
[[spring]]
"""
RATED = 'between = ["A", "C"]\nrate = "1 kN/m"\nfree = "100 mm"\n'


def scene_of(tmp_path: Path, spring: str) -> Path:
    file = tmp_path / "scene.toml"
    file.write_text(SCENE + spring, encoding="utf8")
    return file


def drawn(file: Path) -> Drawn:
    return drawn_of(read(file), exact=True)


def length(phi: np.ndarray) -> np.ndarray:
    """AC by the law of cosines, for complex angles too."""
    return np.sqrt(0.04**2 + 0.16**2 - 2 * 0.04 * 0.16 * np.cos(phi))


@pytest.mark.parametrize("between", ['["A", "C"]', '["C", "A"]'])
@pytest.mark.parametrize("more", ["", 'force = "25 N"\n', 'damping = "80 N*s/m"\n'])
def test_the_power_is_that_of_the_length(tmp_path: Path, between: str, more: str) -> None:
    """M_b ω = F dl/dt; the rate of l by a complex step of its closed form."""
    made = drawn(scene_of(tmp_path, RATED.replace('["A", "C"]', between) + more))
    phi, step = np.arange(8) * np.pi / 4, 1e-40
    by_phi = length(phi + 1j * step).imag / step
    force = 1000.0 * (length(phi) - 0.1) + 25.0 * ("force" in more)
    force = force + 80.0 * 15.0 * by_phi * ("damping" in more)
    forces = FORCES_PLAN.on(made)
    for found in (forces.first.balance, forces.first.lever.balance):
        np.testing.assert_allclose(made.reading[found][0] * 0.04, force * by_phi, atol=1e-9)


@pytest.mark.parametrize("damping", ["", 'damping = "80 N*s/m"\n'])
def test_springs_between_the_same_points_bear_letters_of_their_own(
    tmp_path: Path, damping: str
) -> None:
    turned = RATED.replace('["A", "C"]', '["C", "A"]')
    three = f"{RATED}{damping}[[spring]]\n{turned}{damping}[[spring]]\n{RATED}"
    made = drawn(scene_of(tmp_path, three))
    forces, due = FORCES_PLAN.on(made), ["F_{AC}", "F_{AC(2)}", "F_{AC(3)}"]
    assert [one.letter for one in forces.loads.forces] == due
    assert [one.value.letter for one in forces.loads.forces] == due
    assert [one.line.name for one in forces.loads.forces] == [f"({letter})" for letter in due]
    assert [one.letter for one in forces.first.lever.forces] == due


def test_a_rate_in_newtons_a_millimetre(tmp_path: Path) -> None:
    told = [RATED, RATED.replace("1 kN/m", "1 N/mm"), RATED.replace("1 kN/m", "0.001 kN/mm")]
    rates = [read(scene_of(tmp_path, one)).tasks["forces"].springs[0].rate for one in told]
    np.testing.assert_allclose(rates, 1000.0, rtol=1e-14)


def test_ends_that_come_together_leave_that_position_out(tmp_path: Path) -> None:
    told = scene_of(tmp_path, RATED.replace('"C"', '"K"')).read_text(encoding="utf8")
    file = tmp_path / "scene.toml"
    file.write_text(told.replace("C = [0.16, 0]", "C = [0.16, 0]\nK = [0.04, 0]"), encoding="utf8")
    made = drawn(file)
    balance = made.reading[FORCES_PLAN.on(made).first.balance][0]
    assert np.isnan(balance[0])
    assert np.isfinite(balance[1:]).all()
    assert any(one.step.it.name == "(F_{AK})" and one.positions == (0,) for one in made.findings())


@pytest.mark.parametrize(
    ("spring", "says"),
    [
        ('between = ["A", "C"]\n', "how strong"),
        ('between = ["A", "C"]\nrate = "1 kN/m"\n', 'free = "100 mm"'),
        ('between = ["A", "C"]\nfree = "1 m"\nforce = 3\n', 'rate = "2 kN/m"'),
        (RATED.replace('"C"', '"X"'), "no letter"),
        (RATED.replace('["A", "C"]', '"AC"'), "both ends"),
        (RATED.replace('"C"', '"A"'), "both ends are on one link"),
        (RATED.replace('"A", "C"', '"O", "C"') + "links = [0, 0]\n", "both ends are on one link"),
        (RATED + "links = [1, 2]\n", "two links are wanted"),
        (RATED.replace("1 kN/m", "-1 kN/m"), "greater than 0"),
    ],
)
def test_what_is_refused(tmp_path: Path, spring: str, says: str) -> None:
    with pytest.raises(SceneError, match=says):
        read(scene_of(tmp_path, spring))


def test_the_diagram_goes_over_the_lengths_of_the_positions(tmp_path: Path) -> None:
    made = drawn(scene_of(tmp_path, RATED))
    (law,) = laws(made)
    assert law.low == pytest.approx(0.1)  # the free length is near: the line begins there
    assert 0.0 < law.begin < law.low
    assert law.reach == pytest.approx(0.2)
    assert law.largest == pytest.approx(100.0)
    (view,) = spring_views(made, True)
    dots = [one for one in view.strokes if one.position is not None]
    assert sorted(one.position for one in dots) == list(range(8))
    assert "μ_{F}" in "".join(one.text for one in view.labels) or "μ_F" in str(view.labels)


@pytest.mark.parametrize("between", ['["A", "C"]', '["C", "A"]'])
def test_the_diagram_of_a_spring_that_is_set_in_begins_with_its_force(
    between: str, tmp_path: Path
) -> None:
    """F = c(l − l_0) + F_0 over all lengths; each dot stands at its length and its force, to both scales."""
    spring = RATED.replace('["A", "C"]', between).replace("100 mm", "20 mm") + 'force = "-60 N"\n'
    made = drawn(scene_of(tmp_path, spring))
    (law,) = laws(made)
    assert law.low == pytest.approx(0.12)  # the free length is far below
    assert law.begin == pytest.approx(0.12 - 0.2 * 0.08)
    assert law.largest == pytest.approx(120.0)
    lengths = length(np.arange(8) * np.pi / 4)
    for at in (0.0, 0.02, 0.2):
        assert law.force(at) == pytest.approx(1000.0 * (at - 0.02) - 60.0)
    (view,) = spring_views(made, True)
    dots = {one.position: one for one in view.strokes if one.position is not None}
    spots = np.array([_centre(dots[k]) for k in range(8)])
    mu_l, mu_F = made.scales["positions"].value, choices(made).scale(law.view, "μ_F").value
    due = lengths / mu_l + 1j * (1000.0 * lengths - 80.0) / mu_F
    np.testing.assert_allclose(spots - spots[0], due - due[0], atol=1e-9)
    assert abs(due[4] - due[0]) > 20.0
    upright = [
        x for x in _paths(view, "axis") if abs(x[0] - x[-1]) > 20.0 and x[0].real == x[-1].real
    ]
    assert upright[0][0].real == pytest.approx((spots[0] - due[0]).real + law.begin / mu_l)


def _paths(view: Drawing, part: str) -> list[list[complex]]:
    inked = (one for one in view.strokes if isinstance(one, Stroke) and one.part == part)
    return [[complex(x, y) for x, y, _ in one.path] for one in inked]


def _centre(dot: object) -> complex:
    assert isinstance(dot, Stroke)
    return complex(np.mean([complex(x, y) for x, y, _ in dot.path]))


def test_a_force_alone_has_no_diagram_and_its_own_letter(tmp_path: Path) -> None:
    made = drawn(scene_of(tmp_path, 'between = ["A", "C"]\nforce = "-60 N"\n'))
    assert list(laws(made)) == []
    (one,) = FORCES_PLAN.on(made).loads.springs
    assert letter_of(one.spring, one.number) == "F_0"
    (force,) = FORCES_PLAN.on(made).loads.forces
    assert made.reading[force.value][0] == pytest.approx(-60.0)


def test_a_damper_has_no_diagram(tmp_path: Path) -> None:
    made = drawn(scene_of(tmp_path, 'between = ["A", "C"]\ndamping = 20\n'))
    assert list(laws(made)) == []
    assert FORCES_PLAN.on(made).loads.springs[0].force is None


@pytest.mark.parametrize("more", ["", 'damping = "80 N*s/m"\n'])
def test_a_task_shows_and_gives_the_spring(tmp_path: Path, more: str) -> None:
    scene = read(scene_of(tmp_path, RATED + more))
    spots = {"A": 0j, "C": 60 + 80j}
    posed = Posed(lambda letter, link: (spots[letter], 1j), 5.0, lambda link: 1 + 0j)
    (shown,) = (one for part in chapters() for one in TaskSheet.of(part).acting(scene, posed))
    across = np.array([1j * (60 + 80j) / 100])
    reach = [complex(x, y) for stroke in shown.strokes for x, y, _ in stroke.path]
    aside = (np.array(reach) * across.conj()).real
    assert max(aside) > 10.0  # beside the cylinder, which lies along it
    assert min(aside) > -1e-9
    assert shown.wanted[0].text == ("c, b" if more else "c")
    given = {one.symbol: one.value for part in chapters() for one in (part_given(part, scene))}
    assert given["c"] == 1000.0
    assert given["l_0"] == pytest.approx(0.1)
    assert ("b" in given) == bool(more)


def part_given(part: Chapter, scene: Scene) -> list[Given]:
    sheet = TaskSheet.of(part)
    return list(sheet.given(scene)) if sheet.given is not None else []


@pytest.mark.parametrize("fast", [False, True])
@pytest.mark.parametrize("turned", [False, True])
def test_at_any_angle(tmp_path: Path, turned: bool, fast: bool) -> None:
    file = scene_of(tmp_path, RATED + 'damping = "80 N*s/m"\n')
    scene = replace(read(file), turned=turned)
    angles = np.random.default_rng(1).uniform(0.0, 360.0, 300)
    found = tmm.motion(scene, angles, plans=["forces"], exact=True, fast=fast).balance
    phi, step = np.radians(angles), 1e-40
    by_phi = length(phi + 1j * step).imag / step
    force = 1000.0 * (length(phi) - 0.1) + 80.0 * 15.0 * by_phi
    for name in ("P_bal_forces", "P_bal_lever"):
        np.testing.assert_allclose(found[name] * 0.04, force * by_phi, atol=1e-9)


def test_the_moment_reduced_to_the_crank(tmp_path: Path) -> None:
    """M_r = −F dl/dφ: positive where spring and damper drive the crank."""
    wheel = "[flywheel]\ndelta = 0.05\n[effects]\ninertia = true\n"
    told = scene_of(tmp_path, RATED + 'damping = "80 N*s/m"\n').read_text(encoding="utf8")
    told = told.replace("positions = 8", "positions = 24").replace("S2", "D")
    told = told.replace("D = [0.06, 0] }", 'D = [0.06, 0] }\nmass = 1\ncentre = "D"\nJ = 0.001')
    told = told.replace("E = [-0.02, 0] }", 'E = [-0.02, 0] }\nmass = 1\ncentre = "E"\nJ = 0.001')
    file = tmp_path / "scene.toml"
    file.write_text(told.replace("[forces]", wheel + "[forces]"), encoding="utf8")
    made = drawn(file)
    (mark,) = (s.it for s in made.construction.steps if s.it.letter == "M_r")
    phi, step = np.arange(24) * np.pi / 12, 1e-40
    by_phi = length(phi + 1j * step).imag / step
    force = 1000.0 * (length(phi) - 0.1) + 80.0 * 15.0 * by_phi
    np.testing.assert_allclose(made.reading[mark][0][:24], -force * by_phi, atol=1e-9)


def test_with_friction_both_methods_agree(tmp_path: Path) -> None:
    rough = '[effects]\nfriction = true\n[friction]\nf = 0.1\nradius = "6 mm"\npasses = 12\n'
    spring = RATED + 'damping = "80 N*s/m"\nlinks = [2, 3]\n'
    told = (
        scene_of(tmp_path, spring)
        .read_text(encoding="utf8")
        .replace("[forces]", rough + "[forces]")
    )
    file = tmp_path / "scene.toml"
    file.write_text(told, encoding="utf8")
    made = drawn(file)
    forces = FORCES_PLAN.on(made)
    found = [made.reading[one][0] for one in (forces.first.balance, forces.first.lever.balance)]
    np.testing.assert_allclose(*found, rtol=1e-6, atol=1e-9)
    phi, step = np.arange(8) * np.pi / 4, 1e-40
    by_phi = length(phi + 1j * step).imag / step
    smooth = (1000.0 * (length(phi) - 0.1) + 1200.0 * by_phi) * by_phi
    lost = found[0] * 0.04 - smooth
    assert (lost > -1e-9).all()  # friction only takes
    assert lost.max() > 1e-3
