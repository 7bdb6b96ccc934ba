"""The indicator diagram: its base divided as the piston travels, pressures read, two sides, the planimeter."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shapely
from support.boards import drawn_of
from support.gallery import SHEETS

from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.indicator.accuracy import at_count
from graphic_tmm.chapters.indicator.plan import Indicator
from graphic_tmm.chapters.indicator.task import Gas, IndicatorTask
from graphic_tmm.drawn import Drawn
from graphic_tmm.mechanism.records import Row
from graphic_tmm.paper.shapes import flat
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import SheetOrder

R, L, BORE, ROD = 0.3, 0.64, 0.12, 0.04
COVER = (300e3, 300e3, 240e3, 159e3, 121.5e3, 87e3, 30e3, 34.5e3, 42e3, 64.5e3, 100.5e3, 144e3)
SHAFT = (20e3, 30e3, 45e3, 70e3, 110e3, 160e3, 320e3, 310e3, 250e3, 170e3, 120e3, 60e3)


@cache
def drawn(double: bool = False, extra: tuple[float, ...] = ()) -> Drawn:
    scene = read(SHEETS / "engine")
    assert scene.tasks.get("flywheel") is not None
    shaft = Gas(SHAFT, BORE, ROD) if double else None
    order = IndicatorTask("B", Gas(COVER, BORE), shaft, base=80.0, mu=2000.0)
    row = replace(scene.row, extra=extra)
    return drawn_of(
        replace(
            scene, row=row, sheets=(SheetOrder("A1", ("positions", "velocities", "flywheel")),)
        ).asking(flywheel=replace(scene.tasks["flywheel"], indicator=order)),
        exact=True,
    )


def made(of: Drawn) -> Indicator:
    assert FLYWHEEL_PLAN.of(of) is not None
    return FLYWHEEL_PLAN.on(of).cylinder.indicator


def travel() -> np.ndarray:
    phi = np.arange(12) * np.pi / 6
    x = R * np.cos(phi) + np.sqrt(L**2 - (R * np.sin(phi)) ** 2)
    return R + L - x


def test_the_base_is_divided_in_proportion_to_the_travel() -> None:
    feet = drawn().reading[made(drawn()).feet][0]
    np.testing.assert_allclose(feet.real, 80.0 * travel() / (2 * R), atol=1e-9)
    np.testing.assert_allclose(feet.imag, 0.0, atol=1e-9)


def test_pressures_are_read_in_mm_and_come_back_times_their_scale() -> None:
    found = drawn()
    (side,) = made(found).sides
    heights = found.reading[side.ordinate][0]
    np.testing.assert_allclose(heights, np.array(COVER) / 2000.0, atol=1e-9)
    area = np.pi * BORE**2 / 4
    np.testing.assert_allclose(found.reading[made(found).force][0], np.array(COVER) * area)


def test_the_ruler_reads_them_in_its_divisions() -> None:
    scene = drawn().scene
    read_off = drawn_of(replace(scene, ruler=0.5))
    (side,) = made(read_off).sides
    heights = read_off.reading[side.ordinate][0]
    np.testing.assert_allclose(heights * 2, np.round(heights * 2), atol=1e-9)
    assert np.abs(heights - np.array(COVER) / 2000.0).max() <= 0.25 + 1e-9


def test_a_double_acting_piston_has_the_difference_of_two_forces() -> None:
    found = drawn(double=True)
    cover, shaft = made(found).sides
    areas = np.pi * BORE**2 / 4, np.pi * (BORE**2 - ROD**2) / 4
    due = np.array(COVER) * areas[0] - np.array(SHAFT) * areas[1]
    np.testing.assert_allclose(found.reading[made(found).force][0], due, rtol=1e-12)
    assert (cover.name, shaft.name) == ("cover", "shaft")
    np.testing.assert_allclose(found.reading[shaft.ordinate][0], np.array(SHAFT) / 2000.0)


@pytest.mark.parametrize("side", [0, 1])
def test_the_mean_pressure_is_the_area_over_the_base(side: int) -> None:
    found = drawn(double=True)
    one = made(found).sides[side]
    (controls,) = bezier(found.reading[one.curve])
    spots = flat([complex(z) for z in controls])
    area = shapely.Polygon([(z.real, z.imag) for z in spots]).area
    mean = float(found.reading[one.mean][0, 0])
    assert mean == pytest.approx(area / 80.0 * 2000.0, rel=0.01)  # eight chords an arc
    assert 0.2 * max(COVER) < mean < 0.6 * max(COVER)


def test_positions_outside_the_row_have_no_pressure_and_disturb_none() -> None:
    found = drawn(extra=(105.0,))
    (side,) = made(found).sides
    heights = found.reading[side.ordinate][0]
    assert np.isnan(heights[-1])
    np.testing.assert_allclose(heights[:-1], np.array(COVER) / 2000.0, atol=1e-9)
    assert not [f for f in found.findings() if f.kind == "undrawn"]


def test_a_scale_that_is_not_given_is_standard_and_has_room() -> None:
    scene = drawn().scene
    assert scene.tasks.get("flywheel") is not None
    order = replace(scene.tasks["flywheel"].indicator, mu=None, height=120.0)
    free = drawn_of(
        scene.asking(flywheel=replace(scene.tasks["flywheel"], indicator=order)), exact=True
    )
    assert free.scales["indicator"].value == 2500.0
    assert Row().count == 12


@pytest.mark.parametrize(
    ("strokes", "due"),
    [
        (2, (10.0, 15.0, 20.0, 40.0, 60.0, 35.0)),
        (4, (10, 12.5, 15, 17.5, 20, 30, 40, 50, 60, 47.5, 35, 22.5)),
    ],
)
def test_more_positions_in_a_turn_keep_the_pressures_of_the_whole_cycle(
    strokes: int, due: tuple[float, ...]
) -> None:
    """Three pressures are given; at six positions a turn two strokes have six of them, four strokes twelve."""
    sides = Gas((10.0, 20.0, 60.0), BORE), Gas((20.0, 40.0, 120.0), BORE, ROD)
    finer = at_count(IndicatorTask("B", *sides, strokes=strokes), 6)
    assert finer.cover.pressures == pytest.approx(due)
    assert finer.shaft is not None
    assert finer.shaft.pressures == pytest.approx([2 * p for p in due])
