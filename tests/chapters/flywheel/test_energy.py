"""Energies of links: each part by its formula, the centre found on the plan, faults told."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import SHEETS

from graphic_tmm.chapters.flywheel.energy import Energies
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.records import Link
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder


def scene(**links: dict[str, object]) -> Scene:
    """Return the engine with fields of its links changed: link2 = {...}."""
    made = read(SHEETS / "engine")
    assert made.mechanism is not None
    changed = tuple(
        replace(link, **links.get(f"link{link.number}", {}))  # type: ignore[arg-type]
        for link in made.mechanism.links
    )
    return replace(
        made,
        mechanism=replace(made.mechanism, links=changed),
        sheets=(SheetOrder("A1", ("positions", "velocities", "flywheel")),),
    )


def energies(made: Drawn) -> Energies:
    assert FLYWHEEL_PLAN.of(made) is not None
    return FLYWHEEL_PLAN.on(made).energies


def test_a_link_without_mass_or_inertia_has_no_part() -> None:
    made = drawn_of(scene(link2={"mass": None}, link1={"inertia": None}), exact=True)
    assert set(energies(made).parts) == {"T_{2r}", "T_{3t}"}
    total = sum(made.reading[mark] for mark in energies(made).parts.values())
    np.testing.assert_allclose(made.reading[energies(made).total], total)


def test_a_centre_at_the_crank_pin_has_the_speed_of_the_pin() -> None:
    made = drawn_of(scene(link2={"mass": 2.0, "centre": "A", "inertia": None}), exact=True)
    part = made.reading[energies(made).parts["T_{2t}"]]
    np.testing.assert_allclose(part, 2.0 * (50 * 0.3) ** 2 / 2, rtol=1e-12)


def test_a_centre_on_the_frame_does_not_move() -> None:
    made = drawn_of(scene(link1={"mass": 8.0, "centre": "O"}), exact=True)
    assert "T_{1t}" not in energies(made).parts


def test_a_mass_without_a_centre_is_told() -> None:
    with pytest.raises(
        StructureError, match=r'link 2 has a mass, but nothing says .*write centre = "S2"'
    ):
        drawn_of(scene(link2={"centre": None}))


def test_links_are_records() -> None:
    assert isinstance(scene().mechanism.links[0], Link)  # type: ignore[union-attr]
