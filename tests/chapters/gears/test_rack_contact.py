"""A wheel on a rack: involutes and straight teeth built by points here touch, and overlap only where told.

The wheel is made without the package, from a string unwound from its base circle; the rack by its half breadth
at each height. The wheel turns, the rack runs on by the way of the pitch circle.
"""

from __future__ import annotations

from dataclasses import replace
from math import acos, atan, cos, pi, radians, sin, sqrt, tan
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
import shapely
from shapely import affinity
from support.each import each
from support.scenes import written
from support.teeth import Pair, pair

from graphic_tmm.chapters.gears.task import ASKED, GearTask
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.scene.read import read

POINTS = 60
"""Of a flank of the wheel; chords lie less than 1e-4 of a module inside an involute."""
TURNS = 24
"""Of a pitch, in each of which both are laid on one another."""
FLAT = 2e-6
"""Overlap of chords with the arcs that they stand for, in squares of the module."""
CORNERS = {"undercut", "interference", "pointed tooth"}
"""Checks that tell of corners where this outline of a wheel has no right shape."""


class Given(NamedTuple):
    """The pair in modules of the drawn section: radii and half an angle of a tooth; heights of the rack."""

    z: int
    alpha: float
    roll: float
    base: float
    tip: float
    root: float
    half: float
    datum: float
    heads: tuple[float, float]
    clear: float

    def spread(self, r: float) -> float:
        """Half the angle of a tooth at a radius."""
        angle = acos(min(1.0, self.base / r))
        return self.half - (tan(angle) - angle)


def given(order: GearTask) -> Given:
    lean = cos(radians(order.beta or 0.0))
    alpha, roll = atan(tan(radians(order.alpha)) / lean), order.z1 / 2
    x = lean * (order.x1 or 0.0)
    heads = (lean * order.addenda[0], lean * order.addenda[1])
    half = (pi / 2 + 2 * x * tan(alpha)) / order.z1 + tan(alpha) - alpha
    tip, root = roll + heads[0] + x, roll - heads[1] - lean * order.c + x
    base, clear = roll * cos(alpha), lean * order.c
    return Given(order.z1, alpha, roll, base, tip, root, half, roll + x, heads, clear)


def wheel(of: Given) -> shapely.Polygon:
    """The whole wheel about the origin, a tooth upright; below the base circle a flank goes straight down."""
    low = max(of.base, of.root)
    string = np.linspace(sqrt(low**2 - of.base**2), sqrt(of.tip**2 - of.base**2), POINTS)
    r = np.hypot(string, of.base)
    away = np.maximum([of.spread(one) for one in r], 0.0)
    r, away = np.append(of.root, r), np.append(away[0], away)
    rise, fall = r * np.exp(1j * away), (r * np.exp(-1j * away))[::-1]
    step = 2 * pi / of.z
    tooth = np.concatenate([rise, fall])[::-1] * 1j
    spots = np.concatenate([tooth * np.exp(1j * step * n) for n in range(of.z)])
    return shapely.Polygon(np.column_stack([spots.real, spots.imag])).buffer(0.0)


def rack(of: Given) -> shapely.Geometry:
    """Eight teeth that point down, a space above the origin."""
    deep, pitch = of.heads[0], pi
    tip, top = of.datum - of.heads[1], of.datum + deep

    def half(y: float) -> float:
        return pi / 4 + (y - of.datum) * tan(of.alpha)

    one = [(-half(top), top), (-half(tip), tip), (half(tip), tip), (half(top), top)]
    teeth = [affinity.translate(shapely.Polygon(one), pitch * (n + 0.5)) for n in range(-4, 4)]
    return shapely.unary_union(teeth)


def laid(of: Given, both: tuple, turn: float) -> tuple:
    """Both when the wheel has turned so far (radians, clockwise) from where its tooth stands in a space."""
    first = affinity.rotate(both[0], -turn, (0, 0), use_radians=True)
    return first, affinity.translate(both[1], of.roll * turn)


def drawn_rack(of: Pair, module: float) -> shapely.Polygon:
    """The three drawn teeth with the roundings of their roots, in modules, from the axis of the wheel."""
    teeth, scale = of.gear.rack, of.mm / 1000 / module
    assert teeth is not None
    spots: list[complex] = []
    for k in range(3):
        for side, order in ((teeth.left, -1), (teeth.right, 1)):
            tip, start, centre, root = (complex(of.reading[m][0, k]) for m in side.marks)
            bend = np.angle((root - centre) / (start - centre)) if start != centre else 0.0
            arc = [centre + (start - centre) * np.exp(1j * bend * u) for u in np.linspace(0, 1, 33)]
            spots += [tip, *arc][::order]
    top = max(z.imag for z in spots) + 5.0
    spots += [complex(spots[-1].real, top), complex(spots[0].real, top)]
    return shapely.Polygon([(z.real * scale, z.imag * scale) for z in spots])


