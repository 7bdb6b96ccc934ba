"""Klein's and Ritterhaus's constructions against a vector loop of their own, the plans, a published figure."""

from __future__ import annotations

import cmath
import math
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.boards import in_usual_size

from graphic_tmm.accuracy.geometrography import elements
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.klein.accuracy import prices
from graphic_tmm.chapters.klein.record import KLEIN_PLAN, Figure
from graphic_tmm.chapters.klein.table import columns, figure_columns, results
from graphic_tmm.chapters.klein.task import KLEIN, RITTERHAUS, VIEWS
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read

STEP = 1e-30
"""Of derivatives by a complex step."""
SCENE = """title = "T"
language = "en"
[frame]
number = 4
O = [0, 0]
x = {{ through = [{tx!r}, {ty!r}], angle = {tilt!r} }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [{r!r}, 0]{pins} }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [{rod!r}, 0], C = [{cx!r}, {cy!r}] }}
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "+" }}
{more}
[drive]
link = 1
speed = "{omega!r} rad/s"
turns = "{turns}"
positions = {places}
{drive}
accelerations = "all"
[klein]
{klein}
[[sheet]]
format = "A1"
place = ["positions", "velocities", "accelerations", "klein", "klein table"]
"""


def drawn_of(
    folder: Path, *, r: float, rod: float, e: float = 0.0, tilt: float = 0.0, omega: float = 20.0,
    c: complex | None = 0.15 + 0j, sense: int = 1, at: list[float] | None = None, klein: str = "",
    drive: str = "", more: str = "", pins: str = "",
) -> Drawn:  # fmt: skip
    """Draw a slider-crank; ``e``: how far its guide passes O on its left, ``at``: angles of the crank, °."""
    through = 1j * e * cmath.rect(1.0, math.radians(tilt))
    places = str([f"{one!r} deg" for one in at]).replace("'", '"') if at else 12
    zero = "" if at else 'zero = "17 deg"'
    path, points = folder / "scene.toml", 'points = ["C"]' if c is not None else ""
    c = c or 0.15 + 0j
    path.write_text(
        SCENE.format(
            r=r, rod=rod, tx=through.real, ty=through.imag, tilt=f"{tilt!r} deg", cx=c.real, cy=c.imag,
            omega=omega, turns="counterclockwise" if sense > 0 else "clockwise", places=places,
            drive=f"{zero}\n{drive}", klein=f"{points}\n{klein}", more=more, pins=pins,
        ).replace("angle = '", 'angle = "').replace("deg'", 'deg"'),
        encoding="utf-8",
    )  # fmt: skip
    (found,) = in_usual_size(read(path), exact=True).boards
    return found


def loop(phi: Any, r: float, rod: float, e: float, c: complex) -> tuple[Any, ...]:
    """Return B and C of the loop OA + AB = OB in the guide's axes: x, y each, of real or complex angles."""
    ax, ay = r * np.cos(phi), r * np.sin(phi)
    sine = (e - ay) / rod
    cosine = np.sqrt(1.0 - sine * sine)
    return (
        ax + rod * cosine, 0.0 * phi + e,
        ax + c.real * cosine - c.imag * sine, ay + c.real * sine + c.imag * cosine,
    )  # fmt: skip


def speeds(phi: Any, *sizes: Any) -> list[Any]:
    """Return d/dφ of the loop by hand, so that a complex step gives the second derivative."""
    r, rod, e, c = sizes
    sine = (e - r * np.sin(phi)) / rod
    cosine = np.sqrt(1.0 - sine * sine)
    turn = -r * np.cos(phi) / (rod * cosine)
    return [
        -r * np.sin(phi) - rod * sine * turn, 0.0 * phi,
        -r * np.sin(phi) - (c.real * sine + c.imag * cosine) * turn,
        r * np.cos(phi) + (c.real * cosine - c.imag * sine) * turn,
    ]  # fmt: skip


