"""The moment of inertia of a link as a mark: given, or that of an even rod, calculated."""

from __future__ import annotations

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import rod_inertia
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.mechanism.records import Link


def inertia_of(draft: Draft, link: Link) -> Mark:
    """Return the moment of inertia of a link that has one, kg·m², in the view that is open."""
    n = link.number
    assert link.inertia is not None
    if link.rod is None or link.mass is None:
        return draft.take(Number, f"J_{n}", link.inertia, "kg·m²")
    mass = draft.constant(f"m_{n}", link.mass, "kg")
    length = draft.constant(f"l_{n}", link.rod, "m")
    return draft.draw(rod_inertia, f"J_{n}", mass, length, unit="kg·m²")
