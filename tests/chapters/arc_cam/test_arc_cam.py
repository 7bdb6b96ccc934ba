"""Cams given by arcs against a follower lowered onto points of the contour until it touches."""

from __future__ import annotations

import math
import random
from dataclasses import replace

import numpy as np
import pytest
from support.arc_cams import FLANKS, FLATS, KINDS, contour, drawn, lowest, place, random_order
from support.each import each

from graphic_tmm.board.bounds import TaskError
from graphic_tmm.chapters.arc_cam.geometry import lie
from graphic_tmm.chapters.arc_cam.task import FLAT, FLAT_ROCKER, ROCKER, ArcTask, Flank

CASES = [
    (kind, flank)
    for kind in KINDS
    for flank in FLANKS
    if not (kind in FLATS and flank in ("straight", "hollow"))
]
FINE = 4000
"""Points of each circle: they lie up to 1/8·(2π/4000)² = 3·10⁻⁷ of a radius inside their chords."""


def near(order: ArcTask) -> float:
    """How far the follower lowered onto the points may be off (m, or rad)."""
    sagitta = 0.125 * (2 * math.pi / FINE) ** 2 * (order.distance + order.nose)
    return 20.0 * sagitta / arm(order)


def arm(order: ArcTask) -> float:
    """About how far a lever's pivot stands from what it touches, m; 1 for a follower that slides."""
    return order.lever or (0.8 * order.centres if order.centres else 1.0)


@pytest.mark.parametrize(("kind", "flank"), CASES)
def test_the_follower_stands_where_it_touches_the_contour(kind: str, flank: str) -> None:
    order = random_order(random.Random(f"{kind} {flank}"), kind, flank)
    made, _, reading = drawn(order)
    begin, lines = made.lie.changes[0], contour(order, FINE)
    due = np.array([place(order, begin + angle, lines) for angle in made.angles]) - lowest(order)
    found = reading[made.follower.travel][0]
    found = np.radians(found) if order.rocks else found * _mu(made, reading)
    assert np.isfinite(found).all()
    assert np.abs(found - due).max() < near(order)
    assert due.max() > 0.3 * (order.distance + order.nose - order.base) / arm(order)


@pytest.mark.parametrize("same_sense", [False, True])
@pytest.mark.parametrize("centres", [0.062, 0.08, 0.5])
def test_a_flat_lever_never_leaves_a_convex_cam(centres: float, same_sense: bool) -> None:
    """Not where it ends its work behind a whole turn from the cam's axis."""
    flank, size = Flank(0.095), {"centres": centres, "same_sense": same_sense}
    order = ArcTask(0.012, 0.046, 0.011, flank, flank, follower=FLAT_ROCKER, **size)
    made, _, reading = drawn(order)
    begin, lines = made.lie.changes[0], contour(order, FINE)
    due = np.array([place(order, begin + angle, lines) for angle in made.angles]) - lowest(order)
    found = np.radians(reading[made.follower.travel][0])
    assert np.abs(found - due).max() < near(order)
    assert 0.0 < made.lie.work < 360.0


def _mu(made, reading) -> float:  # type: ignore[no-untyped-def]
    return float(reading[made.contour.mu][0, 0])


@pytest.mark.turns(7)
@pytest.mark.slow
@pytest.mark.parametrize(("kind", "flank"), CASES)
def test_the_instant_centre_tells_the_derivative(kind: str, flank: str) -> None:
    """Against the difference of two places a little apart; not where the follower goes from arc to arc."""
    order = random_order(random.Random(f"{kind} {flank} rate"), kind, flank)
    made, _, reading = drawn(order)
    lines = contour(order, 5_000)
    found = np.broadcast_to(reading[made.follower.rate], (1, len(made.angles)))[0]
    begin, step = made.lie.changes[0], 1.0
    changes = [angle - begin for angle in made.lie.changes]
    tried = 0
    for angle, rate in zip(made.angles, found, strict=True):
        if min(abs(angle - change) for change in changes) < 1.5 * step:
            continue
        ends = [place(order, begin + angle + way * step / 2, lines) for way in (-1, 1)]
        due = (ends[1] - ends[0]) / math.radians(step)
        scale = order.distance / arm(order)
        assert rate == pytest.approx(due, abs=3e-3 * scale)
        tried += 1
    assert tried > 10


@pytest.mark.parametrize("kind", ["central", "offset", "flat", "against"])
def test_chords_come_near_the_instant_centre(kind: str) -> None:
    """A chord's slope is the mean of its interval: off by what the second derivative leaps within it."""
    order = replace(random_order(random.Random(kind), kind, "convex"), parts=64)
    made, _, reading = drawn(order)
    chart = made.charts["V"]
    mu = float(reading[chart.mu][0, 0])
    chords = reading[chart.ordinates[0]][0, : order.parts] * mu
    rate = np.broadcast_to(reading[made.follower.rate], (1, len(made.angles)))[0, : order.parts]
    assert np.abs(chords - rate).max() < 0.04 * np.abs(rate).max()