def due(phi: float, omega: float, *sizes: Any) -> dict[str, float]:
    """Return the lengths of v_B, v_C, a_B, a_C (SI) by the vector loop."""
    first = [np.imag(x) / STEP for x in loop(phi + 1j * STEP, *sizes)]
    assert np.allclose(first, speeds(phi, *sizes), rtol=1e-12, atol=1e-12 * sizes[0])
    second = [np.imag(x) / STEP for x in speeds(phi + 1j * STEP, *sizes)]
    v = [omega * math.hypot(*first[k : k + 2]) for k in (0, 2)]
    a = [omega**2 * math.hypot(*second[k : k + 2]) for k in (0, 2)]
    return {"v_B": v[0], "v_{C}": v[1], "a_B": a[0], "a_{C}": a[1]}


def values(drawn: Drawn, view: str) -> dict[str, np.ndarray]:
    """The quantities of a construction by positions, SI."""
    made = KLEIN_PLAN.on(drawn)
    reading = drawn.of(view)
    assert reading is not None
    return {
        one.vector: np.abs(np.broadcast_to(reading[one.value][0], (len(drawn.row(view)),)))
        for one in made.figures[view].quantities
    }


def lengths(drawn: Drawn, view: str, k: int = 0) -> dict[str, float]:
    """The sides of a construction as they really are, mm, by the letters at their ends."""
    made, reading = KLEIN_PLAN.on(drawn).figures[view], drawn.of(view)
    assert reading is not None
    mu = drawn.scales[view].value
    found = {one.segment.name: reading[one.segment] for one in made.quantities}
    return {name: 1000.0 * mu * float(np.ravel(row)[k]) for name, row in found.items()}


@pytest.mark.parametrize("view", VIEWS)
def test_the_acceptance_figure_of_the_field(tmp_path: Path, view: str) -> None:
    """OA 100, AB 400 mm at 45° and 20 1/s, computed apart from the package (field.md, 8)."""
    drawn = drawn_of(tmp_path, r=0.1, rod=0.4, at=[45.0, 60.0])
    sides, found = lengths(drawn, view), values(drawn, view)
    assert sides["OM"] == pytest.approx(83.4107, abs=5e-5)
    assert sides["ON"] == pytest.approx(71.1204, abs=5e-5)
    assert found["v_B"][0] == pytest.approx(1.668214, abs=5e-7)
    assert found["a_B"][0] == pytest.approx(28.4481, abs=5e-5)


@pytest.mark.parametrize("view", VIEWS)
def test_a_published_figure(tmp_path: Path, view: str) -> None:
    """Khurmi R. S., Gupta J. K., Theory of Machines, example of Klein's construction (readings from memory).

    Crank 200 mm, rod 700 mm, 120 rad/s, 30° from the inner dead centre (askfilo.com has the task so, too);
    read off paper: OM 127, CM 173, QN 93, NO 200 mm; of the middle of the rod 140 and 193 mm. They are within
    2 % of what is exact.
    """
    drawn = drawn_of(tmp_path, r=0.2, rod=0.7, omega=120.0, c=0.35 + 0j, at=[30.0, 40.0])
    told = {"OM": 127.0, "AM": 173.0, "QN": 93.0, "ON": 200.0, "Oc′": 140.0, "Oc″": 193.0}
    sides = lengths(drawn, view)
    assert {name: sides[name] for name in told} == pytest.approx(told, rel=0.02)


def sizes_at_random(rng: np.random.Generator) -> dict[str, Any]:
    r = float(rng.uniform(0.02, 0.4))
    rod = r * float(rng.uniform(1.6, 6.0))
    e = float(rng.uniform(-0.8, 0.8)) * (rod - r) * float(rng.integers(0, 2))
    c = complex(rng.uniform(-0.3, 1.2) * rod, rng.uniform(-0.4, 0.4) * rod * rng.integers(0, 2))
    return {
        "r": r, "rod": rod, "e": e, "c": c, "tilt": float(rng.uniform(-180.0, 180.0)),
        "omega": float(rng.uniform(1.0, 200.0)), "sense": int(rng.choice([-1, 1])),
    }  # fmt: skip


