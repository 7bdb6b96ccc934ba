"""Hodographs against vector loops: ends, tangents, analogues; what is refused; a mistake of a plan is told."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.boards import in_usual_size

from graphic_tmm.board.values import Curve
from graphic_tmm.chapters.hodograph.findings import WARNINGS
from graphic_tmm.chapters.hodograph.ink import draw_hodograph
from graphic_tmm.chapters.hodograph.operations import off_tangent
from graphic_tmm.chapters.hodograph.record import HODOGRAPH_PLAN
from graphic_tmm.chapters.hodograph.table import angles, limits
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.readers.columns import Tabled
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.read import read

STEP = 1e-30
"""Of derivatives by a complex step."""
SCENE = """title = "T"
language = "en"
[frame]
number = 4
O = [0, 0]
D = [{d!r}, 0]
[[link]]
number = 1
points = {{ O = [0, 0], A = [{a!r}, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [{b!r}, 0], K = [{kx!r}, {ky!r}] }}
[[link]]
number = 3
points = {{ D = [0, 0], B = [{c!r}, 0] }}
side = "left of AD"
[drive]
link = 1
speed = "{omega!r} rad/s"
turns = "{turns}"
{row}
[plans]
{plans}
[hodograph]
{asks}
[[sheet]]
format = "A1"
place = ["positions", "velocities", "accelerations", "hodograph", "hodograph table"]
"""
ROW = 'positions = {count}\nzero = "{zero!r} deg"\naccelerations = "all"'
SIZES = {"a": 0.1, "b": 0.28, "c": 0.2, "d": 0.3, "k": 0.15 + 0.06j}


def drawn_of(
    folder: Path, *, omega: float = 10.0, sense: int = 1, count: int = 12, zero: float = 20.0,
    asks: str = 'points = ["K"]', row: str = "", plans: str = "", **sizes: Any,
) -> Drawn:  # fmt: skip
    """Draw a four-bar with a coupler point K."""
    told = {**SIZES, **sizes}
    k = told.pop("k")
    path = folder / "scene.toml"
    path.write_text(
        SCENE.format(
            **told, kx=k.real, ky=k.imag, omega=omega, asks=asks, plans=plans,
            turns="counterclockwise" if sense > 0 else "clockwise",
            row=row or ROW.format(count=count, zero=zero),
        ),
        encoding="utf-8",
    )  # fmt: skip
    (found,) = in_usual_size(read(path), exact=True).boards
    return found


def place_of_k(phi: Any, a: float, b: float, c: float, d: float, k: complex) -> tuple[Any, Any]:
    """Return x and y of K of the loop OA + AB = OD + DB, of real or complex angles, reals only."""
    ax, ay = a * np.cos(phi), a * np.sin(phi)
    x, y = d - ax, -ay
    far = x * x + y * y
    along = (b * b - c * c + far) / (2.0 * far)
    up = np.sqrt(b * b / far - along * along)
    # B stands to the left of AD
    bx, by = along * x - up * y, along * y + up * x
    return ax + (k.real * bx - k.imag * by) / b, ay + (k.real * by + k.imag * bx) / b


def first(phi: float, **sizes: Any) -> complex:
    """Return dK/dφ by a complex step."""
    x, y = place_of_k(phi + 1j * STEP, **sizes)
    return complex(x.imag, y.imag) / STEP


def second(phi: float, **sizes: Any) -> complex:
    """Return d²K/dφ² by differences of the complex step, of sixth order: good to 1e-9 of the size."""
    h, shares = 5e-3, ((1, 3 / 4), (2, -3 / 20), (3, 1 / 60))
    return sum(
        w * (first(phi + n * h, **sizes) - first(phi - n * h, **sizes)) / h for n, w in shares
    )


def of(drawn: Drawn) -> Any:
    made = HODOGRAPH_PLAN.of(drawn)
    assert made is not None
    return made


def turned_angles(drawn: Drawn) -> list[float]:
    return [math.radians(phi) for phi in drawn.project.coordinates if phi is not None]


@pytest.mark.parametrize(("sense", "omega"), [(1, 10.0), (-1, 37.5)])
def test_ends_are_the_velocities_of_the_loop(tmp_path: Path, sense: int, omega: float) -> None:
    drawn = drawn_of(tmp_path, sense=sense, omega=omega)
    (one,) = of(drawn).curves
    scale = drawn.scales["velocities"].value
    ends = drawn.reading[one.end][0] * scale
    for end, phi in zip(ends, turned_angles(drawn), strict=True):
        assert end == pytest.approx(sense * omega * first(phi, **SIZES), abs=1e-9 * omega)


def test_the_hodograph_of_accelerations_has_theirs(tmp_path: Path) -> None:
    drawn = drawn_of(tmp_path, asks='points = ["K", "B"]\naccelerations = true')
    made = of(drawn)
    assert [(one.point, one.plan) for one in made.curves] == [
        ("K", "velocities"), ("B", "velocities"), ("K", "accelerations"), ("B", "accelerations"),
    ]  # fmt: skip
    one = made.curves[2]
    ends = drawn.reading[one.end][0] * drawn.scales["accelerations"].value
    for end, phi in zip(ends, turned_angles(drawn), strict=True):
        assert end == pytest.approx(100.0 * second(phi, **SIZES), abs=1e-6 * 100.0)


@pytest.mark.parametrize("sense", [1, -1])
def test_analogues_are_derivatives_by_the_turn(tmp_path: Path, sense: int) -> None:
    """As plans to ω_1 = 1: they are the same whatever ω is, and those of the loop."""
    for omega in (1.0, 47.0):
        drawn = drawn_of(
            tmp_path, sense=sense, omega=omega, asks='points = ["K"]\nanalogues = true'
        )
        chapter = next(one for one in chapters() if one.name == "hodograph")
        told = {one.letter: one.value[0] for one in Tabled.of(chapter).columns(drawn)}
        for k, phi in enumerate(turned_angles(drawn)):
            assert told["s′_{K}"][k] == pytest.approx(abs(first(phi, **SIZES)), abs=1e-10)
            assert told["s″_{K}"][k] == pytest.approx(abs(second(phi, **SIZES)), abs=1e-8)


def crank_rocker(seed: int) -> dict[str, Any]:
    """Sizes of a crank-rocker (Grashof) whose transmission angle stays above 35°."""
    rng = np.random.default_rng(seed)
    while True:
        a, b, c, d = 0.1, *(0.1 * rng.uniform(1.5, 4.0, 3))
        short = a + max(b, c, d) <= 0.95 * (b + c + d - max(b, c, d))
        least = min(
            math.acos(max(-1.0, min(1.0, (b * b + c * c - x * x) / (2 * b * c))))
            for x in (d - a, d + a)
        )
        most = math.acos(max(-1.0, min(1.0, (b * b + c * c - (d + a) ** 2) / (2 * b * c))))
        if short and least > math.radians(35.0) and most < math.radians(145.0):
            break
    return {"a": a, "b": float(b), "c": float(c), "d": float(d), "k": complex(0.6 * b, 0.3 * b)}


@pytest.mark.parametrize("count", [12, 13, 24, 36])
@pytest.mark.parametrize("seed", range(12))
def test_tangents_are_within_what_the_positions_explain(
    tmp_path: Path, seed: int, count: int
) -> None:
    """Random crank-rockers (Grashof, transmission angle above 35°): no angle is beyond its limit."""
    sizes = crank_rocker(seed)
    drawn = drawn_of(tmp_path, count=count, **sizes)
    (one,) = of(drawn).curves
    found, limit = np.abs(angles(drawn, one)[0]), limits(drawn, one)[0]
    assert np.isfinite(found).all()
    assert (found <= limit).all(), (found, limit)
    assert not list(WARNINGS.warnings(drawn, "en"))


def test_a_row_that_is_too_coarse_is_told(tmp_path: Path) -> None:
    """Eight positions of a crank-rocker: the warning is true, and its remedy (36, above) helps."""
    told = list(WARNINGS.warnings(drawn_of(tmp_path, count=8, **crank_rocker(0)), "en"))
    assert len(told) == 1
    assert "more than 8 positions explain" in told[0]


def test_the_limit_falls_with_the_fourth_power_of_the_positions(tmp_path: Path) -> None:
    """What the number of positions explains, a degree of the protractor aside."""
    most = []
    for count in (24, 48):
        drawn = drawn_of(tmp_path, count=count)
        (one,) = of(drawn).curves
        most.append(float((limits(drawn, one)[0] - 1.0).max()))
    assert 10.0 < most[0] / most[1] < 22.0


def test_a_spline_of_one_harmonic_errs_as_told() -> None:
    """Through n points of e^{imφ} the slope is off by θ⁴/180 of itself, θ = 2πm/n, to the next order."""
    from graphic_tmm.board.operations.curve import periodic

    for n, m in ((24, 1), (36, 2), (48, 3)):
        theta = math.tau * m / n
        points = np.exp(1j * theta * np.arange(n))
        share = periodic(points) / (1j * theta * points)
        assert share - 1.0 == pytest.approx(-(theta**4) / 180.0, rel=0.1)


def test_a_vector_that_is_off_is_told(tmp_path: Path) -> None:
    """One acceleration turned by 15°, as by a mistake in its plan: its angle is beyond the limit."""
    drawn = drawn_of(tmp_path, count=24)
    (one,) = of(drawn).curves
    step = drawn.construction.step(one.angle)
    assert step is not None
    reading = drawn.numbers.drawn
    curve, end, start, tip = (reading[mark] for mark in step.uses)
    wrong = np.array(tip)
    wrong[0, 5] = start[0, 0] + (wrong[0, 5] - start[0, 0]) * np.exp(1j * math.radians(15.0))
    assert step.uses[3].view == "accelerations"
    found = off_tangent.run(curve, end, start, wrong, row=24)[0]
    over = np.abs(found) > limits(drawn, one)[0]
    assert np.flatnonzero(over).tolist() == [5]
    assert found[5] == pytest.approx(15.0, abs=1.0)


def test_no_direction_has_no_angle() -> None:
    """A vector of no length, an end beyond the row: nothing is read, and numpy does not warn."""
    knots = np.array([[1.0, 1j, -1.0, -1j]])
    curve = Curve(knots, 1j * knots, True)
    tip = np.array([[1j, 0.0, np.nan, 1.0 + 0j, 2.0]])
    with np.errstate(all="raise"):
        found = off_tangent.run(curve, np.zeros((1, 5)) + 0j, np.zeros((1, 1)) + 0j, tip, row=4)
    assert found[0, [0, 3]] == pytest.approx([0.0, 0.0])
    assert np.isnan(found[0, [1, 2, 4]]).all()


def test_a_row_that_does_not_come_back_is_open_and_its_ends_say_nothing(tmp_path: Path) -> None:
    row = 'positions = 9\nfrom = "20 deg"\nto = "120 deg"\naccelerations = "all"'
    drawn = drawn_of(tmp_path, row=row)
    (one,) = of(drawn).curves
    assert not drawn.reading[one.curve].closed
    limit = limits(drawn, one)[0]
    assert np.isnan(limit[[0, 1, 2, -3, -2, -1]]).all()
    assert np.isfinite(limit[3:-3]).all()
    assert (np.abs(angles(drawn, one)[0][3:-3]) <= limit[3:-3]).all()


def test_without_accelerations_nothing_is_held_against_them(tmp_path: Path) -> None:
    row = 'positions = 12\nzero = "20 deg"'
    drawn = drawn_of(tmp_path, row=row, asks='points = ["K"]\nanalogues = true')
    made = of(drawn)
    assert made.curves[0].angle is None
    assert [one.plan for one in made.analogues] == ["velocities"]
    row = 'positions = 12\nzero = "20 deg"\naccelerations = [2, 5]'
    drawn = drawn_of(tmp_path, row=row, asks='points = ["K"]\nanalogues = true')
    made = of(drawn)
    there = np.flatnonzero(np.isfinite(angles(drawn, made.curves[0])[0]))
    assert there.tolist() == [2, 5]


def test_one_omega_with_an_epsilon_is_no_motion_and_no_tangent_is_held(tmp_path: Path) -> None:
    """Else true plans of accelerations are called wrong: the row is not the hodograph of a motion."""
    row = ROW.format(count=36, zero=20.0)
    drawn = drawn_of(tmp_path, row=row + '\nacceleration = "60 rad/s^2"')
    assert of(drawn).curves[0].angle is None
    assert not list(WARNINGS.warnings(drawn, "en"))


def test_the_figure_has_a_vector_for_each_end_and_a_closed_curve(tmp_path: Path) -> None:
    drawn = drawn_of(tmp_path)
    (one,) = of(drawn).curves
    view = draw_hodograph(subject(drawn, ""), one, drawn.names, drawn.all, (1, 4), 1.0, "m/s")
    assert sum("segment" in dict(s.data) for s in view.strokes if hasattr(s, "data")) == 12
    assert sum(s.part == "tangent" for s in view.strokes) == 2
    texts = {t for want in view.wanted for t in want.text.replace("{", "").split(", ")}
    assert {str(k) for k in range(1, 13)} <= texts or {str(k) for k in range(12)} <= texts


REFUSED = {
    "frame": ({"asks": 'points = ["D"]'}, "no point of a moving link|stands still"),
    "turned": ({"plans": 'velocities = "turned"'}, "this one of velocities is turned"),
    "every": (
        {
            "asks": 'points = ["K"]\naccelerations = true',
            "row": 'positions = 12\nzero = "0 deg"\naccelerations = [2]',
        },
        'accelerations = "all"',
    ),
    "even": (
        {
            "asks": 'points = ["K"]\nanalogues = true',
            "row": 'positions = 12\nzero = "0 deg"\nacceleration = "5 rad/s^2"',
        },
        "only where the crank turns evenly",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_drawn_is_refused(tmp_path: Path, case: str) -> None:
    told, says = REFUSED[case]
    with pytest.raises(StructureError, match=says):
        drawn_of(tmp_path, **told)


def test_a_scene_without_the_section_records_no_step(tmp_path: Path) -> None:
    drawn = drawn_of(tmp_path)
    path = tmp_path / "scene.toml"
    text = path.read_text(encoding="utf-8")
    text = text.replace('[hodograph]\npoints = ["K"]\n', "").replace(
        ', "hodograph", "hodograph table"', ""
    )
    path.write_text(text, encoding="utf-8")
    bare = in_usual_size(read(path), exact=True).mechanism
    assert bare is not None
    names = {step.it.view for step in drawn.construction.steps}
    assert {n for n in names if "hodograph" in n}
    assert not [s for s in bare.construction.steps if "hodograph" in s.it.view]
    assert KINEMATICS_PLAN.on(bare).velocities is not None


def test_a_point_that_slides_on_the_frame_has_a_straight_hodograph(tmp_path: Path) -> None:
    """Dead centres are ends at the pole; no tangent is held against anything, and nothing is in doubt."""
    path = tmp_path / "scene.toml"
    path.write_text(SLIDER, encoding="utf-8")
    (drawn,) = in_usual_size(read(path), exact=True).boards
    (one,) = of(drawn).curves
    ends = drawn.reading[one.end][0]
    assert one.angle is None
    assert np.abs(ends.imag).max() < 1e-12
    assert np.abs(ends[[0, 6]]).max() < 1e-12
    assert not list(drawn.findings())


SLIDER = """title = "T"
language = "en"
[frame]
number = 4
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.4, 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "+" }
[drive]
link = 1
speed = "20 rad/s"
turns = "counterclockwise"
positions = 12
zero = { point = "B", at = "right" }
accelerations = "all"
[hodograph]
points = ["B"]
[[sheet]]
format = "A1"
"""
