"""What says in which scale factor a plan was drawn: mm and value in a row, rates, round numbers, lengths.

Thresholds are those of 184 plans drawn by an independent student in scale factors of his own, with 104 kinds of
mistakes (none of them was given a false one), but where another source is named.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.checking.congruence.lengths import Group, Rate, Read, middle

OWN = 0.025
"""Nearer to what is due than this (a logarithm) no scale factor is another one: paper is off by it."""
RANGE = (0.3, 3.4)
"""So many times as large as due a plan may be in a scale factor of its own; what is beyond is another unit."""
GRAPHS, SPREAD = (0.12, 8.0), 1.5
"""The same of graphs, whose scale factors follow from one another; their ratio is another one if it differs
from 1 by so many usual deviations of a single ordinate."""
ROUND, MANTISSAS = 0.012, (1.0, 1.2, 1.25, 1.5, 1.6, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5, 8.0)
"""Lengths alone tell a scale factor to about 1 %: a round one so near is meant."""
COARSELY = 0.03
"""A few lengths tell it less well: within the gaps between round ones."""
EXACT = 0.004
"""Rows and rates tell a scale factor so nearly: a round one so near is meant."""
WRITTEN = 0.012
"""Rows with mm and value that agree so exactly tell a scale factor that is no farther from the due one."""
ROWS, NEARLY = 0.8, 0.02
"""Of rows with mm and value this share must have one scale factor, so nearly."""
STEADY, SAME = 0.004, 0.015
"""Rates and lengths agree where their quotient scatters by no more; two witnesses where they are so near."""
FIRST, FIRST_SHARE = 0.03, 0.7
"""What is laid off first has one ratio, so nearly, in this share of the positions."""
MANY, MORE, ALONE = 0.5, 0.1, 0.8
"""The share of the other lengths that must agree, by how much more than with what is due; where nothing is laid
off first, the share of all."""
SIGNIFICANT = 3.0
"""By so many standard deviations all lengths together must say a ratio near 1, as does what is laid off
first."""
DIVISION = 0.15
"""A length that is laid off is off by half a division of a ruler, mm: 0.5 over √12."""
CLEAR, NEARER = 0.2, 0.75
"""Where what is laid off first has a ratio so far from 1 (a logarithm), it is enough that so many of the others
are nearer to it: a mistake moves lengths, but not by that."""
UNITS = {"cm": 10.0, "inch": 25.4}
"""What may be written where mm are asked for."""
WITHIN = 2.1
"""A scale factor of his own makes lengths in another unit so many times longer or shorter at the most: most are
within twice the task's. A plan drawn 0.25 times as large is in no other unit."""
FEWEST, PLENTY = 3, 4
"""Fewer lengths say nothing of a scale factor; rates of fewer positions are not more exact than lengths."""


class Verdict(NamedTuple):
    """How many times as large as due a plan was drawn, and what says so.

    ``by``: "rows", "rates", "round", "lengths", "" where it is as due; ``agree`` figures ``among`` so many say
    it; ``places``: positions in which it is another, and how many times; ``against``: what lengths say and
    what rates say where they differ, None if they agree. ``rates``: how many times as large rates alone say.
    """

    times: float = 1.0
    by: str = ""
    agree: int = 0
    among: int = 0
    places: tuple[tuple[str, float], ...] = ()
    against: tuple[float, float] | None = None
    rates: float = 1.0


def verdict(
    group: Group, lengths: Sequence[Read], rates: Sequence[Rate], others: Sequence[Read] = ()
) -> Verdict:
    """Return in which scale factor lengths were drawn that are due in that of a group.

    ``others``: lengths of the plan of positions, by which rates may have been calculated, too.
    """
    told = _rates_say([one for one in lengths if not one.apart], rates, others)
    found = _verdict(group, lengths, told)
    if told is not None and told[1] >= PLENTY - 1:
        found = found._replace(rates=math.exp(told[0]))
    near = rounded(group.mu / found.times)
    if found.by in ("rows", "rates") and abs(math.log(near * found.times / group.mu)) <= EXACT:
        return found._replace(times=group.mu / near)
    return found


