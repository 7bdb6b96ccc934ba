"""Scale factors that a plan with a mistake may have: what is laid off first, or most lengths, have one ratio.

They are no decision: a drawing is judged by them where they, with a mistake, explain it better.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence

import numpy as np

from graphic_tmm.checking.congruence.lengths import SHORT, Group, Read, middle
from graphic_tmm.checking.congruence.witnesses import (
    ALONE,
    FEWEST,
    FIRST,
    FIRST_SHARE,
    GRAPHS,
    OWN,
    PLENTY,
    RANGE,
    Verdict,
    agreeing,
    fitted,
    fitting,
    meant,
    rounded,
    share,
)

SUPPOSED = "supposed"
"""What says a scale factor: lengths, with a mistake beside them."""
MOST = 0.4
"""Where nothing is laid off first, this share of the lengths must have one ratio."""
MARK = 10.0
"""What is read too much from the first mark of a ruler that bears a number, mm."""
MUCH = 0.6
"""So much of what lengths are off must be left at the most where they are taken as read from there."""
MERE = ("round", "lengths", "rates", SUPPOSED)
"""What may be a mistake that looks like a scale factor."""

Found = Mapping[Group, Verdict]


def supposed(
    found: Found, plain: Found, lengths: Mapping[Group, Sequence[Read]], stated: Collection[Group]
) -> list[dict[Group, Verdict]]:
    """Return other scale factors that plans may have been drawn in, the likelier first.

    ``found``: what is decided; ``plain``: what each plan says by itself; ``stated``: what needs no guess.
    """
    free = [group for group in found if group not in stated and found[group].by != "rows"]
    ways = (
        {g: one for g in free if (one := way(g, lengths[g], found[g], plain[g]))}
        for way in (_own, _most)
    )
    own, most = ways
    due = {
        g: Verdict() for g in free if found[g].by in MERE and 2 * found[g].agree < found[g].among
    }
    tried = [{**found, **own}] if own else []
    if most.keys() - own.keys():
        tried.append({**found, **most, **own})
    return tried + ([{**found, **own, **due}] if due else [])


def _own(group: Group, lengths: Sequence[Read], found: Verdict, plain: Verdict) -> Verdict | None:
    """Return the scale factor that a plan may have, other than the one that was found."""
    if plain.rates != 1.0 and abs(math.log(plain.rates / found.times)) > OWN:
        return Verdict(plain.rates, SUPPOSED, len(lengths), len(lengths))
    if found.times != 1.0:
        return None
    if (own := _from_a_mark(group, lengths)) or fitting(lengths, 1.0):
        return own
    if plain.times != 1.0:
        return plain._replace(by=SUPPOSED)
    laid = [one for one in lengths if one.laid]
    k = middle([one.ratio for one in laid])
    steady = len(laid) > 1 and share(laid, k, FIRST) >= FIRST_SHARE
    if steady and abs(k) > OWN and RANGE[0] < math.exp(k) < RANGE[1]:
        return settled(group, laid, math.exp(k))  # in one position it may be another
    return None


def _most(group: Group, lengths: Sequence[Read], found: Verdict, plain: Verdict) -> Verdict | None:
    """Return the scale factor that most lengths of a plan have, where it is another than was found."""
    if found.times != 1.0 or plain.times != 1.0 or fitting(lengths, 1.0):
        return None
    k = _mode(lengths)
    if not abs(k) > OWN or not GRAPHS[0] < math.exp(k) < GRAPHS[1]:
        return None
    alike = agreeing(lengths, k) > agreeing(lengths, 0.0)
    return settled(group, lengths, *fitted(lengths, k)) if alike else None


def _from_a_mark(group: Group, lengths: Sequence[Read]) -> Verdict | None:
    """Return the scale factor that all lengths have if they were read from the ruler's 1 cm mark."""
    less = [one._replace(mm=one.mm - MARK) for one in lengths if one.mm > MARK + SHORT]
    k = middle([one.ratio for one in less])
    if len(less) <= PLENTY or not abs(k) > OWN or agreeing(less, k) < ALONE * len(less):
        return None
    left, as_is = _left(less), _left(lengths)
    if left > MUCH * as_is:
        return None
    return settled(group, less, *fitted(less, k))


def _left(lengths: Sequence[Read]) -> float:
    """Return how far lengths are off a ratio of their own in the median, mm."""
    times = math.exp(middle([one.ratio for one in lengths]))
    return float(np.median([abs(one.mm - times * one.due) for one in lengths]))


def settled(group: Group, lengths: Sequence[Read], times: float, off: float = 0.0) -> Verdict:
    """Return lengths being so many times as long as a verdict; a round scale factor so near is meant.

    ``off``: how far off that may be (a logarithm).
    """
    near = rounded(group.mu / times)
    if abs(math.log(near * times / group.mu)) <= meant(off):
        times = group.mu / near
    return Verdict(times, SUPPOSED, agreeing(lengths, math.log(times)), len(lengths))


def _mode(lengths: Sequence[Read]) -> float:
    """Return the ratio that most lengths have (a logarithm); NaN where few have one."""
    found = [(agreeing(lengths, one.ratio), one.mm, one.ratio) for one in lengths]
    best = max(found, default=(0, 0.0, math.nan))
    return best[2] if best[0] >= max(FEWEST, MOST * len(lengths)) else math.nan
