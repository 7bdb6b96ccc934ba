"""Any pair by involutes built by points here: they touch on the line of action and overlap only where told.

The outlines are whole wheels, made without the package: involutes of the base circles from a string unwound,
cut off at the tips; they are turned by the ratio and laid on one another.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import acos, atan, cos, pi, radians, sin, tan
from typing import NamedTuple

import numpy as np
import pytest
import shapely
from shapely import affinity
from support.teeth import Pair, pair

from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.chapters.gears.views import gear_views
from graphic_tmm.errors import StructureError

POINTS = 60
"""Of a flank; the chords lie less than 1e-4 of a module inside an involute."""
TURNS = 24
"""Of a pitch, in each of which the wheels are laid on one another."""
FLAT = 2e-6
"""Overlap of chords with the arcs that they stand for, in squares of the module: measured 1e-6 at most."""


class Given(NamedTuple):
    """A pair in modules of the drawn section, by formulas of its own: angles, radii, half thickness angles."""

    z: tuple[int, int]
    inside: bool
    alpha: float
    alpha_w: float
    base: tuple[float, float]
    roll: tuple[float, float]
    tip: tuple[float, float]
    root: tuple[float, float]
    half: tuple[float, float]

    @property
    def axes(self) -> float:
        """The distance of the axes."""
        return self.roll[1] - self.roll[0] if self.inside else sum(self.roll)


def inv(angle: float) -> float:
    return tan(angle) - angle


def root_of(run: Callable[[float], float], low: float, high: float) -> float:
    """Where a function is zero between two places of other signs, by halving."""
    sign = run(low) > 0.0
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if (run(middle) > 0.0) == sign else (low, middle)
    return low


def given(order: GearTask) -> Given:
    """The pair from the thickness of its teeth on the rolling circles: they fill the pitch there."""
    z, lean = (order.z1, abs(order.z2)), cos(radians(order.beta or 0.0))
    inside, alpha = order.z2 < 0, atan(tan(radians(order.alpha)) / lean)
    x = [lean * (one or 0.0) for one in (order.x1, order.x2)]
    pitch = [n / 2 for n in z]
    base = [r * cos(alpha) for r in pitch]
    thick = [(pi + 4 * one * tan(alpha)) / n for n, one in zip(z, x, strict=True)]
    sign = -1.0 if inside else 1.0

    def open_(angle: float) -> float:
        """What is left of the pitch, an angle of wheel 1, where both mesh at an angle."""
        first = thick[0] + 2 * (inv(alpha) - inv(angle))
        second = thick[1] + 2 * (inv(alpha) - inv(angle))  # of a ring it is the space
        if inside:
            return second * z[1] / z[0] - first
        return 2 * pi / z[0] - first - second * z[1] / z[0]

    angle = root_of(open_, 1e-3, 1.4)
    axes = abs(pitch[1] + sign * pitch[0]) * cos(alpha) / cos(angle)
    move = axes - abs(pitch[1] + sign * pitch[0])
    less = move - x[1] + x[0] if inside else x[0] + x[1] - move
    if order.delta_y is not None:
        less = order.delta_y * lean
    ha, c = [lean * one for one in order.addenda], lean * order.c
    tip = [pitch[0] + ha[0] + x[0] - less, pitch[1] + sign * (ha[1] + sign * x[1] - less)]
    deep = max(ha) if inside else ha[1]
    root = [pitch[0] - deep - c + x[0], pitch[1] - sign * (ha[0] + c - sign * x[1])]
    half = [one / 2 + inv(alpha) for one in thick]
    roll = [b / cos(angle) for b in base]
    both = [(base[0], base[1]), (roll[0], roll[1]), (tip[0], tip[1]), (root[0], root[1])]
    return Given((z[0], z[1]), inside, alpha, angle, *both, (half[0], half[1]))


def side(of: Given, k: int, low: float, high: float) -> tuple[np.ndarray, np.ndarray]:
    """Radii of a flank, and by how much it has gone away from the middle of the tooth (of a ring the space)."""
    low = max(low, of.base[k])
    string = np.linspace(*(np.sqrt(max(r**2 - of.base[k] ** 2, 0.0)) for r in (low, high)), POINTS)
    roll = string / of.base[k]
    return np.hypot(string, of.base[k]), of.half[k] - (roll - np.arctan(roll))


def outline(of: Given, k: int, low: float, high: float) -> np.ndarray:
    """A wheel, a tooth (of a ring a space) along the x axis, from one radius to another."""
    r, away = side(of, k, low, high)
    away = np.maximum(away, 0.0)
    if low < of.base[k]:
        r, away = np.append(low, r), np.append(away[0], away)
    rise, fall = r * np.exp(-1j * away), (r * np.exp(1j * away))[::-1]
    arc = [r[-1] * np.exp(1j * t) for t in np.linspace(-away[-1], away[-1], 9)[1:-1]]
    step = 2 * pi / of.z[k]
    gap = [r[0] * np.exp(1j * t) for t in np.linspace(away[0], step - away[0], 9)[1:-1]]
    tooth = np.concatenate([rise, arc, fall, gap])
    return np.concatenate([tooth * np.exp(1j * step * n) for n in range(of.z[k])])


def polygon(spots: np.ndarray) -> shapely.Polygon:
    return shapely.Polygon(np.column_stack([spots.real, spots.imag])).buffer(0.0)


def wheels(of: Given) -> tuple[shapely.Geometry, shapely.Geometry]:
    """Both wheels about the origin; below the base circle a flank goes straight to the root."""
    first = polygon(outline(of, 0, of.root[0], of.tip[0]))
    if not of.inside:
        return first, polygon(outline(of, 1, of.root[1], of.tip[1]))
    hollow = polygon(outline(of, 1, of.tip[1], of.root[1]))
    return first, shapely.Point(0, 0).buffer(of.root[1] + 3).difference(hollow)


def laid(of: Given, both: tuple, turn: float, move: complex = 0j) -> tuple:
    """Wheel 1 at ``move``, turned from where a tooth stands on the line of centres, and its mate."""
    first = affinity.rotate(both[0], pi / 2 + turn, (0, 0), use_radians=True)
    first = affinity.translate(first, move.real, move.imag)
    mate, down = turn * of.z[0] / of.z[1], -1 if of.inside else 1
    start = pi / 2 + mate if of.inside else -pi / 2 + pi / of.z[1] - mate
    second = affinity.rotate(both[1], start, (0, 0), use_radians=True)
    return first, affinity.translate(second, 0.0, down * of.axes)


def most_overlap(of: Given, both: tuple) -> float:
    turns = np.arange(TURNS) * 2 * pi / of.z[0] / TURNS
    return max(
        float(np.asarray(a.intersection(b).area)) for a, b in (laid(of, both, t) for t in turns)
    )


def put_in(of: Given, both: tuple, turn: float) -> float:
    """The most overlap while wheel 1 goes from its place to the ring's centre along the line of centres."""
    ways = np.linspace(0.0, min(of.axes, 3.5), 18)
    laid_ = (laid(of, both, turn, -1j * way) for way in ways)
    return max(float(np.asarray(a.intersection(b).area)) for a, b in laid_)


