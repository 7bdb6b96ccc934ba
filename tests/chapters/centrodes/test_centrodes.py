"""Centrodes against velocities: where centres lie, that both curves roll, ellipses and circles."""

from __future__ import annotations

import cmath
import math
from pathlib import Path

import numpy as np
import pytest
from support.boards import in_usual_size
from support.turns import in_turn

import graphic_tmm
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.chapters.centrodes.findings import slipping
from graphic_tmm.chapters.centrodes.record import CENTRODES_PLAN, Centrodes
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read

HEAD = """title = "T"
language = "en"
units = "SI"
[frame]
number = 0
O = [0, 0]
{frame}
[[link]]
number = 1
points = {{ O = [0, 0], A = [{crank!r}, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [{rod!r}, 0] }}
[[link]]
number = 3
{third}
[drive]
link = 1
speed = "2 rad/s"
positions = {count}
zero = "{zero!r} deg"
[plans]
velocities = "{plan}"
[centrodes]
{asks}
[[sheet]]
format = "A1"
place = ["positions", "velocities", "centrodes"]
"""


class FourBar:
    """A crank-rocker by its lengths: where it stands, and its complex step."""

    def __init__(self, crank: float, rod: float, rocker: float, frame: float, side: int) -> None:
        self.crank, self.rod, self.rocker, self.frame = map(float, (crank, rod, rocker, frame))
        self.side = side

    def text(self, count: int, zero: float, asks: str = "link = 2", plan: str = "direct") -> str:
        side = "left" if self.side > 0 else "right"
        third = f'points = {{ D = [0, 0], B = [{self.rocker!r}, 0] }}\nside = "{side} of AD"'
        return HEAD.format(
            frame=f"D = [{self.frame!r}, 0]", crank=self.crank, rod=self.rod, third=third,
            count=count, zero=zero, asks=asks, plan=plan,
        )  # fmt: skip

    def pins(self, phi: complex) -> list[complex]:
        """Coordinates of A and B by arithmetic that takes a complex angle."""
        ax, ay = self.crank * np.cos(phi), self.crank * np.sin(phi)
        dx, dy = self.frame - ax, -ay
        d2 = dx * dx + dy * dy
        foot = (d2 + self.rod**2 - self.rocker**2) / (2.0 * d2)
        height = np.sqrt(self.rod**2 / d2 - foot * foot) * self.side
        return [ax, ay, ax + foot * dx - height * dy, ay + foot * dy + height * dx]


class Slider(FourBar):
    """A slider-crank, its guide off the pivot."""

    def text(self, count: int, zero: float, asks: str = "link = 2", plan: str = "direct") -> str:
        third = 'points = { B = [0, 0] }\nslides = { on = 0, along = "x", side = "right" }'
        guide = f'x = {{ through = [0, {self.frame!r}], angle = "0 deg" }}'
        return HEAD.format(
            frame=guide, crank=self.crank, rod=self.rod, third=third, count=count, zero=zero,
            asks=asks, plan=plan,
        )  # fmt: skip

    def pins(self, phi: complex) -> list[complex]:
        ax, ay = self.crank * np.cos(phi), self.crank * np.sin(phi)
        return [ax, ay, ax + np.sqrt(self.rod**2 - (self.frame - ay) ** 2), self.frame + 0j * ay]


def centre(of: FourBar, phi: float) -> tuple[complex, complex]:
    """P by velocities alone: on the frame, and from A along AB and square to it."""
    step = 1e-30
    ax, ay, bx, by = of.pins(phi + 1j * step)
    a, b = complex(ax.real, ay.real), complex(bx.real, by.real)
    va, vb = complex(ax.imag, ay.imag) / step, complex(bx.imag, by.imag) / step
    omega = ((vb - va) / (1j * (b - a))).real
    p = a + 1j * va / omega
    return p, (p - a) / (b - a) * abs(b - a)


def made_of(folder: Path, text: str) -> tuple[Drawn, tuple[Centrodes, ...]]:
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    (drawn,) = in_usual_size(read(path), exact=True).boards
    return drawn, CENTRODES_PLAN.on(drawn)


