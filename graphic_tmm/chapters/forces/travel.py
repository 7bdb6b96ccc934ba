"""The size of a load by the travel of a point that slides on the frame: straight lines between given shares.

The travel is counted from where the point turns back: the zero position if it does so there, else a dead centre
that is drawn. Which part a position stands on is a choice that is made before the log runs, by the exact travel
and by the way the point goes; the size is a step, by the travel as measured.
"""

from __future__ import annotations

from itertools import pairwise
from operator import itemgetter
from typing import NamedTuple, Protocol

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.energetics import between
from graphic_tmm.board.operations.graphs import at_zero
from graphic_tmm.board.operations.instruments import measure
from graphic_tmm.board.operations.supports import farthest
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Reals
from graphic_tmm.chapters.diagrams.plan import sliding_leg
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.task import TURN, Travel, turns_of
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.dead_centres import (
    WAYS,
    Slider,
    dead_centre_at,
    draw_dead_centres,
    goes_out,
    slider_of,
    stands,
)
from graphic_tmm.chapters.kinematics.extremes import try_extreme
from graphic_tmm.chapters.kinematics.survey import Survey, survey
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Extreme
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.scene.records import Scene

SLACK = 1e-9
"""A share of the stroke, or of a turn, that is over by less than this is on the part still."""
_NOTHING = (0.0, 1.0, 0.0, 0.0)


class Drawing(Protocol):
    """The plan of positions, and the mechanism at any angles."""

    @property
    def positions(self) -> Positions:
        """The plan of positions."""

    @property
    def survey(self) -> Survey:
        """The mechanism tried at any angles of the crank."""


class Traveller(NamedTuple):
    """What a size depends on: the slider, where its travel begins and ends, the way and the stroke (Length)."""

    slider: Slider
    point: Mark
    start: Mark
    last: Mark
    way: Mark
    stroke: Mark


def by_travel(
    draft: Draft, ground: Drawing, travel: Travel, count: int, named: tuple[str, str]
) -> Mark:
    """Calculate the size of a load at all ``count`` positions; ``named``: its letter and its unit.

    Raises
    ------
    StructureError
        If the point does not slide on the frame, or does not turn back where the travel is to begin.
    """
    letter, unit = named
    of = _traveller(draft, ground, travel, count)
    parts = _parts(draft, ground, travel, of)
    units = (unit, unit, "", "")
    given = [
        draft.take(Number, "", parts[k][None, :], one)
        for one, k in zip(units, (2, 3, 0, 1), strict=True)
    ]
    return draft.draw(between, letter, *given, of.way, of.stroke, unit=unit)


def _traveller(draft: Draft, ground: Drawing, travel: Travel, count: int) -> Traveller:
    """Draw from where to where the point travels: from the zero position, or between its dead centres."""
    frame = ground.survey.mechanism.frame.number
    leg = sliding_leg(ground.positions, travel.of, frame, "load", "of")
    slider = slider_of(draft, ground.positions, leg, travel.of)
    point = ground.positions.point(travel.of)
    end = dead_centre_at(ground.survey, slider, travel.start) if travel.start else 1
    if not end:
        ways = '"left", "right"' if travel.start in ("top", "bottom") else '"bottom", "top"'
        says = said(
            "{point} does not turn back there; write one of {ways}", point=travel.of, ways=ways
        )
        raise StructureError(says, "start", head="load")
    if _begins(draft, ground, slider, travel, point):
        start, last = draft.draw(at_zero, f"{travel.of}_0", point, free=True), None
    else:
        start, last = draw_dead_centres(draft, ground.survey, ground.positions, slider)[::end]
    way = draft.draw(measure, f"|s_{travel.of}|", start, point, why=why.TRAVEL)
    if last is None:
        last = draft.draw(farthest, f"{travel.of}_S", start, point, row=count, free=True)
    stroke = draft.draw(measure, f"s_{{{travel.of}max}}", start, last, why=why.STROKE)
    return Traveller(slider, point, start, last, way, stroke)


