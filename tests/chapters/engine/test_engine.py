"""The locomobile: the book's figures, its triangles against closed formulas, what lumping the rod costs."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import SHEETS

from graphic_tmm.chapters.engine.formulas import KGF
from graphic_tmm.chapters.engine.table import engine_columns, engine_results
from graphic_tmm.chapters.engine.task import EngineTask
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.errors import StructureError
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

SCENE = read(SHEETS / "locomobile")
R, LAMBDA, OMEGA, M = 0.115, 0.182, 10 * math.pi, 2.18


@cache
def drawn() -> Drawn:
    return drawn_of(SCENE, exact=True)


def column(made: Drawn, segment: str) -> np.ndarray:
    return next(c for c in engine_columns(made) if c.segment == segment).value[0]


def order(**changes: object) -> EngineTask:
    assert SCENE.tasks.get("engine") is not None
    return replace(SCENE.tasks["engine"], **changes)  # type: ignore[arg-type]


def with_engine(**changes: object) -> Scene:
    return SCENE.asking(engine=order(**changes))


@pytest.mark.parametrize(
    ("segment", "due"),
    [
        ("a_B_series", (134.16, -20.66, -92.84)),
        ("P_in_series", (-292.46, 45.03, 202.40)),
        ("P_in1", (-247.43, 0.0, 247.43)),
        ("P_in2", (-45.03, 45.03, -45.03)),
    ],
)
def test_the_two_term_series_is_the_books(segment: str, due: tuple[float, ...]) -> None:
    found = column(drawn(), segment)[[0, 3, 6]]
    np.testing.assert_allclose(found, due, atol=0.01)


@pytest.mark.parametrize(
    ("segment", "printed"),
    [
        ("a_B_series", (134.2, -20.7, -92.9)),
        ("P_in_series", (-292.5, 45.0, 202.5)),
        ("P_in1", (-247.5, 0.0, 247.5)),
        ("P_in2", (-45.0, 45.0, -45.0)),
    ],
)
def test_the_printed_table_is_within_a_tenth(segment: str, printed: tuple[float, ...]) -> None:
    np.testing.assert_allclose(column(drawn(), segment)[[0, 3, 6]], printed, atol=0.11)


def test_the_exact_slider_crank_at_90_degrees() -> None:
    assert column(drawn(), "a_B")[3] == pytest.approx(-21.01, abs=0.005)


def test_the_triangles_are_the_closed_formulas() -> None:
    made = drawn()
    phi = np.radians(np.arange(12) * 30.0)
    beta = np.arcsin(LAMBDA * np.sin(phi))
    p = column(made, "P′")
    due = {
        "N": p * np.tan(beta),
        "Q": p / np.cos(beta),
        "T": p * np.sin(phi + beta) / np.cos(beta),
        "K": p * np.cos(phi + beta) / np.cos(beta),
    }
    due["M"] = due["T"] * R
    for name, values in due.items():
        np.testing.assert_allclose(column(made, name), values, atol=2e-6 * np.abs(p).max())
    np.testing.assert_allclose(column(made, "NOB"), column(made, "M"), atol=1e-9 * np.abs(p).max())


def test_n_and_m_vanish_at_the_dead_centres_and_m_is_largest_early() -> None:
    made = drawn()
    for name in ("N", "T", "M"):
        assert column(made, name)[0] == pytest.approx(0.0, abs=1e-9)
        assert column(made, name)[6] == pytest.approx(0.0, abs=1e-9)
    assert int(np.argmax(column(made, "M")[:7])) in (2, 3)


def test_p_is_the_difference_of_the_two_sides() -> None:
    made = drawn()
    assert INDICATOR_PLAN.of(made) is not None
    cover, shaft = INDICATOR_PLAN.on(made).indicator.sides
    forces = made.reading[cover.force] - made.reading[shaft.force]
    np.testing.assert_allclose(column(made, "P"), forces[0] / KGF, rtol=1e-12)
    faces = [math.pi * 0.17**2 / 4, math.pi * (0.17**2 - 0.036**2) / 4]
    first = 10 * 98066.5 * faces[0] - made.reading[shaft.force][0, 0]
    assert column(made, "P")[0] == pytest.approx(first / KGF, rel=1e-9)


def test_steam_expands_on_the_side_of_the_shaft_by_its_own_volume() -> None:
    made = drawn()
    assert INDICATOR_PLAN.of(made) is not None
    shaft = INDICATOR_PLAN.on(made).indicator.sides[1]
    x = 0.5 * (1 - math.cos(math.radians(300)))  # position 10, rod of any length to a few per cent
    ordinate = made.reading[shaft.ordinate][0, 10] * made.scales["indicator"].value
    rod = 1 / LAMBDA
    phi = math.radians(300)
    reach = math.cos(phi) + math.sqrt(rod**2 - math.sin(phi) ** 2)
    travel = (1 + rod - reach) / 2
    assert abs(travel - x) < 0.05
    due = 10 * 98066.5 * (0.08 + 1 - 0.65) / (0.08 + 1 - travel)
    assert ordinate == pytest.approx(due, rel=1e-6)


def test_newtons_are_the_kgf_times_g() -> None:
    made, si = drawn(), drawn_of(with_engine(unit="N"), exact=True)
    for name in ("P", "P_in", "N", "Q", "T", "K"):
        np.testing.assert_allclose(column(si, name), column(made, name) * KGF, rtol=1e-9, atol=1e-6)
        np.testing.assert_allclose(
            column(made, f"{name}_SI"), column(si, name), rtol=1e-9, atol=1e-6
        )


def test_the_exact_split_of_the_rod_is_the_lever_rule() -> None:
    made = drawn_of(with_engine(share=None, mass=None), exact=True)
    found = single(engine_results(made))
    assert found["m_rod_at_slider"][0] == pytest.approx(17.1 * 0.25)
    assert found["m_to_and_fro"][0] == pytest.approx(17.1 + 17.1 * 0.25)
    length = R / LAMBDA
    due = 17.1 * 0.25 * 0.75 * length**2
    assert found["J_rod_lumped"][0] == pytest.approx(due, rel=1e-5)
    assert found["J_rod_excess"][0] == pytest.approx(due - 0.9, rel=1e-4)


def test_the_series_can_stand_for_the_plan() -> None:
    made = drawn_of(with_engine(series=True), exact=True)
    total = column(made, "P") + column(made, "P_in_series")
    np.testing.assert_allclose(column(made, "P′"), total, rtol=1e-12)


def test_a_mechanism_without_a_rod_is_refused() -> None:
    yoke = read(SHEETS / "scotch-yoke")
    scene = replace(yoke, sheets=SCENE.sheets).asking(engine=SCENE.tasks["engine"])
    with pytest.raises(StructureError):
        drawn_of(scene)