def random_order(seed: int) -> GearTask:
    rng = np.random.default_rng([41, seed])
    beta = float(rng.choice([8.0, 15.0, 30.0])) if seed % 3 == 1 else None
    ha = (round(float(rng.uniform(0.7, 1.1)), 2), round(float(rng.uniform(0.7, 1.1)), 2))
    return GearTask(
        int(rng.integers(8, 60)), "rack", 0.005, round(float(rng.uniform(-0.3, 0.9)), 3),
        alpha=float(rng.choice([15.0, 20.0, 25.0])), ha=ha if seed % 2 else 1.0, beta=beta,
    )  # fmt: skip


def drawn_or_refused(order: GearTask) -> Pair | None:
    try:
        return pair(order)
    except StructureError as error:
        told = str(error)
    assert any(word in told for word in ("no body", "base circle", "no tooth")), told
    return None


@pytest.mark.turns(24)
@pytest.mark.parametrize("seed", range(300))
def test_flanks_touch_in_the_pitch_point_and_overlap_where_it_is_told(seed: int) -> None:
    order = random_order(seed)
    of = drawn_or_refused(order)
    if of is None:
        return
    own, found = given(order), of.results()
    module = of.real(of.gear.sizes.module)
    for name, due in (("r_a1", own.tip), ("r_f1", own.root), ("H", own.datum), ("r_b1", own.base)):
        assert found[name][0] / module == pytest.approx(due, rel=1e-12), name
    assert found["travel"][0] / module == pytest.approx(2 * pi * own.roll, rel=1e-12)
    both = wheel(own), rack(own)
    # a flank of the wheel stands in the pitch point after a quarter of a tooth
    start = own.spread(own.roll)
    teeth, (first, second) = drawn_rack(of, module), laid(own, both, -start)
    assert teeth.difference(second).intersection(shapely.box(-9, 0, 9, own.datum)).area < 1e-9
    if own.datum - own.heads[1] < own.roll:  # the teeth of the rack reach beyond the pitch point
        assert shapely.dwithin(shapely.Point(0, own.roll), second.boundary, 1e-9)
    assert shapely.dwithin(shapely.Point(0, own.roll), first.boundary, 1e-4)
    assert drawn_flank(of, own, module) < 1e-6
    turns = np.arange(TURNS) * 2 * pi / own.z / TURNS
    failed = {name for name, _ in of.failed()}
    overlap = max(float(a.intersection(b).area) for a, b in (laid(own, both, t) for t in turns))
    if not failed & CORNERS:
        assert overlap < FLAT
        lengthy = (laid(own, (both[0], teeth), t - start)[0] for t in (0.0, turns[3], turns[9]))
        moved = (affinity.translate(teeth, own.roll * t) for t in (0.0, turns[3], turns[9]))
        for a, b in zip(lengthy, moved, strict=True):
            assert float(a.intersection(b).area) < FLAT
            assert a.distance(b) < 1e-4
    if of.real(of.gear.sizes.wheels[0].lowest) < -0.4 * module:
        assert "interference" in failed
        assert overlap > 4 * FLAT


def drawn_flank(of: Pair, own: Given, module: float) -> float:
    """How far the drawn flank lies from the involute that touches in the pitch point, in modules."""
    drawn = of.gear.wheels[0]
    spots = of.row(drawn.points, drawn.roll.count) * of.mm / 1000 / module
    reach = np.abs(spots)
    there = reach > own.base * (1 + 1e-9)
    due = np.array([own.spread(r) - own.spread(own.roll) for r in reach[there]])
    away = np.angle(spots[there] / 1j)
    return float(np.abs((away + due) * reach[there]).max())


@pytest.mark.turns(8)
@pytest.mark.parametrize("seed", range(60))
def test_contact_lasts_as_long_as_sampled_flanks_touch(seed: int) -> None:
    """The gap between an involute from the base circle to the tip and a straight flank down to its tip."""
    order = random_order(1000 + seed)
    of = drawn_or_refused(order)
    if of is None or ("pointed tooth", 1) in of.failed():
        return
    own, found = given(order), of.results()
    string = np.linspace(0.0, sqrt(own.tip**2 - own.base**2), 20001)
    r = np.hypot(string, own.base)
    # the right flank, that passes the pitch point at the turn 0
    away = own.half - (string / own.base - np.arctan(string / own.base)) - own.spread(own.roll)
    curve = 1j * r * np.exp(-1j * away)
    tip, normal = own.datum - own.heads[1], np.exp(1j * own.alpha)

    def touches(turn: float) -> bool:
        rack_at = 1j * own.roll + own.roll * turn
        spots = curve * np.exp(-1j * turn) - rack_at
        gap = -(spots * normal.conjugate()).real
        feet = spots.imag + own.roll + gap * sin(own.alpha)  # the heights of feet on the flank
        free = feet > tip - 1e-9
        if not free.any():
            return False
        k = int(np.argmin(np.where(free, gap, np.inf)))
        return bool(0 < k < len(curve) - 1 and abs(gap[k]) < 1e-7 and free[max(k - 1, 0)])

    ends = []
    for sense in (-1, 1):
        low, high = middle_of(own, sense), 3 * sense
        for _ in range(50):
            turn = (low + high) / 2
            low, high = (turn, high) if touches(turn) else (low, turn)
        ends.append(low)
    ratio = (ends[1] - ends[0]) * own.z / (2 * pi)
    assert found["contact_ratio"][0] == pytest.approx(ratio, abs=3e-3)
    assert found["contact_ratio_drawn"][0] == pytest.approx(found["contact_ratio"][0], rel=1e-9)


