"""Where a plate lies in the other places that it has, which a student may take for the one that is meant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.kinematics.branches import Search
from graphic_tmm.chapters.kinematics.closings import Branch, with_plates
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.readers.columns import Elsewhere

PLACES = "other places"
ALIKE = 1e-3
"""Places whose plates are turned by less from one another, degrees, are one."""


def search_of(tried: Survey, group: str) -> Search:
    """Return what seeks the places of a group on the small board of a mechanism."""
    tracing = tried.tracings[group]

    def loci(row: Reals) -> list[Any]:
        reading = tried.at(row[None, :], tracing.loci)
        return [reading[mark] for mark in tracing.loci]

    return Search(tracing, loci, tried.pairs[0].sweep)


def _branches(tried: Survey, group: str, begun: float) -> Iterator[Branch]:
    """Yield all places at a coordinate of the drive, followed; none that comes back elsewhere."""
    search = search_of(tried, group)
    for place in search.places(begun):
        try:
            yield search.follow(place, begun)
        except StructureError:
            continue


def other_places(drawn: Drawn) -> Iterator[Elsewhere]:
    """Yield the other places of each plate, or of two that are joined; they are sought once for a drawing."""
    found: tuple[Elsewhere, ...] | None = drawn.cache.get(PLACES)
    if found is None:
        found = drawn.cache[PLACES] = tuple(_places(drawn))
    yield from found


def _places(drawn: Drawn) -> Iterator[Elsewhere]:
    made = KINEMATICS_PLAN.of(drawn.project)
    row = drawn.project.coordinates
    if made is None or not row:
        return
    at = np.array([np.nan if one is None else one for one in row])
    for closing in with_plates(made.positions.closings, PLACES):
        own = closing.branch.near(at)[1]
        there = np.flatnonzero(np.isfinite(own))
        if not there.size:
            continue
        for one in _branches(made.tried, closing.group.name, float(at[there[0]])):
            near = one.near(at)
            away = np.abs((near[1] - own + 180.0) % 360.0 - 180.0)
            if np.isfinite(away).any() and np.nanmax(away) > ALIKE:
                yield Elsewhere(
                    closing.root,
                    {mark: angle[None, :] for mark, angle in zip(closing.near, near, strict=True)},
                )
