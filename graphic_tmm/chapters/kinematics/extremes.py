"""Extreme positions of an output point, found before all plans.

Where the mechanism admits it, by its construction on the board: crank and rod in one line (a slider or a
rocker on the crank's rod), crank square to the rocker (a stone on the crank). Elsewhere by refining on the
board: the crank's angle at which the image of the point lies square to the asked direction.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.operations.formulas import difference, total
from graphic_tmm.board.operations.instruments import bearing, cross, cut, strike, touch
from graphic_tmm.board.operations.locus import refinement
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Reals, Side, undefined
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.assembly import check_assembly
from graphic_tmm.chapters.kinematics.bodies import Body, draw_guide
from graphic_tmm.chapters.kinematics.dyads import rocker_offset
from graphic_tmm.chapters.kinematics.positions import side_record
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.task import EXTREMES as VIEW
from graphic_tmm.chapters.kinematics.winding import STEPS
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import Said, said
from graphic_tmm.mechanism.groups import Group, of_two_links
from graphic_tmm.mechanism.guides import level
from graphic_tmm.mechanism.records import Extreme, Sweep

SAME = 1e-6
"""Degrees: a drawn extreme that is nearer than this to the one tried out is the same."""
STILL = 1e-9
"""A point that travels less than this share of its distance from the crank's pivot stands still."""
_WAY = {"left": ("x", -1), "right": ("x", 1), "bottom": ("y", -1), "top": ("y", 1)}

Speed = Callable[[Reals], Reals]
"""How fast something goes at coordinates of the drive (trial, position)."""


class Tried(NamedTuple):
    """An extreme found by trying: the bracket and the coordinate of the drive, degrees or m."""

    low: float
    high: float
    angle: float


class Wanted(NamedTuple):
    """An extreme position that a row wants: its key; ``ends``: between which coordinates, of an open row."""

    extreme: Extreme
    key: str = "zero"
    ends: tuple[float, float] | None = None

    @property
    def remedy(self) -> Said:
        """What to write in place of a position that is not there."""
        zero = self.key == "zero"
        return said("give zero as an angle") if zero else said("leave this position out")


def draw_extreme(draft: Draft, survey: Survey, frame: Body, wanted: Wanted, tag: str) -> Mark:
    """Record how the drive's coordinate at an extreme position is found; return its mark (degrees or m).

    ``tag`` marks the letters of this position ("0", "*").

    Raises
    ------
    StructureError
        If the point is not a moving point of the mechanism, or has no extreme position that way.
    """
    tried, extreme = try_extreme(survey, wanted), wanted.extreme
    draft.open(VIEW)
    if draft.board.construction().view(VIEW) is None:
        draft.lay_out(frame.marks[survey.structure.origin], draft.mu_l)
    group = next(of_two_links(survey.structure.groups[:1], VIEW), None)
    alone = len(survey.pairs) == 1 and survey.sweep.turns
    draw = _CONSTRUCTIONS.get(group.kind) if alone and group else None
    if draw is not None and group is not None and _on_crank_and_frame(survey, group):
        for choice in (1, -1):
            probe = Draft()
            angle = _probe(probe, survey, frame, choice)
            if abs((angle - tried.angle + 180.0) % 360.0 - 180.0) < SAME:
                draft.say(f"{extreme.point}: {extreme.at}")
                return draw(draft, survey, frame, choice, tag)
    return draw_refined(draft, survey, extreme, tried, tag)


