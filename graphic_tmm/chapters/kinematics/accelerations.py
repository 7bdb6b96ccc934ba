"""The plan of accelerations: normal, tangential and Coriolis segments, two legs a group, similarity.

Normal and Coriolis lengths are calculated from readings of the plan of velocities; their directions come
from the plan of positions, so that a vector of zero length needs no direction of its own.
"""

from __future__ import annotations

from collections.abc import Callable

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import meet, parallel
from graphic_tmm.board.record import Mark, between
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.acceleration_lines import (
    free_line,
    read_along,
    read_segment,
    read_tangential,
    tangential_line,
)
from graphic_tmm.chapters.kinematics.bodies import Meshed, Positions
from graphic_tmm.chapters.kinematics.closings import Closing, SpecialClosing
from graphic_tmm.chapters.kinematics.drives import driven
from graphic_tmm.chapters.kinematics.motion import (
    Images,
    Motion,
    component,
    hang_group,
    hang_passive,
    hang_wheel,
    measure_absolute,
    passive_legs,
    pivot_image,
)
from graphic_tmm.chapters.kinematics.special_groups import special_accelerations
from graphic_tmm.chapters.kinematics.wheels import attached
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure

VIEW = "accelerations"
ClosingWay = Callable[[Draft, Positions, Motion, Motion, SpecialClosing], None]
"""How a group of a class above II is drawn, by velocities on a plan of accelerations."""


def draw_accelerations(
    draft: Draft,
    mechanism: Mechanism,
    structure: Structure,
    positions: Positions,
    velocities: Motion,
    *,
    view: str = VIEW,
    mu: Mark | None = None,
    way: ClosingWay = special_accelerations,
) -> Motion:
    """Draw the plan of accelerations of the whole mechanism; ``mu``: its scale factor, if there is one."""
    draft.open(view)
    pole = draft.take(Point, "π", 0j, role=roles.ACCELERATION)
    mu = mu or draft.scale("μ_a", "(m/s²)/mm")
    draft.lay_out(pole, mu)
    frame = positions.bodies[mechanism.frame.number]
    plan = Motion(Images(draft, pole, frame), mu)
    for pair in driven(mechanism, structure):
        if pair.held:
            pair.hold(positions, plan)
        else:
            pair.acceleration(draft, positions, velocities, plan)
    for one in attached(positions, VIEW):
        if isinstance(one, Meshed):
            _wheel(draft, positions, velocities, plan, one)
        elif isinstance(one, Closing):
            _group(draft, positions, velocities, plan, one)
        else:
            way(draft, positions, velocities, plan, one)
    hang_passive(positions, plan)
    for leg, _, point in passive_legs(positions, plan):
        line = tangential_line(draft, velocities, plan, point.letter, leg)
        read_tangential(draft, plan, leg, point, line)
    measure_absolute(draft, plan, positions)
    return plan


def _wheel(
    draft: Draft, positions: Positions, velocities: Motion, plan: Motion, wheel: Meshed
) -> None:
    """Draw a wheel's pitch point: over the other's along the line of centres, and about its own centre.

    Of a belt the ends of its run differ across it only; where that turns with an arm, it is as a link.
    """
    draft.say(wheel.rolling.note)
    on, leg, span = wheel.rolling.on, wheel.leg, wheel.span
    if span:
        letter, start = wheel.letter, pivot_image(plan, span)
    else:
        letter = f"{wheel.letter}{leg.link}"
        start = plan.images.of(on, wheel.pitch, wheel.rolling.letter, f"{wheel.letter}{on}")
    across = tangential_line(draft, velocities, plan, letter, leg)
    turns = span is not None and span.link in velocities.readings
    if span and turns:
        along = tangential_line(draft, velocities, plan, letter, span)
    else:
        name, because = f"({between(start, letter)})", why.RIM_APART if span else why.ROLLING_APART
        along = draft.draw(parallel, name, start, leg.line, sense=1, why=because)
    point = draft.draw(meet, letter, along, across, free=True, why=why.BOTH_EQUATIONS)
    if span and turns:
        component(
            draft, read_segment(draft, point, along, why.TANGENTIAL_READ), "t", letter, span.letter
        )
    elif start != plan.images.pole:
        component(
            draft, read_segment(draft, point, along, why.RELATIVE_READ), "r", letter, start.name
        )
    read_tangential(draft, plan, leg, point, across)
    hang_wheel(positions, plan, wheel, pivot_image(plan, leg), point)


def _group(
    draft: Draft, positions: Positions, velocities: Motion, plan: Motion, closing: Closing
) -> None:
    draft.say(f"II({closing.group.name})")
    lines = [free_line(draft, velocities, plan, closing, leg) for leg in closing.legs]
    point = draft.draw(
        meet, closing.image_letter, lines[1], lines[0], free=True, why=why.BOTH_EQUATIONS
    )
    for leg, line in zip(closing.legs, lines, strict=True):
        read_along(draft, plan, closing, leg, point, line)
    hang_group(positions, plan, closing, point)