def drawn_flanks(of: Pair, own: Given) -> float:
    """How far the drawn flanks lie from the involutes that touch in the pitch point, in modules."""
    module, worst = 1000.0 * of.real(of.gear.sizes.module), 0.0
    for k, wheel in enumerate(of.gear.wheels):
        centre, count = of.one(wheel.circles.centre), wheel.roll.count
        spots = (of.row(wheel.points, count) - centre) * of.mm / module
        pole = (of.one(of.gear.line.pole) - centre) / 1j
        reach = np.abs(spots)
        there = reach > own.base[k] * (1 + 1e-9)
        due = np.array([inv(acos(own.base[k] / r)) for r in reach[there]])
        due = -(due - inv(own.alpha_w))
        found = np.angle(spots[there] / 1j / (1 if pole.real > 0 else -1))
        worst = max(worst, float(np.abs((found + due) * reach[there]).max()))
    return worst


def random_order(seed: int) -> GearTask:
    """A pair at random: external, helical, or in a ring, with shifts and addenda."""
    rng, kind = np.random.default_rng([37, seed]), seed % 3
    z1 = int(rng.integers(10, 40))
    x1, x2 = (round(float(x), 3) for x in rng.uniform(-0.1, 0.7, 2))
    beta = float(rng.choice([10.0, 20.0, 30.0])) if kind == 1 or seed % 6 == 2 else None
    ha = (round(float(rng.uniform(0.8, 1.1)), 2), round(float(rng.uniform(0.8, 1.1)), 2))
    z2 = int(rng.integers(10, 90))
    if kind == 2:
        z2 = -(z1 + int(rng.integers(6, 70)))
        x2 = x1 + round(float(rng.uniform(-0.2, 0.5)), 3)
    alpha = float(rng.choice([17.5, 20.0, 25.0]))
    return GearTask(z1, z2, 0.005, x1, x2, alpha=alpha, ha=ha if seed % 2 else 1.0, beta=beta)