@pytest.mark.parametrize("seed", range(24))
def test_both_are_the_loop_and_the_plans(tmp_path: Path, seed: int) -> None:
    """Random slider-cranks, in line and offset, turned guides, both senses: every position to 1e-9."""
    told = sizes_at_random(np.random.default_rng(seed))
    drawn = drawn_of(tmp_path, **told)
    plans = KINEMATICS_PLAN.on(drawn)
    own = {view: values(drawn, view) for view in VIEWS}
    largest: dict[str, float] = {}
    for k, phi in enumerate(drawn.project.coordinates):
        assert phi is not None
        angle = math.radians(phi - told["tilt"])
        exact = due(angle, told["omega"], told["r"], told["rod"], told["e"], told["c"])
        for letter, value in exact.items():
            size = max(value, told["r"] * told["omega"] ** (1 if letter[0] == "v" else 2))
            for view in VIEWS:
                assert own[view][letter][k] == pytest.approx(value, abs=1e-9 * size), (view, letter)
                largest[letter] = size
    for sign, motion in (("v", plans.velocities), ("a", plans.accelerations)):
        assert motion is not None
        scale, reading = drawn.scales[motion.mu.view].value, drawn.of(motion.mu.view)
        assert reading is not None
        for point, letter in (("B", f"{sign}_B"), ("C", f"{sign}_{{C}}")):
            by_plan = np.abs(reading[motion.images.by_letter[2][point]][0]) * scale
            for view in VIEWS:
                assert np.allclose(own[view][letter], by_plan, rtol=0, atol=1e-9 * largest[letter])
    for column in columns(drawn):
        if column.unit == "%":
            assert np.all(np.nan_to_num(column.value) == 0.0), column.letter


@pytest.mark.parametrize("e", [0.0, 0.03])
def test_components_are_those_of_the_plan(tmp_path: Path, e: float) -> None:
    """AQ and QN are the normal and the tangential acceleration of B about A, AM the relative velocity."""
    drawn = drawn_of(tmp_path, r=0.1, rod=0.35, e=e)
    plans = KINEMATICS_PLAN.on(drawn)
    assert plans.velocities is not None
    assert plans.accelerations is not None
    omega, epsilon = (
        np.abs(drawn.of(view)[rates[2]][0])  # type: ignore[index]
        for view, rates in (
            ("velocities", plans.velocities.rates), ("accelerations", plans.accelerations.rates),
        )
    )  # fmt: skip
    for view in VIEWS:
        own = values(drawn, view)
        assert np.allclose(own["v_{BA}"], omega * 0.35, rtol=0, atol=2e-9)
        assert np.allclose(own["a_{BA}^{n}"], omega**2 * 0.35, rtol=0, atol=4e-8)
        assert np.allclose(own["a_{BA}^{t}"], epsilon * 0.35, rtol=0, atol=4e-8)


def test_the_quadrilateral_is_the_plan_of_accelerations_turned_by_half_a_turn(
    tmp_path: Path,
) -> None:
    """O, A, N stand to each other as π, a, b, in mm of l_OA : πa, turned by 180°; OAM as p, a, b by 90°."""
    drawn = drawn_of(tmp_path, r=0.12, rod=0.3, e=0.04, tilt=35.0)
    plans = KINEMATICS_PLAN.on(drawn)
    for view in VIEWS:
        made = KLEIN_PLAN.on(drawn).figures[view]
        reading = drawn.of(view)
        assert reading is not None
        for motion, image, turn in (
            (plans.velocities, made.M, -1j), (plans.accelerations, made.N, -1.0),
        ):  # fmt: skip
            assert motion is not None
            plan = drawn.of(motion.mu.view)
            assert plan is not None
            a, b = (plan[motion.images.by_letter[n][k]] for n, k in ((1, "A"), (2, "B")))
            own = reading[image] / reading[made.pin]
            assert np.allclose(own, b / a, rtol=0, atol=1e-9), (view, turn)
            way = reading[made.pin] / a
            assert np.allclose(way / np.abs(way), turn, rtol=0, atol=1e-9)