def _verdict(group: Group, lengths: Sequence[Read], told: tuple[float, int, int] | None) -> Verdict:
    if (said := _by_rows(group, lengths)) is not None:
        return said
    if len(lengths) < FEWEST:
        return Verdict()
    laid = [one for one in lengths if one.laid]
    k = middle([one.ratio for one in laid or lengths])
    clear = _apart(k) if laid else abs(k) > OWN and GRAPHS[0] < math.exp(k) < GRAPHS[1]
    if not clear or (laid and share(laid, k, FIRST) < FIRST_SHARE):
        return _in_spite(group, told) or Verdict()
    if told is not None and (found := _by_rates(group, k, told, steady=bool(laid))) is not None:
        return found
    if _from_a_mark(lengths, k):
        return Verdict()
    rest = [one for one in lengths if not one.laid]
    agree, due = agreeing(rest, k), agreeing(rest, 0.0)
    enough = len(rest) * (MANY if laid else ALONE)
    alike = agree >= enough and agree >= due + MORE * len(rest)
    usual = laid and (
        _nearer(rest, k)
        or (agree >= due and _steady(group, laid, k))
        or (agree >= len(rest) * ALONE and _sure(*fitted(lengths, k)))
    )
    if rest and not alike and not usual:
        return Verdict() if laid else _by_spread(lengths, k)
    times, off = _best(laid, lengths, k)
    near = rounded(group.mu / times)
    if abs(math.log(near * times / group.mu)) <= meant(off):
        return Verdict(group.mu / near, "round", agree + len(laid), len(lengths))
    return Verdict(times, "lengths", agree + len(laid), len(lengths))


def _best(laid: Sequence[Read], lengths: Sequence[Read], k: float) -> tuple[float, float]:
    """Return what is surer: `fitted` of what is laid off first, or of all lengths."""
    return min((fitted(some, k) for some in (laid, lengths) if some), key=lambda one: one[1])


def _sure(times: float, off: float) -> bool:
    """Whether lengths tell a ratio near 1 from 1 together, though each fits both; ``off``: a deviation."""
    return abs(math.log(times)) > SIGNIFICANT * off


def meant(off: float) -> float:
    """Return how near (a logarithm) a round scale factor must be to be meant; ``off``: how far lengths are."""
    return max(ROUND, min(2.5 * off, COARSELY))


def _nearer(lengths: Sequence[Read], k: float) -> bool:
    """Whether lengths are far nearer to a ratio (a logarithm) that is clear of 1: a mistake moves them, too."""
    near = sum(abs(one.ratio - k) < 0.5 * abs(one.ratio) for one in lengths)
    return abs(k) > CLEAR and near >= NEARER * len(lengths)


def _from_a_mark(lengths: Sequence[Read], k: float) -> bool:
    """Whether all lengths are too long by the same, as if read from the ruler's 1 cm mark."""
    more = float(np.median([one.mm - one.due for one in lengths]))
    left = float(np.median([abs(one.mm - one.due - more) for one in lengths]))
    scaled = float(np.median([abs(one.mm - math.exp(k) * one.due) for one in lengths]))
    return abs(more - 10.0) < 1.5 and left < 0.6 * scaled


def _by_spread(lengths: Sequence[Read], k: float) -> Verdict:
    """Return the verdict on lengths of a graph, which scatter more: all about another ratio than due."""
    off = [abs(one.ratio - k) for one in lengths]
    usual = 1.5 * middle(off)
    clear = abs(k) > SPREAD * max(usual, 0.02) and 2.0 * sum(off) < sum(
        abs(one.ratio) for one in lengths
    )
    if len(lengths) < 5 or not clear:
        return Verdict()
    squares = sum(one.due**2 for one in lengths)
    times = sum(one.mm * one.due for one in lengths) / squares
    within = sum(one <= 2.0 * usual for one in off)
    return Verdict(times, "lengths", within, len(lengths))