def drawn_or_refused(order: GearTask) -> Pair | None:
    """The pair, None where its shifts leave a wheel no tooth."""
    try:
        return pair(order)
    except StructureError as error:
        told = str(error)
    assert any(word in told for word in ("no body", "base circle", "no tooth")), told
    return None


CORNERS = {"undercut", "interference", "ring tip", "tip overlap", "clearance", "pointed tooth"}
"""Checks that tell of corners where this outline has no right shape, or overlaps."""


@pytest.mark.turns(24)
@pytest.mark.parametrize("seed", range(300))
def test_flanks_touch_on_the_line_of_action_and_overlap_where_it_is_told(seed: int) -> None:
    order = random_order(seed)
    of = drawn_or_refused(order)
    if of is None:
        return
    own, found = given(order), of.results()
    module = of.real(of.gear.sizes.module)
    assert found["a_w"][0] / module == pytest.approx(own.axes, rel=1e-9)
    for k in (1, 2):
        assert found[f"r_a{k}"][0] / module == pytest.approx(own.tip[k - 1], rel=1e-9)
        assert found[f"r_f{k}"][0] / module == pytest.approx(own.root[k - 1], rel=1e-9)
    assert drawn_flanks(of, own) < 1e-6
    failed, both = {name for name, _ in of.failed()}, wheels(own)
    overlap = most_overlap(own, both)
    if not failed & CORNERS:
        assert overlap < FLAT
    if of.real(of.gear.sizes.wheels[0].lowest) < -0.4 * module:
        assert "interference" in failed
        assert overlap > 4 * FLAT
    if own.inside and not failed & {"ring tip", "tip overlap"}:
        turns = np.arange(6) * 2 * pi / own.z[0] / 6
        most, gap = max(put_in(own, both, t) for t in turns), found["assembly_gap"][0] / module
        assert ("assembly" in failed) == (gap < 0.0)
        assert gap < 0.0 or most < FLAT
        assert gap > -0.05 or most > 1e-3


@pytest.mark.parametrize("more", range(1, 13))
def test_tips_away_from_the_line_of_action_overlap_where_it_is_told(more: int) -> None:
    """Shifts of a whole module keep the ring's tips from N1; the fewer teeth it has more, the more overlap."""
    order = GearTask(30, -30 - more, 0.005, 1.0, 1.2, ha=0.8)
    of, own = pair(order), given(order)
    both, away = wheels(own), shapely.Point(0, own.roll[0]).buffer(3.5)
    turns = np.arange(TURNS) * 2 * pi / own.z[0] / TURNS
    pairs = (laid(own, both, turn) for turn in turns)
    most = max(float(np.asarray(a.intersection(b).difference(away).area)) for a, b in pairs)
    assert (("tip overlap", 0) in of.failed()) == (most > FLAT)


def figures(order: GearTask) -> dict[str, float]:
    return {name: value for name, (value, _) in pair(order).results().items()}