def some(k: int) -> FourBar:
    rng = np.random.default_rng(k)
    if k % 3 == 0:
        crank = rng.uniform(0.02, 0.08)
        return Slider(crank, crank * rng.uniform(1.6, 4.0), 0.0, crank * rng.uniform(-0.4, 0.4), 1)
    short = rng.uniform(0.02, 0.06)
    while True:
        rod, rocker, frame = short * rng.uniform(1.3, 4.0, 3)
        longest = max(rod, rocker, frame)
        if short + longest < 0.97 * (rod + rocker + frame - longest):
            return FourBar(short, rod, rocker, frame, 1 if k % 2 else -1)


@pytest.mark.parametrize("k", in_turn(range(60), 8))
@pytest.mark.parametrize("plan", ["direct", "turned"])
def test_centres_are_where_velocities_say(tmp_path: Path, k: int, plan: str) -> None:
    of, zero = some(k), float(np.random.default_rng(k + 999).uniform(0.0, 29.0))
    drawn, (made,) = made_of(tmp_path, of.text(12, zero, plan=plan))
    mu, reading = drawn.value(made.mu), drawn.reading
    for place in range(12):
        p, own = centre(of, math.radians(zero + 30.0 * place))
        size = max(abs(p), abs(own), of.crank + of.rod)
        fixed = [mu * reading[mark][0, place] for mark in (made.fixed.x, made.fixed.y)]
        moving = [mu * reading[mark][0, place] for mark in (made.moving.x, made.moving.y)]
        # a far centre is as uncertain as its normals are parallel
        within = 1e-9 * size * max(1.0, size / of.rod)
        assert abs(complex(*fixed) - p) < within
        assert abs(complex(*moving) - own) < within


@pytest.mark.parametrize("k", in_turn(range(60), 6))
def test_moving_centrode_rolls_on_the_fixed_one(tmp_path: Path, k: int) -> None:
    """Carried into every position it has P there, and goes there as the fixed one does."""
    of, zero = some(k), 4.0
    drawn, (made,) = made_of(tmp_path, of.text(72, zero))
    mu, reading = drawn.value(made.mu), drawn.reading
    stood = [reading[mark][0, 0] for mark in made.moving.stood]
    curves = [(mark_curve.knots[0], mark_curve.tangents[0]) for mark_curve in (
        reading[made.fixed.curve], reading[made.moving.curve])]  # fmt: skip
    for place in range(72):
        a, b = (reading[mark][0, place] for mark in made.moving.points)
        turn = (b - a) / (stood[1] - stood[0])
        rolled = a + (reading[made.moving.centre][0, place] - stood[0]) * turn
        p, _ = centre(of, math.radians(zero + 5.0 * place))
        near = abs(p) < 20.0 * of.rod
        if near:
            assert abs(rolled * mu - p) < 1e-9 * max(abs(p), of.rod) * max(1.0, abs(p) / of.rod)
        (fixed, along), (_, own) = ((one[2 * place], t[2 * place]) for one, t in curves)
        if near and np.isfinite(along) and np.isfinite(own):
            step = 1e-5
            ahead, back = (
                centre(of, math.radians(zero + 5.0 * place) + s)[0] for s in (step, -step)
            )
            way = (ahead - back) / (2.0 * step) * math.radians(5.0) / 2.0 / mu
            arcs = [curves[0][0][(2 * (place + s) + 1) % 144] for s in range(-6, 6)]
            # a spline's tangent is off by the fourth power of the interval, by more at the end of a branch
            if np.isfinite(arcs).all():
                assert abs(along - way) < 0.02 * abs(way) + 0.02
                assert abs(own * turn - way) < 0.02 * abs(way) + 0.02
        assert np.isfinite(fixed) or not near


def test_arcs_are_equal_and_more_so_with_more_positions(tmp_path: Path) -> None:
    of, worst = FourBar(0.11, 0.07, 0.11, 0.07, -1), []
    flips = 'flips_at = ["0 deg", "180 deg"]'
    for count in (16, 32, 64):
        text = of.text(count, 360.0 / count / 2.0).replace("[drive]", f"{flips}\n[drive]", 1)
        drawn, (made,) = made_of(tmp_path, text)
        arcs = [drawn.reading[side.arc][0] for side in made.sides]
        worst.append(float(np.max(np.abs(arcs[1] - arcs[0]) / arcs[0])))
        assert not slipping(drawn, made).any()
        assert abs(float(drawn.reading[made.off][0, 0])) < 40.0 / count
    assert worst[0] < 0.01
    assert worst[2] < worst[0] or worst[2] < 1e-9


