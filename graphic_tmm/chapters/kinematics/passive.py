"""Passive links on the plan of positions: drawn where they are held; whether they fit all the turn."""

from __future__ import annotations

import cmath
import math

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import join, parallel
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import (
    Body,
    Passive,
    anchor,
    draw_guide,
    draw_points,
    stand,
)
from graphic_tmm.chapters.kinematics.closings import PinLeg
from graphic_tmm.chapters.kinematics.figures import tell_link, tell_slide
from graphic_tmm.mechanism.guides import direction, level
from graphic_tmm.mechanism.passive import Hold, holds
from graphic_tmm.mechanism.records import Mechanism


def draw_passive(
    draft: Draft, mechanism: Mechanism, bodies: dict[int, Body]
) -> tuple[Passive, ...]:
    """Draw the passive links, each along what holds it; the letters that it shares stand already."""
    return tuple(_draw(draft, mechanism, bodies, hold) for hold in holds(mechanism))


def _draw(draft: Draft, mechanism: Mechanism, bodies: dict[int, Body], hold: Hold) -> Passive:
    link, pins = hold.link, tuple((pair.name, pair.links[1]) for pair in hold.pins)
    marks = {letter: bodies[on].marks[letter] for letter, on in pins}
    first, *others = marks
    own, leg = link.points[first], None
    if hold.guide is None:
        arm, name = link.points[others[0]] - own, f"{first}{others[0]}"
        length = draft.length(name, abs(arm))
        ends = marks[first], marks[others[0]]
        line = draft.draw(join, f"({name})", *ends, why=why.PASSIVE_AXIS)
        body = Body(link, own, math.degrees(cmath.phase(arm)), lambda: line)
        leg = PinLeg(link.number, pins[0][1], first, marks[first], line, length)
    else:
        pair = hold.guide
        height = level(pair, link.number, own)
        line = draw_guide(draft, bodies[pair.links[1]], pair, height, pair.name)

        def axis() -> Mark:
            name = f"({link.number})"
            return draft.draw(parallel, name, marks[first], line, why=why.SLIDER_AXIS)

        body = Body(link, own, direction(pair, link.number), axis)
    bodies[link.number] = body
    for letter, mark in marks.items():
        stand(body, letter, mark, link.points[letter])
    draw_points(draft, body, anchor(body))
    tell_link(draft, mechanism, body)
    if hold.guide is not None:
        tell_slide(draft, mechanism, hold.guide, marks[first], line)
    return Passive(link.number, pins, line, leg, next(iter(link.slides), None))
