"""A cam that slides: a roller or an edge lowered onto its drawn profile stands where its law puts it."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest
import shapely
from support.boards import in_usual_size
from support.cams import SHAPES, Made, made, shapes
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.scenes import written
from support.turned import inside, laid, picture

import graphic_tmm as tmm
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.values import Curve
from graphic_tmm.chapters.cam.findings import cam_findings
from graphic_tmm.chapters.cam.ink import ProfileNames
from graphic_tmm.chapters.cam.ink_centre import CentreNames
from graphic_tmm.chapters.cam.ink_drum import (
    draw_development_ink,
    draw_drum_radius_ink,
    draw_drum_scheme_ink,
)
from graphic_tmm.chapters.cam.ink_rules import TRACELESS
from graphic_tmm.chapters.cam.ink_scheme import SchemeNames
from graphic_tmm.chapters.cam.kinds import RollerFollower
from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.profile import Contour
from graphic_tmm.chapters.cam.task import CamTask, Law
from graphic_tmm.chapters.cam.task_motion import Stage
from graphic_tmm.chapters.cam.views import cam_views
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read

THIN = 5e-5
"""A fifth of a thin line on a drawing in full size, m."""
NEAR = 0.1
"""A line is three times as broad on the page, mm."""
EDGE = RollerFollower(edge=True)
LAWS = (
    *map(Law, SHAPES),
    Law("constant acceleration", shares=(2.0, 1.0)),
    Law("diagram", ((0.0, 0.0), (0.25, 1.0), (0.75, -1.0), (1.0, 0.0))),
)
LIFTS = (
    Stage(dwell=0.01),
    Stage(rise=0.06, stroke=0.015, law=Law("sine")),
    Stage(dwell=0.02),
    Stage(rise=0.05, stroke=0.01, law=Law("3-4-5")),
    Stage(fall=0.04, stroke=0.008, law=Law("cosine")),
    Stage(dwell=0.015),
)


def plate(**of: object) -> CamTask:
    given = {"stroke": 0.02, "rise": 0.09, "upper_dwell": 0.03, "fall": 0.0, "lower_dwell": 0.0,
             "rise_law": Law("sine"), "return_law": Law("3-4-5"), "divisions": 24}  # fmt: skip
    return CamTask(form="translating", **{**given, **of})


def law_at(order: CamTask, s: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return S, its slope and its second derivative at places of the cam (m), in closed form."""
    found = [np.zeros_like(s), np.zeros_like(s), np.zeros_like(s)]
    start = high = 0.0
    lifts = np.cumsum([0.0, *(one.lift for one in order.stages)])
    high = -float(lifts.min())
    for one in order.stages:
        inside = (s >= start) & (s <= start + one.angle)
        if one.sign:
            shape, u = shapes(one.law), np.clip((s - start) / one.angle, 0, 1)
            for k in range(3):
                value = one.lift * shape[k](u) / one.angle**k
                found[k] = np.where(inside, value + (high if k == 0 else 0.0), found[k])
        else:
            found[0] = np.where(inside, high, found[0])
        start, high = start + one.angle, high + one.lift
    return found[0], found[1], found[2]


def contour(of: Made, drawn: Contour) -> np.ndarray:
    """Return a drawn contour, complex, m: its curves, straight between them and to both ends of the cam."""
    t, spots = np.linspace(0.0, 1.0, 65)[:-1, None], []
    for mark in drawn.curves:
        value = of.reading[mark]
        assert isinstance(value, Curve)
        for run in bezier(value):
            p, q, r, s = run[:-1:3], run[1::3], run[2::3], run[3::3]
            u = 1.0 - t
            spots += [
                *(u**3 * p + 3 * u * u * t * q + 3 * u * t * t * r + t**3 * s).T.ravel(),
                run[-1],
            ]
    once = np.array(spots) * of.one(of.cam.profile.mu)
    ends = complex(-0.05, once[0].imag), complex(of.cam.order.whole + 0.05, once[-1].imag)
    return np.concatenate([ends[:1], once, ends[1:]])


