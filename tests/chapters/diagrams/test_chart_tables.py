"""Tables of diagrams: their values, those of the plans with their signs, the difference in % of the largest."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from support import gallery
from support.boards import drawn_of
from support.gallery import SHEETS

from graphic_tmm.board.charts import ScaleOrder
from graphic_tmm.chapters.diagrams.task import KinematicTask
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.readers.columns import (
    Column,
)
from graphic_tmm.readers.table import columns_of, table
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder

ORDER = KinematicTask("B", start="displacement")


def engine(order: KinematicTask) -> Scene:
    """The engine with diagrams instead of its flywheel."""
    place = ("positions", "velocities", "accelerations", "diagrams")
    sheets = (SheetOrder("A1", place),)
    return replace(read(SHEETS / "engine"), sheets=sheets).asking(diagrams=order, flywheel=None)


@cache
def drawn(start: str = "displacement", exact: bool = True) -> Drawn:
    return drawn_of(engine(replace(ORDER, start=start)), exact=exact)


def found(work: Drawn) -> dict[str, Column]:
    return {c.segment: c for c in columns_of(work) if c.plan == "diagrams"}


def exact_motion() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Travel from the outer dead centre, velocity, acceleration along x of the engine's piston."""
    r, rod, w = 0.3, 0.64, 50.0
    phi = np.arange(12) * np.pi / 6
    root = np.sqrt(rod**2 - (r * np.sin(phi)) ** 2)
    x = r * np.cos(phi) + root
    v = -r * w * (np.sin(phi) + r * np.sin(2 * phi) / (2 * root))
    bend = np.cos(2 * phi) / root + r**2 * np.sin(2 * phi) ** 2 / (4 * root**3)
    return x - r - rod, v, -r * w**2 * (np.cos(phi) + r * bend)


def test_the_columns_are_those_of_the_diagrams_beside_the_plans() -> None:
    columns = found(drawn())
    assert list(columns) == [
        "S", "V", "V_plan", "V_difference", "a", "a_plan", "a_difference"
    ]  # fmt: skip
    s, v, a = exact_motion()
    np.testing.assert_allclose(columns["S"].value[0], s, atol=1e-12)
    np.testing.assert_allclose(columns["V_plan"].value[0], v, atol=1e-12)
    planned = [(k, x) for k, x in enumerate(columns["a_plan"].first_figures[1]) if x is not None]
    assert [k for k, _ in planned] == [1, 4]  # positions 2 and 5 have plans
    np.testing.assert_allclose([x for _, x in planned], [a[1], a[4]], rtol=1e-12)


def test_the_difference_is_told_in_percent_of_the_largest_of_the_plan() -> None:
    columns = found(drawn())
    v, due = (columns[key].value[0] for key in ("V", "V_plan"))
    expected = 100 * (v - due) / np.abs(due).max()
    told = columns["V_difference"].value[0]
    np.testing.assert_allclose(told, expected, atol=0.005 + 1e-9)  # no ruler: two decimals
    np.testing.assert_array_equal(told, np.round(told, 2))
    assert 0.1 < np.abs(expected).max() < 3.0  # what chords over 30° cost
    assert columns["V_difference"].unit == "%"
    assert not columns["V_difference"].drawn


def test_a_velocity_diagram_that_starts_from_the_plan_does_not_differ_from_it() -> None:
    columns = found(drawn("velocity"))
    np.testing.assert_allclose(columns["V_difference"].value[0], 0.0, atol=1e-9)
    s, _, a = exact_motion()
    # ordinates at the middles: the error over any stretch is h²/24 times the change of the slope
    bound = (np.pi / 6) ** 2 / 24 * 2 * np.abs(a).max() / 50.0**2
    np.testing.assert_allclose(columns["S"].value[0], s, atol=1.1 * bound)


def test_scales_are_told_and_turn_mm_into_values() -> None:
    document = json.loads(table(DrawnScene(drawn().scene, (drawn(),)), "json"))
    scales = document["scales"]
    assert {"mu_diagram_S", "mu_diagram_V", "mu_diagram_a", "mu_base"} <= set(scales)
    for column in document["columns"]:
        if column["plan"] == "diagrams" and column["segment"] in ("S", "V", "a"):
            mu = scales[f"mu_diagram_{column['segment']}"]["value"]
            for mm, value in zip(column["mm"], column["value"], strict=True):
                assert value == pytest.approx(mm * mu, rel=1e-10, abs=1e-10)
    assert scales["mu_base"]["unit"] == "s/mm"
    assert scales["mu_base"]["value"] == pytest.approx(2 * np.pi / 50 / 180)


def test_a_chosen_scale_is_standard_and_a_given_pole_is_kept() -> None:
    mantissas = {1.0, 1.5, 2.0, 2.5, 4.0, 5.0, 7.5}
    for key in ("diagram S", "diagram V", "diagram a"):
        value = drawn().scales[key].value
        assert float(f"{value:e}".split("e")[0]) in mantissas
    order = replace(ORDER, V=ScaleOrder(pole=30.0))
    work = drawn_of(engine(order), exact=True)
    scales = work.scales
    due = scales["diagram S"].value / (scales["base"].value * 30.0)
    assert scales["diagram V"].value == pytest.approx(due, rel=1e-12)
    np.testing.assert_allclose(
        found(work)["V"].value, found(drawn())["V"].value, rtol=1e-9, atol=1e-9
    )


def test_without_an_order_there_is_no_column_and_no_step() -> None:
    work = gallery.drawn("shaper")
    if "diagrams" not in work.scene.tasks:
        assert not found(work)
        assert not any(
            step.it.view.startswith("diagram") for step in work.project.construction.steps
        )
