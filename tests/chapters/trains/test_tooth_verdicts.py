"""Verdicts on given tooth numbers: each condition by name, with its numbers, against the oracle."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction as F

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support import train_oracle as oracle

from graphic_tmm.chapters.trains.task import SCHEMES, Limits, PlanetaryTask, Train
from graphic_tmm.chapters.trains.tooth_verdicts import CONDITIONS, Verdict, check
from graphic_tmm.language.catalogue import speaking

C7 = PlanetaryTask("ring", 0.008, 302.0, ratio=4.55, tolerance=0.003)
RING = SCHEMES["ring"]


def verdicts(order: PlanetaryTask, teeth: tuple[int, ...], k: int) -> dict[str, list[Verdict]]:
    found: dict[str, list[Verdict]] = {}
    for verdict in check(order, Train(SCHEMES[order.scheme], teeth, k)):
        found.setdefault(verdict.condition, []).append(verdict)
    return found


def test_three_satellites_of_the_windrower_hold_everywhere() -> None:
    found = verdicts(C7, (25, 32, 89), 3)
    assert tuple(found) == CONDITIONS
    assert all(verdict.holds for group in found.values() for verdict in group)
    (assembly,), (ratio,) = found["assembly"], found["ratio"]
    assert (assembly.found, ratio.found) == (38.0, 4.56)
    assert ratio.text == "ratio: U_1H = 4.56 is +0.22 % from 4.55, within 0.3 %"
    assert [verdict.of for verdict in found["undercut"]] == ["1", "2"]
    assert {verdict.of for verdict in found["interference"]} == {"3-2"}


def test_four_satellites_cannot_be_put_in() -> None:
    found = verdicts(C7, (25, 32, 89), 4)
    wrong = [verdict for group in found.values() for verdict in group if not verdict.holds]
    assert [verdict.text for verdict in wrong] == ["assembly: (25 + 89)/4 = 28.5 is not whole"]
    assert wrong[0].found == 28.5


@pytest.mark.parametrize(
    ("teeth", "k", "name", "text"),
    [
        ((25, 32, 91), 4, "coaxial", "coaxial: 25 + 32 = 57, 91 − 32 = 59 is another distance"),
        (
            (25, 32, 89),
            6,
            "neighbours",
            "sin(180°/6) = 28.5 is not greater than 34: satellites touch",
        ),
        ((16, 41, 98), 3, "undercut", "undercut: z1 = 16 is less than 17"),
        ((25, 32, 39), 4, "interference", "interference: z3 − z2 = 7 is less than 8"),
        ((100, 18, 136), 2, "interference", "z3 = 136: its tips are in the roots of 18 teeth"),
    ],
)
def test_a_condition_that_fails_is_named(
    teeth: tuple[int, ...], k: int, name: str, text: str
) -> None:
    group = verdicts(C7, teeth, k)[name]
    assert any(text in verdict.text and not verdict.holds for verdict in group)


def test_rows_of_two_modules_are_checked_in_modules_of_the_first() -> None:
    teeth = (20, 20, 18, 50)
    order = PlanetaryTask("external-internal", 0.004, 1.0, module_2=0.005, teeth=teeth)
    found = verdicts(order, teeth, 2)
    (coaxial,), (assembly,) = found["coaxial"], found["assembly"]
    assert coaxial.holds
    assert coaxial.text == "coaxial: 20 + 20 = 40, (50 − 18)·1.25 = 40"
    assert assembly.text == "assembly: (20·18 + 20·50)/(2·2) = 340 is whole"
    assert "ratio" not in found


def test_a_train_that_stands_is_no_train() -> None:
    order = PlanetaryTask("external-external", 0.004, 1.0, teeth=(20, 20, 20, 20))
    (ratio,) = verdicts(order, (20, 20, 20, 20), 2)["ratio"]
    assert not ratio.holds
    assert ratio.text == "ratio: U_1H = 0: a shaft stands"
    (ratio,) = verdicts(replace(order, driving="H"), (20, 20, 20, 20), 2)["ratio"]
    assert not ratio.holds
    assert ratio.text == "ratio: U_H1 = ∞: a shaft stands"


def test_a_distance_below_nothing_has_a_minus() -> None:
    order = PlanetaryTask("internal", 0.004, 1.0, teeth=(20, 40))
    (coaxial,) = verdicts(order, (20, 40), 1)["coaxial"]
    assert not coaxial.holds
    assert "20 − 40 = −20" in coaxial.text


def test_a_number_below_nothing_has_a_minus_and_the_sign_of_its_language() -> None:
    order = PlanetaryTask("external-external", 0.004, 1.0, teeth=(100, 20, 20, 101))
    (assembly,) = verdicts(order, (100, 20, 20, 101), 3)["assembly"]
    assert "= −0.333333 is not whole" in assembly.text
    assert "= −0,333333" in speaking("ru")(assembly.text)


def test_a_single_satellite_has_no_neighbour() -> None:
    (found,) = verdicts(C7, (25, 32, 89), 1)["neighbours"]
    assert found.holds
    assert "none" in found.text


@given(st.data())
def test_verdicts_together_say_what_the_oracle_says(data: st.DataObject) -> None:
    name = data.draw(st.sampled_from(sorted(oracle.SENSES)))
    least = data.draw(st.sampled_from([12, 17, 20]))
    q = data.draw(st.sampled_from([F(1), F(5, 4), F(4, 5)])) if name != "ring" else F(1)
    z2, z3 = (data.draw(st.integers(12, 60)) for _ in range(2))
    z1 = data.draw(st.integers(12, 120))
    first, second = oracle.SENSES[name]
    if name == "ring":
        teeth: tuple[int, ...] = (z1, z2, z1 + 2 * z2)
    else:
        z4 = (z1 + first * z2) / q - second * z3
        teeth = (z1, z2, z3, max(1, round(z4)))
    order = PlanetaryTask(
        name, 0.004, 1.0, module_2=None if q == 1 else 0.004 * float(q),
        limits=Limits(least=least), teeth=teeth,
    )  # fmt: skip
    k, four = data.draw(st.integers(1, 6)), oracle.four(name, teeth)
    found = verdicts(order, teeth, k)
    held = {key: all(v.holds for v in group) for key, group in found.items() if key != "ratio"}
    assert all(held.values()) == oracle.sound(order, four, q, k)
    assert held["coaxial"] == oracle.coaxial(name, four, q)
    assert held["assembly"] == oracle.phases(name, four, k)
    assert held["neighbours"] == oracle.apart(name, four, q, k, 1.0) or not held["coaxial"]


def fits(teeth: tuple[int, ...], place: F, tooth: int) -> bool:
    """Whether a satellite of two rims, by this tooth in the mesh with ring 3, fits sun 1 and ring 5."""
    z1, z2, z3, z4, z5 = teeth
    turned = (z3 * place - tooth) / z2
    return (z1 * place + z2 * turned).denominator == (z5 * place - z4 * turned).denominator == 1


def test_satellites_of_three_central_wheels_go_together_where_one_turn_of_theirs_fits_all() -> None:
    """All turns of a satellite in the mesh with ring 3 are tried at every place: the others must fit, too."""
    draw, outcomes = random.Random("three"), set()
    for _ in range(80):
        teeth = oracle.random_teeth(draw, "3K")
        k = draw.randint(2, 4)

        due = all(any(fits(teeth, F(n, k), m) for m in range(teeth[1])) for n in range(k))
        order = PlanetaryTask("3K", 0.004, 1.0, teeth=teeth, satellites=(k,))
        found = check(order, Train(SCHEMES["3K"], teeth, k))
        assert all(one.holds for one in found if one.condition == "assembly") == due, (teeth, k)
        outcomes.add(due)
    assert outcomes == {True, False}
