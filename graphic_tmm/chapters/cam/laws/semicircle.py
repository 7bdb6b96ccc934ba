"""Semicircles that give the diagrams of the sine and the cosine law, outside of a phase's outer end."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.instruments import lay_off, meet, parallel, strike
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam import reasons as why
from graphic_tmm.chapters.cam.laws.ground import Ground, uprights
from graphic_tmm.chapters.cam.operations import divide_semicircle


class Semicircle(NamedTuple):
    """How a semicircle gives one diagram of a law, told for the rise.

    ``centre``: how many radii above the base its centre stands; ``begin``: where the division begins, "out" or
    "drop" or "rise"; ``by``: the formula of the angle; ``sense`` of the division; ``odd``: in the return the
    figure stands below the base.
    """

    radius: Operation
    centre: int
    begin: str
    by: Operation
    sense: int
    odd: bool = False


def by_semicircle(how: Semicircle, draft: Draft, ground: Ground, which: str, height: Mark) -> Mark:
    """Return the levels of the points: through the divisions of a semicircle, parallel to the base."""
    down = how.odd and ground.of.sign < 0
    uses = (height,) if which == "S" else (ground.stroke, ground.phase)
    radius = draft.draw(how.radius, "R", *uses)
    centre = ground.near
    if how.centre:
        centre = draft.draw(
            lay_off,
            "C",
            ground.drop if down else ground.rise,
            radius,
            free=True,
            why=why.WAVE_CENTRE,
        )
    circle = draft.draw(strike, "(R)", centre, radius, why=why.WAVE_CIRCLE)
    begin = {"out": ground.out, "drop": ground.drop, "rise": ground.rise}[how.begin]
    if down and how.begin != "out":
        begin = ground.rise if how.begin == "drop" else ground.drop
    # the return is mirrored, and mirrored once more where its figure stands below the base
    sense = how.sense * (1 if ground.of.sign > 0 or down else -1)
    (share,) = ground.shares
    angle = draft.draw(how.by, "θ", share, unit="°")
    points = draft.draw(divide_semicircle, "q", circle, begin, angle, sense=sense, free=True)
    return draft.draw(parallel, "(q)", points, ground.along, why=why.WAVE_LEVEL)


def at_levels(draft: Draft, ground: Ground, which: str, levels: Mark) -> tuple[Mark, ...]:
    """Return the points of a diagram over the positions, at their levels."""
    over = uprights(draft, ground)
    return (draft.draw(meet, which.lower(), over, levels, free=True, why=why.WAVE_AT),)
