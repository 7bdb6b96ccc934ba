"""What sheets can show, by the names that scenes write."""

from __future__ import annotations

from collections.abc import Mapping, Set
from itertools import chain

from graphic_tmm.scene.registry import sections

_PLANS: Mapping[str, int] = {
    "positions": 10, "velocities": 20, "accelerations": 30, "equations": 40,
    "structure": 90, "results": 95, "velocity table": 0, "acceleration table": 0,
}  # fmt: skip
"""What a sheet can show of a mechanism, by rank on a sheet that does not say what it shows; 0: not there."""
FREE_PLACES = ("lettering", "symbols")
"""What a sheet can show without a mechanism or a part."""
NEEDS: Mapping[str, tuple[str, ...]] = {
    "velocity table": ("velocities",),
    "acceleration table": ("accelerations",),
    **dict.fromkeys(("equations", "results"), ("velocities", "accelerations")),
}
"""The plans of which a place shows something."""


def known() -> tuple[str, ...]:
    """Return all places: first those of a sheet that does not say what it shows, in their order."""
    ranks = dict(_PLANS)
    for section in sections():
        ranks.update(section.places)
    usual = sorted((place for place in ranks if ranks[place]), key=ranks.__getitem__)
    return (*usual, *(place for place in ranks if not ranks[place]), *FREE_PLACES)


def usual(asked: Set[str], *, mechanism: bool) -> tuple[str, ...]:
    """Return what stands on a sheet that does not say what does: all that ``asked``, sections, call for."""
    there = {place for place in _PLANS if mechanism and _PLANS[place]}
    for section in sections():
        there.update(section.places if section.name in asked else ())
    return tuple(place for place in known() if place in there)


def alone() -> tuple[str, ...]:
    """Return what a sheet can show of parts that need no mechanism."""
    return tuple(place for section in sections() if section.alone for place in section.places)


def with_plans(places: Set[str]) -> set[str]:
    """Return places, with the plans of those that would else show nothing."""
    lone = [plans for place, plans in NEEDS.items() if place in places and not places & set(plans)]
    return {*places, *chain.from_iterable(lone)}
