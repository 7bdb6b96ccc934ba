"""Joints that can be dragged on the plan of positions: which given lengths a place of each is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from graphic_tmm.board.operations.instruments import lay_off, place, strike
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Point
from graphic_tmm.page.live.log import LiveLog


def joints(log: LiveLog, views: set[str]) -> Iterator[list[Any]]:
    """Yield of each joint its slot, and its limbs: how it is measured, from which mark, the given, its scale.

    "on": along a line from its beginning; "aside": square to it; "from": from the centre of an arc.
    """
    lines: dict[Mark, Step] = {step.it: step for step in (*log.still, *log.turn)}
    for step in (*log.still, *log.turn):
        if step.it.view not in views or step.it.kind is not Point:
            continue
        limbs = [*_limbs(log, lines, step)]
        for arc in step.uses:
            if arc in lines and lines[arc].op is strike:
                limbs += _limb(log, lines, "from", *lines[arc].uses)
        if limbs:
            yield [step.it.slot, limbs]


def _limbs(log: LiveLog, lines: dict[Mark, Step], step: Step) -> Iterator[list[Any]]:
    if step.op is lay_off:
        yield from _limb(log, lines, "on", *step.uses)
    if step.op is place:
        line, x, y = step.uses
        yield from _limb(log, lines, "on", line, x)
        yield from _limb(log, lines, "aside", line, y)


def _limb(
    log: LiveLog, lines: dict[Mark, Step], how: str, start: Mark, length: Mark
) -> Sequence[list[Any]]:
    """Return a limb whose length is a given one by its scale; none of another."""
    step = lines.get(length)
    if step is None or len(step.uses) != 2 or not log.own.keys() >= set(step.uses):
        return []
    given, scale = step.uses
    return [[how, start.slot, given.slot, scale.slot]]