def test_crossed_four_bar_rolls_on_ellipses() -> None:
    """Both have the pivots, or the pins, as foci: the sum of the distances is the crank."""
    scene = Path(graphic_tmm.__file__).parents[1] / "sheets" / "rolling-centrodes" / "scene.toml"
    at = np.arange(3.0, 360.0, 7.0)
    found = graphic_tmm.motion(scene, at, plans="centrodes", exact=True).columns
    for x, y in (("x20", "y20"), ("xi20", "eta20")):
        z = found[x] + 1j * found[y]
        assert np.abs(np.abs(z) + np.abs(z - 0.07) - 0.11).max() < 1e-9 * 0.11


TRAMMEL = """title = "T"
language = "en"
units = "SI"
[frame]
number = 0
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
y = { through = [0, 0], angle = "90 deg" }
[[link]]
number = 1
points = { A = [0, 0] }
slides = { on = 0, along = "x" }
[[link]]
number = 2
points = { A = [0, 0], B = [0.2, 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = 0, along = "y", side = "+" }
[drive]
link = 1
speed = "0.1 m/s"
from = "-0.19 m"
to = "0.19 m"
positions = 9
[centrodes]
link = 2
at = 4
[[sheet]]
format = "A1"
place = ["positions", "centrodes"]
"""