def middle_of(own: Given, sense: int) -> float:
    """A turn within contact, by the places where the tips cut the line of action."""
    string = own.roll * sin(own.alpha)
    first = max(0.0, string - (own.heads[1] - own.datum + own.roll) / sin(own.alpha))
    last = sqrt(own.tip**2 - own.base**2)
    return ((first + last) / 2 - string) / own.base


def test_flanks_slide_as_their_points_of_contact_part() -> None:
    of = pair(GearTask(18, "rack", 0.005, 0.3, speed=10.0))
    found, line = of.results(), of.gear.line
    way = np.exp(1j * radians(20.0))
    for name, end in zip("ab", line.ends, strict=True):
        spot = of.one(end)
        parting = (-10j * spot * of.mm / 1000 - found["v_rolling"][0]) / way
        assert abs(parting.real) < 1e-9
        assert found[f"v_s{name}"][0] == pytest.approx(-parting.imag, rel=1e-9)
        # ϑ: over the velocity of the point along its own flank
        along = (-10j * spot * of.mm / 1000 / way).imag, (found["v_rolling"][0] / way).imag
        stations = of.gear.sliding.ends[name]
        for mark, own in zip(stations.sliding, along, strict=True):
            sense = 1 if own is along[0] else -1
            assert of.real(mark) == pytest.approx(sense * parting.imag / own, rel=1e-9)
    assert found["v_rolling"][0] == pytest.approx(0.45)


@pytest.mark.parametrize("beta", [None, 20.0])
def test_the_distance_of_the_datum_line_gives_the_shift_back(beta: float | None) -> None:
    due = pair(GearTask(23, "rack", 0.004, 0.37, beta=beta)).results()
    found = pair(GearTask(23, "rack", 0.004, distance=due["H"][0], beta=beta)).results()
    for name in ("x1", "r_a1", "contact_ratio", "s1"):
        assert found[name][0] == pytest.approx(due[name][0], rel=1e-9), name


def test_figures_of_the_books() -> None:
    """z_min = 17.1; ε = z(tan α_a − tan α)/2π + 2·h_a(1 − x)/(π sin 2α), of ever more teeth up to 1.981."""
    for z, x in ((18, 0.0), (24, 0.4), (2000, 0.0)):
        due = z / (2 * pi) * (tan(acos(z / 2 * cos(radians(20)) / (z / 2 + 1 + x))) - tan(pi / 9))
        due += 2 * (1 - x) / (pi * sin(radians(40)))
        of = pair(GearTask(z, "rack", 0.01, x))
        assert of.results()["contact_ratio"][0] == pytest.approx(due, rel=1e-12)
        assert of.failed() == set()
    assert 1.97 < due < 1.981
    of = pair(GearTask(17, "rack", 0.01))
    found = of.results()
    assert of.failed() == {("undercut", 1), ("interference", 1)}
    assert round(found["z_min1"][0], 1) == 17.1
    assert found["s2"][0] == pytest.approx(0.005 * pi)
    assert "gear_ratio" not in found


@each(
    "changes, says",
    [
        ({"x2": 0.1}, "x2: a rack has none: leave it out"),
        ({"x_sum": 0.1}, "x_sum: a rack has none"),
        ({"delta_y": 0.1}, "delta_y: a rack has none"),
        ({"x1": 0.1, "distance": 0.1}, "x1 is given, too: leave one of the two out"),
        ({"distance": 0.2}, "x1 = 31 follows: .* give another distance"),
        ({"ha": (2.5, 1.0)}, r"comes to a point above the depth ha \+ c = 2.75"),
    ],
)
def test_what_is_no_rack_is_refused(changes: dict[str, Any], says: str) -> None:
    with pytest.raises(StructureError, match=says):
        pair(replace(GearTask(18, "rack", 0.005), **changes))


def test_a_word_that_is_no_rack_is_refused(tmp_path: Path) -> None:
    text = 'title = "T"\nlanguage = "en"\n[gears]\nz1 = 18\nz2 = "rak"\nm = "5 mm"\n'
    with pytest.raises(SceneError, match='a whole number is wanted, or "rack"'):
        read(written(tmp_path, text))
    order = ASKED.of(read(written(tmp_path, text.replace("rak", "rack"))))
    assert order is not None
    assert order.racked
