"""The mechanism tried all through its drive before the sheet is begun; how well it passes its motion on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.operations.instruments import measure_along, ray
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.branches import followed_place
from graphic_tmm.chapters.kinematics.closings import (
    ClosingLeg,
    GuideLeg,
    PinLeg,
    groups_of,
    unheld,
)
from graphic_tmm.chapters.kinematics.drives import driven, follow
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.positions import (
    draw_frame,
    draw_positions,
    side_record,
)
from graphic_tmm.chapters.kinematics.sides import standing
from graphic_tmm.chapters.kinematics.special_point import crossing_legs, held_along
from graphic_tmm.chapters.kinematics.tracings import Branch, Tracing
from graphic_tmm.chapters.kinematics.velocities import draw_velocities
from graphic_tmm.chapters.kinematics.wheels import Wheels, Winding
from graphic_tmm.chapters.kinematics.winding import STEPS, winding
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.groups import of_two_links
from graphic_tmm.mechanism.records import TURN, Mechanism, Sweep
from graphic_tmm.mechanism.structure import Structure

WHOLE = 1e-9
"""A number of turns that is off a whole one by no more than this is that, rounded."""


@dataclass(frozen=True)
class Survey:
    """The plan of positions and velocities over a crank angle that is given freely, drawn at 1 m to 1 mm."""

    mechanism: Mechanism
    structure: Structure
    construction: Construction
    given: dict[Mark, object]
    positions: Positions
    velocities: Motion
    axes: dict[tuple[str, str], Mark]
    zero: float = 0.0
    windings: Mapping[int, Winding] = field(default_factory=dict)
    branches: Mapping[str, Branch] = field(default_factory=dict)
    tracings: Mapping[str, Tracing] = field(default_factory=dict)

    @property
    def returning_late(self) -> tuple[str, ...]:
        """The groups that flip an odd number of times in a turn: back in their place after two turns only."""
        sides = [(g.name, side_record(self.mechanism, g)) for g in self.structure.groups]
        return tuple(name for name, side in sides if side and len(side.flips_at or ()) % 2)

    @property
    def pairs(self) -> tuple[DrivenPair, ...]:
        """Its drives, the one of the row first."""
        return driven(self.mechanism, self.structure)

    @property
    def sweep(self) -> Sweep:
        """What the coordinate of the first drive can go through.

        Where others follow a crank, a turn from the zero position on does not end where it began.
        """
        first, *others = self.pairs
        if not first.sweep.closed or not (others or self.rolls_on):
            return first.sweep
        end = self.zero + first.drive.sense * first.sweep.high
        return replace(first.sweep, low=min(self.zero, end), high=max(self.zero, end), closed=False)

    def wound(self, number: int, wheels: Wheels) -> Winding:
        """Return how the angle of a link goes on, as it was found out."""
        return self.windings[number]

    def branch(self, wheels: Wheels, tracing: Tracing) -> Branch:
        """Return which of its places a plate keeps, as it was found out."""
        return self.branches[tracing.group.name]

    @cached_property
    def rolls_on(self) -> bool:
        """Whether a wheel is not back where it was after a turn of the drive: its ratio is no whole number."""
        wheels, sweep = self.positions.wheels, self.pairs[0].sweep
        if not wheels:
            return False
        reading = self.at(np.array([[sweep.low, sweep.high]]), [one.angle for one in wheels])
        turns = [float(np.diff(reading[one.angle])[0, 0]) / TURN.high for one in wheels]
        return any(abs(turn - round(turn)) > WHOLE for turn in turns if np.isfinite(turn))

    @property
    def step(self) -> float:
        """How far apart the coordinates are that are tried over it."""
        return (self.sweep.high - self.sweep.low) / STEPS

    def at(self, row: Reals, wanted: Iterable[Mark]) -> Reading:
        """Run at coordinates of the first drive (trial, position)."""
        given = self.given | {self.positions.row[0]: row}
        return execute(self.construction, given | standing(self, row), wanted)

    def whole(
        self, wanted: Iterable[Mark], ends: tuple[float, float] | None = None
    ) -> tuple[Reals, Reading]:
        """Run over all of its sweep, or from end to end; return coordinates (1, n) and reading."""
        sweep = self.sweep
        if ends is not None:
            row = np.linspace(*ends, STEPS + 1)[None, :]
        else:
            steps = np.arange(STEPS if sweep.closed else STEPS + 1, dtype=np.float64)[None, :]
            row = sweep.low + steps * self.step
        return row, self.at(row, wanted)


def survey(mechanism: Mechanism, structure: Structure, zero: float = 0.0) -> Survey:
    """Draw the mechanism on a small board of its own; ``zero``: where its row begins.

    Raises
    ------
    StructureError
        If the side of a group that has two assemblies is missing, speaks of other letters than the
        group's outer pivots, or is given twice and not alike.
    """
    mechanism, structure = _steady(mechanism, structure)
    _refuse_missing_sides(mechanism, structure)
    _refuse_strange_sides(mechanism, structure)
    draft = Draft()
    frame = draw_frame(draft, mechanism, structure)
    row = follow(draft, driven(mechanism, structure), zero)
    windings: dict[int, Winding] = {}

    def wound(number: int, wheels: Wheels) -> Winding:
        windings[number] = winding(wheels, number)
        return windings[number]

    branches: dict[str, Branch] = {}
    tracings: dict[str, Tracing] = {}

    def branch(wheels: Wheels, tracing: Tracing) -> Branch:
        name = tracing.group.name
        tracings[name], branches[name] = tracing, followed_place(wheels, tracing)
        return branches[name]

    positions = draw_positions(draft, mechanism, structure, frame, row, wound, branch)
    velocities = draw_velocities(draft, mechanism, structure, positions, turned=False)
    pole = velocities.images.pole
    x = draft.draw(ray, "(px)", pole, draft.direction(0.0))
    y = draft.draw(ray, "(py)", pole, draft.direction(90.0))
    axes = {}
    for number, body in positions.bodies.items():
        for letter in body.link.points:
            image = velocities.images.by_letter[number][letter]
            if image == pole or (letter, "x") in axes:
                continue
            for name, axis in (("x", x), ("y", y)):
                along = f"{image.letter}{name}"
                axes[letter, name] = draft.draw(measure_along, along, pole, image, axis)
    given = draft.given | {draft.mu_l: 1.0, velocities.mu: 1.0}
    log = draft.board.construction()
    return Survey(
        mechanism,
        structure,
        log,
        given,
        positions,
        velocities,
        axes,
        zero,
        windings,
        branches,
        tracings,
    )


def _steady(mechanism: Mechanism, structure: Structure) -> tuple[Mechanism, Structure]:
    """Return a mechanism whose first drive goes evenly, whatever it does in the positions of its row."""
    if not mechanism.drive.rates and not mechanism.drive.gains:
        return mechanism, structure
    first, *others = structure.driven
    drive = replace(mechanism.drive, rates=(), gains=())
    even = replace(mechanism, drive=drive)
    return even, structure._replace(driven=(first._replace(drive=drive), *others))


def _refuse_missing_sides(mechanism: Mechanism, structure: Structure) -> None:
    for group in of_two_links(structure.groups, "assembly"):
        if group.kind > 3 or side_record(mechanism, group) is not None:
            continue
        if group.kind == 1:
            a, c = (leg.pair.name for leg in group.legs)
            links = "{} or {}".format(*group.links)
            remedy = said(
                'give link {links} side = "left of {a}{c}" or "right of {a}{c}"',
                links=links,
                a=a,
                c=c,
            )
            key = f"link {group.links[0]}"
        else:
            pair = group.legs[1].pair if group.kind == 2 else group.inner
            remedy = said('give slides of link {links} side = "+" or "-"', links=pair.links[0])
            key = f"link {pair.links[0]}, slides"
        raise StructureError(
            said(
                "group {name} can be assembled in two ways: {remedy}",
                name=group.name,
                remedy=remedy,
            ),
            key,
        )


def _refuse_strange_sides(mechanism: Mechanism, structure: Structure) -> None:
    for group in of_two_links(structure.groups, "assembly"):
        if group.kind != 1:
            continue
        a, c = (leg.pair.name for leg in group.legs)
        told = []
        for number in group.links:
            side = mechanism.by_number[number].side
            if side is None:
                continue
            if side.left_of not in ((a, c), (c, a)):
                raise StructureError(
                    said(
                        "link {number}: its side speaks of {listed}, but group {name} has its "
                        'outer pivots at {a} and {c}: write side = "left of {a}{c}" or "right of '
                        '{a}{c}"',
                        number=number,
                        listed="".join(side.left_of or ()),
                        name=group.name,
                        a=a,
                        c=c,
                    ),
                    f"link {number}, side",
                )
            told.append((side.sign if side.left_of == (a, c) else -side.sign, side.flips_at))
        if len(set(told)) > 1:
            raise StructureError(
                said(
                    "links {links} and {links2} give group {name} different sides: leave the side "
                    "of one of them out",
                    links=group.links[0],
                    links2=group.links[1],
                    name=group.name,
                ),
                *(f"link {number}, side" for number in group.links),
            )


POOR = 0.35
"""Where motion is passed on worse than this at all of some positions, another is looked for."""
TRANSMISSION = "transmission"
DIGITS = 9
"""Decimals of what is compared that are not rounding."""


def best(tried: Survey, angles: Reals, wanted: Sequence[int], all: Sequence[int]) -> int:
    """Return the position (index) that shows the mechanism best: the first in which motion is passed on best.

    It is one of those ``wanted`` (with plans of their own); where motion is passed on poorly in all of these,
    one of ``all``. ``angles``: of the crank in every position, degrees.
    """
    passed = np.nan_to_num(transmission(tried, angles), nan=-1.0)
    rows = np.round(passed, DIGITS)
    found = [max(places, key=lambda k: rows[k]) for places in (wanted, all) if places]
    return found[0] if rows[found[0]] >= POOR else found[-1]


def least_angle(tried: Survey, ends: tuple[float, float] | None = None) -> float:
    """Return the least transmission angle of a mechanism over a turn, degrees; NaN where there is none.

    ``ends``: those of a row that is no whole turn.

    The transmission angle of a group is the acute one of both lines of its velocities at its closing point: of
    a four-bar that between coupler and rocker, of a slider that between its rod and what is square to its
    guide, of a stone that between its guide and what is square to the arm of the link that it slides on.
    """
    crossings = [
        two
        for closing in groups_of(tried.positions.closings, TRANSMISSION)
        for two in crossing_legs(tried.construction, closing)
    ]
    reading = tried.whole([leg.line for two in crossings for leg in two], ends)[1]
    with np.errstate(all="ignore"):
        sines = [float(np.nanmin(_sine(reading, *two), initial=np.inf)) for two in crossings]
    least = min(sines, default=1.0)
    return float(np.degrees(np.arcsin(min(least, 1.0)))) if np.isfinite(least) else np.nan


def transmission(tried: Survey, angles: Reals) -> Reals:
    """Return how well motion is passed on at crank angles (degrees): 1 at its best, 0 at a dead centre.

    The smallest over all groups of the sine of the angle at which both lines of its velocities meet, of the
    speed of its closing point as a share of the largest, and of the sine of the angle between a crank and
    what hangs on its pin, which else lies on the crank.
    """
    first = tried.pairs[0]
    crank = first.arm_ends(tried.positions)
    closed = tried.velocities.closed
    groups = [(c, closed[c.group.name]) for c in groups_of(tried.positions.closings, TRANSMISSION)]
    crossings = [two for closing, _ in groups for two in crossing_legs(tried.construction, closing)]
    lines = [leg.line for two in crossings for leg in two]
    row = angles.astype(np.float64)[None, :]
    reading = tried.at(row, [*crank, *lines, *(image for _, image in groups)])
    found = [np.ones(row.shape), *(_sine(reading, *two) for two in crossings)]
    for closing, image in groups:
        found.append(_speed(reading, image))
        legs = held_along(tried.construction, closing)
        pinned = (leg for leg in legs if isinstance(leg, PinLeg) or leg.inner)
        hung = [leg.line for leg in pinned if crank and leg.body == first.link]
        arm = reading[crank[1]] - reading[crank[0]] if crank else np.ones_like(row)
        found += [np.abs((np.conj(arm) * reading[line].along).imag) / np.abs(arm) for line in hung]
    shares = np.stack([np.broadcast_to(one, row.shape) for one in found])
    return np.asarray(np.min(shares, axis=0)[0])


def _sine(reading: Reading, one: ClosingLeg, other: ClosingLeg) -> Reals:
    first, second = (_way(reading, leg) for leg in (one, other))
    return np.asarray(np.abs((np.conj(first) * second).imag))


def _way(reading: Reading, leg: ClosingLeg) -> Complexes:
    """The direction of the velocity that a leg leaves free: square to a link, along a guide."""
    along = np.asarray(reading[leg.line].along)
    match leg:
        case PinLeg():
            return along * 1j
        case GuideLeg():
            return along
        case _:
            unheld(leg, TRANSMISSION)


def _speed(reading: Reading, image: Mark) -> Reals:
    speed = np.asarray(np.abs(reading[image]))
    there = speed[np.isfinite(speed)]
    most = float(there.max()) if there.size else 0.0
    return speed / most if most > 0.0 else np.ones_like(speed)
