"""What counts as right of a check's findings: the place, the family, the member; what a sure wrong name is."""

from __future__ import annotations

from functools import cache

import pytest
from support.students.early import EARLY
from support.students.measuring import outcome
from support.students.planting import Planted, plant
from support.students.told import step_in

from graphic_tmm.checking.records import INSTRUMENT, MISTAKE, UNKNOWN, Likely, Report

A = "accelerations"
DUE = Likely(
    "operand", "step 5: an2 was calculated with CB instead of AB", (), 3, 0.0, (), MISTAKE, "operand", A,
    "an2", "", "", 0.95,
)  # fmt: skip


@cache
def planted() -> Planted:
    """A normal component of a four-bar that was calculated with another link."""
    one = plant(EARLY[0], "fb", 4, "both")
    assert one is not None
    (truth,) = one.truths
    assert truth.shown
    assert {(A, "an2"), (A, "πn3")} & truth.places
    return one


def due() -> Likely:
    """A finding that is right."""
    (truth,) = planted().truths
    name = "an2" if (A, "an2") in truth.places else "πn3"
    links = " ".join(("OA", "AB", "CB"))
    return DUE._replace(segment=name, position=truth.position, says=f"with {links}")


def report(*found: Likely) -> Report:
    return Report("", "", "en", "student", (), found)


def told(*found: Likely) -> tuple[bool, ...]:
    one = outcome(planted(), report(*found), EARLY)
    return one.place, one.family, one.member, one.right == 1, one.wrong == 1


def test_a_right_name_is_right() -> None:
    assert told(due()) == (True, True, True, True, False)


@pytest.mark.parametrize(
    ("change", "wanted"),
    [
        ({"segment": "n2b"}, (False, True, False, False, True)),
        ({"plan": "velocities"}, (False, True, False, False, True)),
        ({"family": "meeting"}, (True, False, False, False, True)),
        ({"says": "with that of another link"}, (True, True, False, True, False)),
        ({"chance": 0.6}, (True, True, True, False, False)),
        ({"chance": 0.6, "family": "meeting"}, (True, False, False, False, False)),
        ({"kind": UNKNOWN, "family": ""}, (True, False, False, False, False)),
        ({"kind": INSTRUMENT}, (False, False, False, False, False)),
    ],
)
def test_what_is_wrong_of_a_name_is_told(
    change: dict[str, object], wanted: tuple[bool, ...]
) -> None:
    assert told(due()._replace(**change)) == wanted  # type: ignore[arg-type]


def test_a_name_that_no_reading_tells_apart_is_right() -> None:
    found = due()
    other = found._replace(says="with something else", like=(found.says,))
    assert told(other) == (True, True, True, True, False)


def test_nothing_told_is_not_right() -> None:
    assert told() == (False,) * 5


def test_the_first_finding_counts() -> None:
    wrong = due()._replace(family="meeting", segment="n2b", chance=0.5)
    assert told(wrong, due()) == (False, False, False, True, False)


def test_outside_the_grammar_every_sure_name_is_wrong() -> None:
    one = planted()
    outside = one._replace(truths=(one.truths[0]._replace(families=()),))
    assert outcome(outside, report(due()), ()).wrong == 1
    assert outcome(outside, report(due()._replace(kind=UNKNOWN)), ()).wrong == 0


def test_a_mistake_that_gives_the_same_figures_is_right() -> None:
    """Doubling 2 or doubling what it is laid off with: a factor of the step, under another family's name."""
    half = next(kind for kind in EARLY if kind.name == "Coriolis left out")
    one = plant(half, "rpr", 5, "mm")
    assert one is not None
    (truth,) = one.truths
    found = DUE._replace(family="left out", segment="ak2", position=truth.position)
    other = truth._replace(families=("factor",))
    assert outcome(one._replace(truths=(other,)), report(found), EARLY).family
    assert not outcome(one._replace(truths=(other,)), report(found), ()).family


@pytest.mark.parametrize(
    ("says", "wanted"),
    [
        ("Velocity plan, step 5: (aa3) has the opposite sense", ("velocities", "aa3")),
        ("Acceleration plan, step 1: a_A was taken 2 times as large", (A, "aA")),
        ("Loads, step 8: P_i3 has the opposite sense, at position 3 only", ("forces", "Pi3")),
        ("Force polygon of group 2-3, step 8: y_Pi2 was left out", ("forces", "Pi2")),
        ("l_AS2, which is given, was taken 2.014 times as large", ("", "AS2")),
        ("no known mistake explains what is wrong: look at Velocity plan, step 9: ω_2", ("velocities", "ω2")),
    ],
)  # fmt: skip
def test_a_sentence_tells_its_step_as_the_student_calls_it(
    says: str, wanted: tuple[str, str]
) -> None:
    assert wanted in step_in(says)