@pytest.mark.parametrize(
    "order",
    [
        GearTask(20, -30, 0.005, 0.0, 3.5),
        GearTask(20, -30, 0.005, 0.0, 4.9, alpha=25.0),
        GearTask(50, -100, 0.005, 0.0, 4.9, alpha=30.0),
    ],
)
def test_the_teeth_of_a_ring_end_where_its_flanks_meet(order: GearTask) -> None:
    """There the space takes the whole pitch; contact and finding know no tooth farther in."""
    of, own = pair(order), given(order)

    def open_(k: int, turn: float) -> Callable[[float], float]:
        return lambda r: own.half[k] - inv(acos(own.base[k] / r)) - turn

    tops = [root_of(open_(0, 0.0), own.base[0], own.tip[0])]
    tops.append(root_of(open_(1, pi / own.z[1]), own.tip[1], own.root[1]))
    module = of.real(of.gear.sizes.module)
    for wheel, due in zip(of.gear.wheels, tops, strict=True):
        assert of.real(wheel.sizes.top) / module == pytest.approx(due, rel=1e-9)
        apex = of.one(wheel.teeth[1].right.tip) - of.one(wheel.circles.centre)
        assert abs(apex) * of.mm / 1000 / of.real(of.gear.sizes.module) == pytest.approx(
            due, rel=1e-4
        )
    ends = [np.sqrt(r**2 - b**2) for r, b in zip(tops, own.base, strict=True)]
    path = ends[0] - ends[1] + own.axes * sin(own.alpha_w)
    ratio = path / (pi * cos(own.alpha))
    assert of.results()["contact_ratio"][0] == pytest.approx(ratio, rel=1e-9)
    assert of.results()["contact_ratio_drawn"][0] == pytest.approx(ratio, rel=1e-3)


def test_published_figures_of_rings() -> None:
    """20/60, m 5: the ring's tips just reach beyond N1; 63.01 teeth is the least ring; 12/40 is cut at N1."""
    found = figures(GearTask(20, -60, 0.005))
    assert round(found["contact_ratio_uncut"], 6) == 1.949662
    assert [round(1000 * found[name], 2) for name in ("r_a2", "r_a2_least")] == [145.00, 145.04]
    assert found["contact_ratio"] < found["contact_ratio_uncut"]
    assert ("ring tip", 2) in pair(GearTask(20, -63, 0.005)).failed()
    assert ("ring tip", 2) not in pair(GearTask(20, -64, 0.005)).failed()
    assert round(figures(GearTask(12, -40, 0.005))["contact_ratio"], 3) == 1.405


def test_a_helical_pair_by_the_book() -> None:
    """12/60, m_n 3, 30°: m_t, α_t and a by hand; ε_γ with b = 40 mm; z_v = z/cos³ β."""
    found = figures(GearTask(12, 60, 0.003, beta=30.0, width=0.04))
    assert found["m_t"] == pytest.approx(0.003 / cos(pi / 6), rel=1e-12)
    assert found["alpha_t"] == pytest.approx(np.degrees(atan(tan(pi / 9) / cos(pi / 6))), rel=1e-12)
    assert found["a"] == pytest.approx(0.003 * 72 / 2 / cos(pi / 6), rel=1e-12)
    assert found["overlap_ratio"] == pytest.approx(0.04 * 0.5 / (pi * 0.003), rel=1e-12)
    assert found["total_ratio"] == pytest.approx(found["contact_ratio"] + found["overlap_ratio"])
    assert found["z_v1"] == pytest.approx(12 / cos(pi / 6) ** 3, rel=1e-12)
    # least teeth of a helical wheel: 2 h_a cos β / sin² α_t
    due = 2 * cos(pi / 6) / sin(radians(found["alpha_t"])) ** 2
    assert found["z_min1"] == pytest.approx(due, rel=1e-12)


@pytest.mark.parametrize("z2", [31, -59])
@pytest.mark.parametrize("beta", [None, 20.0])
@pytest.mark.parametrize("missing", ["x1", "x2"])
def test_the_shift_that_is_missing_follows(z2: int, beta: float | None, missing: str) -> None:
    """What a pair with both shifts has as its distance and sum gives the missing shift back."""
    whole = GearTask(19, z2, 0.004, 0.35, 0.52, beta=beta)
    due = figures(whole)
    total = 0.52 - 0.35 if z2 < 0 else 0.52 + 0.35
    for given_ in ({"distance": due["a_w"]}, {"x_sum": total}):
        found = figures(replace(whole, **{missing: None}, **given_))
        assert found["x_sum"] == pytest.approx(total, abs=1e-9)
        assert found[missing] == pytest.approx(getattr(whole, missing), abs=1e-9)
        for name in ("a_w", "r_a1", "r_a2", "contact_ratio", "alpha_w"):
            assert found[name] == pytest.approx(due[name], rel=1e-9), name


