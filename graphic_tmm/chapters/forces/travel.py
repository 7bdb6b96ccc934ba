"""The size of a load by the travel of a point that slides on the frame: straight lines between given shares.

Which part a position stands on is a choice that is made before the log runs, by the exact travel; the size is a
step, by the travel as measured.
"""

from __future__ import annotations

from itertools import pairwise
from operator import itemgetter

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
from graphic_tmm.chapters.forces.task import Travel
from graphic_tmm.chapters.kinematics.positions import Positions
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Mechanism

TURN = 360.0
SLACK = 1e-9
"""A share of the stroke, or of a turn, that is over by less than this is on the part still."""
_NOTHING = (0.0, 1.0, 0.0, 0.0)


def by_travel(
    draft: Draft,
    positions: Positions,
    mechanism: Mechanism,
    travel: Travel,
    numbers: np.ndarray,
    named: tuple[str, str],
) -> Mark:
    """Calculate the size of a load at every position; ``named``: its letter and its unit.

    Raises
    ------
    StructureError
        If the point does not slide on the frame, or the row does not begin at an end of its travel.
    """
    letter, unit = named
    sliding_leg(positions, travel.of, mechanism.frame.number, "load", "of")
    point = positions.point(travel.of)
    start = draft.draw(at_zero, f"{travel.of}_0", point, free=True)
    way = draft.draw(measure, f"|s_{travel.of}|", start, point, why=why.TRAVEL)
    last = draft.draw(farthest, f"{travel.of}_S", start, point, row=numbers.size, free=True)
    stroke = draft.draw(measure, f"s_{{{travel.of}max}}", start, last, why=why.STROKE)
    parts = _parts(draft, travel, (point, start, last), way, stroke, numbers)
    units = (unit, unit, "", "")
    given = [
        draft.take(Number, "", parts[k][None, :], of)
        for of, k in zip(units, (2, 3, 0, 1), strict=True)
    ]
    return draft.draw(between, letter, *given, way, stroke, unit=unit)


def _parts(
    draft: Draft,
    travel: Travel,
    ends: tuple[Mark, Mark, Mark],
    way: Mark,
    stroke: Mark,
    numbers: np.ndarray,
) -> Reals:
    """Return of every position its part: from and to which share, from and to which size, (4, position).

    ``ends``: the point, where it begins, where it is farthest from there.
    """
    given = {**draft.given, draft.mu_l: 1.0}
    reading = execute(draft.board.construction(), given, [*ends, way, stroke])
    point, start, last = (reading[mark][0] for mark in ends)
    shares = np.asarray(reading[way][0] / reading[stroke][0, 0])
    if not np.isfinite(shares).all():
        return part_of_travel((), shares)
    along = ((point - start) * np.conj(last - start)).real / np.abs(last - start) ** 2
    if along.min() < -SLACK:
        raise StructureError(
            said(
                "the row does not begin where the travel of {point} does: begin at an extreme position, zero = "
                '{{ point = "{point}", at = "left" }}, or, where another load is told by a travel from there, '
                "tell this one by_angle",
                point=travel.of,
            ),
            "drive.zero",
            "of",
            head="load",
        )
    turn = numbers[int(np.argmax(shares))]
    out, back = parts_of_strokes(travel, shares)
    return np.where(numbers <= turn, out, back)


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

    The last point and the first one of the next turn are joined like others.
    """
    (first, begins), (last, ends) = points[0], points[-1]
    places, sizes = np.array([(last - TURN, ends), *points, (first + TURN, begins)]).T
    at = (turned + SLACK * TURN) % TURN - SLACK * TURN
    k = np.minimum(np.searchsorted(places, at + SLACK * TURN, side="right") - 1, len(points))
    share = np.clip((at - places[k]) / (places[k + 1] - places[k]), 0.0, 1.0)
    return np.asarray(sizes[k] + share * (sizes[k + 1] - sizes[k]))