def fitted(lengths: Sequence[Read], k: float) -> tuple[float, float]:
    """Return how many times as long as due lengths are, by least squares, and how far off that usually is.

    ``k``: nearly that, as a logarithm; what is farther from it is left out. What is laid off first is off by
    its own scatter alone; others of a position have what scatters in its plan in common.
    """
    near = [one for one in lengths if _near(one, k)]
    size = math.sqrt(sum(one.due**2 for one in near))
    times = sum(one.mm * one.due for one in near) / size**2
    if all(one.laid for one in near):
        left = math.sqrt(sum((one.mm - times * one.due) ** 2 for one in near) / len(near))
        return times, max(left, DIVISION) / (times * size)
    positions = len({one.position for one in near})
    return times, math.hypot(0.9 / (times * size), 0.02 / math.sqrt(positions))


def fitting(lengths: Sequence[Read], times: float) -> bool:
    """Whether lengths are so many times as long as due, most of them."""
    return agreeing(lengths, math.log(times)) >= ALONE * len(lengths)


def of_siblings(group: Group, lengths: Sequence[Read], mu: float, by: Verdict) -> Verdict | None:
    """Return the verdict on a group whose lengths do not fit the due scale factor; another of its plan is own.

    ``mu``: SI a mm, in which the other was drawn, ``by`` whose verdict.
    """
    k = math.log(group.mu / mu)
    agree, due = agreeing(lengths, k), agreeing(lengths, 0.0)
    alike = agree >= MANY * len(lengths) and agree > due
    if not _apart(k) or (due and not alike):
        return None
    return Verdict(math.exp(k), by.by, agree, len(lengths))


def _by_rows(group: Group, lengths: Sequence[Read]) -> Verdict | None:
    """Return what rows with mm and value say; None where there are too few, or they differ."""
    rows = [one for one in lengths if math.isfinite(one.value) and one.value > 0.0]
    if len(rows) < 2:
        return None
    ratios = {one: math.log(group.mu * one.mm / one.value) for one in rows}
    k = middle([*ratios.values()])
    places = {place: other for place, other in _places(ratios).items() if abs(other - k) > OWN}
    agree = sum(abs(one - places.get(row.position, k)) <= NEARLY for row, one in ratios.items())
    if agree < ROWS * len(rows):
        return None
    own = tuple((place, math.exp(_settled(one))) for place, one in places.items())
    exact = float(np.median([abs(one - k) for one in ratios.values()])) < EXACT
    settled = k if abs(k) > (WRITTEN if exact else OWN) else 0.0
    by = "rows" if own or settled else ""
    return Verdict(math.exp(settled), by, agree, len(rows), own)


def _places(ratios: Mapping[Read, float]) -> dict[str, float]:
    """Return what the rows of each position say that say the same, two of them at least (logarithms)."""
    by_place: defaultdict[str, list[float]] = defaultdict(list)
    for one, ratio in ratios.items():
        by_place[one.position].append(ratio)
    return {
        place: middle(some)
        for place, some in by_place.items()
        if len(some) > 1 and np.ptp(some) < 2 * NEARLY
    }


def _settled(k: float) -> float:
    return k if abs(k) > OWN else 0.0


def _apart(k: float) -> bool:
    return abs(k) > OWN and RANGE[0] < math.exp(k) < RANGE[1]


def share(lengths: Sequence[Read], k: float, within: float) -> float:
    """Return the share of lengths that have a ratio (a logarithm), nearly or as nearly as they can be read."""
    far = [
        abs(one.ratio - k) - max(within, (2.2 if one.apart else 1.6) / one.mm) for one in lengths
    ]
    return sum(one <= 0.0 for one in far) / len(far)


def _near(one: Read, k: float) -> bool:
    """Whether a length is ``k`` times as long as due (a logarithm), within 2.5 times a usual error."""
    return abs(one.ratio - k) <= 2.5 * math.hypot(0.9 / one.due, 0.02)


def agreeing(lengths: Sequence[Read], k: float) -> int:
    """Return how many lengths are ``k`` times as long as due (a logarithm)."""
    return sum(_near(one, k) for one in lengths)


