"""A drum developed, and a groove in a disc: a roller fits between the drawn flanks where its law puts it."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import shapely
from support.cams import C6, SHAPES, Made, made, motion, outline, place_of, polygon
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.scenes import written

from graphic_tmm.board.findings import examine
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.values import Curve
from graphic_tmm.chapters.cam.findings import CamFinding, cam_findings
from graphic_tmm.chapters.cam.ink import ProfileNames, draw_profile_ink
from graphic_tmm.chapters.cam.ink_centre import CentreNames, draw_centre_ink
from graphic_tmm.chapters.cam.ink_drum import (
    draw_development_ink,
    draw_drum_radius_ink,
    draw_drum_scheme_ink,
)
from graphic_tmm.chapters.cam.ink_rules import TRACELESS
from graphic_tmm.chapters.cam.ink_scheme import SchemeNames
from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.profile import Contour
from graphic_tmm.chapters.cam.task import CamTask, Law, RockerFollower
from graphic_tmm.chapters.cam.task_motion import Stage
from graphic_tmm.errors import SceneError
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.shapes import box
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

THIN = 2.5e-4
"""A thin line on a drawing in full size, m: what differs by less is the same on paper."""
SIZES = {**C6, "stroke": 0.04}
LIFTS = (
    Stage(rise=80.0, stroke=0.02, law=Law("sine")),
    Stage(dwell=20.0),
    Stage(rise=60.0, stroke=0.015, law=Law("3-4-5")),
    Stage(dwell=30.0),
    Stage(fall=120.0, stroke=0.035, law=Law("cosine")),
    Stage(dwell=50.0),
)


def drum(**of: object) -> CamTask:
    given = {"rise_law": Law("sine"), "return_law": Law("3-4-5"), "roller": 0.008, **SIZES, **of}
    return CamTask(form="drum", **given)


@cache
def drawn(law: str, parts: int = 12) -> Made:
    return made(drum(rise_law=Law(law), return_law=Law(law), divisions=parts))


def flank(of: Made, contour: Contour) -> shapely.LineString:
    """Return a drawn contour of the development, m, straight from curve to curve, thrice round the drum."""
    whole = 2 * np.pi * of.one(of.cam.r0)
    points = []
    t = np.linspace(0.0, 1.0, 33)[:-1, None]
    for mark in contour.curves:
        value = of.reading[mark]
        assert isinstance(value, Curve)
        for run in bezier(value):
            p, q, r, s = run[:-1:3], run[1::3], run[2::3], run[3::3]
            u = 1.0 - t
            fine = u**3 * p + 3 * u * u * t * q + 3 * u * t * t * r + t**3 * s
            points += [*fine.T.ravel(), run[-1]]
    once = np.array(points) * of.one(of.cam.profile.mu)
    row = np.concatenate([once - whole, once, once + whole])
    return shapely.LineString(np.stack([row.real, row.imag], axis=1))


def gaps(of: Made, degrees: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return how far a roller placed by its law is from touching the lower flank and the upper one, m.

    It stands between them.
    """
    radius, r = of.one(of.cam.r0), of.one(of.cam.roller.radius)
    spots = shapely.points(radius * np.radians(degrees), motion(of.cam.order, degrees)[0])
    assert of.cam.profile.outer is not None
    lines = [flank(of, contour) for contour in (of.cam.profile.working, of.cam.profile.outer)]
    below, above = (list(line.coords) for line in lines)
    groove = shapely.Polygon([*below, *reversed(above)])
    shapely.prepare(groove)
    assert shapely.contains(groove, spots).all()
    trees = [shapely.STRtree(shapely.linestrings(np.stack([row[:-1], row[1:]], axis=1)))
             for row in map(np.array, (below, above))]  # fmt: skip
    lower, upper = (
        tree.query_nearest(spots, return_distance=True, all_matches=False)[1] - r for tree in trees
    )
    return lower, upper