def try_extreme(survey: Survey, wanted: Wanted) -> Tried:
    """Find by trying where a point comes to an extreme position; StructureError if it does not."""
    point, at = wanted.extreme.point, wanted.extreme.at
    name, way = _WAY[at]
    axis = survey.axes.get((point, name))
    if axis is None:
        says = said(
            "{point} is not a moving point of the mechanism (moving: {listed})",
            point=point,
            listed=", ".join(dict.fromkeys(letter for letter, _ in survey.axes)),
        )
        raise StructureError(says, f"drive.{wanted.key}", head=wanted.key)
    mark = survey.positions.point(point)
    row, reading, there = over_whole(survey, [mark], wanted.ends)
    place = reading[mark][0].real if name == "x" else reading[mark][0].imag
    place = np.where(there, place, np.nan)
    if not np.isfinite(place).any():
        says = said("{point} cannot be drawn at any crank angle", point=point)
    elif np.nanmax(place) - np.nanmin(place) <= STILL * np.nanmax(np.abs(reading[mark])):
        says = said(
            "{point} moves neither {ways}: name another point, or {remedy}",
            point=point,
            ways=said("left nor right") if name == "x" else said("up nor down"),
            remedy=wanted.remedy,
        )
    else:
        best = float(row[0, int(np.nanargmax(way * place))])
        tried = turning_back(survey, Velocity(survey, axis), best, wanted.ends)
        if np.isfinite(tried.angle):
            return tried
        says = _has_none(survey, wanted, best, whole=bool(np.isfinite(place).all()))
    raise StructureError(says, f"drive.{wanted.key}", head=wanted.key)


def _has_none(survey: Survey, wanted: Wanted, best: float, *, whole: bool) -> Said:
    """Return why a point does not turn back where it comes farthest; ``whole``: it can be drawn everywhere."""
    point, at = wanted.extreme.point, wanted.extreme.at
    if wanted.ends is not None:
        return said(
            "{point} does not turn back at {at} between the ends of the row, it goes on there: name another "
            "point or side, or {remedy}",
            point=point,
            at=at,
            remedy=wanted.remedy,
        )
    if whole:
        return said(
            "{point} has no extreme position at {at} (near the crank angle {angle:.4g}° it does "
            "not stand still): {remedy}",
            point=point,
            at=at,
            angle=best,
            remedy=wanted.remedy,
        )
    return said(
        "{point} does not come to an extreme position at {at}, for the crank does not turn "
        "round: {says}; change the lengths, or {remedy}",
        point=point,
        at=at,
        says=check_assembly(survey).said,
        remedy=wanted.remedy,
    )


def over_whole(
    survey: Survey, marks: list[Mark], ends: tuple[float, float] | None = None
) -> tuple[Reals, Reading, np.ndarray]:
    """Read marks over the whole sweep, or from end to end.

    Return its coordinates (1, n), the reading, and where all groups can be drawn.
    """
    closed = [
        root for closing in survey.positions.closings for root in (closing.root, closing.point)
    ]
    row, reading = survey.whole([*marks, *closed], ends)
    gone = [undefined(reading[root])[0] for root in closed]
    return row, reading, ~np.logical_or.reduce(np.broadcast_arrays(np.zeros(row.size, bool), *gone))


def turning_back(
    survey: Survey, speed: Speed, best: float, ends: tuple[float, float] | None = None
) -> Tried:
    """Find by trying where a speed passes 0 beside a coordinate; NaN where it does not."""
    step = survey.step if ends is None else (ends[1] - ends[0]) / STEPS
    low, high = _bracket(step, speed, best)
    tried = refinement(speed, "").run(np.array([[low]]), np.array([[high]]))
    return Tried(low, high, float(tried[0, 0]))


def _bracket(step: float, speed: Speed, best: float) -> tuple[float, float]:
    """Return two coordinates about ``best`` with velocities of opposite senses; NaN if there are none.

    At the end of the crank's range the point stops for want of room, not because it stands still.
    """
    row = best + np.array([[-1.0, 0.0, 1.0]]) * step
    value = np.broadcast_to(speed(row), row.shape)[0]
    for low, high in ((0, 2), (0, 1), (1, 2)):
        if value[low] * value[high] <= 0.0:  # not so of NaN
            return float(row[0, low]), float(row[0, high])
    return float("nan"), float("nan")


@dataclass(frozen=True, eq=False)
class Velocity:
    """How fast a point moves along an axis, at a row of coordinates of the drive: a reading of the survey."""

    survey: Survey
    axis: Mark

    def __call__(self, row: Reals) -> Reals:
        """Return it at coordinates (trial, position), m/s."""
        return np.asarray(self.survey.at(row, [self.axis])[self.axis])


