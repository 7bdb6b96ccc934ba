"""Readings that were made without the package get the verdict that they deserve, and no wrong name."""

from __future__ import annotations

import random
import re
from dataclasses import replace
from functools import cache, partial

import pytest
from support.gallery import CASES, SHEETS

from graphic_tmm.checking.check import Checker, check
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import DOUBTFUL, FINE, MISTAKE, SLIP, WRONG, Judged, Report, Taken
from graphic_tmm.scene.read import read

SCENES = ("sc", "fb", "rpr", "six")
SURE = frozenset({"fine", "wrong"})
MEETING = "of two meetings the other one"
BLAMED = {
    "Coriolis_turned_six": "ak2 has the opposite sense",
    "coriolis_left_out_six": "ak2 was left out",
    "coriolis_along_rpr": r"ak2\) was drawn parallel to \(BA\) instead of square",
    "coriolis_half_rpr": "ak2 was calculated as ω_3·aa3·μ_v/μ_a",
    "eps_total_sc": "ε_2 was calculated with ab instead of n2b",
    "normal_forgotten_sc": "an2 was left out",
    "normal_from_the_wrong_end_sc": "an2 has the opposite sense|an2 points away",
    "normal_pb_sc": "an2 was calculated with pb instead of ab",
    "normal_v_over_l_rpr": r"πn3 was calculated as pa3·μ_v/\(BA·μ_l\)/μ_a",
    "normal_wrong_link_sc": "an2 was calculated with OA instead of AB",
    "other_assembly_fb": f"{MEETING} was marked for B",
    "other_dead_centre_sc": f"{MEETING} was marked for B|counted from 180°",
    "mirrored_positions_fb": f"{MEETING} was marked for B",
    "mirrored_positions_sc": f"{MEETING} was marked for B",
    "mirrored_positions_six": f"{MEETING} was marked for D",
    "rowshift_sc": "figures of the table stand one row too low",
    "similarity_mirrored_fb": "built mirrored for e",
    "tangent_from_a_sc": "drawn from a instead of n2",
    "velocity_along_rod_sc": "",
    "wrong_length_sc": "",
}
"""Drawings with a mistake, and what is said of it; nothing where no name may be given as sure."""


@cache
def checker(name: str) -> Checker:
    """What checks drawings of a scene: of those made outside, or of the package."""
    if name in SCENES:
        return Checker(read(CASES / "check" / f"{name}.toml"))
    return Checker(read(SHEETS / name))


def drawing(case: str) -> tuple[Checker, tuple[Taken, ...]]:
    name = "six" if case.startswith("honest") else case.rsplit("_", 1)[-1]
    return checker(name), read_readings(CASES / "check" / f"{case}.csv")


@cache
def report(case: str) -> Report:
    by, rows = drawing(case)
    return by.of(rows).report


@cache
def judged(case: str) -> tuple[Judged, ...]:
    by, rows = drawing(case)
    return by.verdicts(rows)[0]


def verdicts(case: str, verdict: str) -> set[tuple[str, str]]:
    rows = judged(case)
    return {(one.taken.position, one.taken.segment) for one in rows if one.verdict == verdict}


@pytest.mark.slow
@pytest.mark.parametrize("case", ["honest_six_mm", "honest_six_points"])
def test_an_honest_drawing_is_fine(case: str) -> None:
    assert not verdicts(case, WRONG)
    assert len(verdicts(case, DOUBTFUL)) <= 0.05 * len(judged(case))


@pytest.mark.slow
@pytest.mark.parametrize("case", ["pa_engine", "pa_sc"])
def test_a_length_half_a_division_off_what_is_calculated_is_fine(case: str) -> None:
    assert {one.verdict for one in judged(case)} == {FINE}


