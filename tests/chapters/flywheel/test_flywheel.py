"""The flywheel of the engine: by published readings, by exact plans, by a fine integration; both methods."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from support.boards import drawn_of
from support.flywheels import along, graphs, slopes
from support.gallery import SHEETS

from graphic_tmm.board.charts import ScaleOrder
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN, Flywheel
from graphic_tmm.chapters.flywheel.rim import wanted_outer
from graphic_tmm.chapters.flywheel.task import FlywheelTask
from graphic_tmm.chapters.flywheel.views import flywheel_views
from graphic_tmm.chapters.indicator.task import Gas
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.paper.drawing import Bezier, Stroke
from graphic_tmm.paper.lettering.letters import plain
from graphic_tmm.paper.shapes import shape
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder

R, L, S2, W, DELTA = 0.3, 0.64, 0.22, 50.0, 0.23
BORE = 0.12
P = np.array([300, 300, 240, 159, 121.5, 87, 30, 34.5, 42, 64.5, 100.5, 144]) * 1e3
PUBLISHED = {
    "pb": [0, 44, 65, 60, 39, 17, 0, 17, 39, 60, 65, 44],
    "ps2": [40, 49, 60, 60, 51, 44, 40, 44, 51, 60, 60, 49],
    "ab": [60, 52, 31, 0, 31, 52, 60, 52, 31, 0, 31, 52],
}


def scene(**changes: object) -> Scene:
    made = read(SHEETS / "engine")
    assert made.tasks.get("flywheel") is not None
    order = replace(made.tasks["flywheel"], **changes)  # type: ignore[arg-type]
    return replace(
        made, sheets=(SheetOrder("A1", ("positions", "velocities", "flywheel")),)
    ).asking(flywheel=order)


@cache
def drawn(**changes: object) -> Drawn:
    return drawn_of(scene(**changes), exact=True)


def fly(made: Drawn) -> Flywheel:
    assert FLYWHEEL_PLAN.of(made) is not None
    return FLYWHEEL_PLAN.on(made)


def inertia(made: Drawn) -> float:
    return float(made.reading[fly(made).inertia][0, 0])


def second(made: Drawn) -> float:
    found = fly(made).energy_mass
    assert found is not None
    return float(made.reading[found.inertia][0, 0])


# an oracle of its own: closed form of the engine, periodic spline by a dense system, sums


def motion(phi: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Velocity of the piston (m/s, outward), of S2, angular velocity of the rod."""
    beta = np.arcsin(-R * np.sin(phi) / L)
    pin = 1j * W * R * np.exp(1j * phi)
    rod = -R * W * np.cos(phi) / (L * np.cos(beta))
    along = np.exp(1j * beta)
    return (pin + 1j * rod * L * along).real, np.abs(pin + 1j * rod * S2 * along), rod


def energy(v: np.ndarray, vs: np.ndarray, rod: np.ndarray) -> np.ndarray:
    return 2.4 * vs**2 / 2 + 0.020 * rod**2 / 2 + 1.9 * v**2 / 2 + 0.012 * W**2 / 2


def spline(y: np.ndarray, parts: int) -> np.ndarray:
    return along(y, slopes(y), parts)


def by_hand(mode: str) -> float:
    """J by the curves through the row, in the way that ``mode`` names."""
    return float(np.ptp(graphs(MOMENT, LINKS, mode).own) / (DELTA * W**2))


PHI = np.arange(12) * np.pi / 6
V, VS, ROD = motion(PHI)
MOMENT = -P * np.pi * BORE**2 / 4 * V / W
LINKS = energy(V, VS, ROD)


def test_the_moments_and_energies_are_those_of_the_mechanism() -> None:
    made = drawn()
    found, reading = fly(made), made.reading
    chart = next(c for c in found.charts if c.view == "moment")
    np.testing.assert_allclose(
        reading[chart.ordinates[0]][0] * made.scales["moment"].value, MOMENT, atol=1e-9
    )
    np.testing.assert_allclose(reading[found.energies.total][0], LINKS, rtol=1e-12)
    assert set(found.energies.parts) == {"T_{1r}", "T_{2t}", "T_{2r}", "T_{3t}"}


SAMPLED = 1e-6
"""400 samples an arc lie below its crest by 1/800² of an arc's bend at the most."""


@pytest.mark.parametrize(
    ("mode", "cd", "due"),
    [("areas", 60.77, 1.7707), ("middles", 61.56, 1.7938), ("chords", 59.20, 1.7249)],
)
def test_the_example_from_exact_plans(mode: str, cd: float, due: float) -> None:
    """Published is 1.77: what the areas below the curve give."""
    made = drawn(integration=mode)
    assert made.reading[fly(made).segment][0, 0] == pytest.approx(cd, abs=0.005)
    assert inertia(made) == pytest.approx(due, abs=0.0001)
    assert inertia(made) == pytest.approx(by_hand(mode), rel=SAMPLED)


