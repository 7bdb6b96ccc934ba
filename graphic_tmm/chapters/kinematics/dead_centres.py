"""Dead centres of what slides on the frame: the two places where it turns back, drawn as points of the plan.

Where the slider hangs on a rod of the crank they are cut from its guide with both lengths in the compass.
Elsewhere the crank's angle is looked for as that of any extreme position, and the mechanism is drawn once more
at it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.locus import drawn_once_more
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.chapters.kinematics.bodies import GuideLeg, Positions
from graphic_tmm.chapters.kinematics.extremes import (
    draw_refined,
    slider_end,
    try_extreme,
)
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.task import EXTREMES as VIEW
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Extreme

STANDS = 1e-6
"""What goes slower than this share of its fastest stands."""
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


def slider_of(draft: Draft, positions: Positions, leg: GuideLeg, letter: str) -> Slider:
    """Return a slider by its leg and the letter of its point."""
    closing = next(c for c in positions.closings if leg in c.legs)
    side = positions.sides.get(closing.group.name)
    outward = 1.0 if side is None else float(np.ravel(np.asarray(draft.given[side]))[0])
    return Slider(leg, letter, outward)


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
        group.kind == 2
        and len(survey.pairs) == 1
        and survey.sweep.closed
        and slider.point == group.inner.name
        and (rod.body, rod.pair.kind) == (survey.structure.first.link, "R")
    )
    drawn = list[Mark]()
    for choice, sign in ((1, "′"), (-1, "″")):
        name = f"{slider.point}{sign}"
        role = f"dead centre {name}"
        known = draft.board.construction().roles(VIEW, role)
        if known:
            drawn += known[:1]
        elif simple:
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


def dead_centre_at(survey: Survey, slider: Slider, at: str) -> int:
    """Return which dead centre lies "left" (or so) of the other: 1 away from the crank, −1, 0 if neither."""
    out = slider.outward * _direction(survey, slider)
    ahead = (out * WAYS[at].conjugate()).real
    return 0 if abs(ahead) < LEVEL else 1 if ahead > 0.0 else -1


def turned_at(survey: Survey, slider: Slider, choice: int) -> float:
    """Return the crank's angle, degrees, at a dead centre."""
    return try_extreme(survey, extreme_at(survey, slider, choice)).angle


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
    name, role = named
    extreme = extreme_at(survey, slider, choice)
    angle = draw_refined(draft, survey, extreme, try_extreme(survey, extreme), name)
    step = drawn_once_more(
        _Place(survey, survey.positions.point(slider.point)),
        said(
            "At the crank angle {angle} draw the mechanism once more, thinly; mark {it}, where {point} stands.",
            angle="{angle}",
            point=slider.point,
            it="{it}",
        ),
    )
    return draft.draw(step, name, angle, draft.mu_l, role=role)


@dataclass(frozen=True, eq=False)
class _Place:
    """Where a point stands at a row of crank angles (degrees), m."""

    survey: Survey
    mark: Mark

    def __call__(self, row: Reals) -> Complexes:
        return np.asarray(self.survey.at(row, [self.mark])[self.mark])


def goes_out(survey: Survey, slider: Slider, angles: Reals, way: complex) -> np.ndarray:
    """Tell at which crank angles (degrees) a slider goes the way, by the sign of its velocity.

    Where it stands, at a dead centre, it counts as having gone that way.
    """
    speed, way_ = _speed(survey, slider, angles)
    return np.asarray(speed * np.sign((way * np.conj(way_)).real) >= -STANDS)


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
    return np.asarray(np.abs(_speed(survey, slider, angles)[0]) <= STANDS)


def _speed(survey: Survey, slider: Slider, angles: Reals) -> tuple[Reals, complex]:
    """Return how fast a slider goes, as a share of its fastest, and along which axis that is measured."""
    along = _direction(survey, slider)
    axis_name, way = ("x", 1 + 0j) if abs(along.real) >= abs(along.imag) else ("y", 1j)
    axis = survey.axes[slider.point, axis_name]
    fastest = np.max(np.abs(np.nan_to_num(survey.whole([axis])[1][axis])), initial=0.0)
    return np.asarray(survey.at(angles[None, :], [axis])[axis])[0] / (fastest or 1.0), way
