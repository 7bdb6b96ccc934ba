"""Where what slides cannot turn the next link: a rod whose line goes through its pivot, links in one line."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.values import undefined
from graphic_tmm.chapters.kinematics.bodies import PinLeg, dyads
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said

ROD = said(
    "The rod of link {rod} cannot turn link {link} in position {listed}: {line} passes through {pivot}.",
    "The rod of link {rod} cannot turn link {link} in positions {listed}: {line} passes through {pivot}.",
)
SLIDER = said(
    "Link {slider} cannot move link {link} in position {listed}: {points} lie in one line.",
    "Link {slider} cannot move link {link} in positions {listed}: {points} lie in one line.",
)


def dead_places(drawn: Drawn, language: str) -> Iterator[str]:
    """Yield, as sentences, the positions in which a drive that slides is at a dead place."""
    plans, reading, _ = KINEMATICS_PLAN.on(drawn), drawn.of(VELOCITIES), speaking(language)
    if plans.velocities is None or reading is None:
        return
    sliders = {pair.link for pair in plans.pairs if pair.pair.kind == "P"}
    for closing in dyads(plans.positions.closings, VELOCITIES):
        first, second = closing.legs
        for leg, other in ((first, second), (second, first)):
            if not (isinstance(leg, PinLeg) and isinstance(other, PinLeg)):
                continue
            if not leg.rod and leg.body not in sliders:
                continue
            image = plans.velocities.closed[closing.group.name]
            there = ~undefined(drawn.reading[closing.point])[0]
            lost = undefined(reading[image])[0] & there
            row = drawn.row(VELOCITIES)
            listed = [drawn.names[row[k]] for k in np.flatnonzero(lost)]
            if listed:
                ends = (leg.letter, closing.letter)
                of = {"link": str(other.link), "listed": ", ".join(listed)}
                if leg.rod:
                    of |= {"rod": str(leg.rod), "line": "".join(ends), "pivot": other.letter}
                else:
                    of |= {"slider": str(leg.body), "points": ", ".join((*ends, other.letter))}
                yield _(ROD if leg.rod else SLIDER, n=len(listed), **of)