@pytest.mark.parametrize("beta", [None, 8.0, 21.0, 35.0])
@pytest.mark.parametrize(("z2", "x2"), [(41, -0.5), (-60, 0.5), (-97, 0.5)])
def test_shifts_that_cancel_leave_the_axes_in_their_place(
    z2: int, x2: float, beta: float | None
) -> None:
    found = figures(GearTask(20, z2, 0.005, 0.5, x2, beta=beta))
    assert (found["y"], found["delta_y"]) == (0.0, 0.0)
    apart = figures(GearTask(20, z2, 0.005, 0.5, x2 + 1e-9, beta=beta))
    assert abs(apart["y"]) == pytest.approx(1e-9, rel=1e-3)


def test_the_caption_names_the_base_pitch_of_its_section() -> None:
    """Helical, that of the transverse section, as in the table."""
    for beta, pitch in ((None, "p_{b}"), (20.0, "p_{bt}")):
        made = gear_views(pair(GearTask(20, 40, 0.005, beta=beta)).drawn, True)
        told = [label.text for view in made for label in view.labels if "ab/" in label.text]
        assert len(told) == 2
        assert all(f"ab/{pitch}" in one for one in told)


@pytest.mark.parametrize("z2", [60, -80])
def test_flanks_slide_as_fast_as_their_points_of_contact_part(z2: int) -> None:
    """By the velocities of the two points that touch, of wheels that turn about their centres."""
    of = pair(GearTask(20, z2, 0.005, 0.4, 0.4, speed=10.0))
    found, line = of.results(), of.gear.line
    way = np.exp(1j * radians(found["alpha_w"][0]))
    centres = [of.one(circles.centre) for circles in line.circles]
    omega = (-10.0, -10.0 * 20 / z2 * -1)  # wheel 1 turns clockwise, a ring the same way
    assert found["omega2"][0] == pytest.approx(abs(omega[1]), rel=1e-12)
    assert found["n2"][0] == pytest.approx(abs(omega[1]) * 30 / pi, rel=1e-12)
    for name, end in zip("ab", line.ends, strict=True):
        spot = of.one(end)
        pace = [1j * w * (spot - c) * of.mm / 1000 for w, c in zip(omega, centres, strict=True)]
        parting = (pace[0] - pace[1]) / way
        assert abs(parting.real) < 1e-9  # along the line of action both are equally fast
        assert abs(found[f"v_s{name}"][0]) == pytest.approx(abs(parting.imag), rel=1e-9)
        ratio = found[f"v_s{name}"][0] / found["v_rolling"][0]
        assert found[f"v_s{name}_ratio"][0] == pytest.approx(ratio, rel=1e-12)
    assert found["v_sa"][0] < 0.0 < found["v_sb"][0]


def test_each_wheel_has_its_own_addendum_and_room_for_its_mates() -> None:
    found = figures(GearTask(20, 60, 0.005, ha=(1.1, 0.9)))
    assert found["r_a1"] == pytest.approx(0.05 + 1.1 * 0.005)
    assert found["r_a2"] == pytest.approx(0.15 + 0.9 * 0.005)
    assert found["r_f1"] == pytest.approx(0.05 - (0.9 + 0.25) * 0.005)
    assert found["r_f2"] == pytest.approx(0.15 - (1.1 + 0.25) * 0.005)
    assert found["h"] == pytest.approx(2.25 * 0.005)
    assert found["h_w"] == pytest.approx(2.0 * 0.005)
    for k, ha in ((1, 0.9), (2, 1.1)):  # the rack that cuts a wheel has its mate's addendum
        assert found[f"z_min{k}"] == pytest.approx(2 * ha / sin(radians(20.0)) ** 2)
