"""Which shifts a pair may have: its checks over the plane of x1 and x2, by the record of its dimensions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple, cast

import numpy as np
import shapely

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.gears.contact import LEAST_RATIO, Check, record_checks
from graphic_tmm.chapters.gears.dimensions import GearSizes, calculate_sizes, known
from graphic_tmm.chapters.gears.task import LARGEST_SHIFT, GearTask

if TYPE_CHECKING:
    from contourpy import ContourGenerator

ADVISED = ("tip thickness", "assembly")
"""Checks that are no limits of what can mesh: their lines stand inside the region."""
USUAL_RATIO = 1.2
"""The contact ratio that books ask for at least."""
COARSE, FINE = 201, 241
"""So many shifts of each wheel are tried: to find the region, to draw it (1/2 mm apart on 120 mm)."""
EDGE = 1e-9
"""A line lies on the edge of the region within so much: its corners are those of the same grid."""
AROUND = 0.12
"""How much more than the region is shown, of its larger side."""


class Limit(NamedTuple):
    """Where a check turns (x1 + i·x2), as far as every other check that must hold does.

    ``bounds``: whether the region ends there. ``value``, ``least``: what are equal along it.
    """

    bounds: bool
    value: Mark
    least: Mark | float
    lines: tuple[tuple[complex, ...], ...]


class Chart(NamedTuple):
    """The region of shifts, all its corners x1, x2, its limits; the part of the plane that is shown.

    ``low``, ``high``: two of its corners (x1 + i·x2).
    """

    region: shapely.Geometry
    limits: tuple[Limit, ...]
    low: complex
    high: complex


class _Plane:
    """The dimensions of a pair with whatever shifts: x1, x2 are given in rows to its record."""

    def __init__(self, draft: Draft, sizes: GearSizes) -> None:
        self.given = draft.given
        self.shifts = tuple(wheel.x for wheel in sizes.wheels)
        self.checks = record_checks(draft, sizes)
        self.ratio = sizes.contact_ratio
        self.log = draft.board.construction()

    def margins(self, x: Reals, y: Reals) -> Mapping[Check, Reals]:
        """Return by how much each check holds at the shifts of a grid, in the unit of its value."""
        across, up = np.meshgrid(x, y)
        rows = dict(zip(self.shifts, (across.ravel(), up.ravel()), strict=True))
        wanted = [mark for check in self.checks for mark in (check.value, check.least)]
        found = execute(self.log, {**self.given, **rows}, wanted)
        return {
            check: np.reshape(
                np.broadcast_to(found[check.value] - found[check.least], (1, across.size)),
                across.shape,
            )
            for check in self.checks
        }


@lru_cache(maxsize=8)
def chart_of(order: GearTask) -> Chart | None:
    """Return the chart of a pair of these teeth; None where no shifts give one that can mesh."""
    plane = _plane(order)
    if plane is None:
        return None
    tried = np.linspace(-LARGEST_SHIFT, LARGEST_SHIFT, COARSE)
    holds = np.all([m >= 0.0 for c, m in plane.margins(tried, tried).items() if _binds(c)], axis=0)
    if not holds.any():
        return None
    step = tried[1] - tried[0]
    ends = [
        (tried[held].min() - step, tried[held].max() + step)
        for held in (holds.any(axis=0), holds.any(axis=1))
    ]
    more = AROUND * max(high - low for low, high in ends)
    x, y = (np.linspace(low - more, high + more, FINE) for low, high in ends)
    return _drawn(plane, x, y)


def _plane(order: GearTask) -> _Plane | None:
    """Return a record whose teeth end on their tip circles and work within the line of action.

    What is beyond is calculated by other formulas: shifts that need them bound no region.
    """
    free = replace(order, distance=None, x_sum=None)
    tried = [(order.x1 or 0.0, order.x2 or 0.0)]
    tried += sorted(
        ((0.1 * i, 0.1 * j) for i in range(-5, 16) for j in range(-5, 16)),
        key=lambda at: abs(at[0] - 0.5) + abs(at[1] - 0.5),  # most can mesh about there
    )
    for x1, x2 in tried:
        draft = Draft()
        sizes = calculate_sizes(draft, replace(free, x1=x1, x2=x2))
        value = known(draft)
        ends = all(wheel.top is wheel.r_a for wheel in sizes.wheels)
        if ends and not any(sizes.beyond) and value(sizes.contact_ratio) > 0.0:
            return _Plane(draft, sizes)
    return None


def _binds(check: Check) -> bool:
    return check.name not in ADVISED


def _drawn(plane: _Plane, x: Reals, y: Reals) -> Chart:
    """Draw the region as what all areas have in common in which a check holds, and the limits on it."""
    margins = plane.margins(x, y)
    areas = [_area(x, y, margin) for check, margin in margins.items() if _binds(check)]
    region = shapely.intersection_all(areas)
    edge = shapely.buffer(region, EDGE)
    limits = []
    for check, margin in margins.items():
        if lines := _lines(x, y, margin, 0.0, edge):
            least = LEAST_RATIO if check.value is plane.ratio else check.least
            limits.append(Limit(_binds(check), check.value, least, lines))
        if check.value is plane.ratio:
            usual = _lines(x, y, margin, USUAL_RATIO - LEAST_RATIO, edge)
            limits.append(Limit(False, check.value, USUAL_RATIO, usual))
    return Chart(region, tuple(limits), complex(x[0], y[0]), complex(x[-1], y[-1]))


def _area(x: Reals, y: Reals, margin: Reals) -> shapely.Geometry:
    """Return where a check holds: polygons with holes."""
    outer = cast(
        "tuple[list[Reals], list[Sequence[int]]]", _contours(x, y, margin).filled(0.0, np.inf)
    )
    found = []
    for corners, cuts in zip(*outer, strict=True):
        shell, *holes = (corners[a:b] for a, b in pairwise(cuts))
        found.append(shapely.Polygon(shell, holes))
    return shapely.union_all(found)


def _contours(x: Reals, y: Reals, margin: Reals) -> ContourGenerator:
    from contourpy import contour_generator

    return contour_generator(
        x, y, np.ma.masked_invalid(margin), line_type="Separate", fill_type="OuterOffset"
    )


def _lines(
    x: Reals, y: Reals, margin: Reals, level: float, within: shapely.Geometry
) -> tuple[tuple[complex, ...], ...]:
    """Return where a check is off its limit by ``level``, each line as long as it goes: its corners."""
    found = cast("list[Reals]", _contours(x, y, margin).lines(level))
    lines = [shapely.LineString(one) for one in found if len(one) > 1]
    parts = shapely.get_parts(shapely.intersection(lines, within))
    long = [one for one in shapely.get_parts(parts) if one.length > EDGE]
    whole = shapely.get_parts(shapely.line_merge(shapely.MultiLineString(long)))
    return tuple(tuple(complex(*spot) for spot in shapely.get_coordinates(one)) for one in whole)
