"""How the angle of a link goes on that a wheel rolls by: tried before the sheet is begun.

A mechanism with wheels is back where it was after whole turns of its drive only, as many as its ratios have
denominators. Over these a link turns by whole turns, and so do the drive and the wheels that stand already:
counted by the one that it keeps nearest to, times the quotient of both, its angle is periodic.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from graphic_tmm.board.execute import execute
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.kinematics.sides import standing
from graphic_tmm.chapters.kinematics.wheels import Wheels, Winding
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import TURN

STEPS = 1440
"""So many places are tried in a turn: every quarter of a degree."""
MOST = 60
"""So many turns are tried at most, each way: hunting teeth come back after as many turns as there are teeth.

These take 0.08 s, beside 0.01 s of a ratio that is back after two."""
FEW = 2, 1
"""So many turns are tried where an angle cannot be followed over these: rows of one turn are in two.

Of 60 random geared five-bars with a wheel on a coupler 13 are drawn so, 8 in two turns each way, 5 in one."""


def winding(wheels: Wheels, number: int) -> Winding:
    """Return how the angle of a link goes on while the drive goes through all that it can.

    Raises
    ------
    StructureError
        If it does not stay within half a turn of anything that it could be counted by.
    """
    turns = _turns(wheels) if wheels.pairs[0].sweep.closed else 1
    for tried in (min(turns, most) for most in (MOST, *FEW)):
        best, swing = _tried(wheels, number, tried, back=tried == turns)
        if swing < TURN.high:
            return best if tried == turns else best._replace(within=tried * TURN.high)
    raise StructureError(
        said(
            "a wheel rolls by the angle of link {number}, which swings by more than a whole turn and back: "
            "this board cannot follow it",
            number=number,
        ),
        f"link {number}",
        head="mesh",
    )


def _tried(wheels: Wheels, number: int, tried: int, *, back: bool) -> tuple[Winding, float]:
    """Count an angle over so many turns each way; return how far it swings, degrees, beside the best count."""
    draft, sweep = wheels.draft, wheels.pairs[0].sweep
    low = -tried * sweep.high if sweep.closed else sweep.low
    way = np.linspace(low, tried * sweep.high, 2 * tried * STEPS + 1)
    given = draft.given | {draft.mu_l: 1.0, wheels.row[0]: way[None]} | standing(wheels, way[None])
    axis = wheels.bodies[number].axis
    reading = execute(draft.board.construction(), given, [axis, *wheels.counted])
    values = [reading[axis].along, *(reading[mark] for mark in wheels.counted)]
    along, *lines = (np.broadcast_to(one, (1, way.size))[0] for one in values)
    runs = _runs(np.asarray(np.isfinite([along, *lines]).all(axis=0)), closed=sweep.closed)
    if not runs:
        return Winding(0, 0.0), 0.0
    angles = [np.degrees(np.unwrap(np.angle(along[run]))) for run in runs]
    best, least = Winding(0, 0.0), math.inf
    for by, times in _choices(runs, angles, lines, tried if back and sweep.closed else 0):
        parts = [
            angle - times * lines[by][run] if times else angle
            for run, angle in zip(runs, angles, strict=True)
        ]
        first = parts[0].mean()
        whole = np.concatenate(
            [one - TURN.high * round((one.mean() - first) / TURN.high) for one in parts]
        )
        low, high = float(whole.min()), float(whole.max())
        if (swing := round(high - low, 6)) < least:
            best, least = Winding(times, round((low + high) / 2.0, 1), by), swing
    return best, least


def _turns(wheels: Wheels) -> int:
    """Return after how many turns of the first drive all that is drawn is back where it was."""
    back = {one.link: _denominator(one.speed_ratio(wheels.pairs[0])) for one in wheels.pairs} | {
        wheels.mechanism.frame.number: 1
    }
    for rolling in (one.rolling for one in wheels.drawn):
        by = [back.get(k) or math.lcm(*back.values()) for k in (rolling.arm, rolling.on)]
        back[rolling.link] = math.lcm(*by) * _denominator(rolling.ratio)
    return math.lcm(*back.values())


def _denominator(ratio: float) -> int:
    return Fraction(ratio).limit_denominator().denominator


def _runs(there: np.ndarray, *, closed: bool) -> list[np.ndarray]:
    """Return the places between gaps; where all is repeated, those of runs that neither end cuts off."""
    places = np.flatnonzero(there)
    runs = [k for k in np.split(places, np.flatnonzero(np.diff(places) > 1) + 1) if k.size]
    whole = [k for k in runs if k[0] > 0 and k[-1] < there.size - 1]
    return whole if closed and whole else runs


def _choices(
    runs: list[np.ndarray], angles: list[Reals], lines: list[Reals], turns: int
) -> Iterator[tuple[int, float]]:
    """Yield by what the angle may be counted, and how many times: none first; ``turns``: 0 if never back."""
    yield 0, 0
    longest = int(np.argmax([run.size for run in runs]))
    start, end = runs[longest][[0, -1]]
    for by, line in enumerate(lines):
        back = TURN.high
        if turns:
            ways = line[turns * STEPS :] - line[: -turns * STEPS]
            back = float(np.nanmean(ways)) if np.isfinite(ways).any() else 0.0
        turned, way = round(back / TURN.high), float(line[end] - line[start])
        if turned and way:
            rise = float(angles[longest][-1] - angles[longest][0])
            times = round(rise / way * turned) / turned
            if times:
                yield by, times
