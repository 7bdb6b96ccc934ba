"""The results of a Geneva wheel, and its plan in protocols."""

from __future__ import annotations

from graphic_tmm.chapters.geneva.plan import GENEVA_PLAN
from graphic_tmm.chapters.geneva.task import GENEVA
from graphic_tmm.drawn import Drawn, Results
from graphic_tmm.readers.columns import Tabled
from graphic_tmm.readers.protocol import Protocols


def results(drawn: Drawn) -> Results:
    """Return the crank that is due, the angle of engagement, shares and times of motion, the greatest ratio."""
    wheel = GENEVA_PLAN.of(drawn)
    if wheel is None:
        return {}
    marks = {
        "geneva_crank_due": wheel.due,
        "geneva_engaged": wheel.engaged,
        "geneva_share": wheel.share,
        "geneva_share_by_slots": wheel.by_slots,
        "geneva_motion": wheel.motion,
        "geneva_dwell": wheel.dwell,
        "geneva_fastest": wheel.fastest,
    }
    return {
        name: (drawn.reading.figure(mark)[:, 0].copy(), mark.unit)
        for name, mark in marks.items()
        if mark is not None
    }


TABLE = Tabled(results=results)
PROTOCOL = Protocols(views=lambda project: {GENEVA: (GENEVA,)})