def exact(of: Made, degrees: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return pressure angles (degrees) and curvatures of the path, hollow of it positive, by complex steps."""
    order, radius, h = of.cam.order, of.one(of.cam.r0), 1e-20
    rows = [(0.0, order.rise, 1), (order.rise + order.upper_dwell, order.fall, -1)]
    slope, bend = np.zeros_like(degrees), np.zeros_like(degrees)
    for (start, extent, sign), law in zip(rows, (order.rise_law, order.return_law), strict=True):
        shape = SHAPES[law.name]
        inside = (degrees > start) & (degrees < start + extent)
        u = (degrees - start) / extent
        turn = np.radians(extent)
        slope += inside * sign * order.stroke * shape[0](u + 1j * h).imag / h / turn
        bend += inside * sign * order.stroke * shape[1](u + 1j * h).imag / h / turn**2
    return (
        np.degrees(np.arctan2(slope, radius)),
        bend * radius / (radius**2 + slope**2) ** 1.5,
    )


@pytest.mark.turns(2)
@pytest.mark.parametrize("law", SHAPES)
def test_a_roller_between_the_flanks_stands_where_its_law_puts_it(law: str) -> None:
    degrees = np.arange(0.25, 360.0, 1.0)
    for gap in gaps(drawn(law, 24), degrees):
        np.testing.assert_allclose(gap, 0.0, atol=THIN / 5)


def test_with_twice_the_positions_the_flanks_are_nearer_by_far() -> None:
    degrees = np.arange(0.25, 360.0, 1.0)
    coarse, fine = (np.abs(gaps(drawn("3-4-5", n), degrees)).max() for n in (12, 24))
    assert coarse < 2e-5
    assert fine < coarse / 6


@pytest.mark.parametrize("law", ["sine", "cosine", "3-4-5"])
def test_pressure_angles_and_curvature_are_those_of_the_law(law: str) -> None:
    of = drawn(law)
    angles = np.array(of.cam.diagrams.turn.angles)
    alpha, kappa = exact(of, angles)
    np.testing.assert_allclose(of.reading[of.cam.centre.pressure][0], alpha, atol=1e-9)
    for mark, (_, first, last) in zip(
        of.cam.curvature.chart.ordinates, of.cam.diagrams.stretches, strict=True
    ):
        inside = slice(first + 1, last)
        read_off = of.reading[mark][0, inside] * of.one(of.cam.curvature.chart.mu)
        np.testing.assert_allclose(read_off, -kappa[inside], atol=1e-6)


@pytest.mark.parametrize("law", ["sine", "cosine", "3-4-5"])
def test_the_sharpest_bend_to_either_side_is_the_least_radius(law: str) -> None:
    of = drawn(law, 48)
    _, kappa = exact(of, np.arange(0.005, 360.0, 0.01))
    (sharpest,) = of.cam.curvature.extremes
    assert of.one(sharpest.value) == pytest.approx(1 / np.abs(kappa).max(), rel=2e-3)


@pytest.mark.parametrize(("rise", "back"), [(30.0, None), (20.0, 45.0), (45.0, 20.0)])
def test_the_least_mean_radius_is_that_at_which_no_pressure_angle_passes_its_limit(
    rise: float, back: float | None
) -> None:
    of = made(drum(pressure=rise, pressure_return=back, divisions=48))
    low, high, dense = 1e-4, 1.0, np.arange(0.0, 360.0, 0.01)
    slope = motion(of.cam.order, dense)[1]
    for _ in range(50):
        middle = (low + high) / 2
        alpha = np.degrees(np.arctan2(slope, middle))
        fits = alpha.max() <= rise and -alpha.min() <= (back or rise)
        low, high = (low, middle) if fits else (middle, high)
    assert of.one(of.cam.least) == pytest.approx(high, rel=1e-4)
    assert 1000 * of.one(of.cam.r0) == np.ceil(1000 * of.one(of.cam.least))
    assert not cam_findings(of.reading, of.cam)


def test_a_radius_too_small_and_a_roller_too_large_are_findings() -> None:
    of = made(drum(r0=0.05, roller=0.04))
    told = {one.kind: one for one in cam_findings(of.reading, of.cam)}
    assert set(told) == {"drum pressure", "drum roller by r0", "drum undercut"}
    assert told["drum pressure"].least == pytest.approx(1000 * of.one(of.cam.least))
    _, kappa = exact(of, np.arange(0.005, 360.0, 0.01))
    assert told["drum undercut"].limit == pytest.approx(1000 / np.abs(kappa).max(), rel=0.02)
    assert "take 82.7" in told["drum pressure"].says("en")
    flanks = [
        one for contour in (of.cam.profile.working, of.cam.profile.outer) for one in contour.curves
    ]
    missing = examine(of.log, of.given, flanks)
    gone = {one.step.op.name for one in missing if one.kind == "undrawn"}
    assert {"equidistant_pace", "outer_pace"} <= gone


def test_several_lifts_are_one_groove() -> None:
    of = made(CamTask(0.035, 0, 0, 0, 0, phases=LIFTS, form="drum", roller=0.006, divisions=16))
    degrees = np.arange(0.25, 360.0, 1.0)
    for gap in gaps(of, degrees):
        np.testing.assert_allclose(gap, 0.0, atol=THIN / 5)


def random_drums(seed: int, many: int) -> Iterator[CamTask]:
    draw = random.Random(f"drum {seed}")
    for _ in range(many):
        rise, fall = draw.uniform(60, 140), draw.uniform(60, 140)
        upper = draw.choice((0.0, draw.uniform(5, 60)))
        laws = [Law(draw.choice(list(SHAPES))) for _ in range(2)]
        yield CamTask(
            draw.uniform(0.01, 0.06), rise, upper, fall, 360.0 - rise - upper - fall, form="drum",
            rise_law=laws[0], return_law=laws[1], pressure=draw.uniform(20, 40), divisions=24,
        )  # fmt: skip


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10))
def test_random_drums_hold_their_rollers(seed: int) -> None:
    """The radii are chosen by the package: the roller keeps its share of either limit."""
    degrees = np.arange(0.7, 360.0, 3.1)
    for order in random_drums(seed, 5):
        of = made(order)
        assert not cam_findings(of.reading, of.cam), order
        for gap in gaps(of, degrees):
            np.testing.assert_allclose(gap, 0.0, atol=THIN / 2)


@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
@pytest.mark.parametrize("follower", [None, RockerFollower(0.08, 0.1)], ids=["rod", "lever"])
def test_both_flanks_of_a_disc_hold_the_roller(turns: str, follower: RockerFollower | None) -> None:
    of_rod = {} if follower is None else {"follower": follower, "stroke": 0.35}
    order = CamTask(
        **{**C6, **of_rod}, rise_law=Law("3-4-5"), return_law=Law("sine"), turns=turns,
        roller=0.006, groove=True, divisions=24,
    )  # fmt: skip
    of = made(order)
    assert of.cam.profile.outer is not None
    degrees = np.arange(0.25, 360.0, 1.0)
    z = place_of(of, degrees)(motion(order, degrees)[0])
    inner, outer = (
        polygon(outline(of, one)) for one in (of.cam.profile.working, of.cam.profile.outer)
    )
    assert outer.contains(inner)
    spots = shapely.points(z.real, z.imag)
    for flank_ in (inner, outer):
        away = shapely.distance(spots, flank_.exterior)
        np.testing.assert_allclose(away, 0.006, atol=THIN / 10)
    assert outer.contains(shapely.MultiPoint(spots))
    assert not inner.intersects(shapely.MultiPoint(spots))


def test_a_hollow_narrower_than_the_roller_is_found_in_a_groove_only() -> None:
    """Without a groove a hollow of the path is no matter: the roller stands inside its own path."""
    hollow = {
        "rise": 70.0, "rise_law": Law("constant acceleration", shares=(1.0, 6.0)), "fall": 60.0,
        "return_law": Law("constant acceleration", shares=(6.0, 1.0)), "lower_dwell": 210.0,
    }  # fmt: skip
    sizes = {**C6, **hollow, "r0": 0.05, "pressure": 70.0}
    kinds = []
    for groove in (True, False):
        of = made(CamTask(**sizes, groove=groove, roller=0.012))
        kinds.append({one.kind for one in cam_findings(of.reading, of.cam)})
    assert kinds == [{"undercut"}, set()]


@pytest.mark.parametrize(
    ("line", "key"),
    [
        ('form = "drum"\nr0 = "50 mm"', "r0"),
        ('form = "drum"\noffset = "5 mm"', "offset"),
        ('form = "drum"\nfollower = "flat"', "follower"),
        ('form = "drum"\nroller = 0', "roller"),
        ('form = "drum"\nturns = "clockwise"', "turns"),
        ('form = "drum"\ngroove = true', "groove"),
        ('form = "drum"\nspeed = "90 rpm"\nmass = "1 kg"', "mass"),
        ('groove = true\nfollower = "knife edge"', "follower"),
        ('radius = "50 mm"', "radius"),
    ],
)
def test_what_a_drum_and_a_groove_do_not_have_is_refused(
    tmp_path: Path, line: str, key: str
) -> None:
    text = f'[cam]\nrise = 120\nfall = 90\nstroke = "20 mm"\n{line}\n'
    with pytest.raises(SceneError, match=rf"cam\.{key}"):
        read(written(tmp_path, text))


@pytest.mark.parametrize("order", [drum(), CamTask(**C6, groove=True)], ids=["drum", "disc"])
def test_every_step_of_a_groove_is_inked_and_pictures_make_its_views(order: CamTask) -> None:
    of = made(order)
    on = Subject(of.log, of.reading, "X", HEIGHTS["A1"])
    names = [str(k) for k in range(of.cam.diagrams.turn.positions)]
    told = CentreNames(names, "S", "dS/dφ", "R_{min}", "R")
    letters = ProfileNames(names, "R", "r", "theoretical", "working")
    draws = (draw_centre_ink, draw_profile_ink)
    if order.developed:
        draws = (draw_drum_radius_ink, draw_development_ink)
        scheme = finished(draw_drum_scheme_ink(on, of.cam, SchemeNames("α", "R")))
        assert {"drum", "contour", "roller", "follower"} <= {one.part for one in scheme.strokes}
        assert not without_source(scheme)
    drawn = [finished(draws[0](on, of.cam, told)), finished(draws[1](on, of.cam, letters))]
    assert not without_ink(of.log, drawn, TRACELESS)
    for view in drawn:
        assert not without_source(view)
        assert_pictures_make_the_view(of.log, view)


@pytest.mark.parametrize("parts", [12, 24, 48])
def test_numbers_of_a_development_stand_at_their_own_ordinates(parts: int) -> None:
    """Of those that are numbered each is nearest to its own, and all are on one level."""
    of = drawn("sine", parts)
    names = [str(k) for k in range(of.cam.diagrams.turn.positions)]
    letters = ProfileNames(names, "R", "r", "theoretical", "working")
    on = Subject(of.log, of.reading, "X", HEIGHTS["A1"])
    view = finished(draw_development_ink(on, of.cam, letters))
    feet = of.reading[of.cam.profile.feet][0].real
    numbers = [one for one in view.labels if one.position is not None and one.text.isdigit()]
    assert len(numbers) >= len(names) / 5
    places = [one.position for one in numbers]
    for one in numbers:
        left, _, right, _ = box(one).bounds
        off = np.maximum(left - feet[places], feet[places] - right)
        assert places[int(np.argmin(off))] == one.position
    assert len({round(one.at.imag, 6) for one in numbers}) == 1


@pytest.mark.parametrize("stroke", [34, 20, 27.3])
def test_the_radius_to_take_is_larger_than_one_that_is_too_small(
    tmp_path: Path, stroke: float
) -> None:
    """On an A4 the least radius reads less than it is: 56 mm were too small, and 56 to be taken."""
    text = (
        f'title = "T"\nlanguage = "en"\n[cam]\nform = "drum"\nstroke = "{stroke} mm"\nrise = 120\n'
    )
    text += 'upper_dwell = 30\nfall = 120\n{more}\n[[sheet]]\nformat = "A4"\nplace = ["cam"]\n'

    def said(more: str) -> list[CamFinding]:
        (board,) = make(read(written(tmp_path, text.replace("{more}", more)))).boards
        found = cam_findings(board.reading, CAM_PLAN.on(board))
        return [one for one in found if one.kind == "drum pressure"]

    first = said("" if stroke == 34 else 'radius = "30.004 mm"')
    sizes = re.search(r"radius of ([\d.]+) mm is too small, take ([\d.]+) mm", first[0].says("en"))
    assert sizes is not None
    assert float(sizes[2]) > float(sizes[1])
    assert float(sizes[2]) >= first[0].least
    assert said(f'radius = "{sizes[2]} mm"') == []
