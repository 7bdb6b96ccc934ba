"""Scale factors that a page chooses anew when something given was changed: by the rule of its sheet.

A chapter says what each of its free scale factors goes by, and how much room that has on the sheet. The page's
program (`page/web/live/rescale.js`) does with it what the chapter's own choice does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import ENLARGED, LENGTHS, MANTISSAS
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.dense import Dense
from graphic_tmm.page.live.log import LiveLog
from graphic_tmm.scene.chapter import Answer


class LiveScale(NamedTuple):
    """A scale factor that the scene leaves free.

    ``rule``: how it is chosen, a name that the page's program knows; ``points``: of what is drawn to it;
    ``at``: in which positions (indices); ``rooms``: mm, and the rule's other numbers; ``by``: marks that it
    hangs on besides, scale factors chosen before it among them.
    """

    mu: Mark
    rule: str
    points: Sequence[Mark] = ()
    at: Sequence[int] = ()
    rooms: Sequence[float] = ()
    by: Sequence[Mark] = ()


@dataclass(frozen=True)
class LiveScales(Answer):
    """The scale factors of a chapter that a page may choose, in the order in which they hang on one another."""

    stands: ClassVar[str] = "live_scales.LIVE_SCALES"
    free: Callable[[Drawn], Iterable[LiveScale]] = lambda drawn: ()


def free_scales(found: Dense) -> list[LiveScale]:
    """Return the free scale factors of a mechanism."""
    drawn = found.sheet
    return [one for c in drawn.project.chapters for one in LiveScales.of(c).free(drawn)]


def marks_of(scales: Iterable[LiveScale]) -> set[int]:
    """Return the marks (slots) that scale factors are chosen by."""
    return {mark.slot for one in scales for mark in (one.mu, *one.points, *one.by)}


def scales_data(log: LiveLog, scales: Iterable[LiveScale]) -> dict[str, Any]:
    """Return what the page chooses by: the standard rows, free scale factors, that of each view.

    One that hangs on what the page does not run stays as its sheet has it.
    """
    there = {step.it for step in (*log.still, *log.turn)} | log.own.keys()
    every = list(log.found.at)
    free = [
        {
            "mu": one.mu.slot,
            "rule": one.rule,
            "of": [mark.slot for mark in one.points],
            **({"at": at} if (at := [every[k] for k in one.at]) != every else {}),
            "n": list(one.rooms),
            **({"by": [mark.slot for mark in one.by]} if one.by else {}),
        }
        for one in scales
        if one.mu in log.own and there.issuperset((*one.points, *one.by))
    ]
    shown = {
        view.name: view.scale.slot
        for view in log.found.log.views
        if view.scale is not None and view.scale in there
    }
    return {"lengths": LENGTHS, "mantissas": MANTISSAS, "ratios": ENLARGED, "free": free} | {
        "shown": shown
    }
