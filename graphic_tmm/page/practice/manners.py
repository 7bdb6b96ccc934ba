"""In which manners a drawing is read, and the limits of the hand in each, as the page has them."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.check import TRIALS
from graphic_tmm.checking.judging import step_scatter
from graphic_tmm.checking.judging.reader import reader
from graphic_tmm.checking.judging.scatter import Limits, Scatter
from graphic_tmm.checking.judging.step_scatter import StepScatter
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
    return {
        "half": by.half,
        "reading": by.hand.reading,
        "digits": by.hand.digits,
        "finest": by.finest,
        "wrong": Limits().wrong,
        "shares": list(step_scatter.SHARES),
        "few": step_scatter.FEW,
        "most": step_scatter.MOST,
        "sure": step_scatter.SURE,
    }


def manner(scene: Scene, row: Row, named: Named, name: str) -> dict[str, Any]:
    """Return the limits of the hand, read in one manner."""
    hand = HANDS[HAND]._replace(trials=TRIALS, seed=scene.seed)
    by = reader(scene, hand, MANNERS[name])
    whole = name == "plan"
    read = [m for m, (kind, *_) in named.items() if whole or kind == "point"]
    own: dict[str, Any] = {}
    total: dict[str, Any] = {}
    for one in row.own or (row,):
        drawn = drawings(one, read, scene)
        for plan in one.places:
            marks = [mark for mark in read if mark.view == plan]
            found = own_limits(one, plan, marks, drawn, by)
            spread = total_limits(one, plan, named, drawn, by) if whole else {}
            for mark in marks:
                pointed = named[mark][0] == "point"
                slot, places = str(mark.slot), [(mark, at) for at in one.places[plan]]
                _append(own, slot, _own(map(found.get, places), pointed=pointed))
                if whole and not pointed:
                    _append(total, slot, _total(map(spread.get, places)))
    return {"pointing": by.pointing, "own": own, "total": total}


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