def lowered(of: Made, s: np.ndarray) -> np.ndarray:
    """Return how high a roller, or an edge, stands that is lowered until it touches the cam, m."""
    spots = contour(of, of.cam.profile.working)
    r = of.one(of.cam.roller.radius) if of.cam.roller is not None else 0.0
    if r == 0.0:
        line = shapely.LineString(np.stack([spots.real, spots.imag], axis=1))
        tall = [shapely.LineString([(x, -1.0), (x, 1.0)]) for x in s]
        return np.array([shapely.intersection(line, one).bounds[3] for one in tall])
    body = shapely.Polygon(
        [(-0.05, -1.0), *zip(spots.real, spots.imag, strict=True), (spots[-1].real, -1.0)]
    )
    low, high = np.full_like(s, -0.5), np.full_like(s, 0.5)
    shapely.prepare(body)
    for _ in range(45):
        middle = (low + high) / 2
        free = shapely.distance(shapely.points(s, middle), body) > r
        low, high = np.where(free, low, middle), np.where(free, middle, high)
    return high


@pytest.mark.turns(3)
@pytest.mark.parametrize("law", LAWS, ids=str)
@pytest.mark.parametrize("follower", [None, EDGE], ids=["roller", "edge"])
def test_a_follower_lowered_on_the_plate_stands_where_its_law_puts_it(
    law: Law, follower: RollerFollower | None
) -> None:
    more = {"roller": 0.008} if follower is None else {"follower": follower}
    of = made(plate(rise_law=law, **more))
    s = np.linspace(0.0005, 0.1195, 60)
    np.testing.assert_allclose(lowered(of, s), law_at(of.cam.order, s)[0], atol=THIN)
    assert of.cam.profile.outer is None


def test_lifts_that_do_not_come_back_and_a_fall_are_profiles_too() -> None:
    for order in (plate(fall=0.07, lower_dwell=0.02, roller=0.006),
                  plate(phases=LIFTS, stroke=0.025, roller=0.005)):  # fmt: skip
        of = made(order)
        s = np.linspace(0.0005, order.whole - 0.0005, 90)
        np.testing.assert_allclose(lowered(of, s), law_at(order, s)[0], atol=THIN)


@pytest.mark.parametrize("law", ["sine", "cosine", "3-4-5"])
def test_diagrams_pressure_angles_and_curvature_are_those_of_the_law(law: str) -> None:
    of = made(plate(rise_law=Law(law), roller=0.008))
    s = np.array(of.cam.diagrams.turn.angles)
    S, slope, bend = law_at(of.cam.order, s)
    diagrams = of.cam.diagrams
    for one, exact in ((diagrams.S, S), (diagrams.V, slope), (diagrams.A, bend)):
        read_off = of.reading[one.reading][0] * of.one(one.chart.mu)
        np.testing.assert_allclose(
            read_off[:-1], exact[:-1], atol=1e-9
        )  # it may jump behind the last
    assert (diagrams.S.chart.unit, diagrams.V.chart.unit, diagrams.A.chart.unit) == ("m", "", "1/m")
    alpha = np.degrees(np.arctan(slope))
    np.testing.assert_allclose(of.reading[of.cam.centre.pressure][0], alpha, atol=1e-9)
    chart = of.cam.curvature.chart
    read_off = of.reading[chart.ordinates[0]][0] * of.one(chart.mu)
    kappa = -bend / (1 + slope**2) ** 1.5
    np.testing.assert_allclose(read_off[:-1], kappa[:-1], atol=1e-6)


@pytest.mark.parametrize(("rise", "back"), [(30.0, None), (20.0, 45.0), (45.0, 20.0)])
def test_at_the_least_length_no_pressure_angle_passes_its_limit(
    rise: float, back: float | None
) -> None:
    order = plate(fall=0.05, pressure=rise, pressure_return=back, divisions=48)
    least = made(order).one(made(order).cam.least)
    told = {"S": least / order.whole}
    low, high = 0.01, 2.0
    for _ in range(50):
        long = (low + high) / 2
        slope = law_at(order, np.linspace(0.0, order.whole, 40001))[1] * order.whole / long
        alpha = np.degrees(np.arctan(slope))
        fits = alpha.max() <= rise and -alpha.min() <= (back or rise)
        low, high = (low, long) if fits else (long, high)
    assert least == pytest.approx(high, rel=1e-4)
    many = told["S"] * 1.0001
    for factor, kinds in ((many, set()), (many * 0.98, {"plate pressure"})):
        longer = plate(
            rise=0.09 * factor, upper_dwell=0.03 * factor, fall=0.05 * factor, divisions=48,
            pressure=rise, pressure_return=back,
        )  # fmt: skip
        of = made(longer)
        assert {one.kind for one in cam_findings(of.reading, of.cam)} == kinds


