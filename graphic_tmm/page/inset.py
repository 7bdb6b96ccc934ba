"""The mechanism beside a plan that is played: which view shows it, where its points stand, what lines join."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Line, Point
from graphic_tmm.language.symbols import spoken
from graphic_tmm.page.stops import Played
from graphic_tmm.paper.seen import Seen, finite

JOINTS = ("pair", "pivot")
"""Parts of ink that stand on joints: their letters are always there."""


def with_mechanisms(
    views: Sequence[Played], told: list[dict[str, Any]], high: Sequence[float]
) -> None:
    """Tell of each view which one shows its mechanism, and of that one where its points stand.

    A view that leads its sheet shows the mechanism of its board, if it shows the position too. ``high``: of the
    sheets of the views, mm.
    """
    leading = [k for k, view in enumerate(views) if view.drawing.stand.kind == "lead"]
    for data in told:
        for k in leading:
            lead = told[k]
            same = data is not lead and data["board"] == lead["board"]
            if same and data["position"] and data["position"] in lead["names"].values():
                data["mechanism"] = k
                if "joints" not in lead:
                    lead["joints"], lead["joined"] = joints(views[k], high[k])
                break


def joints(view: Played, high: float) -> tuple[list[list[Any]], Mapping[str, list[int]]]:
    """Return the points of a mechanism and which of them its lines join.

    Of a point: slot, letter, whether the letter is always there, its places by position, sheet mm, y downward
    (0, 0 if it is not there). By the slot of a line or of a distance: the points on it, at least two.
    """
    name = view.drawing.shows[-1]
    reading = view.drawn.of(name)
    assert reading is not None
    seen, origin = (
        Seen(view.log, reading, (name,), range(reading.positions)),
        view.drawing.origin(name),
    )
    always = {of for ink in view.drawing.strokes if ink.part in JOINTS for of in ink.of}
    found = {}
    for mark in (*view.log.given, *(step.it for step in seen.steps)):
        if mark.kind is Point and mark.view == name:
            places: list[float] = []
            for k in range(max(view.places) + 1):
                own = view.place_in(name, k)
                at = seen.point(mark, own) + origin if own is not None else complex("nan")
                places += [round(at.real, 2), round(high - at.imag, 2)] if finite(at) else [0, 0]
            letter = spoken(mark, view.language)
            found[mark] = [mark.slot, letter, mark.slot in always, *places]
    joined = {}
    for step in seen.steps:
        if step.it.kind in (Line, Length):
            later = (one.it for one in seen.uses.get(step.it, ()))
            on: dict[Mark, None] = dict.fromkeys(
                mark for mark in (*step.uses, *later) if mark in found
            )
            if len(on) > 1:
                joined[str(step.it.slot)] = [mark.slot for mark in on]
    return list(found.values()), joined
