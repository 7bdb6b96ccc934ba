"""The scale factors of all plans seen together: a copy has none of its own, nor what a wrong plan spoils."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence

import numpy as np

from graphic_tmm.checking.congruence.lengths import Group, Read
from graphic_tmm.checking.congruence.witnesses import PLENTY, Verdict, fitting, of_siblings

ALIKE, COPY = 0.015, 0.16
"""Scale factors of all plans so nearly alike (logarithms), and no farther off, are those of a copy."""
UNLIKELY = 0.05
"""Lengths alone say no scale factor that is nearer to the due one than this, if no other plan has its own."""


def not_copied(found: Mapping[Group, Verdict], plans: Collection[str]) -> dict[Group, Verdict]:
    """Return the scale factors without those that a copy, or the paper, explains: all plans look alike.

    ``plans``: those of points.
    """
    mere = {g: v for g, v in found.items() if v.by in ("round", "lengths", "rates")}
    ratios = [math.log(one.times) for one in mere.values()]
    near = {
        group
        for group, one in mere.items()
        if one.by != "rates" and abs(math.log(one.times)) <= UNLIKELY
    }
    if any(v.by and abs(math.log(v.times)) > COPY for g, v in found.items() if g.plan in plans):
        near = set()  # it is no copy
    elif len(mere) > 1 and max(map(abs, ratios)) <= COPY and np.ptp(ratios) <= 2 * ALIKE:
        near = set(mere)
    return {g: Verdict(among=v.among) if g in near else v for g, v in found.items()}


def not_spoilt(
    found: Mapping[Group, Verdict],
    lengths: Mapping[Group, Sequence[Read]],
    plans: Collection[str],
) -> dict[Group, Verdict]:
    """Return the scale factors without those of graphs and forces that may follow from a wrong plan."""
    fine = all(
        fitting(lengths[group], one.times)
        for group, one in found.items()
        if group.plan in plans and len(lengths[group]) > PLENTY
    )
    if fine:
        return dict(found)
    mere = {
        group
        for group, one in found.items()
        if group.plan not in plans and one.by in ("round", "lengths")
    }
    return {g: Verdict(among=v.among) if g in mere else v for g, v in found.items()}


def with_siblings(
    found: Mapping[Group, Verdict], lengths: Mapping[Group, Sequence[Read]]
) -> dict[Group, Verdict]:
    """Return the verdicts; a few lengths may be drawn to the scale factor of others of their plan."""
    own = [(group, one) for group, one in found.items() if one.times != 1.0]
    better = dict(found)
    for group, one in found.items():
        if one.by or one.against:
            continue
        for other, its in own:
            if (other.plan, other.unit) == (group.plan, group.unit):
                mu = other.mu / its.times
                better[group] = of_siblings(group, lengths[group], mu, its) or better[group]
    return better


def of_other_polygons(
    found: Mapping[Group, Verdict],
    lengths: Mapping[Group, Sequence[Read]],
    stated: Mapping[Group, float],
) -> dict[Group, Verdict]:
    """Return the verdicts; a scale factor stated for one polygon is of another one that is drawn to it.

    ``stated``: by groups, SI a mm; they are due in others.
    """
    better = dict(found)
    for group, mu in stated.items():
        read, times = lengths.get(group, ()), group.mu / mu
        if read and not better[group].by and fitting(read, times) and not fitting(read, 1.0):
            better[group] = Verdict(times, "stated", len(read), len(read))
    return better