def draw_refined(draft: Draft, survey: Survey, extreme: Extreme, tried: Tried, tag: str) -> Mark:
    """Record how the drive's coordinate at an extreme position is looked for; return its mark."""
    name, _ = _WAY[extreme.at]
    axis, says = survey.axes[extreme.point, name], _BY_ANGLES if survey.sweep.turns else _BY_LENGTHS
    sentence = said(says, point=extreme.point, low="{low}", high="{high}", it="{it}")
    return refined(draft, survey.sweep, Velocity(survey, axis), sentence, tried, tag)


_BY_ANGLES = said(
    "Try crank angles between {low} and {high}, each time narrowing to where the image of {point} "
    "passes the pole; this is {it}."
)
_BY_LENGTHS = said(
    "Try lengths between {low} and {high}, each time narrowing to where the image of {point} passes the "
    "pole; this is {it}."
)


def refined(
    draft: Draft, sweep: Sweep, speed: Speed, sentence: str, tried: Tried, tag: str
) -> Mark:
    """Record that a coordinate is looked for between those that were tried; return its mark (degrees or m)."""
    ends, letter = (tried.low, tried.high), f"{sweep.letter}_{{{tag}}}"
    if sweep.turns:
        step, taken = refinement(speed, sentence), [draft.direction(one) for one in ends]
    else:
        step = refinement(speed, sentence, Number)
        taken = [draft.take(Number, "", one, sweep.unit) for one in ends]
    return draft.draw(step, letter, *taken, unit=sweep.unit, why=why.STANDS_STILL)


def _on_crank_and_frame(survey: Survey, group: Group) -> bool:
    first, second = group.legs
    frame = survey.mechanism.frame.number
    if group.kind == 3:
        stone, rocker = (survey.mechanism.by_number[leg.link] for leg in group.legs)
        straight = rocker_offset(group, stone, rocker) == 0.0
        return straight and first.pair.name == survey.structure.first.pin and second.body == frame
    crank_leg = first if first.body == survey.structure.first.link else second
    other = second if crank_leg is first else first
    return (
        group.kind in (1, 2)
        and crank_leg.pair.kind == "R"
        and crank_leg.pair.name == survey.structure.first.pin
        and other.body == frame
    )


def _first(survey: Survey) -> Group:
    """Return the first group, of two links."""
    return next(of_two_links(survey.structure.groups, VIEW))


def _probe(probe: Draft, survey: Survey, frame: Body, choice: int) -> float:
    """Run the drawing-board construction on a small board of its own; return the angle, degrees."""
    from graphic_tmm.chapters.kinematics.positions import draw_frame

    own = draw_frame(probe, survey.mechanism, survey.structure)
    probe.board.open(VIEW)
    group = _first(survey)
    mark = _CONSTRUCTIONS[group.kind](probe, survey, own, choice, "0")
    log = probe.board.construction()
    return float(execute(log, probe.given | {probe.mu_l: 1.0}, [mark])[mark][0, 0])


def _side(draft: Draft, survey: Survey, group: Group, tag: str, flip: int = 1) -> Mark:
    side = side_record(survey.mechanism, group)
    assert side is not None
    return draft.take(Side, f"±{group.name}", float(side.sign * flip))


def _reach(draft: Draft, survey: Survey, group: Group, choice: int) -> tuple[Mark, str, str, bool]:
    """Return the opening OA + AB, or |OA − AB|; the letters of pin and inner pin; if the rod is longer."""
    structure = survey.structure
    leg = next(leg for leg in group.legs if leg.body == structure.first.link)
    rod, crank = (
        survey.mechanism.by_number[leg.link],
        survey.mechanism.by_number[structure.first.link],
    )
    pin, inner = leg.pair.name, group.inner.name
    arm = abs(crank.points[pin] - crank.points[structure.origin])
    reach = abs(rod.points[inner] - rod.points[pin])
    oa = draft.length(f"{structure.origin}{pin}", arm)
    ab = draft.length(f"{pin}{inner}", reach)
    op, sign = (total, "+") if choice > 0 else (difference, "−")
    opening = draft.draw(
        op,
        f"{structure.origin}{pin}{sign}{pin}{inner}",
        oa,
        ab,
        why=why.STRETCHED if choice > 0 else why.FOLDED,
    )
    return opening, pin, inner, reach >= arm


