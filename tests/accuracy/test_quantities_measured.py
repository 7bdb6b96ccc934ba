"""Quantities are those of the tables, and what they should be does not come from the drawing that is judged."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.gallery import exact
from support.tasks import by, drawing, measure, quantity, scales, scene

from graphic_tmm.accuracy.drawing import References
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.settings import own_setting, singly
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.forces.task import ASKED, Friction
from graphic_tmm.readers.position_count import at_count
from graphic_tmm.readers.table import scene_columns, scene_results


@pytest.mark.turns(2)
@pytest.mark.every
@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("windrower", "v a V_diagram a_diagram P_bal J_fly J_fly_energy_mass"),
        ("locomobile", "v a M_engine"),
        ("cam", "r0_min"),
        ("gear-pair", "contact_ratio contact_arc"),
        ("planetary", "Bb s1 s2 sH"),
        ("arc-cam", "s OP S"),  # S′, S″ are by chords: an exact hand has their error, too
    ],
)
def test_a_scene_has_the_quantities_that_its_sheets_show(name: str, found: str) -> None:
    assert [q.name for q in quantities(drawing(name))] == found.split()


def test_each_of_several_drives_has_its_balance_by_name() -> None:
    drawn = drawing("excavator")
    names = [one.name for one in quantities(drawn)]
    assert names == ["v", "a", "P_bal_6", "P_bal_3"]  # the last is the main one: of the row
    columns = {c.segment: c for c in scene_columns(exact("excavator"))}
    for name, segment in (("P_bal_3", "P_bal_forces"), ("P_bal_6", "P_bal_6")):
        mine = quantity(drawn, name)
        value = mine.read(execute(drawn.construction, drawn.given, mine.marks), 1)
        # forces are asked for in one position
        np.testing.assert_allclose(value[0, 1], columns[segment].value[0, 1], rtol=1e-9)
    assert WORDS["en"]["P_bal_6"] == "P_bal of link 6"
    assert WORDS["ru"]["P_bal_3"] == "P_ур звена 3"
    assert "link 6" in WORDS["en"]["letter P_bal_6"]
    assert WORDS["en"]["J_fly_energy_mass"] != WORDS["en"]["P_none_6"] == "P_none_6"


def test_passes_of_friction_bear_upon_the_balance_of_each_drive() -> None:
    friction = Friction({"O": 0.1}, {"O": 0.05}, passes=2)
    own = scene("excavator")
    order = ASKED.of(own)
    assert order is not None
    rough = own_setting(ASKED.put(own, replace(order, friction=friction)), "exact", 10)
    passes = [one for one in singly(rough, 10) if one.axis == "passes"]
    assert passes
    assert {one.only for one in passes} == {("P_bal_3", "P_bal_6")}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("engine", ["J_fly", "J_fly_energy_mass"]),
        ("cam", ["r0_min"]),
        ("gear-pair", ["contact_ratio"]),
    ],
)
def test_numbers_are_those_of_the_table(name: str, found: list[str]) -> None:
    drawn = drawing(name)
    table = scene_results(exact(name))
    for one in found:
        mine = quantity(drawn, one)
        value = mine.read(execute(drawn.construction, drawn.given, mine.marks), 1)
        key = {"contact_ratio": "contact_ratio_drawn"}.get(one, one)
        # the table tells the digits that rounding leaves sure, here twelve
        assert value[0, 0] == pytest.approx(table[key][0][0], rel=5e-12)


def test_diagrams_and_their_plans_are_those_of_the_table() -> None:
    drawn = drawing("slider-diagrams")
    columns = {c.segment: c for c in scene_columns(exact("slider-diagrams"))}
    mine = quantity(drawn, "V_diagram")
    reading = execute(drawn.construction, drawn.given)
    assert mine.read(reading, 1)[0] == pytest.approx(columns["V"].value[0], abs=1e-12)
    due = columns["V_plan"].value[0]
    assert mine.read(reading, 1, due=True)[0] == pytest.approx(due, abs=1e-12)


@pytest.mark.slow
def test_a_moment_is_judged_by_kinetostatics_and_two_masses_leave_only_their_own_error() -> None:
    """Two masses have the rod's mass and centre, not its J: their moment is off by (J_lumped − J)·ε alone.

    With the J of two masses given to the rod both roads are the same dynamics; so the error must vanish.
    """
    own = scene("locomobile")
    assert own.tasks.get("engine") is not None
    assert own.mechanism is not None
    lever = own.asking(engine=replace(own.tasks["engine"], share=None, mass=None))
    (run,) = measure("locomobile").runs(
        by("locomobile", "exact", changed=lever), "", "", ["M_engine"]
    )
    assert 0.05 < run.error < 1.0
    rod = own.mechanism.by_number[2]
    mass, length, at = rod.mass, abs(rod.points["B"]), abs(rod.points["S2"])
    assert mass is not None
    dumbbell = replace(rod, inertia=mass * at * (length - at))
    links = tuple(dumbbell if link.number == 2 else link for link in own.mechanism.links)
    alike = replace(lever, mechanism=replace(own.mechanism, links=links))
    judge = References(alike, scales("locomobile"))
    drawn = drawing("locomobile", alike)
    mine = quantity(drawn, "M_engine")
    due = judge.of(mine, drawn)
    found = mine.read(execute(drawn.construction, drawn.given, mine.marks), 1)
    assert due is not None
    assert np.abs(found - due).max() < 1e-9 * np.abs(due).max()


@pytest.mark.slow
def test_a_reference_has_converged() -> None:
    """Of an error that falls as N⁻² a row four times as fine has a sixteenth; the reference is finer still."""
    own = scene("engine")
    judge = References(own, scales("engine"))
    drawn = drawing("engine")
    due = judge.of(quantity(drawn, "J_fly"), drawn)
    assert due is not None
    errors = []
    for n in (192, 768):
        finer = at_count(own, n)
        assert finer is not None
        one = drawing("engine", finer)
        mine = quantity(one, "J_fly")
        errors.append(
            abs(
                mine.read(execute(one.construction, one.given, mine.marks), 1)[0, 0] / due[0, 0] - 1
            )
        )
    assert errors[1] < errors[0] / 8
    assert errors[1] < 1e-4


def test_the_contact_ratio_by_the_arc_agrees_with_the_formula() -> None:
    """For an involute c1d1 = ε·p_w; a flank through 12 points is off by less than 1e-4 %."""
    for run in measure("gear-pair").runs(by("gear-pair", "exact"), "", ""):
        assert run.error < 1e-4
