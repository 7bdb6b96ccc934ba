"""Plates on tracing paper: laid on arcs and guides, joined by links, or on nothing."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.board.geometry import cis
from graphic_tmm.board.operations.joined import trace_joined
from graphic_tmm.board.operations.slots import trace_on_guide_past, trace_past, trace_past_both
from graphic_tmm.board.operations.tracing import (
    prick,
    trace,
    trace_on_guide,
    trace_on_guides,
)
from graphic_tmm.board.values import Arc, Line

rng = np.random.default_rng(40)
N = 400


def case(guides: int) -> tuple[tuple[object, ...], Line, Line]:
    """Plates laid at random with loci through their three points; near angles some degrees off; the answer."""
    b = rng.uniform(-90, 90, (1, N)) + 1j * rng.uniform(-90, 90, (1, N))
    way = rng.uniform(0, 360, (1, N))
    c, x, y = rng.uniform(40, 90, (1, N)), rng.uniform(-60, 60, (1, N)), rng.uniform(20, 60, (1, N))
    pins = b, b + c * cis(way), b + (x + 1j * y) * cis(way)
    loci: list[object] = []
    turned = rng.uniform(0, 360, (3, 1, N))
    for k, pin in enumerate(pins):
        if k < 3 - guides:
            radius = rng.uniform(60, 120, (1, N))
            loci.append(Arc(pin - radius * cis(turned[k]), radius))
        else:
            loci.append(Line(pin - 30 * cis(turned[k]), cis(turned[k])))
    off = rng.uniform(-0.2, 0.2, (2, 1, N))
    uses = (*loci, c, x, y, turned[0] + off[0], way + off[1])
    return uses, Line(b, cis(way)), Line(cis(turned[0]), cis(way))


@pytest.mark.parametrize(("op", "guides"), [(trace, 0), (trace_on_guide, 1), (trace_on_guides, 2)])
def test_a_plate_is_laid_where_its_loci_are(op: object, guides: int) -> None:
    uses, answer, _ = case(guides)
    found = op.run(*uses)  # type: ignore[attr-defined]
    there = np.isfinite(found.along)
    assert there.mean() > 0.95
    off = np.abs(found.at - answer.at) + 90 * np.abs(found.along - answer.along)
    # near a place where the plate is not held the other of two is as near: few, and on its loci all the same
    assert (off[there] < 1e-9).mean() > 0.97


def test_a_plate_that_cannot_be_laid_is_none() -> None:
    uses, _, _ = case(0)
    first, second, third, *others = uses
    assert isinstance(second, Arc)
    far = Arc(second.centre + 1000.0, second.radius)
    with np.errstate(all="raise", under="ignore", over="ignore", invalid="ignore", divide="ignore"):
        found = trace.run(first, far, third, *others)
    assert np.isnan(found.along).all()
    assert np.isnan(prick.run(found)).all()


def test_another_place_far_off_is_none() -> None:
    uses, _, _ = case(0)
    *loci, leg, plate = uses
    found = trace.run(*loci, leg, plate + 120.0)  # type: ignore[operator]
    turned = np.abs(np.angle(found.along / cis(plate + 120.0)))  # type: ignore[operator, arg-type]
    assert not np.nanmax(turned, initial=0.0) > np.radians(45.6)


SLOTTED = {
    "past": (trace_past, 1, 0),
    "guide": (trace_on_guide_past, 1, 1),
    "both": (trace_past_both, 2, 0),
}


@pytest.mark.parametrize("name", SLOTTED)
def test_a_plate_is_laid_with_its_guides_where_they_pass(name: str) -> None:
    op, slots, guides = SLOTTED[name]
    (first, second, _, c, _, _, leg, plate), answer, _ = case(1 + guides)
    assert isinstance(c, np.ndarray)
    pivots = rng.uniform(-90, 90, (2, 1, N)) + 1j * rng.uniform(-90, 90, (2, 1, N))
    bend = rng.uniform(0, 360, (1, N))
    ways = cis(0.0 * bend) * answer.along, cis(bend) * answer.along
    arms = [
        (np.conj(way) * (pivot - answer.at)).imag for way, pivot in zip(ways, pivots, strict=True)
    ]
    if slots == 1:
        found = op.run(first, second, pivots[1], c, arms[1], bend, leg, plate)
    else:
        found = op.run(first, *pivots, *arms, bend, leg, plate)
    there = np.isfinite(found.along)
    assert there.mean() > 0.9
    off = np.abs(found.at - answer.at) + 90 * np.abs(found.along - answer.along)
    assert (off[there] < 1e-9).mean() > 0.95


def joined() -> tuple[list[np.ndarray], Line]:
    """Plates laid at random about pivots, links between them; near angles some degrees off; the first link."""
    to = rng.uniform(-90, 90, (1, N)) + 1j * rng.uniform(-90, 90, (1, N))
    at = to + rng.uniform(80, 160, (1, N)) * cis(rng.uniform(0, 360, (1, N)))
    ways = rng.uniform(0, 360, (2, 1, N))
    b, c = rng.uniform(40, 90, (2, 1, N))
    bx, cx = rng.uniform(-60, 60, (2, 1, N))
    by, cy = rng.uniform(20, 60, (2, 1, N))
    pins = (b + 0j, bx + 1j * by), (c + 0j, cx + 1j * cy)
    ends = [
        start + pin * cis(way)
        for start, way, two in zip((to, at), ways, pins, strict=True)
        for pin in two
    ]
    links = abs(ends[2] - ends[0]), abs(ends[3] - ends[1])
    off = rng.uniform(-0.2, 0.2, (2, 1, N))
    answer = Line(ends[0], (ends[2] - ends[0]) / links[0])
    return [to, at, b, bx, by, c, cx, cy, *links, ways[0] + off[0], ways[1] + off[1]], answer


def test_joined_plates_are_laid_where_both_links_fit() -> None:
    uses, answer = joined()
    found = trace_joined.run(*uses)
    there = np.isfinite(found.along)
    assert there.mean() > 0.95
    off = np.abs(found.at - answer.at) + 90 * np.abs(found.along - answer.along)
    assert (off[there] < 1e-9).mean() > 0.97


def test_joined_plates_with_a_link_too_long_are_none() -> None:
    uses, _ = joined()
    uses[8] = uses[8] + 1000.0
    with np.errstate(all="raise", under="ignore", over="ignore", invalid="ignore", divide="ignore"):
        assert np.isnan(trace_joined.run(*uses).along).all()


def crossing(first: np.ndarray, to: np.ndarray, second: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return where the lines through two pairs of points cross."""
    p, q = to - first, end - second
    share = (np.conj(second - first) * q).imag / (np.conj(p) * q).imag
    return np.asarray(first + share * p)


