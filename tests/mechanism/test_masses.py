"""The moment of inertia of a rod: derived as a step where a scene says so, and what it comes to."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from support.boards import in_usual_size
from support.scenes import edited

from graphic_tmm.board.operations.energetics import rod_inertia
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.mechanism.masses import mass_centre
from graphic_tmm.mechanism.records import Drive, Link, Mechanism, shared
from graphic_tmm.scene.read import read


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


OWN = 'J      = "0.323 kg*m^2"'
ROD = 'rod    = "393.6 mm"'


def test_the_inertia_of_a_rod_is_a_step_of_its_own(tmp_path: Path) -> None:
    (drawn,) = in_usual_size(read(edited(tmp_path, (OWN, ROD), name="windrower"))).boards
    steps = [step for step in drawn.construction.steps if step.op is rod_inertia]
    assert steps
    assert all(step.it.name == "J_3" and step.reason for step in steps)
    for step in steps:
        assert math.isclose(float(drawn.reading[step.it][0, 0]), 25.0 * 0.3936**2 / 12.0)


def test_a_rod_and_its_moment_of_inertia_give_the_same_forces(tmp_path: Path) -> None:
    told = f'J      = "{25.0 * 0.3936**2 / 12.0!r} kg*m^2"'
    found = []
    for k, own in enumerate((ROD, told)):
        folder = tmp_path / str(k)
        folder.mkdir()
        (drawn,) = in_usual_size(
            read(edited(folder, (OWN, own), name="windrower")), exact=True
        ).boards
        couples = {s.it.name: drawn.numbers.drawn[s.it] for s in drawn.construction.steps}
        found.append(couples["M_{i3}"])
    assert np.allclose(found[0], found[1], rtol=1e-12, equal_nan=True)


@pytest.mark.parametrize(
    ("own", "says"), [(f"{OWN}\n{ROD}", "leave one of the two out"), (ROD, "give its mass")]
)
def test_a_rod_is_told_by_its_mass_and_its_length_alone(
    tmp_path: Path, own: str, says: str
) -> None:
    edits = [(OWN, own)]
    if "J " not in own:
        edits.append(('mass   = "25 kg"\n', ""))
    with pytest.raises(SceneError, match=says):
        read(edited(tmp_path, *edits, name="windrower"))
