"""The ink that moves with the crank: at the sheet's positions the sheet's own, between them the chapter's."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

import numpy as np
import pytest
from support import gallery

from graphic_tmm.drawn import Drawn
from graphic_tmm.page.dense import Dense, dense
from graphic_tmm.page.letters import glide, lettered
from graphic_tmm.page.strands import (
    NEAR,
    STEP,
    Letter,
    Moving,
    MovingFigures,
    MovingStroke,
    Strands,
    folded,
    line_key,
    spread,
    strands,
    unfolded,
)
from graphic_tmm.paper.drawing import Stroke

EXACT = 1e-3
"""What is told of ink, mm."""


def _dense(name: str) -> Dense:
    found = dense(gallery.in_usual(name))
    assert found is not None
    return found


def _moving(drawn: Drawn) -> Iterator[Moving]:
    for chapter in drawn.project.chapters:
        yield from MovingFigures.of(chapter).figures(drawn)


def _ink(moving: Moving, k: int) -> dict[MovingStroke, list[float]]:
    met = Counter[object]()
    return {
        line_key(one, met): [value for vertex in one.path for value in vertex]
        for one in moving.at(k).strokes
        if isinstance(one, Stroke)
    }


@pytest.mark.turns(2)
@pytest.mark.parametrize("name", gallery.NAMES)
@pytest.mark.slow
def test_at_the_positions_ink_is_that_of_the_sheet(name: str) -> None:
    found = _dense(name)
    own = {one.name: one for one in _moving(found.sheet)}
    for moving in _moving(found.drawn):
        made = strands(found, moving)
        shown = found.sheet.row(moving.name)
        for k, place in enumerate(found.at):
            if k not in shown or k in found.sheet.undrawn or k >= found.sheet.project.count:
                continue
            row = made.drawn.index(place)
            due = _ink(own[moving.name], k)
            there = {
                key
                for key, rows in made.rows.items()
                if isinstance(key, MovingStroke) and np.isfinite(rows[row, 0])
            }
            assert there == due.keys(), (moving.name, k)
            for key, values in due.items():
                np.testing.assert_allclose(made.rows[key][row], values, rtol=0.0, atol=EXACT)


@pytest.mark.parametrize(
    "name",
    [
        "oscillating-cylinder",
        *(pytest.param(n, marks=pytest.mark.slow) for n in ("windrower", "lever")),
    ],
)
def test_between_drawn_angles_ink_is_near_to_what_the_chapter_draws(name: str) -> None:
    """Where it bends sharply (a head begins to shrink with its arrow) to 0.3 mm; heads to half their width."""
    found = _dense(name)
    for moving in _moving(found.drawn):
        made = strands(found, moving)
        rows = made.at(found.whole, made.rows)
        for k in range(2, found.whole, 7):
            for key, values in _ink(moving, k).items():
                off = np.abs(rows[key][k] - values).max()
                assert off <= (1.0 if key.filled else 6 * NEAR), (moving.name, k, key)


def test_what_lies_between_four_places_of_a_cubic_is_on_it() -> None:
    whole, refined = 60, (4, 11)
    at = np.arange(whole, dtype=float)
    row = np.where(at < 21.0, 1.0 + at, 1e-4 * (at - 40.0) ** 3)[:, None]
    drawn = [*range(0, whole, STEP), *range(21, 25), *range(56, 60)]
    found = spread(row[drawn], whole, refined)
    np.testing.assert_allclose(found, row, atol=1e-9)


def test_folded_rows_come_back() -> None:
    source = np.random.default_rng(1)
    row = source.integers(-100_000, 100_000, 12 + 8 + 1)
    for refined in ((3, 11), (0, 5)):
        told = folded(row, 60, refined)
        np.testing.assert_array_equal(unfolded(told, 60, refined), row)


def test_letters_stand_where_the_sheet_has_them_and_glide_between() -> None:
    made, sheets = gallery.paper("crank-rocker")
    assert made.mechanism is not None
    found = dense(made.mechanism)
    assert found is not None
    shown = {view.name: view for sheet in sheets for view in sheet.drawings}
    checked = 0
    for moving in _moving(found.drawn):
        ink = strands(found, moving)
        places = lettered(found, moving, ink, shown)
        checked += _as_on_sheet(found, moving, ink, places, shown)
        for row in places.values():
            base = row[: found.whole // STEP]
            off = np.abs(np.diff(base, axis=0, append=base[:1]))
            own = np.nanmax(np.abs(base), initial=1.0)
            assert np.nanmax(off, initial=0.0) < 0.6 * own + 10.0
    assert checked > 10


def _as_on_sheet(found, moving, ink: Strands, places, shown) -> int:  # type: ignore[no-untyped-def]
    checked = 0
    for k, place in enumerate(found.at):
        view = shown.get(moving.on_sheet(found.sheet.names[k]))
        if view is None or len(view.numbers) > 1:
            continue
        for key, row in places.items():
            label = next(
                (one for one in view.labels if (one.of, one.text) == (key.of, key.text)), None
            )
            here = row[ink.drawn.index(place)]
            if label is None or key.ordinal > 1 or not np.isfinite(here[0]):
                continue
            due = label.at - view.origin(moving.name)
            assert label.anchor == "start"
            assert abs(complex(*here) - due) < 0.05
            checked += 1
    return checked


def test_letters_go_the_shorter_way_round() -> None:
    where, asides = np.array([0.0, 90.0]), np.array([3.0 * np.exp(3.0j), 5.0 * np.exp(-3.0j)])
    found = glide(where, asides, np.array([0.0, 45.0, 90.0]), 360.0)
    np.testing.assert_allclose(found[[0, 2]], asides)
    np.testing.assert_allclose(np.abs(found), [3.0, 4.0, 5.0])
    assert abs(abs(np.angle(found[1])) - np.pi) < 1e-9


def test_letters_and_lines_are_told_apart() -> None:
    found = strands(
        _dense("oscillating-cylinder"), next(_moving(_dense("oscillating-cylinder").drawn))
    )
    kinds = {type(key) for key in found.rows}
    assert kinds == {MovingStroke, Letter}
