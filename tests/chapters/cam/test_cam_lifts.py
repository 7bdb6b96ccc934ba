"""Cams with several lifts in a turn: diagrams in closed form, least r0, followers lowered onto profiles."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.cam_springs import closing, values, within
from support.cams import (
    SHAPES,
    Made,
    displaced,
    least_radius,
    made,
    motion,
    pressure_angles,
    stages,
)

from graphic_tmm.chapters.cam.findings import cam_findings
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.kinds_spring import SpringTask
from graphic_tmm.chapters.cam.phases import divide
from graphic_tmm.chapters.cam.task import (
    ASKED,
    CamTask,
    FlatFollower,
    Follower,
    Law,
    RockerFollower,
    RollerFollower,
    Stage,
)
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.scene.read import read

HUNDREDTH = 1e-5
"""0.01 mm, m: of 300 cams the worst was off by 0.0103 mm with 12 parts of a phase; it falls as 1/N⁴."""
LAWS = [
    *map(Law, SHAPES),
    Law("constant acceleration", shares=(2.0, 1.0)),
    Law("diagram", ((0, 0), (1 / 8, 1), (3 / 8, 1), (5 / 8, -1), (7 / 8, -1), (1, 0))),
    Law("diagram", ((0, 2), (1 / 3, 2), (1 / 3, -1), (1, -1))),
]
FOLLOWERS: dict[str, Follower] = {
    "central": RollerFollower(),
    "offset": RollerFollower(0.008),
    "offset back": RollerFollower(-0.006),
    "knife edge": RollerFollower(0.005, edge=True),
    "rocker": RockerFollower(0.08, 0.1),
    "rocker along": RockerFollower(0.08, 0.1, same_sense=True),
    "flat": FlatFollower(0.004),
    "flat rocker": FlatRockerFollower(0.11, 0.0, 0.004),
    "flat rocker along": FlatRockerFollower(0.11, 0.01, 0.004, same_sense=True),
}


def cam_of(phases: list[Stage], **more: object) -> CamTask:
    heights = np.cumsum([0.0, *(one.lift for one in phases)])
    stroke = float(heights.max() - heights.min())
    return CamTask(stroke, 0.0, 0.0, 0.0, 0.0, phases=tuple(phases), **more)  # type: ignore[arg-type]


def random_cam(seed: int) -> CamTask:
    """Two to five moving phases in any order, dwells between some; laws and followers at random."""
    rng = np.random.default_rng(seed)
    follower = list(FOLLOWERS.values())[seed % len(FOLLOWERS)]
    most = {RockerFollower: 0.35, FlatRockerFollower: 0.2}.get(type(follower), 0.03)
    spring = SpringTask(0.4, 6.0) if most == 0.03 else SpringTask(0.002, 0.1)
    moving = int(rng.integers(2, 6))
    places = [0.0]
    while len(places) < moving:
        next_ = float(rng.choice(np.linspace(0.0, 1.0, 7)))
        if next_ != places[-1] and (len(places) < moving - 1 or next_ != places[0]):
            places.append(next_)
    lifts = most * np.diff([*places, places[0]])
    turned = int(rng.integers(moving))
    lifts = np.roll(lifts, turned)
    rests = rng.random(moving + 1) < 0.5
    weights = rng.uniform(0.7, 1.5, moving) * np.sqrt(np.abs(lifts) / most) + 0.25
    rest = rng.uniform(0.2, 0.6, moving + 1) * rests
    whole = weights.sum() + rest.sum()
    angles, dwells = np.round(360.0 * weights / whole), np.round(360.0 * rest / whole)
    angles[-1] += 360.0 - angles.sum() - dwells.sum()
    phases: list[Stage] = []
    for k in range(moving):
        if dwells[k] > 0:
            phases.append(Stage(dwell=float(dwells[k])))
        way = "rise" if lifts[k] > 0 else "fall"
        law = LAWS[int(rng.integers(len(LAWS)))]
        told = {way: float(angles[k]), "stroke": float(abs(lifts[k])), "law": law}
        phases.append(Stage(**told))  # type: ignore[arg-type]
    if dwells[-1] > 0:
        phases.append(Stage(dwell=float(dwells[-1])))
    turns = str(rng.choice(["clockwise", "counterclockwise"]))
    more = {"follower": follower, "turns": turns, "speed": 20.0, "spring": spring}
    return cam_of(phases, pressure=45.0, pressure_return=50.0, divisions=16, **more)


def off_the_law(of: Made) -> float:
    """How far any ordinate is from the closed form, as a share of the largest of its kind."""
    worst, diagrams = 0.0, of.cam.diagrams
    angles = np.array(diagrams.turn.angles)
    for k, diagram in enumerate((diagrams.S, diagrams.V, diagrams.A)):
        size = np.abs(motion(of.cam.order, np.arange(0.25, 360.0, 0.5))[k]).max()
        for mark, (_, a, b) in zip(diagram.readings, diagrams.stretches, strict=True):
            inside = angles[a : b + 1] + np.array([1e-9, *[0.0] * (b - a - 1), -1e-9])
            due = motion(of.cam.order, inside)[k]
            read = of.reading[mark][0, a : b + 1] * of.one(diagram.axes.mu)
            worst = max(worst, float(np.abs(read - due).max() / size))
    return worst


def slack(of: CamTask) -> float:
    """How far the least r0 may be off, m: a spline through the parts of a phase."""
    lever = of.follower.lever if isinstance(of.follower, RockerFollower) else 1.0
    speed = max(
        abs(one.after - one.before) * lever / np.radians(one.extent)
        for one in stages(of)
        if one.law is not None
    )
    limit = min(of.pressure, of.pressure_return or of.pressure)
    return float(5 / 384 * (2 * np.pi / of.divisions) ** 4 * speed / np.tan(np.radians(limit)))


@pytest.mark.slow
def test_random_cams_give_back_their_laws(many: Callable[[int, int], int]) -> None:
    """Diagrams by closed forms, least r0 by brute force, the follower lowered onto the working profile.

    Of the spring: the moment on the shaft by virtual work.
    """
    judged, faced = 0, (FlatFollower, FlatRockerFollower)
    for seed in range(many(300, 18)):
        of = random_cam(seed)
        found = made(of)
        assert off_the_law(found) < 1e-8, seed
        told = {finding.kind for finding in cam_findings(found.reading, found.cam)}
        assert not told - {"no centre", "path", "hollow lever"}, (seed, told)
        if told & {"no centre", "hollow lever"}:
            continue
        if not isinstance(of.follower, faced):
            due = least_radius(of, 0.05)
            assert abs(found.one(found.cam.least) - due) < 3 * slack(of) + 2e-6, seed
        angles = np.arange(0.5, 360.0, 1.0)
        arm = getattr(of.follower, "lever", getattr(of.follower, "centres", 1.0))
        off = np.abs(displaced(found, angles) - motion(of, angles)[0]).max() * arm
        assert off < HUNDREDTH, seed
        at = np.array(found.cam.diagrams.turn.angles)
        work = closing(found, at) * motion(of, at)[1]
        moment, inside = values(found, found.cam.spring.moment), within(found)
        due = np.broadcast_to(work, moment.shape)[inside]
        np.testing.assert_allclose(moment[inside], due, atol=1e-9 * np.abs(work).max())
        judged += 1
    assert judged > 0.9 * many(300, 18)


TWO = [
    Stage(rise=70.0, stroke=0.03, law=Law("sine")),
    Stage(dwell=30.0),
    Stage(fall=50.0, stroke=0.015, law=Law("cosine")),
    Stage(dwell=20.0),
    Stage(rise=45.0, stroke=0.01, law=Law("constant acceleration")),
    Stage(fall=75.0, stroke=0.025, law=Law("3-4-5")),
    Stage(dwell=70.0),
]


def test_the_usual_cam_is_the_same_by_phases() -> None:
    law, other = Law("sine"), Law("cosine")
    usual = made(CamTask(0.028, 100.0, 20.0, 90.0, 150.0, rise_law=law, return_law=other))
    phases = [
        Stage(rise=100.0, stroke=0.028, law=law),
        Stage(dwell=20.0),
        Stage(fall=90.0, stroke=0.028, law=other),
        Stage(dwell=150.0),
    ]
    found = made(cam_of(phases))
    assert found.one(found.cam.least) == pytest.approx(usual.one(usual.cam.least), rel=1e-12)
    for a, b in zip(
        found.cam.profile.working.curves, usual.cam.profile.working.curves, strict=True
    ):
        np.testing.assert_allclose(found.reading[a].knots, usual.reading[b].knots, atol=1e-9)


def test_positions_and_extremes_of_two_lifts() -> None:
    found = made(cam_of(TWO, follower=RollerFollower(0.01)))
    turn = found.cam.diagrams.turn
    assert [(phase.number, phase.name, phase.low) for phase in turn.phases] == [
        (1, "rise", 0.0), (3, "return", 0.015), (5, "rise", 0.015), (6, "return", 0.0),
    ]  # fmt: skip
    assert [turn.angles[phase.first] for phase in turn.phases] == [0.0, 100.0, 170.0, 215.0]
    assert turn.phases[3].first == turn.phases[2].last  # no dwell between them
    assert turn.rest(turn.lowest) == pytest.approx(70.0)
    alpha = pressure_angles(found.cam.order, found.one(found.cam.r0), np.arange(0, 360, 0.02))
    told = [found.one(extreme.value) for extreme in found.cam.pressure.extremes]
    np.testing.assert_allclose(told, [alpha.max(), alpha.min()], atol=0.02)


def test_angles_to_a_tenth_of_a_degree_leave_no_dwell() -> None:
    """Their sums differ from angles by roundings, of either sign: none of them is a dwell, or a whole turn."""
    rng, law = np.random.default_rng(37), Law("sine")
    for _ in range(200):
        tenths = rng.integers(300, 900, 3) / 10.0
        angles = [*map(float, tenths), round(float(360.0 - tenths.sum()), 1)]
        ways = zip(("rise", "fall") * 2, angles, (0.02, 0.01, 0.01, 0.02), strict=True)
        phases = [Stage(**{way: x, "stroke": h, "law": law}) for way, x, h in ways]
        turn = divide(cam_of(phases))
        assert [turn.rest(phase) for phase in turn.phases] == [0.0] * 4, angles
    angles = (69.1, 77.3, 35.6, 98.0)
    ways = zip(("rise", "fall") * 2, angles, (0.02, 0.02, 0.01, 0.01), strict=True)
    phases = [Stage(**{way: x, "stroke": h, "law": law}) for way, x, h in ways]
    turn = divide(cam_of([*phases, Stage(dwell=80.0)]))
    assert turn.lowest.number == 4
    assert turn.rest(turn.lowest) == pytest.approx(80.0)


def test_a_turn_may_begin_anywhere() -> None:
    """Begun with the dwell above, the same cam has the same least radius, and its profile turned."""
    one, other = (made(cam_of(rows)) for rows in (TWO, [*TWO[1:], TWO[0]]))
    assert other.one(other.cam.least) == pytest.approx(one.one(one.cam.least), rel=1e-9)
    curve, same = one.cam.profile.working.curves[0], other.cam.profile.working.curves[-1]
    turned = one.reading[curve].knots * np.exp(-1j * np.radians(290.0))
    np.testing.assert_allclose(other.reading[same].knots, turned, atol=1e-6)


def test_strokes_that_differ_by_less_than_is_read_make_a_turn() -> None:
    """30 mm up and 20 nm less down; the lowest place is come to twice, once by strokes with a rounding."""
    law, low = Law("sine"), 0.02999998
    once = [
        Stage(rise=100.0, stroke=0.03, law=law),
        Stage(fall=100.0, stroke=low, law=law),
        Stage(dwell=160.0),
    ]
    short = [Stage(rise=50.0, stroke=0.03, law=law), Stage(fall=50.0, stroke=low, law=law)]
    again = [Stage(rise=50.0, stroke=0.03, law=law), Stage(fall=50.0, stroke=0.03, law=law)]
    for phases in (once, [*short, *again, Stage(dwell=160.0)], [*again, *short, once[2]]):
        found = made(cam_of(phases))
        assert found.cam.diagrams.turn.lowest is found.cam.diagrams.turn.phases[-1]
        low_, high = (
            found.reading[circle].radius[0, 0] * found.one(found.cam.profile.mu)
            for circle in (found.cam.profile.theoretical.lower, found.cam.profile.theoretical.upper)
        )
        assert low_ == pytest.approx(found.one(found.cam.r0), abs=1e-7)
        assert high == pytest.approx(low_ + 0.03, abs=1e-7)


@pytest.mark.parametrize(
    ("phases", "says"),
    [
        ([*TWO, Stage(dwell=10.0)], "make 370°, not 360°: shorten them by 10°"),
        (TWO[:-1], "make 290°, not 360°: lengthen them by 70°"),
        ([Stage(rise=360.0, stroke=0.01, law=Law("sine"))], "come back to where it began"),
        ([Stage(dwell=360.0)], "rises nowhere"),
        ([Stage(), *TWO], "phase 1 is one of rise, dwell, fall"),
        ([Stage(rise=20.0, fall=20.0, stroke=0.01), *TWO], "phase 1 is one of"),
        ([Stage(dwell=20.0, stroke=0.01), *TWO], "leave its stroke and its law out"),
        ([Stage(rise=20.0, law=Law("sine")), *TWO], "phase 1 needs a stroke"),
    ],
)
def test_phases_that_make_no_turn_are_refused(phases: list[Stage], says: str) -> None:
    with pytest.raises(StructureError, match=says):
        divide(CamTask(0.03, 0.0, 0.0, 0.0, 0.0, phases=tuple(phases)))


SCENE = """title = "T"
language = "en"
[cam]
{keys}
phase = [
  {{ rise = 80, stroke = "20 mm" }}, {{ dwell = 40 }}, {{ fall = 90, stroke = "15 mm", law = "uniform" }},
  {{ fall = 60, stroke = "5 mm", shares = [1, 2] }}, {{ dwell = 90 }},
]
"""


def test_phases_take_what_they_do_not_say_from_the_cam(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(SCENE.format(keys='law = "cosine"'))
    of = ASKED.of(read(path))
    assert of is not None
    laws = [one.law for one in of.phases if one.law is not None]
    assert [law.name for law in laws] == ["cosine", "constant velocity", "constant acceleration"]
    assert laws[2].shares == (1.0, 2.0)
    assert of.stroke == pytest.approx(0.02)
    assert [one.angle for one in of.stages] == [80.0, 40.0, 90.0, 60.0, 90.0]


def test_a_phase_of_the_law_of_the_cam_has_its_shares_and_points(tmp_path: Path) -> None:
    """A phase that says nothing more than the law; shares that it says itself are its own, even ones too."""
    path, text = tmp_path / "scene.toml", SCENE.replace('"uniform"', '"{law}"')
    for law, more in (("constant acceleration", "shares = [2, 1]"), ("diagram", POINTS)):
        path.write_text(text.format(keys=f'law = "{law}"\n{more}', law=law))
        of = ASKED.of(read(path))
        assert of is not None
        first, again, own = (one.law for one in of.phases if one.law is not None)
        assert first == again
        assert first != Law(law)
        assert own == Law("constant acceleration", shares=(1.0, 2.0))
    shared = text.replace("[1, 2]", "[1, 1]")
    path.write_text(
        shared.format(keys='law = "constant acceleration"\nshares = [2, 1]', law="sine")
    )
    assert ASKED.of(read(path)).phases[3].law == Law("constant acceleration")


POINTS = "law_points = [[0, 1], [0.5, 1], [0.5, -1], [1, -1]]"


@pytest.mark.parametrize(
    ("keys", "old", "new", "says"),
    [
        ("rise = 80", "", "", "cam.rise: the phases of"),
        ("return_law = 'sine'", "", "", "cam.return_law: the phases of"),
        ("", '"5 mm"', '"5 deg"', "moves along its guide"),
        ("", "dwell = 90", "dwell = 80", "lengthen them by 10°"),
        ("", '"5 mm"', '"6 mm"', "change a stroke by 1 mm"),
        ("", 'stroke = "5 mm", ', "", "phase 4 needs a stroke"),
        ("", "shares = [1, 2]", "law = 'sine', shares = [1, 2]", "only the law of constant"),
        ("", "[1, 2]", "[1, 0]", "write the shares of speeding up"),
        ("shares = [2, 1]", "", "", "cam.shares: only law"),
        ("", "phase = [", "phases = [", "phases"),
    ],
)
def test_phases_of_a_file_are_refused_by_key(
    tmp_path: Path, keys: str, old: str, new: str, says: str
) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(
        SCENE.format(keys=keys).replace(old, new, 1) if old else SCENE.format(keys=keys)
    )
    with pytest.raises(SceneError) as found:
        read(path)
    assert says in str(found.value)


def test_a_cam_of_one_lift_still_needs_its_keys(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text('title = "T"\nlanguage = "en"\n[cam]\nstroke = "20 mm"\nrise = 80\n')
    with pytest.raises(SceneError, match='"fall" is missing'):
        read(path)
