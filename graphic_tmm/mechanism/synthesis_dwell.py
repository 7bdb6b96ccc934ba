"""A six-bar that stands still for a while: a coupler's point goes along an arc, a second dyad turns about it.

While the crank of a four-bar turns through a part of its turn, a point M of the coupler keeps near an arc. A
link MD as long as the arc's radius has its far pin D at the arc's centre then, and what turns about E with D
stands.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import operation
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Complexes, Number, Reals
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism import synthesis_formulas as f
from graphic_tmm.mechanism.synthesis_kinds import (
    PLACES,
    Given,
    Lengths,
    circle_through,
    refuse_count,
)

TRIED = 721
"""At so many places an arc is compared with a path: between them neither goes away by a share of 1e-5 more."""
EXCHANGES = 40
"""So often at most a place is exchanged for one that is farther off; three or four do."""
LEVEL = 1e-9
"""Four places that are as far off as the farthest, to this share, are those of the arc that is left least."""
HALVINGS = 48
"""So often the part of the crank's turn is halved in which a path crosses its arc."""
SHORTER = 14
"""So often a range is halved to tell for how long an arc does: to a share of 1e-4."""

ON_PIN = 1e-6
"""Nearer to a pin than this share of its link a point is that pin."""


class CouplerPoint(NamedTuple):
    """A four-bar, C at (frame, 0) from O, and a point of its coupler: ``across``, ``up`` from A along AB; m."""

    crank: float
    rod: float
    rocker: float
    frame: float
    across: float
    up: float

    def at(self, turns: Reals) -> Complexes:
        """Return where the point is at some angles of the crank, degrees; B is left of the way from A to C."""
        pin = self.crank * np.exp(1j * np.radians(turns))
        way = self.frame - pin
        far = np.abs(way)
        along = (self.rod**2 + far**2 - self.rocker**2) / (2.0 * far)
        off = np.sqrt(np.maximum(self.rod**2 - along**2, 0.0))
        return np.asarray(
            pin + way / far * (along + 1j * off) / self.rod * complex(self.across, self.up)
        )


class CircleOfPath(NamedTuple):
    """The arc that a path leaves least: where the path crosses it (degrees of the crank), how far it leaves."""

    centre: complex
    radius: float
    crossed: tuple[float, ...]
    off: float


def point_of(given: Given) -> CouplerPoint:
    """Return the four-bar of a task and the point of its coupler."""
    spot = complex(given["M"])
    crank, rod, rocker, frame = (float(given[name]) for name in ("OA", "AB", "BC", "OC"))
    return CouplerPoint(crank, rod, rocker, frame, spot.real, spot.imag)


def range_of(given: Given) -> tuple[float, float]:
    """Return where the crank is when the dwell begins, and by how much it turns until its end, degrees."""
    start, end = given["dwell"]
    return start, (end - start) % 360.0


@lru_cache(maxsize=64)
def best_arc(point: CouplerPoint, start: float, sweep: float) -> CircleOfPath:
    """Return the arc that the path of a point leaves least while the crank turns.

    Of all circles the one that is left least has the path alternately inside and outside, four times as far
    as it gets. |M − D|² = R² + h² ± 2·R·h at these four is linear in D and in what R and h make up.
    """
    turns = start + sweep * np.linspace(0.0, 1.0, TRIED)
    path = point.at(turns)
    middle = path.mean()
    size = float(np.abs(path - middle).max())
    spots = (path - middle) / size
    four = np.rint((1.0 - np.cos(np.pi * np.arange(4) / 3.0)) / 2.0 * (TRIED - 1)).astype(int)
    square = np.abs(spots) ** 2
    for _ in range(EXCHANGES):
        rows = np.column_stack(
            [2.0 * spots[four].real, 2.0 * spots[four].imag, np.ones(4), [1.0, -1.0, 1.0, -1.0]]
        )
        x, y, rest, w = np.linalg.solve(rows, square[four])
        gap = square - 2.0 * (x * spots.real + y * spots.imag) - rest
        if np.abs(gap).max() <= abs(w) * (1.0 + LEVEL):
            break
        four = _alternating(gap)
    whole = x * x + y * y + rest  # R² + h²
    outer, inner = math.sqrt(max(whole + abs(w), 0.0)), math.sqrt(max(whole - abs(w), 0.0))
    centre, radius = middle + size * complex(x, y), size * (outer + inner) / 2.0
    crossed = tuple(
        _crossing(point, centre, radius, float(turns[one]), float(turns[other]))
        for one, other in pairwise(four)
    )
    return CircleOfPath(
        centre, radius, crossed, float(np.abs(np.abs(path - centre) - radius).max())
    )


