"""The columns of forces by centres: arms, loads at what drives, what balances them, differences, advantage."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.advantage.plan import ADVANTAGE_PLAN, Advantage
from graphic_tmm.chapters.advantage.task import ADVANTAGE
from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of
from graphic_tmm.readers.protocol import Protocols

OFF_PLANS, OFF_LEVER = "difference", "lever_difference"
"""How the columns of both differences end; of a force that is sought the first is that from the lever."""


class ArmOrFigure(NamedTuple):
    """A figure as tables call it; ``arm``: a length that is measured."""

    segment: str
    mark: Mark
    arm: bool = False


def figures(made: Advantage) -> Iterator[ArmOrFigure]:
    """Yield the figures in their order."""
    arms = [one.arm for one in made.loads] + [made.tool]
    for own in arms:
        if own is not None:
            yield ArmOrFigure(segment_name(own.height.letter), own.height, arm=True)
    for one in made.loads:
        yield ArmOrFigure(segment_name(one.value.letter), one.value)
    if made.total is None or made.balance is None:
        return
    if made.total != made.loads[0].value:
        yield ArmOrFigure(f"sum_{_letter(made.total)}", made.total)
    yield ArmOrFigure(f"{stem(made)}_centres", made.balance)
    for name, mark in zip((OFF_PLANS, OFF_LEVER), made.off, strict=False):
        yield ArmOrFigure(f"{stem(made)}_{name}", mark)
    for mark in made.gains.values():
        yield ArmOrFigure(segment_name(mark.letter), mark)


def stem(made: Advantage) -> str:
    """Return how the columns of what balances begin, or of the force that is sought."""
    balance = made.balance
    return f"{_letter(balance)}_bal" if balance is not None and made.tool is None else "P_tool"


def _letter(mark: Mark) -> str:
    return "M" if mark.unit == "N·m" else "P"


def columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the figures in the positions that have both centres and forces."""
    made = ADVANTAGE_PLAN.of(drawn)
    if made is None:
        return
    mu, count = CENTRES_PLAN.on(drawn).mu, len(drawn.names)
    for one in figures(made):
        mm = _row(made, drawn, one.mark, None) if one.arm else empty(count)
        value = _row(made, drawn, one.mark, mu if one.arm else None)
        if one.mark.unit == "%":
            value = np.round(value, drawn.percent_decimals) + 0.0
        unit = "m" if one.arm else one.mark.unit
        shown = (np.abs(mm), np.abs(value)) if one.arm else (mm, value)
        yield Column(ADVANTAGE, one.segment, one.mark.name, unit, *shown)


def _row(made: Advantage, drawn: Drawn, mark: Mark, by: Mark | None) -> Reals:
    """Return figures at the positions asked for, NaN at the others."""
    value, places = drawn.reading.figure(mark, by), list(made.places)
    whole = np.broadcast_to(value, (len(value), len(drawn.names)))
    return row_of(whole[:, places], places, len(drawn.names))


TABLE = Tabled(columns=columns)
PROTOCOL = Protocols(views=lambda project: {ADVANTAGE: (ADVANTAGE,)})
