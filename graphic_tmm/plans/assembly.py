"""Does the mechanism assemble, and over which part of the turn; does a side hold through it.

Every step with two roots measures its own gap. Over a turn the gap tells: always negative, the lengths never
assemble; negative in part, the crank rocks; zero without becoming negative, a change point, where both
assemblies meet and a side fixed for the whole turn would give a plausible wrong plan.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.grammar import Gap
from graphic_tmm.board.locus import narrow
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Reals
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.structure import Group
from graphic_tmm.plans.positions import side_record
from graphic_tmm.plans.survey import STEPS, Survey

CHANGE = 1e-9
"""A gap whose least value is below this share of the lengths is zero: a change point."""


class Closure(NamedTuple):
    """A step with two roots: its group, the step, one of its gaps."""

    group: Group
    step: Step
    gap: Gap


class Assembly(NamedTuple):
    """What is found of a mechanism that can be drawn: the ranges of the crank (degrees); empty: all of it."""

    ranges: tuple[tuple[float, float], ...]
    groups: tuple[str, ...]


def closures(survey: Survey) -> tuple[Closure, ...]:
    """Return the steps that close the groups, with their gaps."""
    found = []
    for closing in survey.positions.closings:
        step = survey.construction.step(closing.root)
        assert step is not None
        found += [Closure(closing.group, step, gap) for gap in step.op.gaps]
    return tuple(found)


def check_assembly(survey: Survey) -> Assembly:
    """Return over which ranges of the crank the mechanism assembles.

    Raises
    ------
    StructureError
        If a group never assembles (which lengths, and by how much), or its side is missing, cannot hold
        through a change point, or is told to flip where there is none.
    """
    _refuse_missing_sides(survey)
    ranges: list[np.ndarray] = []
    names = []
    for closure in closures(survey):
        angles, room = _room(survey, closure)
        _refuse_never(survey, closure, room)
        if (room[np.isfinite(room)] < -CHANGE * _size(survey, closure)).any():
            names.append(closure.group.name)
        else:
            _refuse_change_points(survey, closure, angles, room)
    if names:
        ranges = _ranges(survey)
    return Assembly(tuple((float(a), float(b)) for a, b in ranges), tuple(dict.fromkeys(names)))


def _refuse_missing_sides(survey: Survey) -> None:
    for group in survey.structure.groups:
        if group.kind > 3 or side_record(survey.mechanism, group) is not None:
            continue
        if group.kind == 1:
            a, c = (leg.pair.name for leg in group.legs)
            remedy = f'give link {group.links[0]} or {group.links[1]} side = "left of {a}{c}" or "right of {a}{c}"'
        else:
            pair = group.legs[1].pair if group.kind == 2 else group.inner
            remedy = f'give slides of link {pair.links[0]} side = "+" or "-"'
        raise StructureError(f"group {group.name} can be assembled in two ways: {remedy}")


def _measured(survey: Survey, closure: Closure, angles: Reals) -> Reals:
    reading = survey.at(angles, closure.step.uses)
    with np.errstate(all="ignore"):
        room = closure.gap.measure(*(reading[mark] for mark in closure.step.uses))
    return np.broadcast_to(room, angles.shape)


def _room(survey: Survey, closure: Closure) -> tuple[Reals, Reals]:
    angles = np.arange(STEPS, dtype=np.float64)[None, :] * (360.0 / STEPS)
    return angles, _measured(survey, closure, angles)


def _size(survey: Survey, closure: Closure) -> float:
    return sum(
        abs(a - b)
        for leg in closure.group.legs
        for link in [survey.mechanism.by_number[leg.link]]
        for a in link.points.values()
        for b in link.points.values()
    ) + abs(_arm(survey))


def _arm(survey: Survey) -> complex:
    crank = survey.mechanism.by_number[survey.structure.driver]
    return crank.points[survey.structure.pin] - crank.points[survey.structure.pivot]


def _refuse_never(survey: Survey, closure: Closure, room: Reals) -> None:
    defined = room[np.isfinite(room)]
    if defined.size and (defined >= -CHANGE * _size(survey, closure)).any():
        return
    if not defined.size:
        return
    letters = dict(zip(closure.step.op.arguments, closure.step.uses, strict=True))
    words = closure.gap.en.format(**{name: mark.letter for name, mark in letters.items()})
    raise StructureError(
        f"group {closure.group.name} never assembles: {words} "
        f"(short by {_mm(-defined.max())} at the best crank angle): change {_lengths(closure)}"
    )


def _lengths(closure: Closure) -> str:
    pin = closure.group.inner.name
    return " or ".join(
        f"{leg.pair.name}{pin if closure.group.inner.kind == 'R' else ''} (link {leg.link})"
        for leg in closure.group.legs
    )


def _mm(metres: float) -> str:
    return f"{metres * 1000:.4g} mm"


def _refuse_change_points(survey: Survey, closure: Closure, angles: Reals, room: Reals) -> None:
    side = side_record(survey.mechanism, closure.group)
    assert side is not None
    touched = _change_points(survey, closure, angles, room)
    if side.flips_at is None and touched:
        places = ", ".join(f'"{angle:.6g} deg"' for angle in touched)
        raise StructureError(
            f"group {closure.group.name}: its side cannot hold through the change point at crank angle "
            f"{', '.join(f'{angle:.6g}°' for angle in touched)}, where both assemblies meet: "
            f"say beside it where it flips, flips_at = [{places}], or flips_at = [] if it does not"
        )
    for angle in side.flips_at or ():
        gaps = [c for c in closures(survey) if c.group == closure.group]
        rooms = [float(_measured(survey, c, np.array([[angle]]))[0, 0]) for c in gaps]
        if min(map(abs, rooms)) > 1e-6 * _size(survey, closure):
            raise StructureError(
                f"group {closure.group.name}: flips_at names {angle:.6g}°, but the two assemblies do not "
                f"meet there (they are {_mm(2 * min(map(abs, rooms)))} apart): leave it out"
            )


def _change_points(survey: Survey, closure: Closure, angles: Reals, room: Reals) -> list[float]:
    """Return the crank angles where the gap touches zero from above."""
    row, size = room[0], _size(survey, closure)
    before, after = np.roll(row, 1), np.roll(row, -1)
    lowest = np.flatnonzero((row <= before) & (row <= after) & (row < 0.01 * size))
    found: list[float] = []
    for at in lowest:
        angle, value = _least(survey, closure, float(angles[0, at]), 360.0 / STEPS)
        if abs(value) <= CHANGE * size and not any(
            abs((angle - f + 180) % 360 - 180) < 1e-3 for f in found
        ):
            found.append(angle)
    return sorted(found)


def _least(survey: Survey, closure: Closure, centre: float, reach: float) -> tuple[float, float]:
    """Narrow down the least gap near an angle; return the angle (degrees, [0, 360)) and the gap, m."""
    for _ in range(24):
        row = centre + reach * np.linspace(-1.0, 1.0, 33)[None, :]
        value = _measured(survey, closure, row)
        best = int(np.argmin(value[0]))
        centre, reach = float(row[0, best]), reach / 8
    return round(centre, 7) % 360.0, float(value[0, best])


def _ranges(survey: Survey) -> list[np.ndarray]:
    """Return the ranges of the crank over which everything can be drawn, degrees."""
    last: list[Mark] = [closing.point for closing in survey.positions.closings]
    last += [body.axis for body in survey.positions.bodies.values() if body.drawn]

    def drawable(angles: Reals) -> Reals:
        reading = survey.at(angles, last)
        total = np.zeros(angles.shape)
        for mark in last:
            value = reading[mark]
            part = value.along if isinstance(value, tuple) else value
            total = total + np.abs(part)
        return np.where(np.isfinite(total), 1.0, -1.0)

    angles = np.arange(STEPS + 1, dtype=np.float64)[None, :] * (360.0 / STEPS)
    good = drawable(angles)[0] > 0
    edges = np.flatnonzero(good[1:] != good[:-1])
    low, high = angles[0, edges], angles[0, edges + 1]
    at = [
        float(narrow(drawable, np.array([[a]]), np.array([[b]]))[0, 0])
        for a, b in zip(low, high, strict=True)
    ]
    if not at:
        return []
    if good[0]:
        at = [*at[1:], at[0] + 360.0]
    return [np.array(pair) for pair in zip(at[0::2], at[1::2], strict=True)]
