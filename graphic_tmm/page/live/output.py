"""The point that a mechanism moves to and fro: its travel is what a page asks lengths for."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.language.symbols import symbol
from graphic_tmm.mechanism.groups import Leg
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.page.live.log import LiveLog
from graphic_tmm.page.sentences import indexed


def output(log: LiveLog, marks: Collection[Mark], language: str) -> dict[str, Any] | None:
    """Return the point that the last group moves on the frame; None if it is not drawn, or no crank turns.

    ``marks``: of the plan of positions. As data: its slot, its letter, the slot of the scale, how many steps
    are a turn; a link that rocks has its number for a letter, and a ``pivot``.
    """
    mechanism = log.found.sheet.project.scene.mechanism
    if mechanism is None or log.found.ends:
        return None
    points = {mark.name: mark for mark in marks if mark.kind is Point}
    for group in reversed(dissect(mechanism).groups):
        for leg in group.legs:
            letter = _letter(mechanism, leg, points)
            if leg.body == mechanism.frame.number and letter:
                point = points[letter]
                view = log.found.log.view(point.view)
                turns = leg.pair.kind == "R"
                if view is None or view.scale is None or (turns and leg.pair.name not in points):
                    continue
                turn = round(360.0 / abs(log.found.per))
                own = {"slot": point.slot, "scale": view.scale.slot, "turn": turn}
                if turns:
                    return {**own, "l": str(leg.link), "pivot": points[leg.pair.name].slot}
                return {**own, "l": indexed(symbol(letter, language))}
    return None


def _letter(mechanism: Mechanism, leg: Leg, points: Collection[str]) -> str:
    """Return the point of a group's link that goes farthest, of those that are drawn; "" if none is."""
    own = {
        letter: at
        for letter, at in mechanism.by_number[leg.link].points.items()
        if letter in points and letter != leg.pair.name
    }
    pivot = mechanism.by_number[leg.link].points.get(leg.pair.name, 0j)
    return max(own, key=lambda letter: abs(own[letter] - pivot), default="")
