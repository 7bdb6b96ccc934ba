"""What a page draws across the positions of its sheet, with other givens, is what Python draws."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from support import gallery
from support.live_logs import (
    CASES,
    DUST,
    NEAR,
    Floats,
    across_by_page,
    changed,
    largest,
    live_page,
    turning,
)

from graphic_tmm.board.execute import execute
from graphic_tmm.board.values import Curve, arrays

WRITTEN = {
    "engine": {"energy": "J_F", "energy-mass": "J_F′", "moment": "h"},
    "project": {"energy": "J_F", "energy-mass": "J_F′", "diagram a": "a"},
    "slider-diagrams": {"diagram V": "V", "diagram a": "a"},
    "v-engine": {"energy": "J_F", "work": "A_N"},
    "windrower": {"energy": "J_F", "energy-mass": "J_F′", "flywheel-calculation": "δ′"},
}
"""Marks that hang on what is drawn across positions, by scene and view: all of them follow."""


def rows_of(value: Any, count: int) -> Floats:
    """Return the numbers of a value as rows, one for each position; of a curve one row of all."""
    parts = [np.asarray(part[0]) for part in arrays(value)]
    flat = [
        number
        for part in parts
        for number in ((part.real, part.imag) if np.iscomplexobj(part) else (part,))
    ]
    if isinstance(value, Curve):
        pairs = [np.stack(two, axis=1).ravel() for two in (flat[:2], flat[2:])]
        return np.concatenate(pairs)[None, :]
    return np.stack([np.broadcast_to(row, (count,)) for row in flat], axis=1)


def told_of(table: list[list[Any]], slot: int, width: int) -> Floats:
    """Return the numbers of a mark as a page tells them; what is not there is missing in all of them."""
    rows = [one[slot] if len(one[slot]) >= width else [None] * width for one in table]
    return np.array([row[:width] for row in rows], dtype=float)


@pytest.mark.parametrize("name", turning())
def test_rows_are_those_of_python(name: str) -> None:
    """Whatever is given, every mark in the positions of the sheet is what the log has there."""
    page = live_page(gallery.drawn(name))
    if page is None or not page.log.across:
        pytest.skip("nothing is drawn across positions")
    sheet = page.found.sheet
    cases = [changed(page, n) for n in range(CASES)]
    for case, table in zip(cases, across_by_page(page, cases), strict=True):
        due = execute(sheet.construction, {**sheet.given, **case})
        sizes: dict[tuple[str, str, str], float] = {}
        apart: list[tuple[tuple[str, str, str], str, float]] = []
        for step in (*page.log.still, *page.log.turn, *page.log.across):
            mark = step.it
            own = rows_of(due[mark], len(table))
            found = told_of(table[: len(own)], mark.slot, own.shape[1])
            there = np.isfinite(own).all(axis=1)
            if not isinstance(due[mark], Curve):
                np.testing.assert_array_equal(there, np.isfinite(found).all(axis=1), str(mark.key))
            kind = (str(mark.kind), mark.unit, mark.view)
            sizes[kind] = max(sizes.get(kind, 0.0), largest(own))
            apart.append((kind, mark.letter, largest(own - found)))
        least = least_sizes(sizes)
        for kind, letter, off in apart:
            assert off <= NEAR * max(sizes[kind], least[kind[:2]]), (kind, letter)


def least_sizes(sizes: Mapping[tuple[str, str, str], float]) -> dict[tuple[str, str], float]:
    """Return what differences count against at least: sums that cancel leave dust, percents of dust."""
    found: dict[tuple[str, str], float] = {}
    for (kind, unit, _), size in sizes.items():
        of = 1.0 if unit == "%" else DUST * size
        found[kind, unit] = max(found.get((kind, unit), 1e-300), of)
    return found


@pytest.mark.parametrize(("scene", "marks"), WRITTEN.items())
def test_diagrams_and_flywheels_are_written_down(scene: str, marks: Mapping[str, str]) -> None:
    page = live_page(gallery.drawn(scene))
    assert page is not None
    there = {step.it.key for step in (*page.log.live, *page.log.across)}
    assert {*marks.items()} <= there
    assert not {mark for mark in there if mark[0] in marks} & {s.it.key for s in page.log.sheet}


def test_what_stands_at_every_angle_follows_from_what_is_drawn_across() -> None:
    """The stroke of the project's slider, found across the row, moves the force on it at every angle."""
    page = live_page(gallery.drawn("project"))
    assert page is not None
    names = {
        mark.name for step in page.log.after for mark in step.uses if mark.slot in page.log.carried
    }
    assert names
    assert {step.it.view for step in page.log.after} >= {"forces 4-5", "lever"}
