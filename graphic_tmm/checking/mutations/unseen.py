"""What readings cannot show: plans on which whatever is done amiss moves none of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property

import numpy as np

from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.diagnosis import VISIBLE
from graphic_tmm.checking.mutations.mistakes import Mistakes
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import view_name

SAYS = said("these readings do not show what was done on: {plans}")


class Unseen:
    """What each figure of a scene shows; what is found out of one is kept for all drawings."""

    def __init__(self, mistakes: Mistakes) -> None:
        self.boards = mistakes.boards
        self._shown: dict[tuple[Key, bool], set[str]] = {}

    @cached_property
    def _views(self) -> tuple[tuple[str, ...], ...]:
        """The view in which each mutation of each board is made, "" of what has none."""
        return tuple(
            tuple(one.at.it.view if one.at is not None else "" for one in offered.mutations)
            for offered in self.boards
        )

    def of(self, drawing: Comparison) -> tuple[str, ...]:
        """Return the views that can be read of which no mutation moves any reading visibly."""
        by = drawing.by.spread
        readable = {step.it.view for step in drawing.steps.values()}
        self._find({one.at: VISIBLE * by[one.at].rms for one in drawing.rows if one.at in by})
        shown = set[str]().union(*(self._shown.get(one.at, ()) for one in drawing.rows))
        views = dict.fromkeys(view for board in self._views for view in board)
        return tuple(view for view in views if view in readable and view not in shown)

    def _find(self, least: Mapping[tuple[Key, bool], float]) -> None:
        """Find out what figures show that were not read before."""
        new = {at: size for at, size in least.items() if at not in self._shown}
        self._shown |= {at: set() for at in new}
        for offered, views in zip(self.boards, self._views, strict=True) if new else ():
            told = offered.showing({at for at, _ in new})
            for at, moved in offered.moved(new, told):
                self._shown[at] |= {views[row] for row in np.flatnonzero(moved)}


def told(views: Sequence[str], language: str) -> tuple[str, ...]:
    """Return the note on what readings cannot show; none if they show something of every plan."""
    names = dict.fromkeys(view_name(view, language) for view in views)
    return (speaking(language)(SAYS, plans=", ".join(names)),) if names else ()
