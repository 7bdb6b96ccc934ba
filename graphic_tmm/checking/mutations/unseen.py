"""What readings cannot show: plans on which whatever is done amiss moves none of them."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.captions import view_name
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.diagnosis import VISIBLE
from graphic_tmm.checking.mutations.mistakes import Mistakes
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said

SAYS = said("these readings do not show what was done on: {plans}")


def unseen(mistakes: Mistakes, drawing: Comparison) -> tuple[str, ...]:
    """Return the views that can be read of which no mutation moves any reading visibly, as the log has them."""
    by = drawing.by.spread
    readable = {step.it.view for step in drawing.steps.values()}
    least = {one.at: VISIBLE * by[one.at].rms for one in drawing.rows if one.at in by}
    found: dict[str, bool] = {}
    for offered in mistakes.boards:
        moving = set(offered.moving(least).tolist())
        for row, one in enumerate(offered.mutations):
            view = one.at.it.view if one.at is not None else ""
            if view in readable:
                found[view] = found.get(view, False) or row in moving
    return tuple(view for view, shown in found.items() if not shown)


def told(views: Sequence[str], language: str) -> tuple[str, ...]:
    """Return the note on what readings cannot show; none if they show something of every plan."""
    names = dict.fromkeys(view_name(view, language) for view in views)
    return (speaking(language)(SAYS, plans=", ".join(names)),) if names else ()