def test_a_cam_too_short_and_a_roller_too_large_are_findings() -> None:
    of = made(plate(rise=0.04, roller=0.03))
    told = {one.kind: one for one in cam_findings(of.reading, of.cam)}
    assert set(told) == {"plate pressure", "plate undercut"}
    assert told["plate pressure"].angle == pytest.approx(20.0, abs=0.05)
    dense = np.linspace(0.0, 0.07, 70001)
    _, slope, bend = law_at(of.cam.order, dense)
    kappa = -bend / (1 + slope**2) ** 1.5
    assert told["plate undercut"].limit == pytest.approx(1000 / kappa.max(), rel=0.02)
    assert told["plate undercut"].angle == pytest.approx(1000 * dense[kappa.argmax()], abs=0.5)
    chosen = made(plate())
    assert chosen.one(chosen.cam.roller.radius) == pytest.approx(0.4 * 0.02)
    sharp = made(plate(rise=0.05, least_rho=0.03, roller=0.005))
    assert "plate sharp" in {one.kind for one in cam_findings(sharp.reading, sharp.cam)}


def test_both_flanks_of_a_groove_hold_the_roller() -> None:
    of = made(plate(fall=0.08, groove=True, roller=0.007))
    s = np.linspace(0.0005, 0.1995, 100)
    spots = shapely.points(s, law_at(of.cam.order, s)[0])
    assert of.cam.profile.outer is not None
    for one, side in ((of.cam.profile.working, 1.0), (of.cam.profile.outer, -1.0)):
        row = contour(of, one)
        line = shapely.LineString(np.stack([row.real, row.imag], axis=1))
        np.testing.assert_allclose(shapely.distance(spots, line), 0.007, atol=THIN)
        at = [shapely.Point(line.interpolate(line.project(spot)).coords[0]) for spot in spots]
        assert all(side * (spot.y - foot.y) > 0 for spot, foot in zip(spots, at, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10))
def test_random_plates_lift_as_they_should(seed: int) -> None:
    draw = random.Random(f"plate {seed}")
    for _ in range(8):
        order = plate(
            stroke=draw.uniform(0.005, 0.03), rise=draw.uniform(0.06, 0.12),
            upper_dwell=draw.choice((0.0, draw.uniform(0.01, 0.05))),
            fall=draw.choice((0.0, draw.uniform(0.06, 0.12))), lower_dwell=0.0,
            rise_law=Law(draw.choice(list(SHAPES))), return_law=Law(draw.choice(list(SHAPES))),
            pressure=60.0, **draw.choice(({}, {"follower": EDGE})),
        )  # fmt: skip
        of = made(order)
        assert not cam_findings(of.reading, of.cam), order
        s = np.linspace(0.0005, order.whole - 0.0005, 60)
        np.testing.assert_allclose(lowered(of, s), law_at(order, s)[0], atol=2 * THIN)


HEAD = 'title = "T"\nlanguage = "en"\n[cam]\nform = "translating"\nstroke = "20 mm"\n'