SIZES = pytest.mark.parametrize("size", [2.0**-40, 1.0, 2.0**40])


@SIZES
def test_a_plate_whose_legs_go_through_one_point_is_laid_at_no_size(size: float) -> None:
    (first, second, _, c, x, y, leg, plate), answer, true = case(0)
    assert isinstance(first, Arc)
    assert isinstance(second, Arc)
    leg, plate = (np.degrees(np.angle(one)) for one in true)
    third_pin = answer.at + (x + 1j * y) * answer.along  # type: ignore[operator]
    second_pin = answer.at + c * answer.along  # type: ignore[operator]
    special = crossing(first.centre, answer.at, second.centre, second_pin)
    way = (special - third_pin) / np.abs(special - third_pin)
    arcs = [
        Arc(one.centre * size, one.radius * size)
        for one in (first, second, Arc(third_pin + 80.0 * way, np.full((1, N), 80.0)))
    ]
    lengths = [one * size for one in (c, x, y)]  # type: ignore[operator]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        found = trace.run(*arcs, *lengths, leg, plate)
    # of a special point that is far off rounding leaves little
    near = np.abs(special - answer.at) < 300.0
    assert near.mean() > 0.5
    # a correction from there may lead to another of its places
    assert not (np.abs(found.along - answer.along)[near] < 1e-3).any()
    assert np.isnan(found.along[near]).mean() > 0.9


@SIZES
def test_joined_plates_whose_pivots_lie_in_line_with_their_links_are_laid_at_no_size(
    size: float,
) -> None:
    uses, _ = joined()
    to, _, b, bx, by, *_ = uses
    turned = rng.uniform(0, 360, (1, N))
    pins = to + b * cis(turned), to + (bx + 1j * by) * cis(turned)
    others = pins[0] + 100.0 * cis(turned + 70.0), pins[1] + 80.0 * cis(turned + 130.0)
    special = crossing(pins[0], others[0], pins[1], others[1])
    at = special + 0.4 * (to - special)
    arms = [other - at for other in others]
    lies = arms[0] / np.abs(arms[0])
    own = arms[1] / lies
    lengths = [to, at, b, bx, by, np.abs(arms[0]), own.real, own.imag]
    lengths += [np.full((1, N), 100.0), np.full((1, N), 80.0)]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        found = trace_joined.run(
            *(one * size for one in lengths), turned, np.degrees(np.angle(lies))
        )
    assert not (np.abs(found.along - cis(turned + 70.0)) < 1e-3).any()
    assert np.isnan(found.along).mean() > 0.9
