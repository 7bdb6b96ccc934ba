"""Names are understood as people spell them; never as another name, and refused where they may be several."""

from __future__ import annotations

import random
from collections import Counter
from functools import cache

import pytest
from support import gallery
from support.each import each
from support.misspelt import misspelt

from graphic_tmm.checking.readings.names import (
    meant,
    plan_meant,
    segment_meant,
    segments_of,
)
from graphic_tmm.checking.readings.position_names import position_meant
from graphic_tmm.checking.readings.writing import result_columns
from graphic_tmm.readers.table import scene_columns, scene_results

PLANS = ("positions", "velocities", "accelerations", "diagrams", "flywheel", "forces", "results")
POSITIONS = (*map(str, range(12)), "7*", "9*", "9**", "105°", "")


@cache
def segments(name):
    made = gallery.usual(name)
    return segments_of((*scene_columns(made), *result_columns(scene_results(made))))


def outcomes(names, times):
    """Count what becomes of misspelt names of all segments: right, several things, nothing, another thing."""
    source, counts, wrong = random.Random(5), Counter(), []
    for name in names:
        for plan, known in segments(name).items():
            for due in known:
                for _ in range(times):
                    typed, way = misspelt(source, due)
                    if typed in known:
                        continue  # it is another name: nobody can know better
                    found = segment_meant(typed, plan, known).names
                    what = "right" if found == (due,) else "several" if due in found else "nothing"
                    if found and due not in found:
                        wrong.append((name, plan, due, typed, way, found))
                    counts[what] += 1
    return counts, wrong


def test_misspelt_segments_are_understood_and_never_as_others():
    counts, wrong = outcomes(("windrower", "crank-press", "locomobile"), 6)
    assert not wrong
    assert counts["right"] >= 0.98 * counts.total() > 300


@pytest.mark.slow
def test_misspelt_segments_of_scenes_with_every_chapter(many):
    counts, wrong = outcomes((*gallery.EVERYDAY, "engine", "lever", "project"), many(15, 4))
    assert not wrong
    assert counts["right"] >= 0.98 * counts.total() > 200 * many(15, 4)


@each(
    "plan, typed, due",
    [
        *[("velocities", typed, "pa") for typed in ("PA", "рa", "ра", "v_A", "vA", "Pa")],
        *[("velocities", typed, "omega3") for typed in ("ω3", "ω_3", "w3", "ОМЕГА3", "ω₃", "?3")],
        *[("velocities", typed, "cd") for typed in ("dc", "CD", "сd", "v_DC")],
        *[("velocities", typed, "aa3") for typed in ("a3a", "aA3", "аа3")],
        *[("velocities", typed, "ps3") for typed in ("пс3", "pS3", "рs3", "ps_3")],
        *[
            ("accelerations", typed, "πa")
            for typed in ("pia", "Pi a", "па", "?a", "ПЂa", "p'a", "pa")
        ],
        *[("accelerations", typed, "πn3") for typed in ("πn3", "π n₃", "pin3", "пн3", "a_A3B^n")],
        # as earlier versions called it
        *[
            ("accelerations", typed, "πn3")
            for typed in ("nba3", "n_ba3", "нба3", "n_{ba3}", "NBA3")
        ],
        *[("accelerations", typed, "epsilon4") for typed in ("ε4", "e4", "eps4", "?4", "ɛ_4")],
        *[("forces", typed, "P_bal_forces") for typed in ("P_ур", "Pур", "Рур", "P_b")],
        *[("forces", typed, "Pi1") for typed in ("P_и1", "Ри1", "P_{i1}")],
        *[("forces", typed, "P_bal_lever") for typed in ("P_ур^Ж", "PурЖ")],
        *[("flywheel", typed, "ΔT") for typed in ("∆T", "dT", "?T", "delta T", "ΔТ")],
        *[("results", typed, "J_fly") for typed in ("J_м", "Jм")],
    ],
)
def test_a_segment_by_what_it_is_called_elsewhere(plan, typed, due):
    assert segment_meant(typed, plan, segments("windrower")[plan]).names == (due,)


@each("typed", ["bd", "da", "x", "?", "??", "pab", "?b", "n", "_", "пб"])
def test_a_segment_that_the_plan_does_not_have_is_none(typed):
    assert meant(typed, segments("windrower")["velocities"]).names == ()


def test_what_may_be_several_things_is_not_guessed():
    known = {"πa": frozenset(), "εa": frozenset(), "na": frozenset()}
    assert meant("?a", known).names == ("πa", "εa")
    assert meant("пa", known).names == ("πa", "na")
    assert meant("πА", known).names == ("πa",)
    # what is typed right is what it is, whatever else is like it
    assert meant("P", {"P": frozenset(), "p": frozenset()}).names == ("P",)
    assert meant("Р", {"P": frozenset(), "p": frozenset()}).names == ("P",)


@each(
    "typed, due",
    [
        *[(one, "velocities") for one in ("скорости", "План скоростей", "Velocity plan", "vel")],
        *[(one, "velocities") for one in ("СКОРОСТЕЙ", "план скорости", "cкорости", "velocity")],
        *[(one, "velocities") for one in ("vеlocities", "СЃРєРѕСЂРѕСЃС‚Рё", "Plan of velocities")],
        *[(one, "accelerations") for one in ("ускорения", "acceleration", "План ускорений")],
        *[(one, "positions") for one in ("положения", "План положений", "Positions")],
        *[(one, "forces") for one in ("силы", "план сил", "Силовой расчет", "Force analysis")],
        *[(one, "diagrams") for one in ("диаграммы", "Диаграмма", "Diagrams")],
        *[(one, "flywheel") for one in ("маховик", "Маховика")],
        *[(one, "results") for one in ("Результаты", "result")],
    ],
)
def test_plans_in_both_languages(typed, due):
    assert plan_meant(typed, PLANS).names == (due,)


@pytest.mark.parametrize("typed", ["", "v", "plan", "план", "rates", "1", "скорая помощь больным"])
def test_a_plan_that_there_is_not(typed):
    assert plan_meant(typed, PLANS).names == ()


def test_a_name_of_several_plans_is_not_guessed():
    plans = ("planetary-velocities", "planetary-rates", "velocities")
    assert plan_meant("скорости", plans).names == ("velocities",)
    assert plan_meant("Удельное скольжение", ("sliding", "sliding-table")).names == (
        "sliding",
        "sliding-table",
    )


@each(
    "typed, due",
    [
        *[("01", "1"), ("1.0", "1"), ("1,0", "1"), ("1.", "1"), ("011", "11"), ("№3", "3")],
        *[
            ("7 *", "7*"),
            ("9 **", "9**"),
            ("09хх", "9**"),
            ("9×", "9*"),
            ("7∗", "7*"),
            ("07*", "7*"),
            ("7х", "7*"),
            ("pos. 3", "3"),
            ("00", "0"),
        ],
        *[("105", "105°"), ("105 deg", "105°"), ("-", ""), ("—", ""), ("₇", "7")],
    ],
)
def test_positions(typed, due):
    assert position_meant(typed, POSITIONS).names == (due,)


@pytest.mark.parametrize(
    "typed", ["12", "1.5", "8*", "7**", "-1", "one", "1 2 3 4 5 6 7 8 9 0 1 2 3"]
)
def test_positions_that_there_are_not(typed):
    assert position_meant(typed, POSITIONS).names == ()