def _begins(draft: Draft, ground: Drawing, slider: Slider, travel: Travel, point: Mark) -> bool:
    """Tell whether the row begins where the travel does: the slider stands there, and not at the other end."""
    phi = ground.positions.row[0]
    given = {**draft.given, draft.mu_l: 1.0}
    reading = execute(draft.board.construction(), given, [point, phi])
    spots = reading[point][0]
    if not np.isfinite(spots).all():
        return not travel.start
    if not stands(ground.survey, slider, reading[phi][0])[0]:
        return False
    far = complex(max(spots - spots[0], key=abs))
    return not travel.start or (far * WAYS[travel.start].conjugate()).real < 0.0


def _parts(draft: Draft, ground: Drawing, travel: Travel, of: Traveller) -> Reals:
    """Return of every position its part: from and to which share, from and to which size, (4, position)."""
    given = {**draft.given, draft.mu_l: 1.0}
    phi = ground.positions.row[0]
    marks = [of.start, of.last, of.way, of.stroke, phi]
    reading = execute(draft.board.construction(), given, marks)
    start, last = (complex(reading[mark][0, 0]) for mark in (of.start, of.last))
    shares = np.asarray(reading[of.way][0] / reading[of.stroke][0, 0])
    if not np.isfinite(shares).all():
        return part_of_travel((), shares)
    out, back = parts_of_strokes(travel, shares)
    going = goes_out(ground.survey, of.slider, reading[phi][0], last - start)
    return np.where(going, out, back)


def begins_at_zero(scene: Scene, letter: str) -> bool:
    """Tell whether a slider stands in the zero position of a scene."""
    mechanism, zero = scene.mechanism, scene.row.zero
    assert mechanism is not None
    tried = survey(mechanism, dissect(mechanism))
    leg = sliding_leg(tried.positions, letter, mechanism.frame.number, "load", "of")
    angle = try_extreme(tried, zero).angle if isinstance(zero, Extreme) else zero
    return bool(stands(tried, Slider(leg, letter, 1.0), np.array([angle]))[0])


def parts_of_strokes(travel: Travel, shares: Reals) -> tuple[Reals, Reals]:
    """Return the part that each share of the stroke stands on, on the stroke out and on the one back."""
    return part_of_travel(travel.out, shares), part_of_travel(travel.back, shares, ahead=False)


def part_of_travel(
    points: tuple[tuple[float, float], ...], shares: Reals, *, ahead: bool = True
) -> Reals:
    """Return the part that each share of the stroke stands on; nothing acts outside of them.

    From and to which share, from and to which size: (4, share). At a jump it is the size behind it, all the
    way; ``ahead``: whether the shares grow on that stroke.
    """
    pairs = list(pairwise(sorted(points, key=itemgetter(0))))
    found = np.repeat(np.array(_NOTHING)[:, None], shares.size, axis=1)
    # where two parts meet, it is the first one
    for (a, p), (b, q) in reversed(pairs):
        if a < b:
            on = (a - SLACK <= shares) & (shares <= b + SLACK)
            found[:, on] = np.array((a, b, p, q))[:, None]
    for (a, p), (b, q) in pairs:
        if a == b:
            size = q if ahead else p
            found[:, np.abs(shares - a) <= SLACK] = np.array((0.0, 1.0, size, size))[:, None]
    return found


def size_at_turn(points: tuple[tuple[float, float], ...], turned: Reals) -> Reals:
    """Return the size of a load at turns of the crank, degrees; at a jump the size behind it.

    The last point and the first one of the next cycle, of one turn or of two, are joined like others.
    """
    (first, begins), (last, ends) = points[0], points[-1]
    cycle = TURN * turns_of(points)
    places, sizes = np.array([(last - cycle, ends), *points, (first + cycle, begins)]).T
    at = (turned + SLACK * TURN) % cycle - SLACK * TURN
    k = np.minimum(np.searchsorted(places, at + SLACK * TURN, side="right") - 1, len(points))
    share = np.clip((at - places[k]) / (places[k + 1] - places[k]), 0.0, 1.0)
    return np.asarray(sizes[k] + share * (sizes[k + 1] - sizes[k]))
