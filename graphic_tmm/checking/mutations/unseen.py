"""What readings cannot show: plans on which none of them hangs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property

from graphic_tmm.board.record import Mark
from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.evidence import VISIBLE
from graphic_tmm.checking.mutations.grammar import mutations
from graphic_tmm.checking.mutations.mistakes import NONE, Mistakes
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import view_name

SAYS = said("these readings do not show what was done on: {plans}")


class Unseen:
    """What readings of a scene show; what is found out of a figure of a table is kept for all drawings."""

    def __init__(self, mistakes: Mistakes) -> None:
        self.offered = mistakes.boards[0]
        self._shown: dict[tuple[str, tuple[Key, bool]], bool] = {}

    @cached_property
    def _behind(self) -> Mapping[Mark, frozenset[str]]:
        """The views on which each mark hangs, its own among them."""
        behind: dict[Mark, frozenset[str]] = {}
        for step in self.offered.base.log.steps:
            before = (behind.get(mark, frozenset()) for mark in step.uses)
            behind[step.it] = frozenset({step.it.view}).union(*before)
        return behind

    def of(self, drawing: Comparison) -> tuple[str, ...]:
        """Return the views that can be read on which no reading hangs."""
        steps = [drawing.step(one) for one in drawing.rows]
        shown = {view for step in steps if step is not None for view in self._behind[step.it]}
        readable = {step.it.view for step in drawing.steps.values()}
        views = dict.fromkeys(mark.view for mark in self._behind if mark.view in readable)
        by = drawing.by.spread
        tables = [one.at for one, step in zip(drawing.rows, steps, strict=True) if step is None]
        least = {at: VISIBLE * by[at].rms for at in tables if at in by}
        return tuple(view for view in views if view not in shown and not self._moves(view, least))

    def _moves(self, view: str, least: Mapping[tuple[Key, bool], float]) -> bool:
        """Whether a mistake in a view would move a figure of a table by more than a least."""
        new = {at: size for at, size in least.items() if (view, at) not in self._shown}
        if new:
            log = self.offered.base.log
            own = (step for step in log.steps if step.it.view == view)
            beside = self.offered.run([NONE, *mutations(log, own)])
            self._shown |= {(view, at): False for at in new}
            moved = self.offered.moved(new, beside)
            self._shown |= {(view, at): bool(rows.any()) for at, rows in moved}
        return any(self._shown[view, at] for at in least)


def told_unseen(views: Sequence[str], language: str) -> tuple[str, ...]:
    """Return the note on what readings cannot show; none if they show something of every plan."""
    names = dict.fromkeys(view_name(view, language) for view in views)
    return (speaking(language)(SAYS, plans=", ".join(names)),) if names else ()
