"""Cursors run on the sheet's own curves: at the positions they tell what was read there."""

from __future__ import annotations

import numpy as np
import pytest
from support import gallery

from graphic_tmm.board.values import Curve
from graphic_tmm.page.cursors import Cursor, cursors
from graphic_tmm.page.dense import Dense, dense
from graphic_tmm.paper.drawing import Bezier, Drawing

SCENES = ["engine", "slider-diagrams", "locomobile", "windrower", "four-stroke", "v-engine"]


def _found(name: str) -> tuple[Dense, list[Cursor]]:
    made, sheets = gallery.paper(name)
    assert made.mechanism is not None
    found = dense(made.mechanism)
    assert found is not None
    return found, list(cursors(found, made.mechanism, sheets))


@pytest.mark.parametrize("name", SCENES)
def test_every_curve_of_a_chart_that_a_sheet_shows_has_its_cursor(name: str) -> None:
    made, sheets = gallery.paper(name)
    assert made.mechanism is not None
    _, found = _found(name)
    charts = {chart.view for chart in made.mechanism.project.charts}
    log = made.mechanism.construction
    curves = {s.it.slot for s in log.steps if s.it.kind is Curve and s.it.view in charts}
    shown = {
        stroke.of[0]
        for sheet in sheets
        for view in sheet.drawings
        for stroke in view.strokes
        if isinstance(stroke, Bezier) and len(stroke.of) == 1 and set(view.shows) & charts
    }
    assert {one.curve for one in found} == curves & shown
    assert all(np.isfinite(one.spots).all() for one in found)


@pytest.mark.parametrize("name", SCENES)
def test_at_the_positions_a_cursor_tells_what_was_read(name: str) -> None:
    """To a division of the ruler; where a curve is no graph over a base its foot is measured too."""
    made, _ = gallery.paper(name)
    assert made.mechanism is not None
    dense_, found = _found(name)
    ruler = made.mechanism.hand.ruler or 0.1
    compared = 0
    for one in found:
        if one.reading is None or not one.upright:
            continue
        row = np.broadcast_to(made.mechanism.reading[one.reading][0], (len(made.mechanism.names),))
        told = (one.spots[list(dense_.at)] - one.origin).imag
        count = made.mechanism.project.count
        assert np.nanmax(np.abs(told[:count] - row[:count])) <= ruler
        compared += 1
    assert compared


def _nearest(view: Drawing, curve: int, spot: complex) -> float:
    best = np.inf
    u = np.linspace(0.0, 1.0, 400)
    for stroke in view.strokes:
        if isinstance(stroke, Bezier) and stroke.of == (curve,):
            z = np.array(stroke.controls)
            for k in range(0, z.size - 1, 3):
                a, b, c, d = z[k : k + 4]
                path = (
                    a * (1 - u) ** 3 + 3 * b * u * (1 - u) ** 2 + 3 * c * u**2 * (1 - u) + d * u**3
                )
                best = min(best, float(np.abs(path - spot).min()))
    return best


@pytest.mark.parametrize("name", ["engine", "slider-diagrams", "four-stroke"])
def test_between_positions_cursors_stand_on_the_ink_of_the_sheet(name: str) -> None:
    _, sheets = gallery.paper(name)
    _, found = _found(name)
    views = [view for sheet in sheets for view in sheet.drawings]
    for one in found:
        view = next(v for v in views if any(_inked(v, one.curve)))
        for k in (13, 101, 247):
            assert _nearest(view, one.curve, complex(one.spots[k])) < 0.15


def _inked(view: Drawing, curve: int) -> list[bool]:
    return [True for s in view.strokes if isinstance(s, Bezier) and s.of == (curve,)]
