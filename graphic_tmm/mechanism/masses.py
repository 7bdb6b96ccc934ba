"""The mass of a link: its centre, declared or its only point in no pair; its moment of inertia."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import rod_inertia
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Link, Mechanism


def free_points(points: Iterable[str], joined: Collection[str]) -> tuple[str, ...]:
    """Return the letters of a link that are no turning pair."""
    return tuple(letter for letter in points if letter not in joined)


def mass_centre(mechanism: Mechanism, link: Link) -> str:
    """Return the letter of a link's mass centre.

    Raises
    ------
    StructureError
        If none is declared; the message names a point that joins the link to nothing, if there is one.
    """
    if link.centre is not None and link.centre in link.points:
        return link.centre
    free = free_points(link.points, mechanism.pins)
    if not free and len(link.points) > 1:
        first, second, *_ = link.points
        raise StructureError(
            said(
                "link {number} has a mass, but no point that is its mass centre: put one into its points, such "
                "as S{number}, of an even rod halfway from {first} to {second}, and write centre = "
                '"S{number}" in its [[link]]',
                number=link.number,
                first=first,
                second=second,
            ),
            f"link {link.number}, centre",
        )
    meant = next(iter((*free, *link.points)), f"S{link.number}")
    points = said("it has no point yet")
    if link.points:
        points = said("its points are {points}", points=", ".join(link.points))
    raise StructureError(
        said(
            "link {number} has a mass, but nothing says which point is its mass centre: write "
            'centre = "{meant}" in its [[link]] ({points})',
            number=link.number,
            meant=meant,
            points=points,
        ),
        f"link {link.number}, centre",
    )


def inertia_letter(link: Link) -> str:
    """Return the letter of a moment of inertia that is given: with the mass centre, else with the number.

    J_F is that of a flywheel, J_L would be that of all links.
    """
    return f"J_{{{link.centre}}}" if link.centre not in (None, "F", "L") else f"J_{link.number}"


def inertia_of(draft: Draft, link: Link) -> Mark:
    """Return the moment of inertia of a link that has one, kg·m², in the view that is open."""
    n = link.number
    assert link.inertia is not None
    if link.rod is None or link.mass is None:
        return draft.take(Number, inertia_letter(link), link.inertia, "kg·m²")
    mass = draft.constant(f"m_{n}", link.mass, "kg")
    length = draft.constant(f"l_{n}", link.rod, "m")
    return draft.draw(rod_inertia, f"J_{n}", mass, length, unit="kg·m²")
