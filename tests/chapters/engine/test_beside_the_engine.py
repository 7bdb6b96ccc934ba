"""What is calculated beside an engine: the book's formulas, and equal works of T and of P, against numpy."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import SHEETS, drawn
from support.scenes import edited

from graphic_tmm.chapters.engine.record import BESIDE
from graphic_tmm.chapters.engine.table import engine_columns, engine_results
from graphic_tmm.chapters.engine.task import CALCULATED, MASSES, TRANSFER, WORKS_VIEW
from graphic_tmm.chapters.indicator.record import BESIDE as STROKE
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.note.document import Number
from graphic_tmm.note.section_chapter import page_of
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.readers.task_sheet import given_rows
from graphic_tmm.scene.read import read

LAMBDA, R = 0.182, 0.115
PHI = np.radians(np.arange(12) * 30.0)
BETA = np.arcsin(LAMBDA * np.sin(PHI))


@cache
def exact() -> Drawn:
    return drawn_of(read(SHEETS / "locomobile"), exact=True)


def column(made: Drawn, name: str) -> np.ndarray:
    return next(one for one in engine_columns(made) if one.segment == name).value[0]


def check(made: Drawn, name: str) -> np.ndarray:
    return made.reading[BESIDE.on(made).checks[name]][0]


def test_it_moves_no_mark_of_the_drawing() -> None:
    log = exact().construction
    views = {TRANSFER, CALCULATED, MASSES, WORKS_VIEW}
    beside = [step for step in log.steps if step.it.view in views]
    others = [step for step in log.steps if step.it.view not in views]
    assert min(step.it.slot for step in beside) > max(step.it.slot for step in others)
    assert not {step.it for step in beside} & {mark for step in others for mark in step.uses}


def test_beta_is_tabulated() -> None:
    np.testing.assert_allclose(column(exact(), "beta"), np.degrees(BETA), atol=2e-4)


def test_the_formulas_give_what_the_triangles_give() -> None:
    """(339)–(342) by closed forms; the couple of Q is the moment of T."""
    made = exact()
    p = column(made, "P′")
    due = {
        "N": p * np.tan(BETA),
        "Q": p / np.cos(BETA),
        "T": p * np.sin(PHI + BETA) / np.cos(BETA),
        "K": p * np.cos(PHI + BETA) / np.cos(BETA),
        "M": p * np.sin(PHI + BETA) / np.cos(BETA) * R,
    }
    for name, values in due.items():
        np.testing.assert_allclose(check(made, name), values, atol=4e-6 * np.abs(p).max())
        np.testing.assert_allclose(
            check(made, name), column(made, name), atol=1e-9 * np.abs(p).max()
        )


def test_a_clockwise_crank_is_checked_alike(tmp_path: Path) -> None:
    other = drawn_of(
        read(edited(tmp_path, ('"counterclockwise"', '"clockwise"'), name="locomobile")), exact=True
    )
    for name in "NQTKM":
        np.testing.assert_allclose(check(other, name), check(exact(), name), atol=1e-6)
    np.testing.assert_allclose(column(other, "beta"), column(exact(), "beta"), atol=1e-9)


def by_closed_form() -> float:
    """The work of the steam over a turn, kgf·m: ∮p dV of both sides, cut off and compressed as p·V = const."""
    c, stroke = 0.08, 2 * R

    def side(high: float, cut: float, low: float, shut: float) -> float:
        out = high * cut + high * (c + cut) * math.log((c + 1) / (c + cut))
        back = low * (1 - shut) + low * (c + shut) * math.log((c + shut) / c)
        return (out - back) * 1e4

    cover, ring = math.pi * 0.17**2 / 4, math.pi * (0.17**2 - 0.036**2) / 4
    return side(10, 0.35, 1.2, 0.15) * stroke * (cover + ring)


def test_over_a_turn_t_does_the_work_of_the_steam(tmp_path: Path) -> None:
    """Both come near the closed form; at 72 positions nearer, and nearer to each other."""
    few = single(engine_results(exact()))
    scene = read(SHEETS / "locomobile")
    many = single(
        engine_results(drawn_of(replace(scene, row=replace(scene.row, count=72)), exact=True))
    )
    due = by_closed_form()
    assert few["work_T"][1] == "kgf·m"
    for name in ("work_T", "work_P"):
        assert few[name][0] == pytest.approx(due, rel=0.04)
        assert many[name][0] == pytest.approx(due, rel=0.003)
    assert abs(few["work_apart"][0]) < 2.0
    assert abs(many["work_apart"][0]) < 0.2
    apart = 100 * (few["work_T"][0] / few["work_P"][0] - 1)
    assert few["work_apart"] == (pytest.approx(apart, abs=0.005), "%")


def test_a_compressor_takes_the_work_that_its_crank_gives(tmp_path: Path) -> None:
    """The same diagrams gone round the other way: high pressure on the way towards the cover."""
    text = (SHEETS / "locomobile" / "scene.toml").read_text(encoding="utf-8")
    old = text[text.index("cover_strokes") : text.index("[engine]")]
    high, low = "6 kgf/cm^2", "1 kgf/cm^2"
    cover = [[0, high], [0.1, low], [1, low]], [[1, low], [0.3, high], [0, high]]
    shaft = [[0, low], [0.7, high], [1, high]], [[1, high], [0.9, low], [0, low]]
    new = "".join(
        f"{side}_points = {{ out = {json.dumps(out)}, back = {json.dumps(back)} }}\n"
        for side, (out, back) in (("cover", cover), ("shaft", shaft))
    )
    made = drawn_of(read(edited(tmp_path, (old, new), name="locomobile")), exact=True)
    found = single(engine_results(made))
    assert found["work_T"][0] < 0.0
    assert found["work_P"][0] == pytest.approx(found["work_T"][0], rel=0.05)


def test_the_conclusion_tells_the_results_and_nothing_else() -> None:
    made = drawn("locomobile", exact=True)
    engine = next(one for one in made.project.chapters if one.name == "engine")
    for language, word in (("en", "equal"), ("ru", "равны")):
        *_, one = page_of(made, engine, language).concludes()
        numbers = [run for run in one if isinstance(run, Number)]
        results = single(engine_results(made))
        assert [n.value for n in numbers] == [results[n.source.name][0] for n in numbers]
        assert len(numbers) == 3
        assert any(word in getattr(run, "text", "") for run in one)


def test_the_protocol_tells_formulas_with_their_numbers() -> None:
    text = "\n".join(protocol(exact(), ("engine",), "2", "ru", why=True))
    for part in ("N′ = P′·h_A/x", "A_T = 2π·M_m", "Δ_A = 100·(A_T − A_P)/A_P", "формула (341)"):
        assert part in text, part


def test_the_cylinder_and_the_masses_are_given() -> None:
    """Document 001: 170 and 36 mm, 2.18 kgf·s²/m, a quarter of the rod's weight; 000: a bore of 120 mm."""
    found = {one.symbol: (one.value, one.unit) for one in given_rows(read(SHEETS / "locomobile"))}
    assert found["D"] == (pytest.approx(170.0), "mm")
    assert found["d"] == (pytest.approx(36.0), "mm")
    assert found["c"][0] == 0.08
    assert found["k"][0] == 0.25
    assert found["m"] == (pytest.approx(2.18), "kgf·s²/m")
    bore = {one.symbol: one.value for one in given_rows(read(SHEETS / "engine"))}
    assert bore["D"] == pytest.approx(120.0)
    assert "d" not in bore


def test_the_indicator_diagram_is_told_with_the_engine_it_stands_with() -> None:
    text = "\n".join(protocol(exact(), ("engine",), "2", "ru"))
    assert text.index("Индикаторная диаграмма") < text.index("P = P_к − P_в")


def test_the_scale_of_the_stroke_is_a_step_and_stands_below_the_diagram() -> None:
    """2·115 mm on 100 mm; 2·300 mm on 100 mm."""
    for name, due in (("locomobile", 0.0023), ("engine", 0.006)):
        made = drawn(name, exact=True)
        found = STROKE.on(made)
        assert made.reading[found.scales[0]].item() == pytest.approx(due, rel=1e-9)
        text = "\n".join(protocol(made, ("engine", "flywheel"), "2", "en"))
        assert "μ_S = S/L" in text
