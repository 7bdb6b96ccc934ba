"""How far a point has come along a line, or a link has swung: its velocity, its two ends.

One rule for what slides, for any other point and for a link. Where it turns back is looked for over the whole
sweep of the drive, and the mechanism is drawn once more at each of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.locus import drawn_once_more
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.extremes import (
    STILL,
    Tried,
    over_whole,
    refined,
    turning_back,
)
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.task import EXTREMES as VIEW
from graphic_tmm.language.said import Said, said

STANDS = 1e-6
"""What goes slower than this share of its usual speed stands."""
WIDEST = 315.0
"""No link swings farther, degrees: a protractor reads it from 45° before its end on."""


@dataclass(frozen=True, eq=False)
class Course:
    """A coordinate of the mechanism: of the point of a letter, along ``way`` (m); or of a ``link``.

    That of a link is the direction of the line of two letters, degrees, counter-clockwise.
    """

    survey: Survey
    letters: tuple[str, ...]
    way: complex = 1 + 0j
    link: int | None = None

    @property
    def marks(self) -> list[Mark]:
        """The points that it is read off, on the board of the survey."""
        positions = self.survey.positions
        if self.link is None:
            return [positions.point(self.letters[0])]
        return [positions.bodies[self.link].marks[letter] for letter in self.letters]

    def speed(self, row: Reals) -> Reals:
        """Return how fast it grows at coordinates of the drive (trial, position): m/s, or rad/s."""
        if self.link is not None:
            rate = self.survey.velocities.rates[self.link]
            found = self.survey.at(row, [rate])[rate]
        else:
            x, y = (self.survey.axes[self.letters[0], name] for name in ("x", "y"))
            reading = self.survey.at(row, [x, y])
            found = reading[x] * self.way.real + reading[y] * self.way.imag
        return np.broadcast_to(found, row.shape)

    def places(self, row: Reals) -> Reals:
        """Return it at coordinates of the drive that follow one another."""
        reading = self.survey.at(row[None, :], self.marks)
        return self._placed([np.broadcast_to(reading[mark][0], row.shape) for mark in self.marks])

    def _placed(self, spots: list[Complexes]) -> Reals:
        if self.link is None:
            return np.asarray((spots[0] * np.conj(self.way)).real)
        found = np.angle(spots[1] - spots[0])
        there = np.isfinite(found)
        found[there] = np.unwrap(found[there])
        return np.degrees(found)

    @cached_property
    def usual(self) -> float:
        """Its median speed, m/s or rad/s: at an end of what the drive can reach the greatest has no bound."""
        row, _, there = over_whole(self.survey, [])
        speed = np.abs(self.speed(row)[0])
        known = speed[there & np.isfinite(speed)]
        return (float(np.median(known)) if known.size else 0.0) or 1.0

    def goes(self, row: Reals, sense: float) -> np.ndarray:
        """Tell at which coordinates of the drive it goes that way, by the sign of its velocity.

        Where it stands, at a dead centre, it counts as having gone that way.
        """
        share = self.speed(row[None, :])[0] / self.usual
        return np.asarray(share * np.sign(sense) >= -STANDS)

    def stands(self, row: Reals) -> np.ndarray:
        """Tell at which coordinates of the drive it stands."""
        return np.asarray(np.abs(self.speed(row[None, :])[0] / self.usual) <= STANDS)

    @cached_property
    def _reach(self) -> tuple[Reals, list[Complexes], Reals]:
        """Of a drive that turns, the coordinates that it comes to, the points there, how far it has come."""
        row, reading, there = over_whole(self.survey, self.marks)
        reached = _reached(self.survey, row[0], there)
        spots = [np.broadcast_to(reading[mark][0], there.shape)[reached] for mark in self.marks]
        return row[0, reached], spots, self._placed(spots)

    @property
    def span(self) -> float:
        """How far it comes between the places of a drive that turns, m or degrees; 0 where it comes nowhere."""
        places = self._reach[2] if self.survey.sweep.turns else np.zeros(0)
        return float(np.nanmax(places) - np.nanmin(places)) if places.size else 0.0

    @cached_property
    def ends(self) -> tuple[Tried, Tried] | None:
        """Where it is least and greatest, by the drive; None if it does not turn back at both.

        Of a crank that does not turn round, between the dead places on both sides of the zero position: behind
        them the mechanism may stand as well, but never comes there.
        """
        if self.span == 0.0:
            return None
        row, spots, places = self._reach
        most = np.nanmax(np.abs(spots)) if self.link is None else WIDEST
        if self.span <= STILL * most or (self.link is not None and self.span > WIDEST):
            return None
        at = (int(np.nanargmin(places)), int(np.nanargmax(places)))
        least, greatest = (turning_back(self.survey, self.speed, float(row[k])) for k in at)
        return (least, greatest) if np.isfinite([least.angle, greatest.angle]).all() else None


def _reached(survey: Survey, row: Reals, there: np.ndarray) -> np.ndarray:
    """Return which places of a sweep the drive comes to from where it is zero, in order; or none.

    ``there``: where all groups can be drawn.
    """
    count = row.size
    far = [survey.sweep.apart(one, survey.zero) for one in row]
    zero = int(np.argmin(np.where(there, far, np.inf)))
    gone = np.flatnonzero(~there) - zero
    if not gone.size:
        return np.arange(count)
    if survey.sweep.closed:
        gone = np.concatenate([gone % count, gone % count - count])
    before, behind = gone[gone <= 0], gone[gone >= 0]
    low = before.max() + 1 if before.size else -zero
    high = behind.min() if behind.size else count - zero
    return np.arange(zero + low, zero + high) % count


def draw_end(draft: Draft, positions: Positions, course: Course, which: int) -> tuple[Mark, ...]:
    """Draw its points once more at its least (−1) or greatest (1) place, those of the frame as they are."""
    assert course.ends is not None
    survey, tried, view = course.survey, course.ends[which > 0], draft.view
    draft.open(VIEW)
    frame = positions.bodies[survey.mechanism.frame.number]
    if draft.board.construction().view(VIEW) is None:
        draft.lay_out(frame.marks[survey.structure.origin], draft.mu_l)
    role = f"end {course.letters} {course.link} {course.way} {which}"
    drawn = iter(draft.board.construction().roles(VIEW, role))
    sign, found, angle = "′" if which > 0 else "″", list[Mark](), None
    for letter, mark in zip(course.letters, course.marks, strict=True):
        fixed = course.link is not None and letter in frame.marks
        if (known := frame.marks[letter] if fixed else next(drawn, None)) is not None:
            found.append(known)
            continue
        name = draft.board.free(f"{letter}{sign}")
        if angle is None:
            says = _narrowed(course)
            angle = refined(draft, survey.sweep, course.speed, says, tried, name)
        found.append(redrawn(draft, survey, mark, angle, (letter, name, role)))
    draft.open(view)
    return tuple(found)


def _narrowed(course: Course) -> Said:
    if course.link is None:
        return said(
            "Try crank angles between {low} and {high}, each time narrowing to where {point} stands still "
            "along its line; this is {it}.",
            point=course.letters[0],
            low="{low}",
            high="{high}",
            it="{it}",
        )
    return said(
        "Try crank angles between {low} and {high}, each time narrowing to where link {link} does not turn; "
        "this is {it}.",
        link=course.link,
        low="{low}",
        high="{high}",
        it="{it}",
    )


@dataclass(frozen=True, eq=False)
class _Place:
    """Where a point stands at a row of coordinates of the drive, m."""

    survey: Survey
    mark: Mark

    def __call__(self, row: Reals) -> Complexes:
        return np.asarray(self.survey.at(row, [self.mark])[self.mark])


def redrawn(
    draft: Draft, survey: Survey, mark: Mark, angle: Mark, named: tuple[str, str, str]
) -> Mark:
    """Draw the mechanism once more; mark a point of it. ``named``: it, what is marked, its role."""
    point, name, role = named
    step = drawn_once_more(
        _Place(survey, mark),
        said(
            "At the crank angle {angle} draw the mechanism once more, thinly; mark {it}, where {point} stands.",
            angle="{angle}",
            point=point,
            it="{it}",
        ),
    )
    return draft.draw(step, name, angle, draft.mu_l, role=role)
