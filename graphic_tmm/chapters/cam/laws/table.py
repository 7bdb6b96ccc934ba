"""A law given by a table of displacements: its derivatives by chords of the table.

A position stands at every line; of a table at uneven angles, at as many even ones, see `uneven`. dS/dφ is the
slope of the chord between the neighbours of a line, d²S/dφ² what the slopes of both chords that meet in it
differ by. Where the follower comes to rest dS/dφ is zero, and the table goes on beyond its end by the cubic
parabola that is level there and goes through the next two lines: by chords seen in a mirror the sine law would
begin with a shock. A table that begins with a velocity goes on with even third differences.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.cam import words as why
from graphic_tmm.chapters.cam.laws import formulas
from graphic_tmm.chapters.cam.laws.ground import DrawnLaw, Ground, uprights
from graphic_tmm.chapters.cam.task_motion import BY_TABLE, Law
from graphic_tmm.chapters.cam.uneven import SHOCK, is_even

LEAST = 4.0
"""The largest acceleration of a follower that begins and ends at rest is no less, of h/Φ²."""
STEPS = 6
"""Those steps."""
DOUBT = 3.0
"""Steps times one of the last digit: by so much a velocity at an end may be off, of h/Φ.

It is half of the steps times 7·y_1 − 4·y_2 + y_3, each of which is off by half of the digit.
"""
ROUGH = 0.1
"""The share of the largest acceleration by which rounding alone may be off.

Of 20,000 random tables the largest acceleration was off by less than 5 % in 9 of 10 of those below it, of 0.3
by a fifth.
"""
FEW = 8
"""Of 8 steps of a cosine law chords are off by 1.3 % of its largest acceleration, of 6 by 2.3 %."""

ROUNDED = 1e-9
"""Differences of displacements of 1 that are less are rounding."""


@dataclass(frozen=True)
class Displacements:
    """The displacements of a phase, of 1, line by line from its outer end; one of their last ``digit``.

    Each may be off by half of that, but for the ends. ``ends``: the slopes there, if these lines were read off
    a spline through others, 0 where it is at rest.
    """

    heights: tuple[float, ...]
    digit: float = 0.0
    ends: tuple[float, float] | None = None

    @property
    def steps(self) -> int:
        """How many steps there are between the lines."""
        return len(self.heights) - 1

    @property
    def wider(self) -> tuple[float, ...]:
        """The same with a line before the first and one behind the last."""
        y = self.heights
        before, behind = (
            _even_thirds(*line) if shock else 3.0 * line[1] - (line[2] + 3.0 * line[0]) / 2.0
            for line, shock in zip((y[:4], y[:-5:-1]), self.shocks, strict=True)
        )
        return (before, *y, behind)

    @property
    def stride(self) -> int:
        """How many steps are taken as one where velocities at the ends are judged.

        So many that rounding makes no shock; no fewer are left than those of `SHOCK`.
        """
        return max(1, min(ceil(DOUBT * self.digit * self.steps / SHOCK), self.steps // STEPS))

    @property
    def speeds(self) -> tuple[float, float]:
        """With which velocities it begins and ends, of h/Φ."""
        if self.ends is not None:
            return self.ends
        far, y = self.stride, self.heights
        lines = (y[:: sense * far][:4] for sense in (1, -1))
        first, last = ((one[1] - _even_thirds(*one)) * self.steps / far / 2.0 for one in lines)
        return first, -last

    @property
    def shocks(self) -> tuple[bool, bool]:
        """Whether it begins and ends with a velocity, whatever its figures were before they were rounded."""
        begins, ends = self.speeds
        if self.ends is not None:
            return begins > SHOCK, ends > SHOCK
        doubt = DOUBT * self.digit * self.steps / self.stride
        return begins > SHOCK + doubt, ends > SHOCK + doubt

    @property
    def rough(self) -> float:
        """By how much of the largest acceleration that between others may be off by rounding."""
        return 2.0 * self.digit * self.steps**2 / max(self.peaks[1], LEAST)

    @property
    def chords(self) -> tuple[float, ...]:
        """The same lines, but level about an end at rest."""
        first, *lines, last = self.wider
        begins, ends = self.shocks
        return (first if begins else lines[1], *lines, last if ends else lines[-2])

    @property
    def peaks(self) -> tuple[float, float]:
        """The largest velocity and acceleration in size, of h/Φ and h/Φ²."""
        y, n = np.array(self.chords), self.steps
        fastest = np.abs(y[2:] - y[:-2]).max() * n / 2.0
        return float(fastest), float(np.abs(np.diff(self.wider, 2)).max() * n * n)

    @property
    def waves(self) -> int:
        """How often the acceleration changes its sign between lines, but for what is nothing beside it."""
        second = np.diff(self.heights, 2)
        felt = second[np.abs(second) > max(0.02 * np.abs(second).max(), ROUNDED)]
        return int(np.sum(felt[1:] * felt[:-1] < 0.0))


def _even_thirds(first: float, second: float, third: float, fourth: float) -> float:
    """Return the line before four lines, with one third difference."""
    return 4.0 * first - 6.0 * second + 4.0 * third - fourth


def table_of(law: Law) -> Displacements:
    """Return the table of a law that is given so."""
    return Displacements(tuple(height for _, height in law.points), law.digit, law.ends)


def _points(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    """Lay off the displacements told, or the slopes of chords."""
    table, (share,) = table_of(ground.of.law), ground.shares
    lines = np.array(table.chords if which == "V" else table.wider)
    place, parts = draft.uses(share)
    number = np.asarray(draft.given[place])
    at = np.where(np.isfinite(number), number, 0.0).astype(int)
    size, unit = float(np.asarray(draft.given[ground.stroke]).flat[0]), ground.stroke.unit
    letter = "S" if unit == "m" else "ψ"

    def line(of: int, index: str) -> Mark:
        row = np.where(np.isfinite(number), size * lines[at + 1 + of], np.nan)
        return draft.take(Number, f"{letter}_{{{index}}}", row, unit)

    if which == "S":
        long = draft.draw(to_board, "y", line(0, "i"), ground.mu)
    elif which == "V":
        ends = (line(1, "i+1"), line(-1, "i−1"))
        long = draft.draw(formulas.chord_V, "y", *ends, parts, ground.phase, ground.mu)
    else:
        three = (line(1, "i+1"), line(0, "i"), line(-1, "i−1"))
        long = draft.draw(formulas.chord_A, "y", *three, parts, ground.phase, ground.mu)
    given = ground.of.motion.law
    reason = why.BY_TABLE if given is None or is_even(given) else why.BY_SPLINE
    over = uprights(draft, ground, up=which != "V" or ground.of.sign > 0)
    return (draft.draw(lay_off, which.lower(), over, long, free=True, why=reason),)


LAW = DrawnLaw(BY_TABLE, 6, _points, (0.0, 0.0))
