"""The log that a page runs with other givens has of every mark what Python has of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from support import gallery, strangers
from support.live_logs import (
    CASES,
    DUST,
    NEAR,
    Floats,
    LivePage,
    by_page,
    changed,
    largest,
    live_page,
    turning,
)

from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import again
from graphic_tmm.board.values import Point, arrays

ANGLES = 9


def off(page: LivePage, due: Mapping[int, object], told: list[list[Any]], at: list[int]) -> float:
    """Return by how much a mark is off at most, as a share of the largest of its kind in its view.

    Where these are nothing but rounding, as differences in % and moments that cancel are, they count against
    the largest of the kind in all views, or 1 %.
    """
    rows: dict[tuple[str, str], dict[str, list[tuple[Floats, Floats]]]] = {}
    for step in page.log.live:
        mark = step.it
        flat: list[Floats] = []
        for part in arrays(due[mark.slot]):
            row = np.broadcast_to(part[0], page.found.turned.shape)[at]
            flat += [row.real, row.imag] if np.iscomplexobj(row) else [row]
        found = np.array([one[mark.slot] for one in told], dtype=float)
        of = rows.setdefault((str(mark.kind), mark.unit), {})
        of.setdefault(mark.view, []).append((np.stack(flat, axis=1), found))
    worst = 0.0
    for (_, unit), views in rows.items():
        sizes = {view: max(largest(one) for one, _ in pairs) for view, pairs in views.items()}
        least = 1.0 if unit == "%" else DUST * max(sizes.values())
        for view, pairs in views.items():
            for one, other in pairs:
                np.testing.assert_array_equal(np.isfinite(one), np.isfinite(other))
                apart = largest(one - other)
                worst = max(worst, apart / max(sizes[view], least) if apart else 0.0)
    return worst


@pytest.mark.parametrize("name", turning())
def test_numbers_are_those_of_python(name: str) -> None:
    """Whatever is given, every mark that follows at an angle is what the log has there."""
    page = live_page(gallery.drawn(name))
    if page is None:
        pytest.skip("nothing turns")
    judge(page)


@pytest.mark.parametrize("case", ["slotting", "six", "rotary", "row12-lock"])
def test_numbers_of_strangers_are_too(case: str) -> None:
    page = live_page(strangers.mechanism_of(case))
    assert page is not None
    known = {step.it for step in (*page.log.still, *page.log.turn)} | page.log.own.keys()
    points = {step.it for step in page.found.log.steps if step.it.kind is Point}
    assert {point for point in points if point.view == "positions"} <= known
    judge(page)


def judge(page: LivePage) -> None:
    """Hold the numbers of a page against those of Python."""
    cases = [changed(page, n) for n in range(CASES)]
    at = [k * page.found.whole // ANGLES for k in range(ANGLES)]
    for case, told in zip(cases, by_page(page, cases, at), strict=True):
        sheet = page.found.sheet
        across = execute(sheet.construction, {**sheet.given, **case}, page.log.known)
        carried = {mark: across[mark] for mark in page.log.known}
        given = {**page.found.given, **page.log.own, **case, **carried}
        due = execute(again(page.found.log, given), given)
        assert off(page, due.values, told, at) <= NEAR