def _alternating(gap: Reals) -> np.ndarray:
    """Return four places, in turn on this side and on that, the farthest of all among them."""
    cuts = np.flatnonzero(np.diff(np.sign(gap)) != 0) + 1
    farthest = [part[np.argmax(np.abs(gap[part]))] for part in np.split(np.arange(gap.size), cuts)]
    most = int(np.argmax(np.abs(gap)))
    rows = [farthest[k : k + 4] for k in range(len(farthest) - 3)]
    return np.array(max((r for r in rows if most in r), key=lambda r: float(np.abs(gap[r]).min())))


def _crossing(
    point: CouplerPoint, centre: complex, radius: float, low: float, high: float
) -> float:
    """Return where a path crosses an arc between two angles of the crank on both sides of it."""

    def outside(turn: float) -> bool:
        return float(np.abs(point.at(np.array(turn)) - centre)) > radius

    begins = outside(low)
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        low, high = (middle, high) if outside(middle) == begins else (low, middle)
    return (low + high) / 2.0


def _each(what: Callable[[CircleOfPath], float], *values: Reals) -> Reals:
    """Return something of the best arc for each of several sizes, the last two the ends of a range."""
    rows = np.broadcast_arrays(*values)
    found = np.full(rows[0].shape, np.nan)
    for at in np.ndindex(found.shape):
        *sizes, start, end = (float(row[at]) for row in rows)
        if math.isfinite(sum(sizes) + start + end):
            found[at] = what(best_arc(CouplerPoint(*sizes), start, (end - start) % 360.0))
    return found


@operation(
    symbol="2C1 + C3",
    why=said("The circle that a path leaves least has it inside and outside in turn, equally far."),
)
def crossed_at(
    crank: Number, rod: Number, rocker: Number, frame: Number, across: Number, up: Number,
    start: Angle, end: Angle, *, k: int,
) -> Angle:  # fmt: skip
    """With the crank from {start} to {end} try circles; the path crosses the one that it leaves least at {it}.

    ``k``: for which time, from 0.
    """
    return Angle(
        _each(lambda arc: arc.crossed[k], crank, rod, rocker, frame, across, up, start, end)
    )


@operation(symbol="", why=said("Between its crossings the path is farthest from the arc."))
def off_arc(
    crank: Number, rod: Number, rocker: Number, frame: Number, across: Number, up: Number,
    start: Angle, end: Angle,
) -> Number:  # fmt: skip
    """While the crank turns from {start} to {end} the path is off the arc by {it} at most."""
    return Number(_each(lambda arc: arc.off, crank, rod, rocker, frame, across, up, start, end))


class DwellMarks(NamedTuple):
    """Marks of a task: the four-bar and M (as of a `CouplerPoint`), the dwell's ends, E, the crossings."""

    sizes: tuple[Mark, ...]
    ends: tuple[Mark, ...]
    pivot: tuple[Mark, ...]
    turns: tuple[Mark, ...]


def take_dwell(draft: Draft, given: Given) -> DwellMarks:
    """Take what a task gives; try circles for the crank's angles at which the path crosses the best arc."""
    _refuse_dwell(given)
    sizes = tuple(
        draft.take(Number, letter, one, "m")
        for letter, one in zip(_SIZES, point_of(given), strict=True)
    )
    ends = tuple(
        draft.take(Angle, f"φ_{name}", one, "°")
        for name, one in zip("ab", given["dwell"], strict=True)
    )
    spot = complex(given["E"])
    pivot = (
        draft.take(Number, "X_{E}", spot.real, "m"),
        draft.take(Number, "Y_{E}", spot.imag, "m"),
    )
    turns = tuple(
        draft.draw(crossed_at, f"φ_{k}", *sizes, *ends, unit="°", k=k - 1) for k in PLACES
    )
    return DwellMarks(sizes, ends, pivot, turns)


_SIZES = ("l_{OA}", "l_{AB}", "l_{BC}", "l_{OC}", "X_{M}", "Y_{M}")