def test_a_tangential_cam_has_its_known_motion() -> None:
    """On a straight flank S = (r1 + r)·(1/cos φ − 1), on the nose the rod of d and r2 + r (textbooks)."""
    order = ArcTask(0.02, 0.022, 0.007, Flank(None), Flank(None), roller=0.01, parts=24)
    made, _, reading = drawn(order)
    found = reading[made.follower.travel][0] * _mu(made, reading)
    beta = math.asin((order.base - order.nose) / order.distance)
    top = math.pi / 2 - beta  # from the beginning of the rise
    onto = math.atan2(order.distance * math.cos(beta), order.base + order.roller)
    for angle, value in zip(map(math.radians, made.angles), found, strict=True):
        turned = min(angle, 2 * top - angle)
        if turned <= onto:
            due = (order.base + order.roller) * (1 / math.cos(turned) - 1)
        else:
            psi, arm = top - turned, order.nose + order.roller
            due = order.distance * math.cos(psi)
            due += math.sqrt(arm**2 - (order.distance * math.sin(psi)) ** 2)
            due -= order.base + order.roller
        assert value == pytest.approx(due, abs=1e-12)
    assert made.lie.work == pytest.approx(math.degrees(2 * top))
    assert reading[made.follower.work].item() == pytest.approx(made.lie.work, abs=1e-9)


def test_a_harmonic_cam_lifts_its_flat_face_as_its_name_says() -> None:
    """On a convex flank S = (ρ − r1)·(1 − cos φ) (textbooks)."""
    order = ArcTask(0.02, 0.018, 0.006, Flank(0.06), Flank(0.06), follower=FLAT, parts=24)
    made, _, reading = drawn(order)
    found = reading[made.follower.travel][0] * _mu(made, reading)
    onto = made.lie.changes[1] - made.lie.changes[0]
    on_flank = [k for k, angle in enumerate(made.angles) if angle <= onto]
    assert len(on_flank) > 3
    for k in on_flank:
        due = 0.04 * (1 - math.cos(math.radians(made.angles[k])))
        assert found[k] == pytest.approx(due, abs=1e-12)


BASE = ArcTask(0.02, 0.022, 0.006, Flank(0.06), Flank(0.06), roller=0.01)
REFUSED = (
    ("nose", {"nose": 0.02}, "not smaller than the base circle"),
    ("distance", {"distance": 0.013}, "greater than 14 mm"),
    ("flank", {"rise": Flank(0.02)}, "greater than 24 mm"),
    ("return_flank", {"fall": Flank(0.023)}, "greater than 24 mm"),
    ("flank", {"rise": Flank(None), "follower": FLAT, "roller": 0.0}, "take an arc, or a roller"),
    ("hollow", {"rise": Flank(0.06, True), "follower": FLAT}, "leave hollow out"),
    ("hollow", {"rise": Flank(None, True)}, "leave hollow out"),
    ("roller", {"rise": Flank(0.009, True), "roller": 0.0095}, "smaller roller"),
    ("offset", {"offset": -0.031}, "less than 30 mm"),
    ("lever", {"follower": ROCKER, "lever": 0.02, "centres": 0.07}, "change lever or centres"),
    ("centres", {"follower": ROCKER, "lever": 0.045, "centres": 0.0279}, "more than 28 mm"),
    ("centres", {"follower": FLAT_ROCKER, "centres": 0.0379}, "more than 38 mm"),
    ("flank", {"rise": Flank(None), "follower": FLAT_ROCKER, "centres": 0.08}, "take an arc"),
)


@pytest.mark.every
@each("key, wrong, remedy", REFUSED)
def test_what_cannot_be_is_refused_with_its_key(key: str, wrong: dict, remedy: str) -> None:  # type: ignore[type-arg]
    lie(BASE)
    with pytest.raises(TaskError, match=remedy) as found:
        lie(replace(BASE, **wrong))
    assert found.value.key == ("arc_cam", key)


def test_a_follower_that_leaves_the_cam_is_refused() -> None:
    """A deep hollow flank: the edge's line would meet the nose before it has left the flank."""
    deep = ArcTask(0.02, 0.06, 0.002, Flank(0.045, True), Flank(0.045, True), offset=0.0195)
    with pytest.raises(TaskError, match="all the way round"):
        lie(deep)


@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_a_cam_that_turns_the_other_way_is_its_mirror_image(turns: str) -> None:
    order = random_order(random.Random("mirror"), "offset", "unlike")
    one, _, first = drawn(replace(order, turns=turns))
    other, _, second = drawn(replace(order, turns="clockwise"))
    assert np.allclose(first[one.follower.travel], second[other.follower.travel], atol=1e-9)
    assert np.allclose(first[one.follower.rate], second[other.follower.rate], atol=1e-12)


def test_a_sharp_nose_under_an_edge_has_no_arc_of_its_own() -> None:
    order = replace(BASE, nose=0.0, roller=0.0)
    made, _, reading = drawn(order)
    assert made.lie.changes[1] == pytest.approx(made.lie.changes[2])
    found = reading[made.follower.travel][0] * _mu(made, reading)
    assert found.max() == pytest.approx(order.distance - order.base, abs=1e-12)