@pytest.mark.parametrize(
    ("line", "key"),
    [
        ('rise = "80 mm"\nr0 = "50 mm"', "r0"),
        ('rise = "80 mm"\nradius = "50 mm"', "radius"),
        ('rise = "80 mm"\noffset = "5 mm"', "offset"),
        ('rise = "80 mm"\nfollower = "flat"', "follower"),
        ('rise = "80 mm"\nfollower = "rocker"\nlever = "80 mm"\ncentres = "90 mm"', "follower"),
        ('rise = "80 mm"\nturns = "clockwise"', "turns"),
        ('rise = "80 mm"\nspeed = "90 rpm"', "speed"),
        ('rise = "80 mm"\nmass = "1 kg"', "mass"),
        (
            'rise = "80 mm"\nlaw = "table"\nlaw_table = [["0 deg", "0 mm"], ["80 deg", "20 mm"]]',
            "law_table",
        ),
        ('rise = "80 mm"\nmu_dS = "0.001 m/mm"', "mu_dS"),
        ('rise = "80 mm"\nlower_dwell = "10 mm"', "lower_dwell"),
        ('rise = "80 deg"', "rise"),
        ("rise = 80", "rise"),
        ('rise = "-60 mm"', "rise"),
        ('rise = "0 mm"', "rise"),
        ('rise = "-5 deg"', "rise"),
        ('rise = "80 mm"\nupper_dwell = "80 deg"', "upper_dwell"),
        ('[[cam.phase]]\nrise = "80 deg"', r"phase\[1\].rise"),
        ('[[cam.phase]]\nfall = "80 mm"', "phase"),
    ],
)
def test_what_a_plate_does_not_have_is_refused(tmp_path: Path, line: str, key: str) -> None:
    with pytest.raises(SceneError, match=rf"cam\.{key}") as caught:
        read(written(tmp_path, f"{HEAD}{line}\n"))
    assert "an angle is wanted" not in str(caught.value)


def test_a_cam_that_turns_has_angles(tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=r"cam\.rise.*60 deg"):
        read(written(tmp_path, '[cam]\nstroke = "20 mm"\nrise = "80 mm"\nfall = "90 deg"\n'))


TURNS = np.arange(0.0, 360.0, 3.7)


@pytest.mark.parametrize(
    "more",
    ['roller = "7 mm"', 'follower = "knife edge"', 'roller = "7 mm"\nfall = "60 mm"',
     'roller = "7 mm"\nfall = "60 mm"\ngroove = true'],
)  # fmt: skip
def test_on_the_page_the_follower_touches_the_sliding_plate(tmp_path: Path, more: str) -> None:
    shown = picture(tmp_path, f'{HEAD}rise = "80 mm"\nupper_dwell = "20 mm"\n{more}\n')
    cam, guide, follower = shown.bodies
    assert not guide.moves
    edge, groove = "edge" in more, "groove" in more
    places = []
    for turn in TURNS:
        rod = laid(follower, turn, "body" if edge else "main")
        flanks = laid(cam, turn, "main", part="contour")
        assert rod.distance(flanks) < NEAR, turn
        if not groove:
            profile = inside(laid(cam, turn, "main"))
            assert shapely.intersection(rod, profile.buffer(-NEAR)).length == 0.0, turn
        places.append((laid(cam, turn, "main").bounds[0], rod.bounds[1]))
    assert (np.ptp(places, axis=0) > 10.0).all(), "both have gone somewhere"
    gone, high = shown.values
    assert isinstance(gone.course, tuple)
    assert isinstance(high.course, tuple)
    whole = 160.0 if "fall" in more else 100.0
    assert (gone.course[0], gone.course[180]) == (0.0, whole)
    np.testing.assert_allclose(gone.course[1:180], gone.course[:180:-1])
    s = np.array(gone.course) / 1000.0
    order = plate(rise=0.08, upper_dwell=0.02, fall=whole / 1000.0 - 0.1, return_law=Law("sine"))
    np.testing.assert_allclose(high.course, 1000.0 * law_at(order, s)[0], atol=0.02)


@pytest.mark.parametrize(
    "order",
    [plate(roller=0.006), plate(follower=EDGE), plate(fall=0.06, groove=True, roller=0.006),
     plate(phases=LIFTS, stroke=0.025, roller=0.005)],
    ids=["roller", "edge", "groove", "lifts"],
)  # fmt: skip
def test_every_step_is_inked_and_pictures_make_its_views(order: CamTask) -> None:
    of = made(order)
    on = Subject(of.log, of.reading, "X", HEIGHTS["A1"])
    names = [str(k) for k in range(of.cam.diagrams.turn.positions)]
    told = CentreNames(names, "S", "dS", "L_{min}", "L")
    letters = ProfileNames(names, "L", "r", "theoretical", "working")
    scheme = finished(draw_drum_scheme_ink(on, of.cam, SchemeNames("α", "L")))
    assert {"plate", "contour", "follower"} <= {one.part for one in scheme.strokes}
    assert not without_source(scheme)
    drawn = [finished(draw_drum_radius_ink(on, of.cam, told)),
             finished(draw_development_ink(on, of.cam, letters))]  # fmt: skip
    assert not without_ink(of.log, drawn, TRACELESS)
    for view in drawn:
        assert not without_source(view)
        assert_pictures_make_the_view(of.log, view)


