"""Does the mechanism assemble, and over which part of its drive's sweep; does a side hold through it.

Every step with two roots measures its own gap. Over a turn the gap tells: always negative, the lengths never
assemble; negative in part, the crank rocks; zero without becoming negative, a change point, where both
assemblies meet and a side fixed for the whole turn would give a plausible wrong plan.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.grammar import Gap
from graphic_tmm.board.operations.locus import narrow
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Line, Reals
from graphic_tmm.chapters.kinematics.closings import two_legged
from graphic_tmm.chapters.kinematics.positions import side_record
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.winding import STEPS
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import joined, said
from graphic_tmm.mechanism.groups import Group
from graphic_tmm.mechanism.records import TURN, Sweep

CHANGE = 1e-9
"""A gap whose least value is below this share of the lengths is zero: a change point. Far above rounding, far
below what lengths are told to."""
NEAR = 1e-2
"""Degrees: crank angles nearer to each other than this are one change point."""
DECIMALS = {True: 7, False: 12}
"""Decimals of a coordinate that a search tells: degrees of what turns, m of what slides."""


class Closure(NamedTuple):
    """A step with two roots: its group, the step, one of its gaps."""

    group: Group
    step: Step
    gap: Gap


class Assembly(NamedTuple):
    """Where a mechanism can be drawn: the ranges of its drive (degrees or m); empty: all of its sweep."""

    ranges: tuple[tuple[float, float], ...]
    groups: tuple[str, ...]
    sweep: Sweep = TURN

    @property
    def said(self) -> str:
        """The ranges as a sentence; "" if it is all of the turn."""
        if not self.ranges:
            return ""
        if not self.sweep.turns:
            lengths = (
                said("{a:.1f} to {b:.1f} mm", a=1000.0 * a, b=1000.0 * b) for a, b in self.ranges
            )
            return said(
                "group {groups} assembles for {letter} from {ranges} only",
                groups=", ".join(self.groups),
                letter=self.sweep.letter,
                ranges=joined(said(" and "), lengths),
            )
        ranges = (said("{a:.2f}° to {b:.2f}°", a=a % 360, b=b % 360) for a, b in self.ranges)
        return said(
            "group {groups} assembles for crank angles {ranges} only",
            groups=", ".join(self.groups),
            ranges=joined(said(" and "), ranges),
        )


def closures(survey: Survey) -> tuple[Closure, ...]:
    """Return the steps that close the groups, with their gaps."""
    found = []
    for closing in two_legged(survey.positions.closings, "assembly"):
        step = survey.construction.step(closing.root)
        assert step is not None
        found += [Closure(closing.group, step, gap) for gap in step.op.gaps]
    return tuple(found)


def check_assembly(survey: Survey, ends: tuple[float, float] | None = None) -> Assembly:
    """Return over which ranges of the crank the mechanism assembles.

    ``ends``: of an open row, degrees or m; of change points outside it a side need not say anything.

    Raises
    ------
    StructureError
        If a group never assembles (which lengths, and by how much), or its side cannot hold
        through a change point, or is told to flip where there is none.
    """
    names: list[str] = []
    critical: list[float] = []
    closing: dict[str, list[Closure]] = {}
    for closure in closures(survey):
        closing.setdefault(closure.group.name, []).append(closure)
    # one slice of the log for all groups: a slice each would run the first groups as often as there are others
    angles, turned = survey.whole(
        mark for each in closing.values() for closure in each for mark in closure.step.uses
    )
    for name, branch in survey.branches.items():
        if not branch.whole:
            names.append(name)
            critical += [survey.sweep.within(float(end)) for end in branch.at[[0, -1]]]
    for group in survey.structure.groups:
        touched: list[float] = []
        partly = False
        for closure in closing.get(group.name, ()):
            rooms = angles, _gap(closure, turned, angles)
            critical += _refuse_never(survey, closure, rooms)
            size = _size(survey, closure)
            lows = _lows(survey, closure, rooms)
            critical += [angle for angle, _ in lows]
            short = rooms[1][0, np.isfinite(rooms[1][0])] < -CHANGE * size
            partly |= bool(short.any() or any(room < -CHANGE * size for _, room in lows))
            touched += [angle for angle, room in lows if abs(room) <= CHANGE * size]
        if partly:
            names.append(group.name)
        if isinstance(group, Group) and group.kind < 4:
            _refuse_sides(survey, group, _apart(touched), ends)
    ranges = _ranges(survey, critical) if names else []
    return Assembly(tuple(ranges), tuple(names), survey.sweep)


def _measured(survey: Survey, closure: Closure, angles: Reals) -> Reals:
    return _gap(closure, survey.at(angles, closure.step.uses), angles)


def _gap(closure: Closure, reading: Reading, angles: Reals) -> Reals:
    """Return the gap of a step at the crank angles of a reading."""
    with np.errstate(all="ignore"):
        room = closure.gap.measure(*(reading[mark] for mark in closure.step.uses))
    return np.broadcast_to(room, angles.shape)


def _size(survey: Survey, closure: Closure) -> float:
    return sum(
        abs(a - b)
        for leg in closure.group.legs
        for link in [survey.mechanism.by_number[leg.link]]
        for a in link.points.values()
        for b in link.points.values()
    ) + abs(survey.pairs[0].sizes.length)


def _refuse_never(survey: Survey, closure: Closure, rooms: tuple[Reals, Reals]) -> list[float]:
    """Return the crank angle of the greatest gap where the samples alone do not show that it closes."""
    angles, room = rooms
    size = _size(survey, closure)
    if not np.isfinite(room).any() or (room >= -CHANGE * size).any():
        return []
    best = float(angles[0, int(np.nanargmax(room[0]))])
    at, least = _least(survey, closure, best, survey.step, sign=-1)
    if -least >= -CHANGE * size:
        return [at]
    letters = dict(zip(closure.step.op.arguments, closure.step.uses, strict=True))
    words = said(closure.gap.says, **{name: mark.letter for name, mark in letters.items()})
    if not survey.sweep.turns:
        raise StructureError(
            said(
                "group {group} never assembles: {words} (short by {short:.4g} mm at the best, {letter} = "
                "{at:.4g} mm): change {lengths}",
                group=closure.group.name,
                words=words,
                short=least * 1000,
                letter=survey.sweep.letter,
                at=1000.0 * at,
                lengths=_lengths(closure),
            ),
            *(f"link {number}" for number in closure.group.links),
        )
    raise StructureError(
        said(
            "group {group} never assembles: {words} (short by {short:.4g} mm at the best crank angle, "
            "{at:.4g}°): change {lengths}",
            group=closure.group.name,
            words=words,
            short=least * 1000,
            at=at,
            lengths=_lengths(closure),
        ),
        *(f"link {number}" for number in closure.group.links),
    )


def _lengths(closure: Closure) -> str:
    inner = closure.group.inner
    if inner.kind == "P":
        return said(
            "the distance of the guide {guide} from the pivots (link {links})",
            guide=inner.name,
            links=joined(said(" or "), (str(leg.link) for leg in closure.group.legs)),
        )
    return joined(
        said(" or "),
        (
            said("{length} (link {link})", length=f"{leg.pair.name}{inner.name}", link=leg.link)
            if leg.pair.kind == "R"
            else said(
                "the guide {guide} (link {link})", guide=leg.pair.name, link=leg.pair.links[1]
            )
            for leg in closure.group.legs
        ),
    )


def _refuse_sides(
    survey: Survey, group: Group, touched: list[float], ends: tuple[float, float] | None
) -> None:
    """Refuse a side that does not say what it does at the change points, or says it of other angles."""
    side = side_record(survey.mechanism, group)
    assert side is not None
    if not survey.sweep.turns:
        if side.flips_at:
            raise StructureError(
                said(
                    "group {group}: flips_at names crank angles, but what drives slides",
                    group=group.name,
                ),
                *(f"link {number}, flips_at" for number in group.links),
            )
        return
    places = ", ".join(f'"{angle:.6g} deg"' for angle in touched)
    keys = [
        f"link {number}, {key}" for number in group.links for key in ("flips_at", "side", "slides")
    ]
    if side.flips_at is None and any(_passed(angle, ends) for angle in touched):
        raise StructureError(
            said(
                "group {group}: its side cannot hold through the change point at crank angle {angles}, where "
                "both assemblies meet: say beside it where it flips, flips_at = [{places}], or flips_at = [] "
                "if it does not",
                group=group.name,
                angles=", ".join(f"{angle:.6g}°" for angle in touched),
                places=places,
            ),
            *keys,
        )
    flips = side.flips_at or ()
    for angle in flips:
        if min((_between(angle, place) for place in touched), default=360.0) > NEAR:
            meeting = said("they meet nowhere")
            if touched:
                meeting = said("they meet at {places}", places=places)
            raise StructureError(
                said(
                    "group {group}: flips_at names {angle:.6g}°, but the two assemblies do not meet there "
                    "({meeting}): leave it out",
                    group=group.name,
                    angle=angle,
                    meeting=meeting,
                ),
                *keys,
            )
    if len(_apart(list(flips))) < len(flips):
        raise StructureError(
            said("group {group}: flips_at names the same crank angle twice", group=group.name),
            *keys,
        )
    if len(flips) % 2 and len(flips) < len(touched):
        raise StructureError(
            said(
                "group {group}: flips_at names {n} of the {count} change points, so after a whole turn the "
                "group would stand on its other side: name an even number of {places}, or all",
                group=group.name,
                n=len(flips),
                count=len(touched),
                places=places,
            ),
            *keys,
        )


def _passed(angle: float, ends: tuple[float, float] | None) -> bool:
    """Whether a row between two crank angles comes to a third; one without ends comes to all."""
    return ends is None or (angle - min(ends) + NEAR) % 360.0 <= max(ends) - min(ends) + 2 * NEAR


def _between(one: float, other: float) -> float:
    return abs((one - other + 180.0) % 360.0 - 180.0)


def _apart(angles: list[float]) -> list[float]:
    """Return the angles in order, each but once, as far as a flat minimum tells them: 1e-5°."""
    kept: list[float] = []
    for angle in (round(angle, 5) % 360.0 for angle in angles):
        if all(_between(angle, other) > NEAR for other in kept):
            kept.append(angle)
    return sorted(kept)


def _lows(
    survey: Survey, closure: Closure, rooms: tuple[Reals, Reals]
) -> list[tuple[float, float]]:
    """Return where the gap is least: crank angles (degrees) and gaps (m); only small or negative ones."""
    angles, room = rooms
    row, size = np.where(np.isfinite(room[0]), room[0], np.inf), _size(survey, closure)
    before, after = np.roll(row, 1), np.roll(row, -1)
    if not survey.sweep.closed:
        before[0] = after[-1] = np.inf
    lowest = np.flatnonzero((row <= before) & (row <= after) & (np.abs(row) < 0.01 * size))
    return [_least(survey, closure, float(angles[0, at]), survey.step) for at in lowest]


def _least(
    survey: Survey, closure: Closure, centre: float, reach: float, sign: int = 1
) -> tuple[float, float]:
    """Narrow down the least gap near an angle; return the angle (degrees, [0, 360)) and the gap, m.

    ``sign`` = −1: the greatest gap, with its sign changed.
    """
    sweep = survey.sweep
    for _ in range(24):
        row = centre + reach * np.linspace(-1.0, 1.0, 33)[None, :]
        row = row if sweep.closed else np.clip(row, sweep.low, sweep.high)
        value = sign * _measured(survey, closure, row)[0]
        value = np.where(np.isfinite(value), value, np.inf)
        best = int(np.argmin(value))
        centre, reach = float(row[0, best]), reach / 8
    return sweep.within(round(centre, DECIMALS[sweep.turns])), float(value[best])


def _ranges(survey: Survey, critical: list[float]) -> list[tuple[float, float]]:
    """Return the ranges of the crank over which everything can be drawn, degrees.

    ``critical``: crank angles to be tried besides the even steps, lest a narrow range be missed.
    """
    last: list[Mark] = [closing.point for closing in survey.positions.closings]
    last += [body.axis for body in survey.positions.bodies.values() if body.drawn]

    def drawable(angles: Reals) -> Reals:
        reading = survey.at(angles, last)
        total = np.zeros(angles.shape)
        for mark in last:
            value = reading[mark]
            part = value.along if isinstance(value, Line) else value
            total = total + np.abs(part)
        return np.where(np.isfinite(total), 1.0, -1.0)

    sweep = survey.sweep
    even = sweep.low + np.arange(STEPS + 1, dtype=np.float64) * survey.step
    angles = np.union1d(even, np.asarray(critical, dtype=np.float64))[None, :]
    good = drawable(angles)[0] > 0
    edges = np.flatnonzero(good[1:] != good[:-1])
    low, high = angles[0, edges], angles[0, edges + 1]
    at = [
        float(narrow(drawable, np.array([[a]]), np.array([[b]]))[0, 0])
        for a, b in zip(low, high, strict=True)
    ]
    if not sweep.closed:
        at = [*[sweep.low] * bool(good[0]), *at, *[sweep.high] * bool(good[-1])]
    elif at and good[0]:
        at = [*at[1:], at[0] + sweep.high]
    return list(zip(at[0::2], at[1::2], strict=True))
