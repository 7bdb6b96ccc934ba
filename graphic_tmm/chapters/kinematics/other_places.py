"""Where a plate lies in the other places that it has, which a student may take for the one that is meant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.kinematics.branches import Search
from graphic_tmm.chapters.kinematics.closings import Branch, PlateClosing
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.tracings import PlateTracing
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.readers.columns import Elsewhere

PLACES = "other places"
ALIKE = 1e-3
"""Places whose plates are turned by less from one another, degrees, are one."""


def search_of(tried: Survey, closing: PlateClosing) -> Search:
    """Return what seeks the places of a plate on the small board of a mechanism."""
    step = tried.construction.step(closing.root)
    assert step is not None
    marks, lengths = step.uses[:3], step.uses[3:6]

    def loci(row: Reals) -> list[Any]:
        reading = tried.at(row[None, :], marks)
        return [reading[mark] for mark in marks]

    at = np.array([[tried.pairs[0].sweep.low]])
    reading = tried.at(at, lengths)
    apart, x, y = (float(reading[one].flat[0]) for one in lengths)
    link = tried.mechanism.by_number[closing.plate]
    tracing = PlateTracing(closing.group, link, marks, 0.0, apart, complex(x, y))
    return Search(tracing, loci, tried.pairs[0].sweep)


def _branches(tried: Survey, k: int, begun: float) -> tuple[Branch, ...]:
    """Return all places of a plate at a coordinate of the drive, followed; none that comes back elsewhere."""
    closing = tried.positions.closings[k]
    assert isinstance(closing, PlateClosing)
    search, found = search_of(tried, closing), list[Branch]()
    for place in search.places(begun):
        try:
            found.append(search.follow(place, begun))
        except StructureError:
            continue
    return tuple(found)


def other_places(drawn: Drawn) -> Iterator[Elsewhere]:
    """Yield the other places of each plate on three legs; they are sought once for a drawing."""
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
    for k, closing in enumerate(made.positions.closings):
        if not isinstance(closing, PlateClosing):
            continue
        own = closing.branch.near(at)[1]
        there = np.flatnonzero(np.isfinite(own))
        if not there.size:
            continue
        for one in _branches(made.tried, k, float(at[there[0]])):
            near = one.near(at)
            away = np.abs((near[1] - own + 180.0) % 360.0 - 180.0)
            if np.isfinite(away).any() and np.nanmax(away) > ALIKE:
                yield Elsewhere(
                    closing.root,
                    {mark: angle[None, :] for mark, angle in zip(closing.near, near, strict=True)},
                )