@pytest.mark.parametrize("more", ["", 'fall = "70 mm"\n', 'follower = "knife edge"\n'])
def test_motion_at_any_place_of_the_cam_is_the_law(tmp_path: Path, more: str) -> None:
    scene = written(
        tmp_path,
        f'{HEAD}rise = "80 mm"\nupper_dwell = "20 mm"\nlaw = "3-4-5"\n{more}[hand]\nruler = "exact"\n',
    )
    order = plate(
        rise=0.08, upper_dwell=0.02, fall=0.07 if "fall" in more else 0.0, rise_law=Law("3-4-5")
    )
    s = np.linspace(0.0, order.whole, 37)
    found = tmm.motion(scene, s, plans="cam")
    S, slope, _ = law_at(order, s)
    rows = {name: found.columns[name] for name in ("S", "dS", "pressure")}
    np.testing.assert_allclose(rows["S"], S, atol=1e-9)
    np.testing.assert_allclose(rows["dS"], slope, atol=1e-9)
    np.testing.assert_allclose(rows["pressure"], np.degrees(np.arctan(slope)), atol=1e-7)
    point = found.profile["K" if "edge" in more else "B"]
    np.testing.assert_allclose(point, s + 1j * S, atol=1e-9)


TABLE = [0.0, 2.0, 8.0, 15.0, 22.0, 28.0, 30.0]


def test_a_table_of_lifts_stands_over_the_way_of_the_plate(tmp_path: Path) -> None:
    """Its lines are lengths, and the follower is where they say, whatever the plate's length."""
    lines = ", ".join(f'["{10 * k} mm", "{high} mm"]' for k, high in enumerate(TABLE))
    text = f'rise = "60 mm"\nparts = 6\nlaw = "table"\nlaw_table = [{lines}]\n'
    head = HEAD.replace("20 mm", "30 mm")
    (drawn,) = in_usual_size(read(written(tmp_path, head + text)), exact=True).boards
    cam = CAM_PLAN.on(drawn)
    heights = drawn.reading.figure(cam.diagrams.S.reading)[0, :7] * drawn.value(
        cam.diagrams.S.axes.mu
    )
    np.testing.assert_allclose(heights, np.array(TABLE) / 1000.0, atol=1e-9)


def test_a_plate_that_begins_on_a_slope_is_told_it_by_its_own_travel(tmp_path: Path) -> None:
    """20 mm over 80 mm is a slope of 1/4, and the contour goes on to the end of the plate."""
    lines = ", ".join(f'["{10 * k} mm", "{2.5 * k} mm"]' for k in range(9))
    text = f'{HEAD}rise = "80 mm"\nlaw = "table"\nlaw_table = [{lines}]\n'
    (drawn,) = in_usual_size(read(written(tmp_path, text)), exact=True).boards
    told = [one for one in warnings(drawn, "en") if "hard shock" in one]
    assert len(told) == 2
    assert all("dS/ds_c = 0.25 (SI)" in one and "φ" not in one for one in told)
    (view,) = (one for one in cam_views(drawn, True) if one.name == "cam sliding profile")
    (side,) = (one for one in view.strokes if one.part == "plate")
    xs, long = {x for x, *_ in side.path}, 80e-3 / drawn.scales["cam sliding profile"].value
    assert min(abs(x) for x in xs) == 0.0
    assert min(abs(x - long) for x in xs) < 1e-9
    assert max(xs) - min(xs) < 1.2 * long


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ('["0 deg", "0 mm"], ["30 deg", "10 mm"], ["60 deg", "20 mm"]', "of a cam that slides"),
        (", ".join(f'["{10 * k} mm", "{4 * k} mm"]' for k in range(6)), "50 mm long .* 60 mm"),
    ],
)
def test_a_table_of_another_length_is_refused(tmp_path: Path, line: str, says: str) -> None:
    text = f'{HEAD}rise = "60 mm"\nlaw = "table"\nlaw_table = [{line}]\n'
    with pytest.raises((SceneError, StructureError), match=says):
        in_usual_size(read(written(tmp_path, text)), exact=True)
