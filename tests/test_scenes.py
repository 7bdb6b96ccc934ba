"""Every scene that comes with the project, whole, against vector loops that know nothing of plans."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import NAMES, NO_PLANS, one_crank, scene
from support.oracle import Motion, State, solve_from_points

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.positions import side_record
from graphic_tmm.chapters.kinematics.sides import side_values
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.symbols import plain
from graphic_tmm.mechanism.groups import Group, PlateGroup
from graphic_tmm.mechanism.records import Extreme, Mechanism
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.position_count import told_off

pytestmark = pytest.mark.every

RATIO = 1e-9
CRANKED = [name for name in NAMES if one_crank(name)]
"""Of the others all links are judged together (`tests/judges/test_scenes_of_drives.py`)."""


@cache
def work_of(name: str) -> Drawn:
    return drawn_of(scene(name), exact=True)


def _points(made: Drawn, place: int) -> dict[str, complex]:
    """Places (m, sheet's axes) of all letters at a position, as the plan of positions has them."""
    project = made.project
    origin = made.scene.mechanism.frame.points[KINEMATICS_PLAN.on(project).structure.origin]
    mu = made.scales["positions"].value
    found = {}
    for body in KINEMATICS_PLAN.on(project).positions.bodies.values():
        for letter in body.link.points:
            row = np.ravel(made.reading[body.marks[letter]])
            found[letter] = origin + mu * complex(row[place % row.size])
    return found


@cache
def states(name: str) -> tuple[State, ...]:
    made = work_of(name)
    mechanism = made.scene.mechanism
    mechanism = replace(mechanism, links=mechanism.drawn, passive=())
    return tuple(
        solve_from_points(_at_its_speed(mechanism, place), angle, _points(made, place))
        for place, angle in enumerate(made.project.coordinates)
    )


def _at_its_speed(mechanism: Mechanism, place: int) -> Mechanism:
    """Return a mechanism with the speed of a position, where they are listed."""
    drive = mechanism.drive
    if not drive.rates:
        return mechanism
    one = replace(
        drive, speed=drive.rates[place], acceleration=drive.gains[place], rates=(), gains=()
    )
    return replace(mechanism, drive=one)


def _at(array: np.ndarray, place: int) -> complex:
    row = np.ravel(array)
    return complex(row[place % row.size])


def _largest(state: State, name: str) -> float:
    due = [getattr(motion, name) for motion in state.points.values()]
    return max(map(abs, due))


def test_the_scenes_use_every_kind_of_group() -> None:
    groups = [group for name in NAMES for group in dissect(scene(name).mechanism).groups]
    assert {one.kind for one in groups if isinstance(one, Group)} == {1, 2, 3, 4, 5}
    assert any(isinstance(one, PlateGroup) for one in groups)


def test_the_scenes_use_what_a_task_may_ask_for() -> None:
    scenes = [scene(name) for name in NAMES]
    assert {scene.language for scene in scenes} == {"ru", "en"}
    assert {sheet.format for scene in scenes for sheet in scene.sheets} == {"A1", "A2", "A4"}
    assert {scene.row.first for scene in scenes} == {0, 1}
    assert any(scene.mechanism.drive.acceleration for scene in scenes)
    assert {scene.mechanism.drive.speed > 0 for scene in scenes} == {True, False}
    assert {scene.turned for scene in scenes} == {True, False}
    assert any(isinstance(extra, Extreme) for scene in scenes for extra in scene.row.extra)
    assert any(isinstance(extra, float) for scene in scenes for extra in scene.row.extra)


@pytest.mark.parametrize("name", CRANKED)
def test_a_scene_is_drawn_at_every_position(name: str) -> None:
    made = work_of(name)
    assert made.undrawn == ()
    off = told_off(made, "en")  # what the number of positions of the document costs
    assert warnings(made) == ((plain("; ".join(off)),) if off else ())
    assert not [finding for finding in made.findings() if finding.kind == "undrawn"]


@pytest.mark.parametrize("name", CRANKED)
def test_every_point_and_every_velocity_equals_the_vector_loops(name: str) -> None:
    made = work_of(name)
    plan = KINEMATICS_PLAN.on(made).velocities
    mechanism = made.scene.mechanism
    if name in NO_PLANS:
        return
    assert plan is not None
    turn = 1j * math.copysign(1.0, mechanism.drive.speed) if made.scene.turned else 1.0
    mu = made.scales["velocities"].value
    for place, state in enumerate(states(name)):
        points = _points(made, place)
        speed = max(abs(mechanism.drive.speed) * state.size, _largest(state, "v"))
        for number, body in KINEMATICS_PLAN.on(made).positions.bodies.items():
            for letter in body.link.points:
                due: Motion = state.points[letter, number]
                assert abs(points[letter] - due.r) <= RATIO * state.size, (place, letter)
                image = plan.images.by_letter[number][letter]
                seen = _at(made.reading[image], place) * mu * turn
                assert abs(seen - due.v) <= RATIO * speed, (place, letter, number)
        for number, omega in state.omega.items():
            mark = plan.rates.get(number)
            drawn = _at(made.reading[mark], place).real if mark is not None else 0.0
            least = max(abs(mechanism.drive.speed), *map(abs, state.omega.values()))
            assert abs(drawn - omega) <= RATIO * least, (place, number)


@pytest.mark.parametrize("name", CRANKED)
def test_every_acceleration_equals_the_vector_loops(name: str) -> None:
    made = work_of(name)
    plan = KINEMATICS_PLAN.on(made).accelerations
    drive = made.scene.mechanism.drive
    if "accelerations" not in {p for sheet in made.scene.sheets for p in sheet.place}:
        assert not KINEMATICS_PLAN.on(made).accelerated
        return
    assert plan is not None
    assert made.of("accelerations") is not None
    mu = made.scales["accelerations"].value
    for index, place in enumerate(KINEMATICS_PLAN.on(made).accelerated):
        state = states(name)[place]
        pull = max(drive.speed**2 * state.size, _largest(state, "a"))
        for number, body in KINEMATICS_PLAN.on(made).positions.bodies.items():
            for letter in body.link.points:
                image = plan.images.by_letter[number][letter]
                seen = _at(made.of("accelerations")[image], index) * mu
                due = state.points[letter, number].a
                assert abs(seen - due) <= RATIO * pull, (place, letter, number)
        for number, epsilon in state.epsilon.items():
            mark = plan.rates.get(number)
            drawn = _at(made.of("accelerations")[mark], index).real if mark is not None else 0.0
            least = max(drive.speed**2, *map(abs, state.epsilon.values()))
            assert abs(drawn - epsilon) <= RATIO * least, (place, number)


def _reach(state: State, group: Group) -> float:
    """How far (m, m²) a group stands on the side that +1 names."""
    first, second = group.legs
    mechanism = state.mechanism
    if group.kind == 1:
        a, c, b = (state.points[pair.name].r for pair in (first.pair, second.pair, group.inner))
        return ((b - a) * (c - a).conjugate()).imag
    pair = second.pair if group.kind == 2 else group.inner
    assert pair.slide is not None
    turned = state.pose[pair.slide.on][2] + math.radians(pair.slide.guide.angle)
    start, end = (
        (state.points[first.pair.name].r, state.points[group.inner.name].r)
        if group.kind == 2
        else (
            state.points[_letter(group, pair.slide.on)].r,
            state.points[_letter(group, pair.other(pair.slide.on))].r,
        )
    )
    assert mechanism.by_number
    return ((end - start) * cmath.rect(1.0, -turned)).real


def _letter(group: Group, link: int) -> str:
    return next(leg.pair.name for leg in group.legs if leg.link == link)


@pytest.mark.parametrize("name", CRANKED)
def test_the_sides_are_kept(name: str) -> None:
    mechanism = scene(name).mechanism
    for state in states(name):
        for group in dissect(mechanism).groups:
            side = side_record(mechanism, group)
            if not isinstance(group, Group) or group.kind > 3:
                assert side is None
                continue
            assert side is not None
            sign = float(np.asarray(side_values(side, state.phi)))
            size = state.size**2 if group.kind == 1 else state.size
            # an arc that touches may lie on either side by its rounding
            assert sign * _reach(state, group) > -1e-9 * size, (state.phi, group.name)
