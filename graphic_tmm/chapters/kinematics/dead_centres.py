"""Dead centres of what slides on the frame: the two places where it turns back, drawn as points of the plan.

Where the slider hangs on a rod of the crank they are cut from its guide with both lengths in the compass.
Elsewhere the crank's angle is looked for as that of any extreme position, and the mechanism is drawn once more
at it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.closings import GuideLeg
from graphic_tmm.chapters.kinematics.courses import Course, redrawn
from graphic_tmm.chapters.kinematics.extremes import (
    Wanted,
    draw_refined,
    over_whole,
    slider_end,
    try_extreme,
)
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.task import EXTREMES as VIEW
from graphic_tmm.mechanism.groups import Group
from graphic_tmm.mechanism.records import Extreme

ASIDE = 1.0
"""So many degrees off a dead centre a slider has left it."""
LEVEL = 1e-9
"""A guide that leans less than this is level."""


class Slider(NamedTuple):
    """What slides on the frame: its leg, its point, the sense of its guide off the crank."""

    leg: GuideLeg
    point: str
    outward: float


class DeadCentres(NamedTuple):
    """Where a slider turns back: the point away from the crank, the one towards it."""

    outer: Mark
    inner: Mark


def slider_of(
    survey: Survey, given: Mapping[Mark, object], positions: Positions, leg: GuideLeg, letter: str
) -> Slider:
    """Return a slider by its leg and the letter of its point; ``given``: what is given on its board.

    Off the crank is where its rod does not come from; of one without a rod, the end that is farther from it.
    """
    closing = next(c for c in positions.closings if leg in c.legs)
    side = positions.sides.get(closing.group.name)
    if side is not None:
        return Slider(leg, letter, float(np.ravel(np.asarray(given[side]))[0]))
    slider = Slider(leg, letter, 1.0)
    return slider if _farther(survey, slider) else slider._replace(outward=-1.0)


def _farther(survey: Survey, slider: Slider) -> bool:
    """Whether a slider's place farthest along its guide is as far from the crank's pivot as the other end."""
    frame = survey.positions.bodies[survey.mechanism.frame.number]
    pivot, point = frame.marks[survey.structure.origin], survey.positions.point(slider.point)
    _, reading, there = over_whole(survey, [pivot, point])
    off = (reading[point] - reading[pivot]) * np.conj(_direction(survey, slider))
    row = np.broadcast_to(off.real[0], there.shape)[there]
    return bool(np.isnan(row).all() or np.nanmax(row) + np.nanmin(row) >= 0.0)


def draw_dead_centres(
    draft: Draft, survey: Survey, positions: Positions, slider: Slider
) -> DeadCentres:
    """Draw where a slider turns back; once on a board.

    Raises
    ------
    StructureError
        If it does not turn back within the range of the crank.
    """
    view = draft.view
    draft.open(VIEW)
    frame = positions.bodies[survey.mechanism.frame.number]
    if draft.board.construction().view(VIEW) is None:
        draft.lay_out(frame.marks[survey.structure.origin], draft.mu_l)
    group = next(c.group for c in positions.closings if slider.leg in c.legs)
    rod = group.legs[0]
    simple = (
        isinstance(group, Group)
        and group.kind == 2
        and len(survey.pairs) == 1
        and survey.sweep.closed
        and slider.point == group.inner.name
        and (rod.body, rod.pair.kind) == (survey.structure.first.link, "R")
    )
    drawn = list[Mark]()
    for choice, sign in ((1, "′"), (-1, "″")):
        name = f"{slider.point}{sign}"
        role = f"dead centre {name}"
        known, name = draft.board.construction().roles(VIEW, role), draft.board.free(name)
        if known:
            drawn += known[:1]
        elif simple and isinstance(group, Group):
            end = slider_end(draft, survey, frame, group, choice, (name, sign), role)
            drawn.append(end[0])
        else:
            drawn.append(_tried(draft, survey, slider, choice, (name, role)))
    draft.open(view)
    return DeadCentres(*drawn)


def extreme_at(survey: Survey, slider: Slider, choice: int) -> Extreme:
    """Return a dead centre as an extreme position; ``choice``: 1 away from the crank, −1 towards it."""
    way = choice * slider.outward * _direction(survey, slider)
    ways = (("left", "right"), ("bottom", "top"))
    level = abs(way.real) >= abs(way.imag)
    at = ways[0 if level else 1][(way.real if level else way.imag) > 0.0]
    return Extreme(slider.point, at)


WAYS = {"left": -1 + 0j, "right": 1 + 0j, "bottom": -1j, "top": 1j}


def turned_at(survey: Survey, slider: Slider, choice: int) -> float:
    """Return the crank's angle, degrees, at a dead centre."""
    return try_extreme(survey, Wanted(extreme_at(survey, slider, choice))).angle


def _direction(survey: Survey, slider: Slider) -> complex:
    line = _own_leg(survey, slider).line
    along = execute(survey.construction, survey.given, [line])[line].along
    return complex(np.ravel(along)[0])


def _own_leg(survey: Survey, slider: Slider) -> GuideLeg:
    """Return the leg of the slider on the survey's own board."""
    legs = [leg for closing in survey.positions.closings for leg in closing.legs]
    return next(leg for leg in legs if isinstance(leg, GuideLeg) and leg.link == slider.leg.link)


def _tried(
    draft: Draft, survey: Survey, slider: Slider, choice: int, named: tuple[str, str]
) -> Mark:
    extreme = extreme_at(survey, slider, choice)
    ends = course_of(survey, slider).ends
    tried = try_extreme(survey, Wanted(extreme)) if ends is None else ends[choice > 0]
    angle = draw_refined(draft, survey, extreme, tried, named[0])
    return redrawn(
        draft, survey, survey.positions.point(slider.point), angle, (slider.point, *named)
    )


def goes_out(survey: Survey, slider: Slider, angles: Reals, way: complex) -> np.ndarray:
    """Tell at which crank angles (degrees) a slider goes the way, by the sign of its velocity."""
    course = course_of(survey, slider)
    return course.goes(angles, float((way * course.way.conjugate()).real))


def goes_inward(survey: Survey, slider: Slider, angles: Reals) -> np.ndarray:
    """Tell at which crank angles (degrees) a slider comes from its dead centre away from the crank."""
    return goes_out(survey, slider, angles, -slider.outward * _direction(survey, slider))


def dead_centre(survey: Survey, slider: Slider, angle: float) -> int:
    """Return at which dead centre a slider stands at an angle (degrees): 1 away from the crank, or −1."""
    mark, ahead = survey.positions.point(slider.point), slider.outward * _direction(survey, slider)
    there = survey.at(np.array([[angle, angle + ASIDE]]), [mark])[mark][0]
    return 1 if ((there[0] - there[1]) * np.conj(ahead)).real > 0.0 else -1


def stands(survey: Survey, slider: Slider, angles: Reals) -> np.ndarray:
    """Tell at which crank angles (degrees) a slider stands."""
    return course_of(survey, slider).stands(angles)


def course_of(survey: Survey, slider: Slider) -> Course:
    """Return the course of a slider along its guide, off the crank."""
    return Course(survey, (slider.point,), slider.outward * _direction(survey, slider))