def _in_line(
    draft: Draft, survey: Survey, found: Mark, frame: Body, choice: int, longer: bool, tag: str
) -> Mark:
    """Find the crank's angle from the inner pin's extreme place: towards it, or away from it."""
    pivot = frame.marks[survey.structure.origin]
    ends = (pivot, found) if choice > 0 or not longer else (found, pivot)
    return draft.draw(bearing, f"φ_{{{tag}}}", *ends, unit="°", why=why.IN_LINE)


def _slider(draft: Draft, survey: Survey, frame: Body, choice: int, tag: str) -> Mark:
    group = _first(survey)
    name = f"{group.inner.name}_{{{tag}}}"
    found, longer = slider_end(draft, survey, frame, group, choice, (name, tag))
    return _in_line(draft, survey, found, frame, choice, longer, tag)


def slider_end(
    draft: Draft,
    survey: Survey,
    frame: Body,
    group: Group,
    choice: int,
    named: tuple[str, str],
    role: str = "",
) -> tuple[Mark, bool]:
    """Draw where a slider on the crank's rod turns back; return the point, and if the rod is longer.

    ``choice``: 1 with crank and rod stretched, −1 with them folded; ``named``: the letter of the point, the tag
    of what belongs to it; ``role``: what the point is for.
    """
    name, tag = named
    opening, _, inner, longer = _reach(draft, survey, group, choice)
    arc = draft.draw(
        strike,
        f"({opening.letter})",
        frame.marks[survey.structure.origin],
        opening,
        why=why.STRETCHED if choice > 0 else why.FOLDED,
    )
    leg = group.legs[1]
    own = survey.mechanism.by_number[leg.link].points[inner]
    guide = draw_guide(draft, frame, leg.pair, level(leg.pair, leg.link, own), leg.pair.name)
    side = _side(draft, survey, group, tag)
    return draft.draw(cut, name, guide, arc, side, role=role, why=why.EXTREME_PIN), longer


def _rocker(draft: Draft, survey: Survey, frame: Body, choice: int, tag: str) -> Mark:
    group = _first(survey)
    opening, _, inner, longer = _reach(draft, survey, group, choice)
    pivot = frame.marks[survey.structure.origin]
    because = why.STRETCHED if choice > 0 else why.FOLDED
    arc = draft.draw(strike, f"({opening.letter})", pivot, opening, why=because)
    first, second = group.legs
    leg = second if second.body == frame.link.number else first
    rocker = survey.mechanism.by_number[leg.link]
    outer = leg.pair.name
    length = draft.length(f"{outer}{inner}", abs(rocker.points[inner] - rocker.points[outer]))
    swing = draft.draw(
        strike, f"({outer}; {length.letter})", frame.marks[outer], length, why=why.PIN_ARC
    )
    flip = 1 if leg is second else -1
    side = _side(draft, survey, group, tag, flip)
    found = draft.draw(cross, f"{inner}_{{{tag}}}", arc, swing, side, why=why.EXTREME_PIN)
    return _in_line(draft, survey, found, frame, choice, longer, tag)


def _stone(draft: Draft, survey: Survey, frame: Body, choice: int, tag: str) -> Mark:
    group, structure = _first(survey), survey.structure
    crank = survey.mechanism.by_number[structure.first.link]
    pivot, pin = structure.origin, structure.first.pin
    length = draft.length(f"{pivot}{pin}", abs(crank.points[pin] - crank.points[pivot]))
    name, because = f"({pivot}; {length.letter})", why.CRANK_CIRCLE
    arc = draft.draw(strike, name, frame.marks[pivot], length, why=because)
    which = draft.take(Side, "±", float(choice))
    rocker = frame.marks[group.legs[1].pair.name]
    slide = group.inner.slide
    swings = why.CYLINDER_TOUCHES if slide is not None and slide.cylinder else why.ROCKER_TOUCHES
    found = draft.draw(touch, f"{pin}_{{{tag}}}", rocker, arc, which, why=swings)
    ends = frame.marks[pivot], found
    return draft.draw(bearing, f"φ_{{{tag}}}", *ends, unit="°", why=why.CRANK_AT_EXTREME)


_CONSTRUCTIONS = {1: _rocker, 2: _slider, 3: _stone}