def test_dead_centres_are_right_or_not_there(tmp_path: Path) -> None:
    """Crank and rod in one line: Klein's circles give r(1 ± λ); Ritterhaus's lines coincide, and it is said."""
    drawn = drawn_of(tmp_path, r=0.1, rod=0.4, at=[0.0, 90.0, 180.0, 200.0], omega=10.0)
    klein, other = values(drawn, KLEIN), values(drawn, RITTERHAUS)
    assert klein["a_B"] == pytest.approx([12.5, 10 / math.sqrt(15), 7.5, klein["a_B"][3]], rel=1e-9)
    assert klein["v_B"][[0, 2]] == pytest.approx(0.0, abs=1e-12)
    assert klein["a_{BA}^{t}"][[0, 2]] == pytest.approx(0.0, abs=1e-9)
    assert np.isnan(other["a_B"][[0, 2]]).all()
    assert other["a_B"][1] == pytest.approx(10 / math.sqrt(15), rel=1e-9)
    assert other["v_B"] == pytest.approx(klein["v_B"], abs=1e-12)
    told = [one for one in warnings(drawn, "en") if "take Klein's construction there" in one]
    assert ["in positions 0, 2 " in one for one in told] == [True]
    found = [one for one in drawn.findings() if one.step.it.view == RITTERHAUS]
    assert {k for one in found for k in one.positions} == {0, 2}
    kinds = {one.kind for one in drawn.findings() if one.step.it.view == KLEIN}
    assert kinds <= {"touching"}  # where M falls on A the smaller circle is a point of the other


@pytest.mark.parametrize("off", [1e-3, 1e-6, 1e-9])
def test_next_to_a_dead_centre_nothing_plausible_is_wrong(tmp_path: Path, off: float) -> None:
    """A thousandth of a degree and less from the line: each figure is right to 1e-6, or is not there."""
    drawn = drawn_of(tmp_path, r=0.1, rod=0.4, at=[off, 90.0 + off, 180.0 + off], omega=10.0)
    for view in VIEWS:
        own = values(drawn, view)
        for k, phi in enumerate((off, 90.0 + off, 180.0 + off)):
            exact = due(math.radians(phi), 10.0, 0.1, 0.4, 0.0, 0.15 + 0j)
            for letter in ("v_B", "a_B"):
                value = own[letter][k]
                assert np.isnan(value) or value == pytest.approx(exact[letter], abs=1e-6 * 10.0)
            assert view == RITTERHAUS or np.isfinite(own["a_B"][k])


def test_where_the_crank_is_square_to_the_guide_m_falls_on_a(tmp_path: Path) -> None:
    for e in (0.0, 0.05):
        drawn = drawn_of(tmp_path, r=0.1, rod=0.4, e=e, at=[89.0, 90.0, 270.0], omega=10.0)
        for view in VIEWS:
            own = values(drawn, view)
            assert own["v_B"][1:] == pytest.approx([1.0, 1.0], rel=1e-12)
            assert own["v_{BA}"][1:] == pytest.approx([0.0, 0.0], abs=1e-12)
            for k, side in ((1, 1.0), (2, -1.0)):
                sine = (0.1 * side - e) / 0.4
                size = 10.0 * abs(sine) / math.sqrt(1.0 - sine**2)
                assert own["a_B"][k] == pytest.approx(size, rel=1e-9)


def test_a_long_am_has_no_common_chord_and_ritterhaus_still_has_q(tmp_path: Path) -> None:
    """A rod shorter than the crank swings only: AM may be longer than AB."""
    drawn = drawn_of(tmp_path, r=0.4, rod=0.2, at=[5.0, 10.0, 20.0], omega=3.0)
    klein, other = values(drawn, KLEIN), values(drawn, RITTERHAUS)
    assert np.isnan(klein["a_B"]).all()
    for k, phi in enumerate((5.0, 10.0, 20.0)):
        exact = due(math.radians(phi), 3.0, 0.4, 0.2, 0.0, 0.15 + 0j)
        assert other["a_B"][k] == pytest.approx(exact["a_B"], rel=1e-9)
        assert other["v_B"][k] == pytest.approx(exact["v_B"], rel=1e-9)
    found = [one for one in drawn.findings() if one.step.it.view == KLEIN]
    assert {k for one in found for k in one.positions} == {0, 1, 2}


