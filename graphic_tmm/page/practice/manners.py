"""In which manners a drawing is read, and the limits of the hand in each, as the page has them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations
from typing import Any

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.check import TRIALS
from graphic_tmm.checking.judging import equivalents, step_scatter
from graphic_tmm.checking.judging.scatter import Limits, Scatter
from graphic_tmm.checking.judging.step_scatter import StepScatter
from graphic_tmm.checking.judging.taken_marks import reader
from graphic_tmm.page.practice.limits import (
    HAND,
    Named,
    bounds,
    drawings,
    own_limits,
    told,
    total_limits,
)
from graphic_tmm.page.practice.tasks import Row
from graphic_tmm.scene.records import Scene

MANNERS = {"plan": "screen", "points": "photo"}
"""What is read of a plan, and how points are: all of it, on a screen; points alone, off a photograph."""


def reader_of(scene: Scene) -> dict[str, Any]:
    """Return who reads a drawing, and how a judgement is made."""
    by = reader(scene, HANDS[HAND], "screen")
    both = equivalents.pair(Limits())
    return {
        "half": by.half,
        "reading": by.hand.reading,
        "swing": by.hand.swing,
        "compass": by.hand.compass,
        "prick": by.hand.prick,
        "digits": by.hand.digits,
        "finest": by.finest,
        "wrong": Limits().wrong,
        "pair": {"doubtful": both.doubtful, "wrong": both.wrong},
        "sine": equivalents.LEAST_SINE,
        "shares": list(step_scatter.SHARES),
        "few": step_scatter.FEW,
        "most": step_scatter.MOST,
        "sure": step_scatter.SURE,
    }


def manner(scene: Scene, row: Row, named: Named, name: str, plans: Sequence[str]) -> dict[str, Any]:
    """Return the limits of the hand, read in one manner; ``plans``: as the page counts them.

    ``own``: of a plan read alone; ``with``: by the numbers of those before it whose points are read too.
    """
    hand = HANDS[HAND]._replace(trials=TRIALS, seed=scene.seed)
    by = reader(scene, hand, MANNERS[name])
    whole = name == "plan"
    read = [m for m, (kind, *_) in named.items() if whole or kind == "point"]
    own: dict[str, Any] = {}
    beside: dict[str, Any] = {}
    total: dict[str, Any] = {}
    for one in row.own or (row,):
        drawn = drawings(one, read, scene)
        for plan, others in _together(list(one.places), whole=whole):
            found = own_limits(one, [m for m in read if m.view in (plan, *others)], drawn, by)
            key = " ".join(str(plans.index(other)) for other in others)
            to = beside.setdefault(key, {}) if others else own
            for mark in (m for m in read if m.view == plan):
                rows = [found.get((mark, at)) for at in one.places[plan]]
                _append(to, str(mark.slot), _own(rows, pointed=named[mark][0] == "point"))
        for plan in one.places if whole else ():
            spread = total_limits(one, plan, named, drawn, by)
            for mark in (m for m in read if m.view == plan and named[m][0] != "point"):
                figures = [spread.get((mark, at)) for at in one.places[plan]]
                _append(total, str(mark.slot), _total(figures))
    return {"pointing": by.pointing, "own": own, "with": beside, "total": total}


def _together(plans: Sequence[str], *, whole: bool) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield each plan with those before it that are read too; alone where all of it is read."""
    for k, plan in enumerate(plans):
        for count in range(1 if whole else k + 1):
            yield from ((plan, others) for others in combinations(plans[:k], count))


def _own(limits: Iterable[StepScatter | None], *, pointed: bool) -> dict[str, list[Any]]:
    """Return limits of a step's own errors, position by position."""
    rows = list(limits)
    found: dict[str, list[Any]] = {
        "b": [told(one.sizes) if one else [] for one in rows],
        "d": bounds(one.scatter.doubtful if one else math.nan for one in rows),
        "w": bounds(one.scatter.wrong if one else math.nan for one in rows),
    }
    if pointed:
        found["s"] = [told(one.sharp) if one else [] for one in rows]
        found["m"] = told([one.most if one else math.nan for one in rows])
    return found


def _total(limits: Iterable[Scatter | None]) -> dict[str, list[Any]]:
    """Return limits of the deviations of a figure, position by position."""
    rows = list(limits)
    return {
        "d": bounds(one.doubtful if one else math.nan for one in rows),
        "w": bounds(one.wrong if one else math.nan for one in rows),
        "t": bounds(one.times if one else math.nan for one in rows),
    }


def _append(to: dict[str, Any], slot: str, more: dict[str, list[Any]]) -> None:
    """Append columns to those of a mark."""
    there = to.setdefault(slot, {key: [] for key in more})
    for key, column in more.items():
        there[key] += column