@pytest.mark.slow
def test_calculated_figures_are_judged_for_slips_not_for_rounding() -> None:
    """39.8 for 39.79 1/s, 78.4 for 78.48 N, 373 for 372.78 N; but no length of another μ, no other speed."""
    assert {s for _, s in verdicts("calc_windrower", FINE)} == {"omega1", "G1", "G3", "G5", "F5"}
    assert verdicts("calc_windrower", WRONG) == {("1", "pa")}  # 82.5 mm for 54.35
    assert {s for _, s in verdicts("calc_engine", FINE)} == {"omega1", "pa"}
    assert verdicts("calc_engine", WRONG) == {("2", "πa")}  # 60 mm for 75
    assert verdicts("calc_lever", WRONG) == {("1", "omega1")}  # 10.5 1/s for 31.4


@pytest.mark.turns(5)
@pytest.mark.slow
@pytest.mark.parametrize("case", BLAMED)
def test_a_mistake_is_blamed_and_called_by_no_wrong_name(case: str) -> None:
    found = report(case)
    assert found.wrong
    said = [one.says for one in found.mistakes if one.kind == MISTAKE]
    sure = [one for one in found.mistakes if one.kind == MISTAKE and one.chance >= 0.8]
    assert bool(said) == bool(BLAMED[case])
    assert len(sure) <= 1
    assert not said or re.search(BLAMED[case], " or ".join((said[0], *found.mistakes[0].like)))


@pytest.mark.slow
def test_a_crank_that_stands_amiss_in_one_position_is_named_with_its_angle() -> None:
    (found,) = report("one_position_15deg_rpr").mistakes
    assert (found.kind, found.family, found.position) == (MISTAKE, "crank", "3")
    assert found.chance >= 0.8
    assert re.search("amiss by 1[3-7]°", found.says)


@pytest.mark.parametrize("scene", ["sc", "fb", "six"])
def test_the_point_that_is_mirrored_is_blamed_at_every_position(scene: str) -> None:
    point = "D" if scene == "six" else "B"
    wrong = verdicts(f"mirrored_positions_{scene}", WRONG)
    assert {position for position, segment in wrong if segment == point} == set("01234567")


def test_a_rate_found_from_another_segment_is_wrong() -> None:
    assert verdicts("eps_total_sc", WRONG) == {(k, "epsilon2") for k in "135"}


def test_what_follows_from_a_wrong_reading_names_it() -> None:
    """The normal component is wrong; what is drawn from it says so."""
    rows = judged("normal_pb_sc")
    assert {one.taken.segment for one in rows if one.verdict == WRONG} == {"an2"}
    followed = {one.taken.segment: one.follows.segment for one in rows if one.follows is not None}
    assert followed["πb"] == "an2"


@pytest.mark.turns(2)
@pytest.mark.parametrize("seed", [None, 1, 2])
@pytest.mark.parametrize("y", [828.4, 8284216.0])
@pytest.mark.slow
def test_a_point_from_which_nothing_more_can_be_drawn_was_written_amiss(
    y: float, seed: int | None
) -> None:
    """What was read behind it and cannot be drawn from it says nothing for another mistake.

    Exactly, and as a hand has it that is off by 0.2 mm and reads tenths.
    """
    rows = [*read_readings(CASES / "check" / "wild_point_crank-rocker.csv")]
    (k,) = (k for k, one in enumerate(rows) if one.key == ("positions", "A", "3*"))
    if seed is not None:
        off = partial(random.Random(seed).gauss, 0.0, 0.2)
        rows = [
            one._replace(x=round(one.x + off(), 1), y=round(one.y + off(), 1))
            if one.x is not None and one.y is not None
            else one
            for one in rows
        ]
    rows[k] = rows[k]._replace(y=y)
    scene = read(SHEETS / "crank-rocker")
    drawn_to = replace(scene.scales, mu_v=0.04, mu_a=5.0)
    (first,) = check(replace(scene, scales=drawn_to), rows, trials=50).mistakes
    assert (first.kind, first.segment) == (SLIP, "A")
