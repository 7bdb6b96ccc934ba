"""The kinetic energy of the links: of each its translation and its rotation, by the velocity plan."""

from __future__ import annotations

from operator import attrgetter
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import added, rotation, translation
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.flywheel import reasons as why
from graphic_tmm.chapters.kinematics.motion import Motion, reading_of
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.inertia import inertia_of
from graphic_tmm.mechanism.masses import mass_centre
from graphic_tmm.mechanism.records import Link, Mechanism


class Energies(NamedTuple):
    """The parts of the energy by name, T_{2t} of translation and T_{2r} of rotation (J), and their sum."""

    parts: dict[str, Mark]
    total: Mark


def draw_energies(draft: Draft, mechanism: Mechanism, velocities: Motion) -> Energies:
    """Calculate the energies of all links that have a mass or a moment of inertia, in the open view.

    Raises
    ------
    StructureError
        If no link has any, or a mass has no centre on the plan.
    """
    parts: dict[str, Mark] = {}
    for link in sorted(mechanism.links, key=attrgetter("number")):
        parts |= _of_link(draft, mechanism, link, velocities)
    if not parts:
        raise StructureError(
            said("no link has a mass or J: write mass and J of the links that have them"),
            "flywheel",
            head="flywheel",
        )
    total: Mark | None = None
    for part in parts.values():
        total = (
            part
            if total is None
            else draft.draw(
                added, "T_{L}", total, part, unit="J", role=roles.SUM, why=why.LINKS_ENERGY
            )
        )
    assert total is not None
    return Energies(parts, total)


def _of_link(draft: Draft, mechanism: Mechanism, link: Link, velocities: Motion) -> dict[str, Mark]:
    n, found = link.number, {}
    if link.mass:
        segment = _speed(draft, mechanism, link, velocities)
        if segment is not None:
            mass = draft.take(Number, f"m_{n}", link.mass, "kg")
            found[f"T_{{{n}t}}"] = draft.draw(translation, f"T_{{{n}t}}", mass, segment, unit="J")
    rate = velocities.rates.get(n)
    if link.inertia and rate is not None:
        inertia = inertia_of(draft, link)
        found[f"T_{{{n}r}}"] = draft.draw(rotation, f"T_{{{n}r}}", inertia, rate, unit="J")
    return found


def _speed(draft: Draft, mechanism: Mechanism, link: Link, velocities: Motion) -> Mark | None:
    """Return the reading of the velocity of a link's mass centre; None where the centre stands still."""
    images = velocities.images.by_letter.get(link.number, {})
    image = images.get(mass_centre(mechanism, link))
    return None if image is None else reading_of(draft, velocities, image)