SECOND = """[[link]]
number = 5
points = { D = [0, 0], E = [0.5, 0] }
[[link]]
number = 6
points = { E = [0, 0] }
slides = { on = "frame", along = "x", side = "-" }
"""


def test_of_several_slider_cranks_the_named_one_is_drawn(tmp_path: Path) -> None:
    """A second rod on a pin off the crank's axis: its figure stands on its own crank and rod."""
    told: dict[str, Any] = {
        "r": 0.1,
        "rod": 0.4,
        "more": SECOND,
        "pins": ", D = [-0.12, 0.02]",
        "omega": 10.0,
    }
    drawn = drawn_of(tmp_path, **told)
    assert KLEIN_PLAN.on(drawn).of.slider == "B"
    drawn = drawn_of(tmp_path, **told, klein='slider = "E"', c=None)
    made = KLEIN_PLAN.on(drawn)
    assert (made.of.slider, made.of.pin) == ("E", "D")
    pin = complex(-0.12, 0.02)
    for k, phi in enumerate(drawn.project.coordinates):
        assert phi is not None
        # its guide is the same, and it slides on the other side
        angle = math.radians(phi) + cmath.phase(pin) - math.pi
        exact = due(angle, 10.0, abs(pin), 0.5, 0.0, 0j)
        for view in VIEWS:
            own = values(drawn, view)
            assert own["v_E"][k] == pytest.approx(exact["v_B"], abs=1e-9)
            assert own["a_E"][k] == pytest.approx(exact["a_B"], abs=1e-8)


def _work(drawn: Drawn, view: str) -> Counter[str]:
    """The elements of geometrography of a construction, from M on to N."""
    made: Figure = KLEIN_PLAN.on(drawn).figures[view]
    steps = [one for one in drawn.construction.steps if one.it.view == view]
    names = [one.it for one in steps]
    of = steps[names.index(made.M) + 1 : names.index(made.N) + 1]
    found: Counter[str] = Counter()
    for step in of:
        if not step.op.reads and not step.op.formula:
            found += elements(step.op.symbol or "")
    return found


def test_the_hand_has_less_to_do_with_ritterhaus(tmp_path: Path) -> None:
    """From M to N: two circles, a midpoint and a square, or three lines by the set square."""
    drawn = drawn_of(tmp_path, r=0.1, rod=0.4)
    klein, other = (_work(drawn, view) for view in VIEWS)
    assert sum(other.values()) < sum(klein.values())
    assert not {one for one in other if one.startswith("C")}
    assert klein["C3"] >= 2


def test_positions_without_a_construction_have_no_figures(tmp_path: Path) -> None:
    drawn = drawn_of(tmp_path, r=0.1, rod=0.4, klein="positions = [2, 5]")
    for figure in KLEIN_PLAN.on(drawn).figures.values():
        for column in figure_columns(drawn, figure):
            there = np.flatnonzero(np.isfinite(column.value[0]))
            assert there.tolist() == [2, 5], column.letter


def test_klein_is_truer_and_ritterhaus_cheaper_than_the_other(tmp_path: Path) -> None:
    """All that leads to a_B, by the student's hand at one size; the plans are drawn larger and are truest."""
    drawn = drawn_of(tmp_path, r=0.1, rod=0.4)
    price = prices(drawn)
    assert price[RITTERHAUS].operations < price[KLEIN].operations
    assert price[KLEIN].scatter < 0.95 * price[RITTERHAUS].scatter
    assert price["accelerations"].scatter < price[KLEIN].scatter
    told = {name: value[0] for name, (value, _) in results(drawn).items()}
    assert told["klein_work_klein"] == price[KLEIN].operations
    assert told["klein_scatter_ritterhaus"] == pytest.approx(price[RITTERHAUS].scatter, abs=0.06)
