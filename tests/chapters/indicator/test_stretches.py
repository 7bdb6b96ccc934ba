"""Indicator diagrams given as points or as polytropic strokes: the pressure of every position."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import SHEETS

from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.indicator.task import Gas, IndicatorTask, Stretch
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import SheetOrder

BORE, C = 0.12, 0.08
STEAM = (
    Stretch("out", 0.0, 0.3, 600e3, 0.0),  # admission
    Stretch("out", 0.3, 1.0, 600e3, 1.0),  # expansion
    Stretch("back", 1.0, 0.25, 110e3, 0.0),  # exhaust
    Stretch("back", 0.25, 0.0, 110e3, 1.2),  # compression
)
TRACED = (
    Stretch("out", 0.0, 0.4, 300e3, None, 260e3),
    Stretch("out", 0.4, 1.0, 260e3, None, 60e3),
    Stretch("back", 1.0, 0.5, 30e3, None, 40e3),
    Stretch("back", 0.5, 0.0, 40e3, None, 150e3),
)


def drawn(*stretches: Stretch, count: int = 12, extra: tuple[float, ...] = ()) -> Drawn:
    scene = read(SHEETS / "engine")
    assert scene.tasks.get("flywheel") is not None
    gas = Gas((), BORE, 0.0, stretches, C)
    order = replace(scene.tasks["flywheel"], indicator=IndicatorTask("B", gas, mu=2000.0))
    row = replace(scene.row, count=count, extra=extra, accelerations=())
    sheets = (SheetOrder("A1", ("positions", "velocities", "flywheel")),)
    return drawn_of(replace(scene, row=row, sheets=sheets).asking(flywheel=order), exact=True)


def pressures(made: Drawn) -> np.ndarray:
    assert FLYWHEEL_PLAN.of(made) is not None
    (side,) = FLYWHEEL_PLAN.on(made).cylinder.indicator.sides
    return np.asarray(made.reading[side.ordinate][0] * 2000.0)


def shares(count: int) -> np.ndarray:
    phi = 2 * np.pi * np.arange(count) / count
    x = 0.3 * np.cos(phi) + np.sqrt(0.64**2 - (0.3 * np.sin(phi)) ** 2)
    return (0.94 - x) / 0.6


def test_polytropic_strokes() -> None:
    s = shares(12)
    due = np.where(s <= 0.3, 600e3, 600e3 * (C + 0.3) / (C + s))
    back = np.where(s >= 0.25, 110e3, 110e3 * ((C + 0.25) / (C + s)) ** 1.2)
    due[7:] = back[7:]
    np.testing.assert_allclose(pressures(drawn(*STEAM)), due, rtol=1e-12)


def test_points_are_joined_by_straight_lines() -> None:
    s = shares(12)
    due = np.interp(s, [0, 0.4, 1], [300e3, 260e3, 60e3])
    due[7:] = np.interp(s, [0, 0.5, 1], [150e3, 40e3, 30e3])[7:]
    np.testing.assert_allclose(pressures(drawn(*TRACED)), due, rtol=1e-12)


def test_at_a_jump_the_pressure_behind_it_holds() -> None:
    """At 0.6 m of stroke, crank 0.3, the dead centres are the places that a position stands on exactly."""
    jumps = (
        Stretch("out", 0.0, 0.0, 100e3, None, 300e3),
        Stretch("out", 0.0, 0.4, 300e3, None, 300e3),
        Stretch("out", 0.4, 0.4, 300e3, None, 80e3),
        Stretch("out", 0.4, 1.0, 80e3, None, 60e3),
        *TRACED[2:],
    )
    s = shares(12)
    due = np.where(s < 0.4, 300e3, np.interp(s, [0.4, 1], [80e3, 60e3]))
    due[7:] = np.interp(s, [0, 0.5, 1], [150e3, 40e3, 30e3])[7:]
    np.testing.assert_allclose(pressures(drawn(*jumps)), due, rtol=1e-12)


def test_the_mean_pressure_of_many_positions_is_that_of_the_strokes() -> None:
    made = drawn(*STEAM, count=360)
    assert FLYWHEEL_PLAN.of(made) is not None
    (side,) = FLYWHEEL_PLAN.on(made).cylinder.indicator.sides
    out = 600e3 * (0.3 + (C + 0.3) * np.log((C + 1) / (C + 0.3)))
    compressed = 110e3 * (C + 0.25) / 0.2 * (((C + 0.25) / C) ** 0.2 - 1)
    due = out - 110e3 * 0.75 - compressed
    assert made.reading[side.mean][0, 0] == pytest.approx(due, rel=2e-3)


def test_positions_outside_the_row_have_no_pressure() -> None:
    found = pressures(drawn(*STEAM, extra=(105.0,)))
    assert np.isnan(found[-1])
    assert np.isfinite(found[:-1]).all()


def test_a_gap_in_the_diagram_is_told() -> None:
    with pytest.raises(
        StructureError, match=r"no part of the diagram stands over .* of the stroke out"
    ):
        drawn(*STEAM[:1], *STEAM[2:])
