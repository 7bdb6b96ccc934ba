"""Drives: what a pair whose coordinate is given puts on the board.

A drive is a file here that declares a class DRIVE, a `DrivenPair`; it is found by being there, and takes what
it `fits`. A drive between bodies that stand makes the next one stand (crank, slider); one between two links
that move makes them one leg of a group, as long as it says (a rod in its cylinder).
"""

from __future__ import annotations

import pkgutil
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from graphic_tmm.board.draft import Draft
    from graphic_tmm.board.record import Mark
    from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
    from graphic_tmm.mechanism.records import Mechanism
    from graphic_tmm.mechanism.structure import Structure


@cache
def drives() -> tuple[type[DrivenPair], ...]:
    """Return the drives that there are, by their names."""
    rooms = (import_module(f"{__name__}.{one.name}") for one in pkgutil.iter_modules(__path__))
    return tuple(room.DRIVE for room in rooms if hasattr(room, "DRIVE"))


def driven(mechanism: Mechanism, structure: Structure) -> tuple[DrivenPair, ...]:
    """Return the drives of a mechanism, the one of the row first."""
    return tuple(
        next(kind(mechanism, one) for kind in drives() if kind.fits(one))
        for one in structure.driven
    )


def follow(
    draft: Draft, pairs: tuple[DrivenPair, ...], zero: float, row: Mark | None = None
) -> list[Mark]:
    """Return where each drive stands: the first at a ``row`` from ``zero`` on, the others as they follow."""
    first, *further = pairs
    at = first.ask(draft) if row is None else row
    return [at, *(one.follow(draft, first, at, zero) for one in further)]
