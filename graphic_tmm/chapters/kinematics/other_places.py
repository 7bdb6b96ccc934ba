"""Where a plate lies in the other places that it has, which a student may take for the one that is meant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.values import Line, Reals
from graphic_tmm.chapters.kinematics.branches import Search, drawn_places
from graphic_tmm.chapters.kinematics.closings import SpecialClosing, with_plates
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.tracings import Branch
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.readers.columns import Elsewhere, GroupPlaces

PLACES = "other places"
ALIKE = 1e-3
"""Places whose plates, and first legs, are turned by less from one another, degrees, are one."""


def search_of(tried: Survey, group: str) -> Search:
    """Return what seeks the places of a group on the small board of a mechanism."""
    tracing = tried.tracings[group]

    def loci(row: Reals) -> list[Any]:
        reading = tried.at(row[None, :], tracing.loci)
        return [reading[mark] for mark in tracing.loci]

    return Search(tracing, loci, tried.pairs[0].sweep)


class Traced(NamedTuple):
    """A group that is laid, at a coordinate of the drive: its places there that go on, each a branch."""

    closing: SpecialClosing
    search: Search
    at: float
    places: tuple[tuple[Line, Branch], ...]

    def taken(self, branch: Branch, row: Reals) -> bool:
        """Tell whether a branch is that of the drawing, at coordinates where both are there."""
        own, other = (np.stack(one.near(row)) for one in (self.closing.branch, branch))
        away = np.abs((other - own + 180.0) % 360.0 - 180.0)
        return not (np.isfinite(away).any() and np.nanmax(away) > ALIKE)


def _followed(search: Search, at: float) -> Iterator[tuple[Line, Branch]]:
    """Yield all places at a coordinate of the drive, followed; none that comes back elsewhere."""
    for place in search.places(at):
        try:
            yield place, search.follow(place, at)
        except StructureError:
            continue


def _coordinates(drawn: Drawn) -> Reals:
    row = drawn.project.coordinates or ()
    return np.array([np.nan if one is None else one for one in row])


def traced_groups(drawn: Drawn) -> tuple[Traced, ...]:
    """Return the groups that are laid, where the main position is or the first; sought once for a drawing."""
    found: tuple[Traced, ...] | None = drawn.cache.get(PLACES)
    if found is None:
        found = drawn.cache[PLACES] = tuple(_traced(drawn))
    return found


def _traced(drawn: Drawn) -> Iterator[Traced]:
    plan, row = KINEMATICS_PLAN.of(drawn.project), _coordinates(drawn)
    if plan is None or not row.size:
        return
    for closing in with_plates(plan.positions.closings, PLACES):
        there = np.flatnonzero(np.isfinite(closing.branch.near(row)[1]))
        if there.size:
            at = float(row[drawn.main if drawn.main in there else there[0]])
            search = search_of(plan.tried, closing.group.name)
            yield Traced(closing, search, at, tuple(_followed(search, at)))


def other_places(drawn: Drawn) -> Iterator[Elsewhere]:
    """Yield the other places of each plate, or of two that are joined."""
    row = _coordinates(drawn)
    for one in traced_groups(drawn):
        for _, branch in one.places:
            if not one.taken(branch, row):
                near = zip(one.closing.near, branch.near(row), strict=True)
                yield Elsewhere(one.closing.root, {mark: angle[None, :] for mark, angle in near})


def group_places(drawn: Drawn) -> Iterator[GroupPlaces]:
    """Yield the places of each group that is laid, drawn small, where it has several."""
    row = _coordinates(drawn)
    for one in traced_groups(drawn):
        taken = [one.taken(branch, row) for _, branch in one.places]
        if len(taken) > 1 and any(taken):
            places = drawn_places(one.search, one.at, (place for place, _ in one.places))
            yield GroupPlaces(one.closing.group.name, places, taken.index(True))