@pytest.mark.parametrize(
    ("mode", "cd", "due"),
    [("areas", 61.18, 1.7827), ("middles", 61.88, 1.8033), ("chords", 59.81, 1.7427)],
)
def test_the_example_from_published_readings(mode: str, cd: float, due: float) -> None:
    """The readings of a hand drawing typed in stand for what the plans would have given."""
    made = drawn(integration=mode)
    project, log = made.project, made.project.construction
    from graphic_tmm.board.execute import execute
    from graphic_tmm.board.record import Construction

    typed = {}
    for step in log.steps:
        if step.it.view == "velocities" and step.it.letter in PUBLISHED:
            row = np.array(PUBLISHED[step.it.letter], dtype=float)[None, :]
            sign = -1.0 if step.it.letter == "pb" else 1.0
            row[0, :6] *= sign  # the piston moves towards the crank first
            typed[step.it] = row
    assert len(typed) == 3
    steps = tuple(step for step in log.steps if step.it not in typed)
    given = (*log.given, *typed)
    bare = Construction(given, steps, log.views, log.figures, log.size)
    values = {**made.given, **typed}
    reading = execute(bare, values, [fly(made).segment, fly(made).inertia])
    assert FLYWHEEL_PLAN.of(project) is not None
    assert reading[FLYWHEEL_PLAN.on(project).segment][0, 0] == pytest.approx(cd, abs=0.005)
    assert reading[FLYWHEEL_PLAN.on(project).inertia][0, 0] == pytest.approx(due, abs=0.001)


def wittenbauer(surplus: np.ndarray, links: np.ndarray) -> float:
    steep, flat = (W**2 / 2 * (1 + sign * DELTA) for sign in (1, -1))
    reduced = 2 * links / W**2
    ab = np.max(surplus - steep * reduced) - np.min(surplus - flat * reduced)
    return float(ab / (DELTA * W**2))


def test_the_energy_mass_curve_and_why_it_differs() -> None:
    made = drawn()
    found = graphs(MOMENT, LINKS)
    assert second(made) == pytest.approx(1.6245, abs=0.0001)
    assert second(made) == pytest.approx(wittenbauer(found.ahead, found.links), rel=SAMPLED)
    near = drawn(delta=0.001)
    assert second(near) == pytest.approx(inertia(near), rel=6e-4)  # 0.05 % as δ goes to 0
    assert abs(second(near) / inertia(near) - 1) < abs(second(made) / inertia(made) - 1) / 100


def test_tangents_to_the_smooth_curve_lie_outside_those_to_the_points() -> None:
    points, curve = drawn(tangents="points"), drawn()
    assert second(curve) > second(points)
    found = graphs(MOMENT, LINKS)
    assert second(points) == pytest.approx(wittenbauer(found.surplus, LINKS), rel=1e-9)
    assert fly(drawn(tangents=None)).energy_mass is None


def test_at_many_positions_it_agrees_with_a_fine_integration_of_the_same_curve() -> None:
    """Between the 12 positions M_red is its C² curve; pressures that give it at 360 positions."""
    fine = np.arange(360) * np.pi / 180
    v, vs, rod = motion(fine)
    moment = spline(MOMENT, 30)
    with np.errstate(all="ignore"):
        pressures = -moment / (np.pi * BORE**2 / 4 * v / W)
    pressures[~np.isfinite(pressures)] = 300e3  # the piston stands: any pressure will do
    near = (np.abs(v) < 1e-9) & (np.abs(moment) > 1e-6)
    assert not near.any()
    made = scene()
    assert made.tasks.get("flywheel") is not None
    gas = Gas(tuple(float(x) for x in pressures), BORE)
    order = replace(
        made.tasks["flywheel"], indicator=replace(made.tasks["flywheel"].indicator, cover=gas)
    )
    row = replace(made.row, count=360, accelerations=())
    many = drawn_of(replace(made, row=row).asking(flywheel=order), exact=True)
    found = inertia(many)
    assert second(many) == pytest.approx(1.628, abs=0.002)  # tangents to the smooth curve
    works = np.concatenate([[0.0], np.cumsum((moment + np.roll(moment, -1)) / 2) * np.pi / 180])
    own = (works - works[-1] * np.arange(361) / 360)[:360] - energy(v, vs, rod)
    due = np.ptp(own) / (DELTA * W**2)
    assert due == pytest.approx(1.773, abs=0.001)
    assert found == pytest.approx(due, rel=0.005)