def _rates_say(
    lengths: Sequence[Read], rates: Sequence[Rate], others: Sequence[Read]
) -> tuple[float, int, int] | None:
    """Return by the rate and the length that agree best how many times larger the plan is; in how many rows.

    Of a rate that was calculated from a length, rate : length is μ over what is the same everywhere, or over a
    length of the plan of positions.
    """
    best: tuple[tuple[float, float], float] | None = None
    by_rate, by_length, by_other = map(_by_name, (rates, lengths, others))
    for rate in by_rate.values():
        for length in by_length.values():
            for other in ({}, *by_other.values()):
                places = rate.keys() & length.keys() & (other or rate).keys()
                if len(places) < 2:
                    continue
                q = np.array([length[n] - rate[n] - other.get(n, 0.0) for n in sorted(places)])
                k = float(np.median(q))
                off = np.abs(q - k)
                wide, agree = float(np.median(off)), int((off <= STEADY).sum())
                rank = (-agree, wide)
                if wide < STEADY and 2 * agree > len(q) and (best is None or rank < best[0]):
                    best = rank, k
    if best is None:
        return None
    return best[1], int(-best[0][0]), max(map(len, by_rate.values()))


def _by_name(some: Sequence[Any]) -> dict[str, dict[str, float]]:
    """Return ratios by segment and position."""
    found: defaultdict[str, dict[str, float]] = defaultdict(dict)
    for one in some:
        found[one.segment][one.position] = one.ratio
    return found


def _by_rates(
    group: Group, k: float, told: tuple[float, int, int], *, steady: bool
) -> Verdict | None:
    """Return the verdict where rates say something: the same as lengths, or against them; None if too little.

    ``steady``: lengths have told ``k`` (a logarithm) by what is laid off, to half a division of the ruler.
    """
    says, agree, among = told
    if abs(says - k) <= (SAME if agree < PLENTY else FIRST):
        return Verdict(math.exp(k if steady and agree < PLENTY else says), "rates", agree, among)
    if agree < PLENTY - 1:
        return None
    if abs(says) <= OWN:
        return Verdict(against=(math.exp(k), 1.0), agree=agree, among=among)
    # either all rates are wrong by one factor, or what is laid off
    return None if _is_round(group, k, ROUND) else _in_spite(group, told)


def _in_spite(group: Group, told: tuple[float, int, int] | None) -> Verdict | None:
    """Return a round scale factor that rates say, though what is laid off does not."""
    if told is None or told[1] < PLENTY - 1 or not _apart(told[0]):
        return None
    if not _is_round(group, told[0], EXACT):
        return None
    says, agree, among = told
    return Verdict(math.exp(says), "rates", agree, among)


def _is_round(group: Group, k: float, within: float) -> bool:
    mu = group.mu / math.exp(k)
    return abs(math.log(rounded(mu) / mu)) <= within


def _steady(group: Group, laid: Sequence[Read], k: float) -> bool:
    """Whether what is laid off first says a round scale factor in all positions: the rest may be wrong."""
    clear = abs(k) > 0.5 * CLEAR and _is_round(group, k, EXACT)
    return clear and len(laid) > 1 and share(laid, k, SAME) == 1.0


def rounded(mu: float) -> float:
    """Return the round number nearest to a scale factor, by their ratio.

    >>> rounded(0.0199), rounded(0.0312)
    (0.02, 0.03)
    """
    power = math.floor(math.log10(mu))
    tried = [float(f"{m:g}e{p}") for p in (power - 1, power, power + 1) for m in MANTISSAS]
    return min(tried, key=lambda one: abs(math.log(one / mu)))


def unit_of(ratios: Sequence[tuple[Group, float]]) -> str:
    """Return the unit that lengths of so many times their due (logarithms) were written in, "" for mm.

    Inches where these, and not cm, make a scale factor the due one, or a round one.
    """
    if not ratios:
        return ""

    def usual(unit: str) -> bool:
        own = [(group, one + math.log(UNITS[unit])) for group, one in ratios]
        return all(abs(k) < OWN or _is_round(group, k, ROUND) for group, k in own)

    unit = "inch" if usual("inch") and not usual("cm") else "cm"
    far = max(abs(one + math.log(UNITS[unit])) for _, one in ratios)
    return unit if far <= math.log(WITHIN) else ""
