"""Curves of all orders of cuts at once, against every tree of cuts tried one by one."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.examples import most

from graphic_tmm.paper.compose.slicing import GRID, NONE, Cut, Leaf, Tree, curve, curves, tree

Size = tuple[int, int]
boxes = st.lists(st.tuples(st.integers(1, 12), st.integers(1, 12)), min_size=1, max_size=5)


def every_size(run: list[Size], first: int, below: tuple[tuple[int, int], ...]) -> Iterator[Size]:
    """What a run of boxes takes, cut in any way that keeps its order: by trying all of them."""
    if len(run) == 1:
        yield run[0]
        return
    for k in range(1, len(run)):
        end = first + len(run)
        split = any(first <= a < first + k <= b < end for a, b in below)
        one = every_size(run[:k], first, below)
        other = list(every_size(run[k:], first + k, below))
        for (w, h), (v, g) in itertools.product(one, other):
            yield max(w, v), h + g
            if not split:
                yield w + v, max(h, g)


def leaves(sizes: list[Size], width: int, height: int) -> list[np.ndarray]:
    return [curve([(w * GRID, h * GRID)], width, height) for w, h in sizes]


@settings(max_examples=most(60), deadline=None)
@given(boxes, st.booleans())
def test_the_curve_of_a_run_is_the_best_of_all_cuts(sizes: list[Size], kept: bool) -> None:
    width, height = 30, 25
    below = ((0, len(sizes) - 1),) if kept and len(sizes) > 1 else ()
    found = curves(leaves(sizes, width, height), height, below)
    due = set(every_size(sizes, 0, below))
    for wide in range(width + 1):
        least = min((h for w, h in due if w <= wide), default=int(NONE))
        got = int(found.heights[len(sizes), 0, wide])
        assert got == least if least <= height else got > height


def extents(part: Tree, sizes: list[Size]) -> Size:
    if isinstance(part, Leaf):
        return sizes[part.place]
    found = [extents(one, sizes) for one in part.parts]
    wide, high = [w for w, _ in found], [h for _, h in found]
    return (sum(wide), max(high)) if part.across else (max(wide), sum(high))


def places(part: Tree) -> list[int]:
    return [part.place] if isinstance(part, Leaf) else [k for p in part.parts for k in places(p)]


@settings(max_examples=most(60), deadline=None)
@given(boxes, st.integers(5, 30), st.integers(5, 25))
def test_cuts_fit_the_sheet_and_keep_the_order(sizes: list[Size], width: int, height: int) -> None:
    found = tree(curves(leaves(sizes, width, height), height), width, height)
    fitting = any(w <= width and h <= height for w, h in every_size(sizes, 0, ()))
    assert (found is not None) == fitting
    if found is not None:
        wide, high = extents(found, sizes)
        assert wide <= width
        assert high <= height
        assert places(found) == list(range(len(sizes)))


def test_what_stands_below_is_never_cut_off_sideways() -> None:
    sizes = [(10, 4), (3, 3), (10, 4)]
    found = tree(curves(leaves(sizes, 40, 20), 20, ((0, 2),)), 40, 20)
    assert isinstance(found, Cut)

    def apart(part: Tree) -> bool:
        if isinstance(part, Leaf):
            return False
        home = [k for k, one in enumerate(part.parts) if {0, 2} & set(places(one))]
        return part.across if len(home) == 2 else apart(part.parts[home[0]])

    assert not apart(found)
    assert tree(curves(leaves(sizes, 40, 7), 7, ((0, 2),)), 40, 7) is None
    assert tree(curves(leaves(sizes, 40, 7), 7), 40, 7) is not None


@pytest.mark.parametrize("length", [0.0, 0.5, 2.0, 2.0000001, 7.3])
def test_a_length_in_steps_is_no_shorter(length: float) -> None:
    (found,) = np.flatnonzero(curve([(length, 2.0)], 10, 10) == 1)[:1]
    assert found * GRID >= length - 1e-5
    assert (found - 1) * GRID < length