def test_the_rim_is_that_of_the_document() -> None:
    made = drawn()
    rim = fly(made).rim
    assert rim is not None
    sizes = [
        float(made.reading[m][0, 0]) for m in (rim.limit, rim.inner, rim.mean, rim.mass, rim.width)
    ]
    limit, inner, mean, mass, width = sizes
    assert limit == pytest.approx(4.4)
    assert (inner, mean) == pytest.approx((0.38, 0.415))
    assert mass == pytest.approx(4 * inertia(made) / mean**2, rel=1e-12)
    ring = np.pi / 4 * (0.45**2 - inner**2) * 7800
    assert width == pytest.approx(mass / ring, rel=1e-12)
    assert (mass, width) == pytest.approx((41.1, 0.115), rel=0.006)


@pytest.mark.parametrize(("outer", "drum"), [(0.2, True), (0.42, False)])
def test_a_rim_that_is_a_drum_is_told_with_what_to_choose(outer: float, drum: bool) -> None:
    order = scene().tasks["flywheel"]
    assert order is not None
    assert order.rim is not None
    made = drawn(rim=replace(order.rim, outer=outer, inner=None))
    rim = fly(made).rim
    assert rim is not None
    width = float(made.reading[rim.width][0, 0])
    assert (width > outer / 2) == drum
    says = f"the rim of D_e = {outer} m is {width:.3g} m wide: choose D_e = 0.4 m or more"
    assert [text for text in warnings(made) if "wide" in text] == (
        [f"Flywheel: {says}"] if drum else []
    )


def test_no_sheet_advises_whoever_draws_it() -> None:
    """A drum's other diameter, a better number of positions are for the terminal; how far off it is stays."""
    order = read(SHEETS / "windrower").tasks["flywheel"]
    wide = replace(order, rim=replace(order.rim, outer=0.3, inner=None))
    scene = replace(read(SHEETS / "windrower"), language="en").asking(flywheel=wide)
    made = drawn_of(scene, exact=True)
    told = "\n".join(warnings(made))
    assert "choose D_e" in told
    assert "within 1 %" in told
    views = flywheel_views(made, True)
    lettered = "\n".join(plain(label.text) for view in views for label in view.labels)
    assert "Sketch of the flywheel" in lettered
    assert "With 12 positions" in lettered
    assert "choose D_e" not in lettered
    assert "within 1 %" not in lettered


@given(outer=st.floats(0.1, 2.0), width=st.floats(0.001, 50.0))
def test_the_diameter_advised_gives_a_rim_that_is_not_told_of_again(
    outer: float, width: float
) -> None:
    least = wanted_outer(outer, width)
    if least is None:
        assert width <= outer / 2
        return
    due = width * (outer / least) ** 4  # of the same J and D_i/D_e
    assert due <= least / 2 * (1 + 1e-9)
    assert width * (outer / (least - 0.05)) ** 4 > (least - 0.05) / 2 * (1 - 1e-6)


def test_a_constant_driving_moment_tells_the_resistance_of_the_gas_and_the_same_surplus() -> None:
    resisting, driving = drawn(), drawn(constant="driving")
    surplus = graphs(MOMENT, LINKS).surplus
    mu = resisting.scales["energy"].value
    chart = next(c for c in fly(driving).charts if c.view == "energy")
    found = driving.reading[chart.ordinates[0]][0] * mu
    np.testing.assert_allclose(found, surplus, atol=1e-9)
    moments = [next(c for c in fly(w).charts if c.view == "moment") for w in (resisting, driving)]
    one, other = (
        w.reading[c.ordinates[0]] for w, c in zip((resisting, driving), moments, strict=True)
    )
    np.testing.assert_allclose(other, -one, atol=1e-9)
    assert inertia(driving) == pytest.approx(inertia(resisting), rel=1e-9)


def test_another_pole_distance_changes_the_drawing_and_not_the_result() -> None:
    other = drawn(A=ScaleOrder(pole=25.0))
    assert other.scales["work"].value == pytest.approx(drawn().scales["work"].value * 25 / 40)
    assert inertia(other) == pytest.approx(inertia(drawn()), rel=1e-12)
    assert other.reading[fly(other).segment][0, 0] == pytest.approx(60.77 * 40 / 25, abs=0.01)


def bare(mechanism: Mechanism) -> Mechanism:
    links = [replace(link, mass=None, inertia=None) for link in mechanism.links]
    return replace(mechanism, links=tuple(links))


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"delta": 0.0}, "delta = 0: a number greater than 0 and less than 2"),
        ({"delta": -0.1}, "delta = -0.1: "),
        ({"A": ScaleOrder(pole=0.0)}, "H = 0 mm"),
        ({"A": ScaleOrder(pole=-5.0)}, "H = -5 mm"),
    ],
)
def test_what_cannot_be_built_is_refused(changes: dict[str, object], says: str) -> None:
    with pytest.raises(StructureError, match=says):
        drawn_of(scene(**changes))


