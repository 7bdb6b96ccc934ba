"""The size of a load by the travel of a point or by the swing of a link: straight lines between given shares.

Either is counted from where it turns back: the zero position if it does so there, else an end that is drawn.
Which part a position stands on is a choice that is made before the log runs, by the exact travel and by the way
that it goes; the size is a step, by the travel as measured.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from operator import itemgetter
from typing import Any, NamedTuple, Protocol

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.energetics import between, between_turns
from graphic_tmm.board.operations.graphs import at_end, at_zero
from graphic_tmm.board.operations.instruments import measure, measure_along, ray
from graphic_tmm.board.operations.supports import farthest, swung
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Reals
from graphic_tmm.chapters.diagrams.plan import sliding_leg
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.task import TURN, Table, Travel, scaled, turns_of
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.courses import WIDEST, Course, draw_end
from graphic_tmm.chapters.kinematics.dead_centres import (
    LEVEL,
    WAYS,
    Slider,
    course_of,
    draw_dead_centres,
    slider_of,
)
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.chapters.kinematics.extremes import Wanted, try_extreme
from graphic_tmm.chapters.kinematics.row import zero_of
from graphic_tmm.chapters.kinematics.survey import Survey, survey
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Extreme
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.references import of_link
from graphic_tmm.scene.values import CLOCKWISE, COUNTERCLOCKWISE

SLACK = 1e-9
"""A share of the stroke, or of a turn, that is over by less than this is on the part still."""
BETWEEN = 360
"""A row is looked through in so many parts."""
_NOTHING = (0.0, 1.0, 0.0, 0.0)


class Drawing(Protocol):
    """The plan of positions, and the mechanism at any angles."""

    @property
    def positions(self) -> Positions:
        """The plan of positions."""

    @property
    def survey(self) -> Survey:
        """The mechanism tried at any angles of the crank."""

    @property
    def intervals(self) -> int:
        """How many positions the row has, of a turn."""

    @property
    def steps(self) -> np.ndarray | None:
        """How far each position of a row that does not close is from its first."""


class Traveller(NamedTuple):
    """What a size goes by: its course, the sense in which it goes out, its ends, the way and the stroke.

    ``start``, ``last``: a point, or two of a link; ``way``, ``stroke``: Length, of a link Angle.
    """

    course: Course
    ahead: float
    start: tuple[Mark, ...]
    last: tuple[Mark, ...]
    way: Mark
    stroke: Mark


def by_travel(
    draft: Draft, ground: Drawing, travel: Travel, count: int, named: tuple[str, str]
) -> tuple[Mark, Traveller]:
    """Calculate the size of a load at all ``count`` positions; ``named``: its letter and its unit.

    Raises
    ------
    StructureError
        If what it goes by has no travel, or does not turn back where that is to begin.
    """
    letter, unit = named
    of = _traveller(draft, ground, travel, count)
    parts = _parts(draft, ground, travel, of)
    units = (unit, unit, "", "")
    given = [
        draft.take(Number, "", parts[k][None, :], one)
        for one, k in zip(units, (2, 3, 0, 1), strict=True)
    ]
    op = between if of.course.link is None else between_turns
    return draft.draw(op, letter, *given, of.way, of.stroke, unit=unit), of


def _traveller(draft: Draft, ground: Drawing, travel: Travel, count: int) -> Traveller:
    """Draw from where to where it goes: from zero, between its dead centres, or all of an open row."""
    course, slider = _course_by(draft.given, ground.positions, ground.survey, travel)
    row, begin = _row(draft, ground), _begin(course, travel)
    inside = 0 if course.ends is not None else _first(course, row, ground)
    if course.ends is None and not inside and course.link is not None and course.span > WIDEST:
        raise _too_wide(course.link, course.span)
    if course.ends is None and not inside and (slider is None or ground.steps is not None):
        says = said(
            "{what} does not turn back at both ends, nor go one way through the row; give the size "
            "by_position, or by_angle",
            what=_called(travel),
        )
        raise StructureError(says, "of", head="load")
    sides = (begin,) if travel.start else (begin, -begin)
    zero = next((one for one in sides if _comes(course, row[:1], one, stands=True)), inside)
    begin = begin if travel.start else zero or begin
    ends = _Ends(draft, ground, course, slider)
    start = ends.drawn(at_zero, "0") if begin == zero else ends.end(begin, inside)
    letter = str(course.link or travel.of)
    line = None
    if slider is None and course.link is None:
        way = np.degrees(np.angle(-begin * course.way))
        line = draft.draw(ray, f"({letter})", start[0], draft.direction(float(way)), free=True)

    def read(named: str, to: tuple[Mark, ...], reason: str) -> Mark:
        if course.link is not None:
            marks, named = (*start, *to), named.replace("s", "ψ", 1)
            return draft.draw(swung, named, *marks, unit="°", sense=-begin)
        if line is not None:
            return draft.draw(measure_along, named, start[0], to[0], line, why=reason)
        return draft.draw(measure, named, start[0], to[0], why=reason)

    travelled = f"|s_{letter}|" if slider is not None else f"s_{{{letter}}}"
    measured = read(travelled, ends.points, why.TRAVEL)
    if begin == zero and slider is not None and _comes(course, row[:count], -begin):
        last = ends.drawn(farthest, "S", *start, row=count)
    else:
        last = ends.end(-begin, inside)
    stroke = read(f"s_{{{letter}max}}", last, why.STROKE)
    return Traveller(course, -begin, start, last, measured, stroke)


def _first(course: Course, row: Reals, ground: Drawing) -> int:
    """Return which end of a course an open row begins at that it goes through one way; else 0.

    StructureError if a link turns farther there than a protractor reads.
    """
    if ground.steps is None:
        return 0
    places = course.places(np.linspace(row[0], row[ground.intervals - 1], BETWEEN + 1))
    gains = np.diff(places)
    first = -1 if (gains > 0.0).all() else int((gains < 0.0).all())
    if first and course.link is not None and (swing := abs(places[-1] - places[0])) > WIDEST:
        raise _too_wide(course.link, swing)
    return first


def _too_wide(link: int, swing: float) -> StructureError:
    says = said(
        "link {link} turns by {swing:.3g}°, and a protractor reads {widest:g}° at most; give the size "
        "by_position, or by_angle",
        link=link,
        swing=swing,
        widest=WIDEST,
    )
    return StructureError(says, "of", head="load")


class _Ends(NamedTuple):
    """Draws the ends of a course."""

    draft: Draft
    ground: Drawing
    course: Course
    slider: Slider | None

    @property
    def points(self) -> tuple[Mark, ...]:
        """The points that it is read off."""
        positions, course = self.ground.positions, self.course
        if course.link is None:
            return (positions.point(course.letters[0]),)
        return tuple(positions.bodies[course.link].marks[letter] for letter in course.letters)

    def drawn(
        self, op: Operation, index: str, *before: Mark, row: int | None = None
    ) -> tuple[Mark, ...]:
        """Mark where its points stand; those of the frame are there."""
        survey, choice = self.ground.survey, dict[str, Any]({} if row is None else {"row": row})
        fixed = self.ground.positions.bodies[survey.mechanism.frame.number].marks.values()
        return tuple(
            mark
            if mark in fixed
            else self.draft.draw(op, f"{letter}_{index}", *before, mark, **choice, free=True)
            for letter, mark in zip(self.course.letters, self.points, strict=True)
        )

    def end(self, which: int, inside: int) -> tuple[Mark, ...]:
        """Draw its least (−1) or greatest (1) place; ``inside``: which of them an open row begins at."""
        draft, ground = self.draft, self.ground
        if inside:
            last = ground.intervals
            return (
                self.drawn(at_zero, "0") if which == inside else self.drawn(at_end, "S", row=last)
            )
        if self.slider is None:
            return draw_end(draft, ground.positions, self.course, which)
        ends = draw_dead_centres(draft, ground.survey, ground.positions, self.slider)
        return (ends.outer if which > 0 else ends.inner,)


def _course_by(
    given: Mapping[Mark, object], positions: Positions, survey: Survey, travel: Travel
) -> tuple[Course, Slider | None]:
    """Return what a size goes by, with the slider if it is one."""
    of, frame = travel.of, survey.mechanism.frame.number
    if isinstance(of, int):
        return Course(survey, _two_letters(survey, of), link=of), None
    if travel.along is not None:
        return Course(survey, (of,), turn(travel.along)), None
    for driven in (one.driven for one in survey.pairs):
        slide, letters = driven.pair.slide, survey.mechanism.by_number[driven.link].points
        if slide is not None and not driven.telescopes and of in letters:
            return Course(survey, (of,), turn(slide.guide.angle)), None
    leg = sliding_leg(positions, of, frame, "load", "of")
    slider = slider_of(survey, given, positions, leg, of)
    return course_of(survey, slider), slider


def _two_letters(survey: Survey, number: int) -> tuple[str, ...]:
    """Return two letters of a link, of the frame first: its line tells how far it has swung."""
    body = survey.positions.bodies.get(number)
    frame = survey.mechanism.frame.points
    own = body.link.points if body is not None else {}
    first = min(own, key=lambda k: k not in frame, default="")
    far = max(own, key=lambda k: abs(own[k] - own[first]), default="")
    if not own or own[far] == own[first] or number not in survey.velocities.rates:
        says = said(
            "link {link} shows no swing: it does not turn, or has not two letters that stand apart",
            link=number,
        )
        raise StructureError(says, "of", head="load")
    return first, far


def _called(travel: Travel) -> str:
    if isinstance(travel.of, int):
        return said("link {number}", number=travel.of, context="turns back")
    return said("{point} along its line", point=travel.of)


def _begin(course: Course, travel: Travel) -> int:
    """Return at which end a travel begins that is not counted from zero: 1 the greatest, −1 the least place."""
    if course.link is not None:
        at = 1 if travel.start == COUNTERCLOCKWISE else -1
        known = travel.start in ("", CLOCKWISE, COUNTERCLOCKWISE)
        ways = '"clockwise", "counterclockwise"'
    else:
        away = 1.0 if travel.along is None else -1.0
        way = WAYS.get(travel.start, 0j) if travel.start else away * course.way
        ahead = float((way * course.way.conjugate()).real)
        at, known = (1 if ahead > 0.0 else -1), abs(ahead) >= LEVEL
        level = travel.start in ("top", "bottom") or abs(course.way.real) > abs(course.way.imag)
        ways = '"left", "right"' if level else '"bottom", "top"'
    if not known:
        says = said(
            "{point} does not turn back there; write one of {ways}", point=_name(travel), ways=ways
        )
        raise StructureError(says, "start", head="load")
    return at


def _name(travel: Travel) -> str:
    return of_link(travel.of) if isinstance(travel.of, int) else travel.of


def _row(draft: Draft, ground: Drawing) -> Reals:
    """Return the coordinate of the drive at every position."""
    phi = ground.positions.row[0]
    given = {**draft.given, draft.mu_l: 1.0}
    return np.asarray(execute(draft.board.construction(), given, [phi])[phi][0])


def _comes(course: Course, row: Reals, which: int, *, stands: bool = False) -> bool:
    """Tell whether a row comes to an end of a course, and ``stands`` there."""
    if course.ends is None or (stands and not course.stands(row).all()):
        return False
    ends = [one.angle for one in course.ends]
    *there, least, greatest = course.places(np.array([*row, *ends]))
    end, span = (least, greatest)[which > 0], abs(greatest - least)
    return any(abs(one - end) <= SLACK * span for one in there)


def _parts(draft: Draft, ground: Drawing, travel: Travel, of: Traveller) -> Reals:
    """Return of every position its part: from and to which share, from and to which size, (4, position)."""
    given = {**draft.given, draft.mu_l: 1.0}
    phi = ground.positions.row[0]
    reading = execute(draft.board.construction(), given, [of.way, of.stroke, phi])
    shares = np.asarray(reading[of.way][0] / reading[of.stroke][0, 0])
    if not np.isfinite(shares).all():
        return part_of_travel((), shares)
    return parts_at(travel, of, shares, reading[phi][0])


def parts_at(travel: Travel, of: Traveller, shares: Reals, row: Reals) -> Reals:
    """Return the part that each share stands on, by the way that goes there, (4, position)."""
    out, back = parts_of_strokes(travel, shares)
    return np.where(of.course.goes(row, of.ahead), out, back)


def end_of(scene: Scene, travel: Travel) -> str:
    """Return at which end a travel begins: "left", of a link "clockwise" (or so); "" in the zero position."""
    mechanism, zero = scene.mechanism, scene.row.zero
    assert mechanism is not None
    structure = dissect(mechanism)
    if isinstance(zero, Extreme):
        angle = try_extreme(survey(mechanism, structure), Wanted(zero)).angle
    else:
        angle = zero_of(scene.row)
    tried = survey(mechanism, structure, angle)
    course = _course_by(tried.given, tried.positions, tried, travel)[0]
    at = np.array([angle])
    if not travel.start and any(_comes(course, at, side, stands=True) for side in (1, -1)):
        return ""
    begin = _begin(course, travel)
    if course.link is not None:
        return COUNTERCLOCKWISE if begin > 0 else CLOCKWISE
    return max(WAYS, key=lambda at: (begin * course.way * WAYS[at].conjugate()).real)


def parts_of_strokes(travel: Travel, shares: Reals) -> tuple[Reals, Reals]:
    """Return the part that each share of the stroke stands on, on the stroke out and on the one back."""
    return part_of_travel(travel.out, shares), part_of_travel(travel.back, shares, ahead=False)


def part_of_travel(points: Table, shares: Reals, *, ahead: bool = True) -> Reals:
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


def size_in_row(by_time: Table, pair: DrivenPair, way: float, gone: Reals) -> Reals:
    """Return the size of a load by time where a row that goes a ``way`` has gone so far (° or m).

    Nothing acts before the first time of the table, nor behind the last.
    """
    shares = gone / way
    a, b, p, q = part_of_travel(scaled(by_time, pair.time(way), 1.0), shares)
    return np.asarray(p + (q - p) * (shares - a) / (b - a))


def size_at_turn(points: Table, turned: Reals) -> Reals:
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
