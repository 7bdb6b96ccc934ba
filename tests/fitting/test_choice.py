"""The choice of scale factors, recorded: every μ that was chosen has its steps, and they come to its number."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.each import each
from support.gallery import ALL, made
from support.parts import PARTS, part_of
from support.scenes import edited

from graphic_tmm.accuracy.cost import count
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import PREFERRED, Scale, nearest, next_standard, scale_of, standard
from graphic_tmm.board.values import Number
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.fitting.choice import SCALES, Choices, Ledger, choices
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.language.numbers import number
from graphic_tmm.readers.narration import protocol
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

SAME = 1e-12
"""A share of μ: the choice computes it in another order than the search."""


def boards(name: str) -> list[Drawn]:
    return list(made(name).boards)


def value(found: Choices, mark: Mark) -> float:
    return float(execute(found.construction, found.given, [mark])[mark][0, 0])


def figure(drawn: Drawn, mark: Mark) -> float:
    return float(np.ravel(np.asarray(drawn.given[mark]))[0])


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_every_scale_factor_of_a_sheet_has_its_step_and_its_number(name: str) -> None:
    for drawn in boards(name):
        found, log = choices(drawn), drawn.construction
        for view in log.views:
            if view.name not in drawn.scales or view.scale is None:
                continue
            due = drawn.scales[view.name].value
            assert found.chosen[view.scale.slot] in {s.it for s in found.construction.steps}, view
            assert math.isclose(found.value(view.scale), due, rel_tol=SAME), view
        for chart in drawn.project.charts:
            due = float(drawn.reading[chart.mu][0, 0])
            assert math.isclose(found.value(chart.mu), due, rel_tol=SAME), chart.view


@pytest.mark.slow
@each("what", PARTS)
def test_every_scale_factor_of_a_part_has_its_number(what: str, tmp_path: Path) -> None:
    part = part_of(tmp_path, what)
    found = choices(part)
    for view in part.construction.views:
        if view.name in part.scales and view.scale is not None:
            due = part.scales[view.name].value
            assert math.isclose(found.value(view.scale), due, rel_tol=SAME), view
    assert all(step.reason for step in (*part.construction.steps, *found.construction.steps))


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_the_choice_is_told_in_both_languages_and_costs_work(name: str) -> None:
    for drawn in boards(name):
        found = choices(drawn)
        reading = execute(found.construction, found.given)
        for language in ("ru", "en"):
            lines = list(protocol(found.construction, SCALES, reading, 0, language))
            assert all(line.why for line in lines if line.number), language
            assert not any("—" in line.text or "nan" in line.calculation for line in lines)
        calculated = sum(bool(step.op.formula) for step in found.construction.steps)
        assert count(found.construction, ()).elements.get("N1", 0) >= calculated


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_a_standard_scale_is_the_next_one_and_what_it_was_chosen_by_is_round(name: str) -> None:
    for drawn in boards(name):
        found = choices(drawn)
        steps = found.construction.steps
        for step, before in zip(steps[1:], steps, strict=False):
            if step.op is not next_standard:
                continue
            assert before.op is scale_of
            exact, chosen = value(found, before.it), value(found, step.it)
            assert exact <= chosen * (1 + SAME)
            assert chosen == standard(exact, 1.0)
            length = value(found, before.uses[1])
            tenths = length * 10.0
            assert math.isclose(tenths, round(tenths), rel_tol=1e-9)


def test_the_choice_of_the_windrower_is_that_of_a_student() -> None:
    drawn = boards("windrower")[0]
    found = choices(drawn)
    told = dict[str, float]()
    for step in found.construction.steps:  # the lever has a μ_v of its own, behind
        told.setdefault(step.it.name, value(found, step.it))
    assert math.isclose(told["ω_1"], 380.0 * math.pi / 30.0, rel_tol=SAME)
    arm = next(figure for mark, figure in found.given.items() if mark.name == "l_{OA}")
    assert isinstance(arm, float)
    assert math.isclose(told["v_A"], told["ω_1"] * arm, rel_tol=SAME)
    assert math.isclose(told["pa"], told["v_A"] / told["μ_v"], rel_tol=SAME)
    assert math.isclose(told["πa"], told["ω_1"] ** 2 * arm / told["μ_a"], rel_tol=SAME)
    assert told["μ_l"] == 0.004


def test_a_length_that_the_scene_gives_makes_its_scale() -> None:
    drawn = boards("engine")[0]
    told = {step.it.name: step for step in choices(drawn).construction.steps}
    assert told["μ_v"].op is scale_of
    assert told["μ_v"].uses[1].name == "pa"


def test_lengths_that_are_wished_for_give_way_to_standard_scales() -> None:
    """The worked example: 0.003 s/mm is 0.0025, so the base 96 mm; 1.5 is 2, so the pole stands 15 mm off."""
    drawn = boards("slider-diagrams")[0]
    found = choices(drawn)
    told = {step.it.name: value(found, step.it) for step in found.construction.steps}
    due = {"μ_t′": 0.003, "μ_t": 0.0025, "L": 96.0, "μ_a′": 1.5, "μ_a": 2.0, "H_a": 15.0}
    assert {name: round(told[name], 9) for name in due} == due
    assert math.isclose(drawn.scales["diagram a"].value, 2.0)


def test_a_pole_that_is_wished_for_needs_the_scale_before_it(tmp_path: Path) -> None:
    edit = ('mu_V  = "0.075 (m/s)/mm"\n', "")
    with pytest.raises(StructureError, match="write mu_V"):
        make(read(edited(tmp_path, edit, name="slider-diagrams")))


@each("length, told", [(61.3, 70.0), (40.0, 40.0), (0.37, 0.4), (0.012, 0.012)])
def test_a_length_that_no_round_one_stands_for_is_told_as_it_is(length: float, told: float) -> None:
    """Less than a tenth of a mm is not made one: the largest over its length is the scale that was due."""
    due, ledger = 0.02, Ledger()
    mu = Draft().take(Number, "μ_v", due, "(m/s)/mm")
    ledger.of("velocities")
    ledger.fitting(mu, ledger.quantity("v_A", due * length, "m/s"), due)
    found = ledger.choices()
    assert math.isclose(found.value(mu), due, rel_tol=SAME)
    (wanted,) = (step.uses[1] for step in found.construction.steps if step.op is scale_of)
    assert value(found, wanted) == pytest.approx(told)


@given(st.floats(1e-9, 1e9))
def test_the_nearest_standard_is_the_nearest(exact: float) -> None:
    mu = nearest(exact)
    mantissa = float(f"{mu:e}".partition("e")[0])
    assert mantissa in PREFERRED
    assert max(mu / exact, exact / mu) <= math.sqrt(2.0) * (1 + 1e-12)


@given(st.floats(1e-6, 1e9), st.floats(5.0, 400.0))
def test_a_scale_is_the_least_standard_one(largest: float, room: float) -> None:
    mu = standard(largest, room)
    assert Scale("μ", mu, "").to_board(largest) <= room * (1 + 1e-9)
    assert standard(largest, largest / mu * (1 + 1e-9)) == mu


# what sheets tell


TOLD = re.compile(r"(μ_(?:\{[^}]*\}|\w)) = ([\d.]+(?:·10\^?\{?[⁻⁰¹²³⁴⁵⁶⁷⁸⁹−\d]+\}?)?) ")
"""A scale factor as a sheet tells it in English: its letter, its number."""


def bare(name: str) -> str:
    """A letter without braces about an index of one sign."""
    return re.sub(r"\{(\w)\}", r"\1", name)


def told_on_sheets(drawn: Drawn) -> set[tuple[str, str]]:
    """The scale factors below all that a scene can show of a board: letters and numbers."""
    found: set[tuple[str, str]] = set()
    for chapter in drawn.project.chapters:
        for place in chapter.places:
            labels = [
                label.text for view in drawing_of(place.name)(drawn, True) for label in view.labels
            ]
            told = [match for text in labels for match in TOLD.findall(text)]
            found |= {(bare(name), figure) for name, figure in told}
    return found


def steps_of_scales(drawn: Drawn) -> set[tuple[str, str]]:
    """The scale factors that a step came to: in the choice, or on the board; as they are written."""
    chosen = choices(drawn)
    reading = execute(chosen.construction, chosen.given)
    rows = [(step.it.name, reading[step.it]) for step in chosen.construction.steps]
    rows += [
        (step.it.name, drawn.reading[step.it])
        for step in drawn.construction.steps
        if step.it.unit.endswith("/mm") and step.it in drawn.reading
    ]
    found = [(name, float(np.ravel(value)[0])) for name, value in rows]
    found += [(name, math.degrees(value)) for name, value in found if name == "μ_φ"]
    return {(bare(name), number(value, "en")) for name, value in found}


@pytest.mark.turns(4)
@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_every_scale_factor_on_a_sheet_is_what_a_step_came_to(name: str) -> None:
    """Whatever is written below a view, by whichever reader: no μ comes out of a view itself."""
    for drawn in boards(name):
        english = replace(drawn.project, scene=replace(drawn.scene, language="en"))
        told = told_on_sheets(replace(drawn, project=english))
        assert told <= steps_of_scales(drawn), told - steps_of_scales(drawn)
        assert told or not drawn.scales


def test_the_diagram_of_a_load_is_drawn_to_what_was_chosen_for_it() -> None:
    """The largest force of the press on 40 mm or less; a larger one would not fit. Its travel goes by μ_l."""
    (drawn, *_) = boards("crank-press")
    found = choices(drawn)
    up = found.scale("load F_{3}", "μ_F")
    assert (up.value, up.unit) == (750.0, "N/mm")
    assert 24000.0 / up.value <= 40.0 < 24000.0 / up.value * 1.34
    assert told_on_sheets(drawn) >= {("μ_l", "0.002"), ("μ_F", "750")}