def test_pressures_points_masses_and_rims_that_do_not_fit_are_refused() -> None:
    made = scene()
    order = made.tasks["flywheel"]
    assert order is not None
    assert order.rim is not None

    def with_order(**changes: object) -> Scene:
        return made.asking(flywheel=replace(order, **changes))  # type: ignore[arg-type]

    few = replace(order.indicator, cover=Gas((1e5,) * 5, BORE))
    with pytest.raises(StructureError, match="5 pressures for 12 positions"):
        drawn_of(with_order(indicator=few))
    with pytest.raises(StructureError, match=r"point A does not slide.*are B"):
        drawn_of(with_order(indicator=replace(order.indicator, point="A")))
    with pytest.raises(StructureError, match=r"runs faster than 110 m/s.*4.4 m at most"):
        drawn_of(with_order(rim=replace(order.rim, outer=5.0)))
    with pytest.raises(StructureError, match="leaves no rim"):
        drawn_of(with_order(rim=replace(order.rim, ratio=1.0)))
    assert made.mechanism is not None
    with pytest.raises(StructureError, match="no link has a mass or J"):
        drawn_of(replace(made, mechanism=bare(made.mechanism)))


def test_a_flywheel_that_is_not_needed_is_a_finding_and_no_number() -> None:
    """A machine whose links are heavy and whose gas is weak, by the energy–mass curve at a large δ."""
    made = scene(delta=1.5)
    order = made.tasks["flywheel"]
    assert order is not None
    weak = replace(order.indicator, cover=Gas(tuple(p / 1000 for p in P), BORE))
    found = drawn_of(made.asking(flywheel=replace(order, indicator=weak)), exact=True)
    assert np.isnan(second(found))
    told = [f for f in found.findings() if f.kind == "undrawn"]
    assert [f.step.it.letter for f in told] == ["J_F′"]
    assert "no flywheel is needed" in told[0].step.op.fails


def test_an_order_without_a_part_records_no_step_of_it() -> None:
    full = {step.it.view for step in drawn().project.construction.steps}
    assert {"indicator", "moment", "work", "energy", "energy-mass"} <= full
    lean = drawn(tangents=None, rim=None)
    views = {step.it.view for step in lean.project.construction.steps}
    assert "energy-mass" not in views
    assert not any(step.it.letter == "D_{max}" for step in lean.project.construction.steps)
    without = drawn_of(scene().asking(flywheel=None))
    assert FLYWHEEL_PLAN.of(without) is None
    assert not {"indicator", "moment"} & {s.it.view for s in without.project.construction.steps}


def test_orders_are_frozen() -> None:
    order = scene().tasks["flywheel"]
    assert isinstance(order, FlywheelTask)
    with pytest.raises(AttributeError):
        order.delta = 0.1  # type: ignore[misc]


def test_the_curve_stands_level_with_the_surplus_and_under_the_turned_inertia() -> None:
    """On wish: every point of it is carried over from both, so origins, lines and sizes agree."""
    whole = drawn()
    made = drawn(energy_mass="projected")
    apart = [view.name for view in flywheel_views(whole, True)]
    views = flywheel_views(made, True)
    assert len(views) == len(apart) - 1
    (view,) = [one for one in views if {"energy", "energy-mass"} <= set(one.shows)]
    left, right = view.origin("energy"), view.origin("energy-mass")
    assert left.imag == right.imag
    assert fly(made).energy_mass is not None
    spots = np.ravel(made.reading[fly(made).energy_mass.points][0])[:12]
    (chart,) = [one for one in fly(made).charts if one.view == "energy"]
    ordinates = np.ravel(made.reading[chart.ordinates[0]][0])[:12]
    np.testing.assert_allclose(spots.imag, ordinates, atol=1e-9)
    strokes = [one for one in view.strokes if isinstance(one, Stroke) and one.pen == "thin"]
    for k, spot in enumerate(right + complex(z) for z in spots):
        ends = [shapely.Point(spot.real, spot.imag)]
        near = [s for s in strokes if shape(s).distance(ends[0]) < 3.0 and s.part == "axis"]
        boxes = [shape(s).bounds for s in near]
        assert any(b[3] - b[1] < 1e-6 and abs(b[1] - spot.imag) < 1e-6 for b in boxes), k
    inertia = [one for one in view.strokes if isinstance(one, Bezier) and one.part == "axis"]
    (curve,) = inertia
    through = [z for k, z in enumerate(curve.controls) if k % 3 == 0]
    np.testing.assert_allclose([z.real for z in through[:12]], (right + spots).real, atol=1e-9)
    steps = -np.diff([z.imag for z in through])
    np.testing.assert_allclose(steps, made.value(fly(made).base.length) / 12, atol=1e-9)