def test_elliptic_trammel_rolls_on_circles_of_ratio_two(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(TRAMMEL, encoding="utf-8")
    found = graphic_tmm.motion(
        path, np.linspace(-0.18, 0.18, 25), plans="centrodes", exact=True
    ).columns
    fixed, moving = found["x20"] + 1j * found["y20"], found["xi20"] + 1j * found["eta20"]
    assert np.abs(np.abs(fixed) - 0.2).max() < 1e-9 * 0.2
    assert np.abs(np.abs(moving - 0.1) - 0.1).max() < 1e-9 * 0.2


def test_curves_break_where_the_centre_runs_to_infinity(tmp_path: Path) -> None:
    drawn, (made,) = made_of(tmp_path, Slider(0.06, 0.2, 0.0, 0.0, 1).text(12, 0.0))
    for side in made.sides:
        runs = bezier(drawn.reading[side.curve])
        assert len(runs) == 2
        # no arc leads across the drawing: along a branch the centre is always on one side of the crank's square
        for run in runs:
            places = np.array(run[::6])
            assert places.size == 5
    told = [one for one in warnings(drawn, "en") if one.startswith("centrodes")]
    assert any("positions 3, 9" in one and "at infinity" in one for one in told)
    assert np.isnan(drawn.reading.figure(made.fixed.x)[0, [3, 9]]).all()


@pytest.mark.parametrize("k", in_turn(range(1, 40), 4))
def test_links_roll_on_links_that_move(tmp_path: Path, k: int) -> None:
    """Crank on rocker: the centre lies on the lines of their pins and of their pivots."""
    of = some(3 * k + 1)
    drawn, (made,) = made_of(tmp_path, of.text(12, 7.0, "link = 1\nagainst = 3"))
    mu, reading = drawn.value(made.mu), drawn.reading
    for place in range(12):
        ax, ay, bx, by = (float(z.real) for z in of.pins(math.radians(7.0 + 30.0 * place) + 0j))
        a, b = complex(ax, ay), complex(bx, by)
        rod = (b - a) / abs(b - a)
        p = a - rod * a.imag / rod.imag + 0j
        own = p / a * abs(a)
        seen = (p - of.frame) / (b - of.frame) * abs(b - of.frame)
        size = max(abs(p), of.rod)
        within = 1e-8 * size * max(1.0, size / of.rod) ** 2
        if abs(rod.imag) < 1e-3:
            continue
        crank = complex(*(mu * reading[m][0, place] for m in (made.moving.x, made.moving.y)))
        rocker = complex(*(mu * reading[m][0, place] for m in (made.fixed.x, made.fixed.y)))
        assert abs(crank - own) < within
        assert abs(rocker - seen) < within


@pytest.mark.parametrize(
    ("asks", "says"),
    [
        ("link = 1", "turns about O of link 0"),
        ("link = 3", "slides straight on link 0"),
        ("link = 2\nagainst = 1", "turns about A of link 1"),
        ("link = 2\nat = 40", "there is no position 40"),
        ("link = 7", "there is no moving link 7; there are 1, 2, 3"),
        ("link = 2\nagainst = 2", "does not move against itself"),
        ("link = [2, 2]", "write the number of a link"),
    ],
)
def test_what_has_no_centrodes_is_refused(tmp_path: Path, asks: str, says: str) -> None:
    with pytest.raises((StructureError, SceneError), match=says):
        made_of(tmp_path, Slider(0.06, 0.2, 0.0, 0.01, 1).text(12, 0.0, asks))


def test_several_links_are_drawn_each_by_itself(tmp_path: Path) -> None:
    of = FourBar(0.03, 0.08, 0.07, 0.09, 1)
    _, found = made_of(
        tmp_path, of.text(12, 5.0, "link = [2, 1]\nagainst = 3").replace("[2, 1]", "[1]")
    )
    assert [one.view for one in found] == ["centrodes 1/3"]


def test_scenes_without_the_section_record_nothing(tmp_path: Path) -> None:
    text = FourBar(0.03, 0.08, 0.07, 0.09, 1).text(12, 5.0)
    text = text.replace("[centrodes]\nlink = 2\n", "").replace(', "centrodes"', "")
    path = tmp_path / "scene.toml"
    path.write_text(text, encoding="utf-8")
    (drawn,) = in_usual_size(read(path), exact=True).boards
    assert not [step for step in drawn.construction.steps if step.it.view.startswith("centrodes")]


def test_angles_of_nothing_are_not_told(tmp_path: Path) -> None:
    """Where both touch at infinity nothing is drawn, and the remedy is told."""
    text = Slider(0.06, 0.2, 0.0, 0.0, 1).text(12, 0.0, "link = 2\nat = 3")
    drawn, (made,) = made_of(tmp_path, text)
    assert cmath.isnan(complex(drawn.reading[made.touch][0, 0]))
    told = warnings(drawn, "en")
    assert any("write another position for at" in one for one in told)


def way_of_centre(of: FourBar, phi: float) -> tuple[complex, complex]:
    """P and dP/dφ, exact: P lies on OA and on BD, or on the normal to the guide; a complex step of that."""
    step = 1e-30
    ax, ay, bx, by = of.pins(phi + 1j * step)
    wx = bx - of.frame
    share = bx / ax if isinstance(of, Slider) else of.frame * by / (ax * by - ay * wx)
    x, y = ax * share, ay * share
    return complex(x.real, y.real), complex(x.imag, y.imag) / step


@pytest.mark.parametrize("k", in_turn(range(36), 6))
def test_drawn_tangents_are_the_way_of_the_centre(tmp_path: Path, k: int) -> None:
    """Both centrodes go where P goes, for the link stands still in P; with the fourth power of the interval."""
    of, zero, off = some(k), 4.0, dict[int, list[float]]()
    place, way = way_of_centre(of, math.radians(zero))
    judged = centre(of, math.radians(zero))[0]
    assert place == pytest.approx(judged, abs=1e-11 * abs(judged) * max(1.0, abs(judged) / of.rod))
    for count in (144, 288):
        drawn, (made,) = made_of(tmp_path, of.text(count, zero))
        tangents = [drawn.reading[side.tangent] for side in made.sides]
        off[count] = [abs(math.sin(cmath.phase(complex(t.along[0, 0]) / way))) for t in tangents]
        for tangent in tangents:
            assert complex(tangent.at[0, 0]) * drawn.value(made.mu) == pytest.approx(
                place, abs=1e-9 * abs(place) * max(1.0, abs(place) / of.rod)
            )
    for coarse, fine in zip(off[144], off[288], strict=True):
        assert fine < 1e-5
        assert fine < 1e-7 or 12.0 < coarse / fine < 20.0
