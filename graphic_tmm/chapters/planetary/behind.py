"""How fast the wheel at the end of the pair behind a train turns: a calculation beside the drawing."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapter import Aside
from graphic_tmm.chapters.planetary.formulas import speed_behind
from graphic_tmm.chapters.planetary.plan import PLANETARY_TRAIN
from graphic_tmm.project import Bench

VIEW = "planetary-behind"


class Behind(NamedTuple):
    """The speed of the last wheel (Number, 1/s, without sign)."""

    speed: Mark


BEHIND: Aside[Behind] = Aside(PLANETARY_TRAIN.chapter)


def record_behind(bench: Bench) -> Behind | None:
    """Calculate the speed of the last wheel from the driving shaft; None where no pair stands behind."""
    made, draft = PLANETARY_TRAIN.on(bench), bench.draft
    if made.pair is None:
        return None
    draft.open(VIEW)
    driving = draft.take(Number, f"ω_{made.order.driving}", abs(made.order.speed), "1/s")
    last = len(made.train.scheme.wheels) + 2
    return Behind(draft.draw(speed_behind, f"ω_{last}", driving, made.pair.ratio, unit="1/s"))
