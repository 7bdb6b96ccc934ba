"""A mass centre is the point that a scene declares: no letter is one, no letter is none."""

from __future__ import annotations

import pytest

from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.masses import mass_centre
from graphic_tmm.mechanism.records import Drive, Link, Mechanism, shared


def mechanism(**rod: object) -> Mechanism:
    crank = Link(1, {"O": 0j, "S": 1 + 0j})
    coupler = Link(2, {"S": 0j, "S2": 2 + 0j, "E": 1 + 0j}, mass=1.0, **rod)  # type: ignore[arg-type]
    rocker = Link(3, {"C": 0j, "S2": 2 + 0j})
    return Mechanism(Link(0, {"O": 0j, "C": 2 + 0j}), (crank, coupler, rocker), Drive(1, 1.0))


def test_a_pin_is_a_letter_on_two_links_whatever_the_letter() -> None:
    assert mechanism().pins == {"O", "S", "S2", "C"}
    assert shared([{"A": 0j}, {"A": 0j, "B": 0j}, {"A": 0j, "C": 0j}]) == {"A"}


@pytest.mark.parametrize("letter", ["E", "S2"])
def test_the_declared_point_is_the_centre(letter: str) -> None:
    made = mechanism(centre=letter)
    assert mass_centre(made, made.by_number[2]) == letter


def test_none_is_taken_for_granted_and_the_free_point_is_named() -> None:
    made = mechanism()
    with pytest.raises(StructureError, match=r'link 2 has a mass.* write centre = "E".*S, S2, E'):
        mass_centre(made, made.by_number[2])
