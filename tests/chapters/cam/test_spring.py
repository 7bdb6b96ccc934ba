"""Springs of followers: judged by closed formulas over 3,600 angles, by virtual work, by equilibrium."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.cam_springs import closing, values, within
from support.cams import C6, SHAPES, made, motion, pressure_angles, swung
from support.scenes import written

from graphic_tmm import motion as tmm_motion
from graphic_tmm.board.bounds import TaskError
from graphic_tmm.board.findings import examine
from graphic_tmm.board.values import Curve
from graphic_tmm.chapters.cam.findings import FORCE, cam_findings
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.kinds_spring import SpringTask
from graphic_tmm.chapters.cam.operations import steepest_ray
from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.spring import ROOM
from graphic_tmm.chapters.cam.task import (
    CamTask,
    FlatFollower,
    Follower,
    Law,
    RockerFollower,
    RollerFollower,
)
from graphic_tmm.errors import SceneError, TmmError
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import composed_sheets

DENSE = np.arange(3600) * 0.1
FOLLOWERS: dict[str, Follower] = {
    "central": RollerFollower(),
    "offset": RollerFollower(0.01),
    "knife edge": RollerFollower(0.01, edge=True),
    "rocker": RockerFollower(0.08, 0.1),
    "rocker along": RockerFollower(0.08, 0.1, same_sense=True),
    "flat": FlatFollower(0.005),
    "flat rocker": FlatRockerFollower(0.09, 0.01, 0.004),
    "flat rocker along": FlatRockerFollower(0.09, 0.0, 0.004, same_sense=True),
}


def order_of(name: str, spring: SpringTask | None = None, **other: object) -> CamTask:
    follower = FOLLOWERS[name]
    rocks = isinstance(follower, RockerFollower | FlatRockerFollower)
    own = spring or (SpringTask(0.0012, 0.2) if rocks else SpringTask(0.4, 6.0))
    data = {**C6, "stroke": 0.2 if rocks else 0.028}
    return CamTask(
        **{**data, "follower": follower, "pressure": 40.0, "speed": 40.0, "spring": own, **other}
    )


@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
@pytest.mark.parametrize("name", FOLLOWERS)
def test_the_moment_on_the_shaft_does_the_work_of_the_force(name: str, turns: str) -> None:
    """Virtual work: the moment times the cam's turn is the force times the follower's way."""
    of = made(order_of(name, turns=turns))
    angles = np.array(of.cam.diagrams.turn.angles)
    due = closing(of, angles) * motion(of.cam.order, angles)[1]
    drawn, inside = values(of, of.cam.spring.moment), within(of)
    np.testing.assert_allclose(
        drawn[inside], np.broadcast_to(due, drawn.shape)[inside], atol=1e-9 * np.abs(due).max()
    )


@pytest.mark.parametrize("name", FOLLOWERS)
def test_the_force_of_contact_is_in_balance_with_what_presses(name: str) -> None:
    """By pressure angles from velocities; on a face of a lever by where it meets the finished profile."""
    of = made(order_of(name, divisions=24))
    angles, follower = np.array(of.cam.diagrams.turn.angles), of.cam.order.follower
    due = closing(of, angles)
    if isinstance(follower, FlatRockerFollower):
        due = due / swung(of, angles)[1]
    elif not isinstance(follower, FlatFollower):
        due = due / np.cos(np.radians(pressure_angles(of.cam.order, of.one(of.cam.r0), angles)))
    if isinstance(follower, RockerFollower):
        due = due / follower.lever
    drawn, inside = values(of, of.cam.spring.contact), within(of)
    slack = 2e-3 if isinstance(follower, FlatRockerFollower) else 1e-9
    np.testing.assert_allclose(
        drawn[inside], np.broadcast_to(due, drawn.shape)[inside], rtol=slack, atol=1e-9
    )


@pytest.mark.parametrize("name", FOLLOWERS)
def test_at_any_angle_forces_are_those_of_the_motion_there(name: str) -> None:
    """Virtual work between positions too; the contact by pressure angles; while it rests the spring alone."""
    of = made(order_of(name, rise_law=Law("3-4-5"), divisions=24))
    one = Scene("spring", "", "en", tasks={"cam": of.cam.order})
    angles = np.linspace(0.7, 359.3, 277)
    found = tmm_motion(one, angles, exact=True).columns
    force, (_, speed, second) = closing(of, angles), motion(of.cam.order, angles)
    spring, follower = of.cam.order.spring, of.cam.order.follower
    assert spring is not None
    lifting = -spring.inertia * 40.0**2 * second
    np.testing.assert_allclose(found["P"], lifting, atol=1e-9 * np.abs(lifting).max())
    due = force * speed
    np.testing.assert_allclose(found["M"], due, atol=1e-9 * np.abs(due).max())
    if isinstance(follower, FlatRockerFollower):
        due = force / swung(of, angles)[1]
    elif isinstance(follower, FlatFollower):
        due = force
    else:
        due = force / np.cos(np.radians(pressure_angles(of.cam.order, of.one(of.cam.r0), angles)))
    if isinstance(follower, RockerFollower):
        due = due / follower.lever
    slack = 2e-3 if isinstance(follower, FlatRockerFollower) else 1e-9
    np.testing.assert_allclose(found["N"], due, rtol=slack)
    nowhere = tmm_motion(one, [np.nan, 3.0], exact=True).columns
    assert [np.isnan(nowhere[name]).tolist() for name in "PNM"] == [[True, False]] * 3


@pytest.mark.parametrize("name", ["central", "flat rocker"])
def test_without_friction_the_moment_does_no_work_over_the_turn(name: str) -> None:
    of = made(order_of(name, divisions=48, rise_law=Law("3-4-5"), return_law=Law("cosine")))
    rows, angles = values(of, of.cam.spring.moment), np.radians(of.cam.diagrams.turn.angles)
    works = [
        np.trapezoid(row[first : last + 1], angles[first : last + 1])
        for row, (_, first, last) in zip(rows, of.cam.diagrams.stretches, strict=True)
    ]
    assert works[0] > 0 > works[1]
    assert abs(sum(works)) < 2e-3 * works[0]


def test_a_harmonic_cam_has_the_spring_of_its_closed_form() -> None:
    """Harmonic motion: a_max = ½h(πω/Φ)² (Shigley, Norton), −a grows evenly along S.

    So the line from the pole, a stroke before the lowest place, meets it at the end of the stroke.
    """
    law = Law("cosine")
    of = made(order_of("central", SpringTask(0.5, reserve=1.5), rise_law=law, return_law=law))
    most = 1.5 * 0.5 * 0.5 * 0.028 * (np.pi * 40.0 / np.radians(90.0)) ** 2
    assert of.one(of.cam.spring.preload) == pytest.approx(most / 2, rel=1e-5)
    assert of.one(of.cam.spring.rate) == pytest.approx(most / 2 / 0.028, rel=1e-5)


def test_the_lead_and_a_load_change_the_spring_as_they_should() -> None:
    plain = made(order_of("flat", SpringTask(0.4)))
    longer = made(order_of("flat", SpringTask(0.4, lead=0.056)))
    loaded = made(order_of("flat", SpringTask(0.4, load=20.0)))
    for of, lead in ((plain, 0.028), (longer, 0.056), (loaded, 0.028)):
        spring = of.cam.spring
        assert of.one(spring.preload) == pytest.approx(of.one(spring.rate) * lead)
    assert longer.one(longer.cam.spring.rate) < plain.one(plain.cam.spring.rate)
    assert loaded.one(loaded.cam.spring.preload) < plain.one(plain.cam.spring.preload)
    held = made(order_of("flat", SpringTask(0.4, load=500.0)))
    assert held.one(held.cam.spring.rate) == 0.0
    assert held.one(held.cam.spring.preload) == 0.0
    assert not cam_findings(held.reading, held.cam)


def test_a_contact_at_the_foot_of_the_pivot_is_a_finding_and_no_force() -> None:
    """In the lowest place the lever stands at asin 58/60 = 75.2°, in the highest beyond 90°."""
    follower = FlatRockerFollower(0.06, 0.0, 0.004)
    order = replace(order_of("flat rocker"), follower=follower, stroke=np.radians(20.0), r0=0.058)
    of = made(order)
    (foot,) = [one for one in cam_findings(of.reading, of.cam) if one.kind != "hollow lever"]
    assert foot.kind == "foot"
    angles = np.array(of.cam.diagrams.turn.angles)
    place = of.reading[of.cam.contact.chart.ordinates[0]][0] * of.one(of.cam.contact.chart.mu)
    inside, gone = within(of), place <= 0.0
    assert gone[inside[0]].any()
    assert foot.value == pytest.approx(1000.0 * place.min(), abs=0.05)
    assert foot.angle == pytest.approx(angles[np.argmin(place)], abs=8.0)
    force = values(of, of.cam.spring.contact)
    for row, own in zip(force, inside, strict=True):
        assert np.isnan(row[own & gone]).all()
        assert (row[own & ~gone] > 0.0).all()
    bare = made(replace(order, spring=None, speed=None))
    assert foot in cam_findings(bare.reading, bare.cam)


def test_a_cam_without_a_mass_records_nothing_of_a_spring() -> None:
    order = order_of("central")
    with_, without = made(order), made(replace(order, spring=None))
    assert without.cam.spring is None
    assert without.log.steps == with_.log.steps[: len(without.log.steps)]
    assert not {s.it.view for s in without.log.steps} & {
        chart.view for chart in with_.cam.spring.charts
    }


def random_order(draw: random.Random) -> CamTask:
    name = draw.choice(list(FOLLOWERS))
    order = order_of(
        name, rise_law=Law(draw.choice(list(SHAPES))), return_law=Law(draw.choice(list(SHAPES)))
    )
    order = replace(order, divisions=24, speed=draw.uniform(10.0, 80.0))
    return replace(order, spring=replace(order.spring, load=0.0, reserve=draw.uniform(1.2, 1.5)))


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10))
def test_springs_that_are_sought_hold_with_their_reserve(seed: int) -> None:
    """Ten a seed: the contact stays, and the spring is over the wanted force, at 3,600 angles."""
    draw = random.Random(f"springs {seed}")
    for _ in range(10):
        of = made(random_order(draw))
        kinds = {one.kind for one in cam_findings(of.reading, of.cam)}
        assert not kinds & {"lift-off", "reserve"}
        spring, (S, _, A) = of.cam.order.spring, motion(of.cam.order, DENSE)
        inertia = -spring.inertia * of.cam.order.speed**2 * A
        line = of.one(of.cam.spring.preload) + of.one(of.cam.spring.rate) * S
        assert (closing(of, DENSE) >= 0.0).all()
        over = line - spring.reserve * inertia
        assert over.min() > -2e-3 * inertia.max()
        assert over.min() < 0.02 * inertia.max()  # and no stronger than it must be: it touches


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10))
def test_a_given_spring_is_judged_by_what_it_does(seed: int) -> None:
    """Ten a seed: lift-off is told if and only if what closes the pair is negative somewhere."""
    draw = random.Random(f"given {seed}")
    told = set()
    for _ in range(10):
        order = random_order(draw)
        sought = made(order)
        share = draw.uniform(0.4, 1.2)
        rate, preload = (
            share * sought.one(m) for m in (sought.cam.spring.rate, sought.cam.spring.preload)
        )
        of = made(replace(order, spring=replace(order.spring, rate=rate, preload=preload)))
        kinds = {one.kind for one in cam_findings(of.reading, of.cam)}
        least = closing(of, DENSE)
        if abs(least.min()) < 2 * FORCE * least.max():
            continue  # nearer than a ruler tells
        assert ("lift-off" in kinds) == bool(least.min() < 0.0), share
        if "lift-off" in kinds:
            (lift,) = [one for one in cam_findings(of.reading, of.cam) if one.kind == "lift-off"]
            near = closing(of, lift.angle + np.linspace(-1.0, 1.0, 21))  # on both sides of a jump
            assert near.min() < 0.6 * least.min()
        elif share < 0.97:
            assert "reserve" in kinds
        told |= kinds & {"lift-off"}
    assert told


def test_the_steepest_ray_touches_the_curve() -> None:
    rng = np.random.default_rng(37)
    for _ in range(50):
        x = np.cumsum(rng.uniform(1, 5, 9))
        knots = (x + 1j * rng.uniform(-20, 20, 9))[None, :]
        tangents = (np.gradient(x) + 1j * rng.uniform(-9, 9, 9))[None, :]
        start = np.array([[-10.0 + 0j]])
        (way,) = steepest_ray.run(start, Curve(knots, tangents, False)).along[0]
        t = np.linspace(0, 1, 2000)[:, None]
        p, q, m, n = knots[0, :-1], knots[0, 1:], tangents[0, :-1], tangents[0, 1:]
        arcs = p + t * (m + t * (3 * (q - p) - 2 * m - n + t * (2 * (p - q) + m + n)))
        slopes = np.angle(arcs - start[0, 0])
        assert np.angle(way) == pytest.approx(slopes.max(), abs=1e-6)


SLOW = """title = "T"
language = "en"
[cam]
stroke = "20 mm"
rise = 100
upper_dwell = 20
fall = 100
speed = "60 rpm"
mass = "1 kg"
{}
[[sheet]]
format = "A1"
place = ["cam"]
"""


@pytest.mark.parametrize(
    "keys",
    [
        'rate = "5 kN/m"\npreload = "100 N"',
        'load = "100 N"',
        'follower = "knife edge"\nload = "5 kN"',
    ],
)
def test_a_spring_many_times_the_inertia_force_goes_on_the_sheet(tmp_path: Path, keys: str) -> None:
    """A slow cam: the forces on the line of the spring have a scale factor of their own."""
    scene, composed = composed_sheets(read(written(tmp_path, SLOW.format(keys))))
    (drawn,) = scene.boards
    chart = CAM_PLAN.on(drawn).spring.chart
    high = max(float(np.nanmax(np.abs(drawn.reading[mark]))) for mark in chart.ordinates)
    assert 0.4 * ROOM < high <= ROOM
    shown = {view for sheet in composed.sheets for one in sheet.drawings for view in one.shows}
    assert chart.view in shown


def test_a_long_lead_makes_nothing_else_wide(tmp_path: Path) -> None:
    """The line of the spring does not fit on A3; the diagrams beside it do, so it alone is what is too wide."""
    text = SLOW.format('lead = "200 mm"').replace("A1", "A3")
    with pytest.raises(TmmError, match="the view 'Line of the spring"):
        composed_sheets(read(written(tmp_path, text)))
    composed_sheets(read(written(tmp_path, text.replace("A3", "A1"))))


@pytest.mark.parametrize("law", ["constant acceleration", "constant velocity"])
def test_a_level_force_is_in_no_doubt(law: str) -> None:
    """All points of a level stretch are the highest, and on the axis all stand on one ray from the pole."""
    of = made(order_of("central", rise_law=Law(law), return_law=Law(law)))
    told = examine(of.log, of.given, [step.it for step in of.log.steps])
    assert [(one.kind, one.step.op.name) for one in told if one.kind == "doubtful"] == []


def test_a_program_that_gives_no_speed_is_refused() -> None:
    with pytest.raises(TaskError, match="300 rpm"):
        made(order_of("flat", speed=None))


HEAD = '[cam]\nrise = 120\nfall = 90\nstroke = "{}"\nfollower = "{}"\n'
ROD, LEVER = (
    HEAD.format("20 mm", "flat"),
    HEAD.format("10 deg", "flat rocker") + 'centres = "80 mm"\n',
)


@pytest.mark.parametrize(
    ("text", "key"),
    [
        (ROD + 'mass = "1 kg"\n', "speed"),
        (ROD + 'mass = "0 kg"\nspeed = "60 rpm"\n', "mass"),
        (ROD + 'inertia = "1 kg*m^2"\nspeed = "60 rpm"\n', "inertia"),
        (LEVER + 'mass = "1 kg"\nspeed = "60 rpm"\n', "mass"),
        (ROD + 'rate = "1 kN/m"\npreload = "10 N"\n', "rate"),
        (ROD + 'mass = "1 kg"\nspeed = "60 rpm"\nrate = "1 kN/m"\n', "preload"),
        (ROD + 'mass = "1 kg"\nspeed = "60 rpm"\nload = "1 N*m"\n', "load"),
        (LEVER + 'inertia = "1 kg*m^2"\nspeed = "60 rpm"\nload = "1 N"\n', "load"),
        (
            ROD
            + 'mass = "1 kg"\nspeed = "60 rpm"\nrate = "1 kN/m"\npreload = "9 N"\nlead = "9 mm"\n',
            "lead",
        ),
        (ROD + 'mass = "1 kg"\nspeed = "60 rpm"\nlead = "0 mm"\n', "lead"),
        (ROD + 'mass = "1 kg"\nspeed = "60 rpm"\nlead = "2 m"\n', "lead"),
    ],
)
def test_what_contradicts_itself_names_its_key(tmp_path: Path, text: str, key: str) -> None:
    with pytest.raises(SceneError, match=rf"cam\.{key}"):
        read(written(tmp_path, text))
