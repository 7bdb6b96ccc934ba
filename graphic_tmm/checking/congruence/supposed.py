"""Scale factors that a plan with a mistake may have: what is laid off first, or most lengths, have one ratio.

They are no decision: a drawing is judged by them where they, with a mistake, explain it better.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence

from graphic_tmm.checking.congruence.lengths import Group, Read, middle
from graphic_tmm.checking.congruence.witnesses import (
    FEWEST,
    FIRST,
    FIRST_SHARE,
    GRAPHS,
    OWN,
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
    own = {
        group: one
        for group in free
        if (one := _own(group, lengths[group], found[group], plain[group]))
    }
    doubtful = (g for g, v in found.items() if g in free and v.by in MERE and 2 * v.agree < v.among)
    due = {group: Verdict() for group in doubtful}
    tried = [{**found, **own}] if own else []
    tried += [{**found, group: one} for group, one in own.items()] if len(own) > 1 else []
    return tried + ([{**found, **due}] if due else [])


def _own(group: Group, lengths: Sequence[Read], found: Verdict, plain: Verdict) -> Verdict | None:
    """Return the scale factor that a plan may have, other than the one that was found."""
    if plain.rates != 1.0 and abs(math.log(plain.rates / found.times)) > OWN:
        return Verdict(plain.rates, SUPPOSED, len(lengths), len(lengths))
    if found.times != 1.0 or fitting(lengths, 1.0):
        return None
    if plain.times != 1.0:
        return plain._replace(by=SUPPOSED)
    laid = [one for one in lengths if one.laid]
    k = middle([one.ratio for one in laid])
    steady = len(laid) > 1 and share(laid, k, FIRST) >= FIRST_SHARE
    if steady and abs(k) > OWN and RANGE[0] < math.exp(k) < RANGE[1]:
        return settled(group, laid, math.exp(k))  # in one position it may be another
    k = _mode(lengths)
    if not abs(k) > OWN or not GRAPHS[0] < math.exp(k) < GRAPHS[1]:
        return None
    alike = agreeing(lengths, k) > agreeing(lengths, 0.0)
    return settled(group, lengths, *fitted(lengths, k)) if alike else None


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