def dwell(draft: Draft, given: Given) -> Lengths:
    """A second dyad on a coupler's point: as long as the radius of the arc that its path leaves least."""
    marks = take_dwell(draft, given)
    crank, rod, rocker, frame, across, up = marks.sizes
    origin = [draft.take(Number, letter, 0.0, "m") for letter in ("X_{O}", "Y_{O}")]
    places = []
    for k, phi in zip(PLACES, marks.turns, strict=True):
        x = draft.draw(f.end_across, f"X_{{A{k}}}", origin[0], crank, phi, unit="m")
        y = draft.draw(f.end_up, f"Y_{{A{k}}}", origin[1], crank, phi, unit="m")
        far = draft.draw(f.link_length, f"d_{k}", x, y, frame, origin[1], unit="m")
        along = draft.draw(f.along_diagonal, f"s_{k}", rod, rocker, far, unit="m")
        off = draft.draw(f.off_diagonal, f"h_{k}", rod, along, unit="m")
        own = (x, y, frame, far, along, off)
        pin = (
            draft.draw(f.pin_across, f"X_{{B{k}}}", *own, unit="m"),
            draft.draw(f.pin_up, f"Y_{{B{k}}}", *own, unit="m"),
        )
        link = (x, y, *pin, rod, across, up)
        places.append(
            (
                draft.draw(f.point_across, f"X_{{M{k}}}", *link, unit="m"),
                draft.draw(f.point_up, f"Y_{{M{k}}}", *link, unit="m"),
            )
        )
    centre = circle_through(draft, places, "D")
    return {
        "OA": crank, "AB": rod, "BC": rocker, "OC": frame, "xM": across, "yM": up,
        "xE": marks.pivot[0], "yE": marks.pivot[1],
        "MD": draft.draw(f.link_length, "l_{MD}", *places[0], *centre, unit="m"),
        "DE": draft.draw(f.link_length, "l_{DE}", *centre, *marks.pivot, unit="m"),
        "departure": draft.draw(off_arc, "Δ", *marks.sizes, *marks.ends, unit="m"),
    }  # fmt: skip


def _refuse_dwell(given: Given) -> None:
    refuse_count(given, "dwell", 2)
    point, (start, sweep) = point_of(given), range_of(given)
    crank, rod, rocker, frame = point[:4]
    most = min(rod + rocker - frame, frame - abs(rod - rocker))
    if not (crank + frame < rod + rocker and abs(frame - crank) > abs(rod - rocker)):
        says = said("with these lengths the crank does not turn all round; take other ones")
        if most > 0.0:
            says = said(
                "with these lengths the crank turns all round only while OA is less than {most:.4g} mm",
                most=1000.0 * most,
            )
        raise StructureError(says, "task.OA", head="task")
    if min(abs(given["M"]), abs(given["M"] - rod)) < ON_PIN * rod:
        says = said("a pin of the coupler goes along an arc all the time: take M beside A and B")
        raise StructureError(says, "task.M", head="task")
    if not sweep:
        says = said("the dwell has no length: give two angles of the crank, from where to where")
        raise StructureError(says, "task.dwell", head="task")
    if not one_bend(point, start, sweep):
        says = said(
            "while the crank turns so far the path of M bends both ways, or by more than half a turn: no arc; "
            "take a shorter dwell or another M"
        )
        raise StructureError(says, "task.dwell", head="task")
    best = best_arc(point, start, sweep)
    if best.off > given["tolerance"]:
        raise _no_arc(point, start, sweep, given["tolerance"], best)
    if abs(given["E"] - best.centre) < ON_PIN * best.radius:
        says = said("E is the arc's centre itself, so that DE has no length: take it elsewhere")
        raise StructureError(says, "task.E", head="task")


def one_bend(point: CouplerPoint, start: float, sweep: float) -> bool:
    """Whether a path bends one way only and by less than half a turn: no line crosses it three times then."""
    path = point.at(start + sweep * np.linspace(0.0, 1.0, TRIED))
    ways = np.diff(path)
    bends = np.angle(ways[1:] * np.conj(ways[:-1]))
    return bool((bends > 0.0).all() or (bends < 0.0).all()) and abs(float(bends.sum())) < math.pi


def _no_arc(
    point: CouplerPoint, start: float, sweep: float, tolerance: float, best: CircleOfPath
) -> StructureError:
    """Return the refusal of a tolerance that no arc keeps: the least that one does, for how long one does."""
    low, high = 0.0, 1.0
    for _ in range(SHORTER):
        middle = (low + high) / 2.0
        there = best_arc(point, start + sweep * (1.0 - middle) / 2.0, sweep * middle)
        low, high = (middle, high) if there.off <= tolerance else (low, middle)
    says = said(
        "every arc leaves the path of M by {off:.4f} mm or more; with this tolerance one does while the crank "
        "turns from {start:.1f}° to {end:.1f}°",
        off=math.ceil(1e7 * best.off) / 1e4,
        start=start + sweep * (1.0 - low) / 2.0 + 0.05,
        end=start + sweep * (1.0 + low) / 2.0 - 0.05,
    )
    return StructureError(says, "task.tolerance", head="task")
