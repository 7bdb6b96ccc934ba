"""Where a mechanism does not go on: what slides cannot turn the next link, or guides become parallel.

A rod cannot where its line goes through the pivot, a slider where links lie in one line. Two guides that become
parallel meet nowhere: on both sides the group can be drawn, and never comes from one to the other.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.geometry import wedge
from graphic_tmm.board.operations.instruments import meet
from graphic_tmm.board.operations.locus import narrow
from graphic_tmm.board.values import Reals, undefined
from graphic_tmm.chapters.kinematics.closings import PinLeg, two_legged
from graphic_tmm.chapters.kinematics.fit import coordinate_text
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.survey import Survey
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


PARALLEL = said(
    "At {at} both guides of group {group} are parallel and meet nowhere: the mechanism does not go past it."
)
TURNED = 1e-6
"""The sine of two guides that are parallel is less than this."""


def dead_places(drawn: Drawn, language: str) -> Iterator[str]:
    """Yield, as sentences, the positions in which a drive that slides is at a dead place; parallel guides."""
    yield from _locked(drawn, language)
    plans, _ = KINEMATICS_PLAN.on(drawn), speaking(language)
    for closing in two_legged(plans.positions.closings, VELOCITIES):
        for place in _parallel(plans.tried, closing.group.name, plans.ends):
            yield _(
                PARALLEL, at=coordinate_text(place, plans.tried.sweep), group=closing.group.name
            )


def _parallel(survey: Survey, group: str, ends: tuple[float, float] | None) -> list[float]:
    """Return the coordinates of the drive over the row at which both guides of a group are parallel."""
    root = next(c.root for c in survey.positions.closings if c.group.name == group)
    step = survey.construction.step(root)
    if step is None or step.op is not meet:
        return []

    def sine(row: Reals) -> Reals:
        reading = survey.at(row, step.uses)
        first, second = (reading[mark].along for mark in step.uses)
        return np.asarray(np.broadcast_to(wedge(first, second), row.shape))

    row, _ = survey.whole([], ends)
    row = np.append(row[0], survey.sweep.high) if ends is None and survey.sweep.closed else row[0]
    tried = sine(row[None, :])[0]
    at = np.flatnonzero(tried[:-1] * tried[1:] < 0.0)
    if not (tried.any() and (at.size or (tried == 0.0).any())):
        return []
    turned = narrow(sine, row[at, None], row[at + 1, None])
    found = [*row[tried == 0.0], *turned[np.abs(sine(turned)) < TURNED]]
    return sorted(survey.sweep.within(float(place)) for place in found)


def _locked(drawn: Drawn, language: str) -> Iterator[str]:
    plans, reading, _ = KINEMATICS_PLAN.on(drawn), drawn.of(VELOCITIES), speaking(language)
    if plans.velocities is None or reading is None:
        return
    sliders = {pair.link for pair in plans.pairs if pair.pair.kind == "P"}
    for closing in two_legged(plans.positions.closings, VELOCITIES):
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
