"""Tables and results of the flywheel: columns by positions, results with units; the narration of it."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import SHEETS, drawn, exact, made

from graphic_tmm.chapters.flywheel.task import FlywheelTask
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.readers.table import results_of, table
from graphic_tmm.scene.read import read


def test_columns_are_what_the_ruler_reads_times_their_scale() -> None:
    document = json.loads(table(exact("engine"), "json"))
    found = {c["segment"]: c for c in document["columns"] if c["plan"] == "flywheel"}
    assert list(found) == ["p_k".replace("_", ""), "M", "ΔT", "TL", "TF", "Jr"]
    keys = {"pk": "mu_p", "M": "mu_M", "ΔT": "mu_T", "TL": "mu_T", "TF": "mu_T", "Jr": "mu_J"}
    for segment, column in found.items():
        mu = document["scales"][keys[segment]]["value"]
        np.testing.assert_allclose(
            np.array(column["mm"]) * mu, column["value"], rtol=1e-10, atol=1e-9
        )
    assert found["pk"]["value"][:4] == pytest.approx([300e3, 300e3, 240e3, 159e3])
    fly = np.array(found["ΔT"]["value"]) - np.array(found["TL"]["value"])
    np.testing.assert_allclose(found["TF"]["value"], fly, atol=1e-9)


def test_results_carry_their_units() -> None:
    results = json.loads(table(exact("engine"), "json"))["results"]
    assert results["cd"] == {"value": pytest.approx(60.77, abs=0.005), "unit": "mm"}
    assert results["J_fly"] == {"value": pytest.approx(1.7707, abs=0.0001), "unit": "kg·m²"}
    assert results["J_fly_energy_mass"]["value"] == pytest.approx(1.6245, abs=0.0001)
    assert results["D_max"]["value"] == pytest.approx(4.4)
    assert {"rim_mass", "rim_width", "D_i", "D_mean", "p_mean_cover"} <= set(results)


def test_the_ruler_stays_within_what_it_is_worth() -> None:
    read_off = json.loads(table(made("engine"), "json"))["results"]
    assert read_off["J_fly"]["value"] == pytest.approx(1.7707, rel=0.01)


def test_the_protocol_tells_the_flywheel_as_a_student_would_do_it() -> None:
    text = "\n".join(protocol(drawn("engine", exact=True), ("flywheel",), "3", "ru"))
    for part in (
        "Индикаторная диаграмма, положение 3",
        "μ_A = μ_M·μ_φ·H = 8·0,05236·40 = 16,76 Дж/мм",
        "ΔT",
        "J_м = cd·μ_A/(δ·ω_1²) = 60,77·16,76/(0,23·50²) = 1,771 кг·м²",
        "T_2пост = m_2·(ps2·μ_v)²/2",
        "b = 16·J_м/(π·ρ·(D_e² − D_i²)·D_ср²)",
    ):
        assert part in text, part
    english = "\n".join(protocol(drawn("engine", exact=True), ("flywheel",), "3", "en"))
    assert "Indicator diagram, position 3" in english


def test_a_machine_that_locks_part_of_the_turn_has_no_flywheel_and_says_so() -> None:
    scene = read(SHEETS / "engine")
    assert scene.mechanism is not None
    rod = scene.mechanism.by_number[2]
    short = replace(rod, points={**rod.points, "B": 0.29 + 0j})
    links = tuple(short if link.number == 2 else link for link in scene.mechanism.links)
    made = drawn_of(replace(scene, mechanism=replace(scene.mechanism, links=links)))
    assert "J_fly" not in results_of(made)
    assert any("a position of the row is missing" in text for text in warnings(made))


def test_a_scene_without_a_flywheel_has_no_column_of_it() -> None:
    found = made("offset-slider")
    assert "flywheel" not in found.scene.tasks
    document = json.loads(table(found, "json"))
    assert not [c for c in document["columns"] if c["plan"] == "flywheel"]
    assert set(document["results"]) == {"W", "formula"}
    assert isinstance(drawn("engine", exact=True).scene.tasks["flywheel"], FlywheelTask)
