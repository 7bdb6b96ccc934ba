"""Zhukovsky's lever: the whole turned velocity plan as a rigid lever about its pole, every load at its image.

A force is carried parallel to the image of its point of application; a couple on a link as its moment converted
to the plan, M·ab/l, or as a pair of forces at the ends of the link's segment. The lever is in equilibrium.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.instruments import measure, parallel, square
from graphic_tmm.board.operations.statics import (
    arm,
    balancing_on_lever,
    carry,
    converted,
    converted_reversed,
    moment_on_arm,
    on_lever,
    per_times,
    reversed_,
    tangential,
)
from graphic_tmm.board.record import Mark, between
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.detached import bare
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.by_drive import ByDrive
from graphic_tmm.chapters.kinematics.closings import PinLeg, groups_of, with_plates
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.chapters.kinematics.motion import Motion, pin_image, pivot_image
from graphic_tmm.chapters.kinematics.special_point import special_point

VIEW = "lever"


class Carried(NamedTuple):
    """A force on the lever: its letter, its image point, its line, its size (N)."""

    letter: str
    point: Mark
    line: Mark
    value: Mark


class Turning(NamedTuple):
    """The moment of a load on the lever (N·mm), and the size of that load (N or N·m)."""

    load: Mark
    value: Mark


class Converted(NamedTuple):
    """A couple on the lever: its letter, the couple (N·m) and what it becomes (N·mm), its segment's ends."""

    letter: str
    couple: Mark
    value: Mark
    ends: tuple[Mark, Mark]


class Lever(NamedTuple):
    """The lever of a drive: its pole, how much larger than the plan it is, its μ_v, images by link, forces.

    ``balance``: N at the crank pin, or N·m; ``moments``: of all loads, ``total``: their sum (N·mm), ``force``:
    what at the crank pin balances it (N); ``segment``: of the crank pin, as read (Length). ``loads``: what is
    carried onto it, as it acts on the links.
    """

    pole: Mark
    times: Mark
    mu: Mark
    images: dict[int, tuple[Mark, ...]]
    forces: tuple[Carried, ...]
    moments: tuple[Turning, ...]
    balance: Mark
    pin: Mark
    segment: Mark
    couples: tuple[Converted, ...]
    total: Mark
    force: Mark
    loads: tuple[list[Force], list[Couple]]


class _Plan:
    """The lever while it is drawn; ``quarters``: right angles that its plan lacks to be a turned one."""

    def __init__(self, draft: Draft, velocities: Motion, quarters: int) -> None:
        self.draft, self.velocities, self.quarters = draft, velocities, quarters
        self.pole = draft.take(Point, "p", 0j)
        self.times = draft.ask(Number, "k")
        self.known: dict[Mark, Mark] = {velocities.images.pole: self.pole}
        self.forces: list[Carried] = []
        self.moments: list[Turning] = []
        self.couples: list[Converted] = []

    def image(self, of: Mark) -> Mark:
        if of not in self.known:
            plan = (self.velocities.images.pole, of)
            self.known[of] = self.draft.draw(
                carry, of.letter, self.pole, *plan, self.times, quarters=self.quarters, free=True
            )
        return self.known[of]

    def carry_force(self, letter: str, image: Mark, line: Mark, value: Mark, load: Mark) -> None:
        """Carry a force to its image; one at the pole has no arm. ``load``: the size of what it stands for."""
        point = self.image(image)
        if point != self.pole:
            along = self.draft.draw(
                parallel, f"({letter})", point, line, sense=1, why=why.FORCE_ON_LEVER
            )
            self.turn(letter, point, along, value, load)

    def turn(self, letter: str, point: Mark, along: Mark, value: Mark, load: Mark) -> None:
        """Measure the arm of a force on the lever and calculate its moment, N·mm."""
        draft = self.draft
        height = draft.draw(arm, f"h_{{{bare(letter)}}}", self.pole, along)
        found = draft.draw(on_lever, f"M({letter})", value, height, unit="N·mm")
        self.forces.append(Carried(letter, point, along, value))
        self.moments.append(Turning(load, found))

    def carry_couple(self, couple: Couple, base: _Base, kind: str) -> None:
        """Convert a couple to the plan, or set a pair of forces at the ends of its link's segment."""
        draft, load = self.draft, couple.value
        if kind == "moment":
            formula = converted if base.sense > 0 else converted_reversed
            found = draft.draw(
                formula,
                f"{couple.letter}′",
                couple.value,
                self.times,
                base.segment,
                base.length,
                unit="N·mm",
            )
            self.moments.append(Turning(load, found))
            ends = self.image(base.start), self.image(base.end)
            self.couples.append(Converted(found.letter, couple.value, found, ends))
            return
        letter = f"F_{{{bare(couple.letter)}}}"
        force = draft.draw(
            tangential, letter, couple.value, base.length, unit="N", why=why.PAIR_FORCE
        )
        self._set(letter, base.end, base.line, force, load)
        if base.start != self.velocities.images.pole:
            back = draft.draw(reversed_, f"−{letter}", force, unit="N")
            self._set(f"−{letter}", base.start, base.line, back, load)

    def _set(self, letter: str, image: Mark, line: Mark, value: Mark, load: Mark) -> None:
        """Set a force of a pair at an end of its link's segment, square to the link."""
        point = self.image(image)
        if point != self.pole:
            across = self.draft.draw(
                square, f"({letter})", point, line, sense=1, why=why.PAIR_ACROSS
            )
            self.turn(letter, point, across, value, load)


class _Base(NamedTuple):
    """What a link's couple is converted by: its segment on the plan, its length, their ends, the sense."""

    segment: Mark
    length: Mark
    start: Mark
    end: Mark
    line: Mark
    sense: int


def draw_lever(
    draft: Draft,
    positions: Positions,
    by: ByDrive,
    loads: tuple[list[Force], list[Couple]],
    *,
    turned: bool,
    couples: str,
    moment: bool,
) -> Lever:
    """Draw the lever of a drive and find what balances it there.

    ``loads``: their images lie on the plan of that drive, which is drawn ``turned``, or direct; ``moment``: a
    balancing moment of the crank is wanted, not a force.
    """
    (pairs, velocities), pair = by, by.pairs[0]
    sense, several = pair.drive.sense, len(pairs) > 1
    draft.open(f"{VIEW} {pair.link}" if several else VIEW)
    plan = _Plan(draft, velocities, 0 if turned else -sense)
    mu = draft.draw(per_times, "μ_{vl}", velocities.mu, plan.times, unit="(m/s)/mm")
    draft.lay_out(plan.pole, mu)
    forces, acting = loads
    start, end = (plan.image(image) for image in velocities.driven[pair.link])
    for force in forces:
        assert force.image is not None
        plan.carry_force(force.letter, force.image, force.line, force.value, force.value)
    for couple in acting:
        base = _base(draft, positions, velocities, pairs, couple.link, sense)
        if base is not None:
            plan.carry_couple(couple, base, couples)
    for number in positions.bodies:
        for image in velocities.images.by_letter[number].values():
            plan.image(image)
    crank = _crank(pair)
    because = why.LEVER_ARM_OF_CRANK if crank else why.LEVER_ARM_OF_SLIDE
    segment = draft.draw(measure, between(start, end.letter), start, end, why=because)
    arm = crank.real_arm(draft, positions) if crank and moment else None
    balance = _balance(draft, plan, segment, arm, str(pair.link) if several else "")
    images = {
        number: tuple(
            plan.known[image]
            for image in dict.fromkeys(velocities.images.by_letter[number].values())
        )
        for number in positions.bodies
    }
    found = (images, tuple(plan.forces), tuple(plan.moments))
    told = (tuple(plan.couples), balance.total, balance.force)
    return Lever(
        plan.pole, plan.times, mu, *found, balance.asked, end, segment, *told, loads=loads
    )  # fmt: skip


class _Balance(NamedTuple):
    """The sum of moments (N·mm), the force at the crank pin that balances it, and what is asked for."""

    total: Mark
    force: Mark
    asked: Mark


def _balance(draft: Draft, plan: _Plan, segment: Mark, arm: Mark | None, index: str) -> _Balance:
    total: Mark | None = None
    for found in (one.value for one in plan.moments):
        total = (
            found
            if total is None
            else draft.draw(
                added, "ΣM", total, found, unit="N·mm", role=roles.SUM, why=why.SUM_ON_LEVER
            )
        )
    if total is None:
        total = draft.take(Number, "ΣM", 0.0, "N·mm")
    force = draft.draw(balancing_on_lever, f"P_{{bl{index}}}", total, segment, unit="N")
    if arm is None:
        return _Balance(total, force, force)
    return _Balance(
        total, force, draft.draw(moment_on_arm, f"M_{{bl{index}}}", force, arm, unit="N·m")
    )


def _crank(pair: DrivenPair) -> Crank | None:
    return pair if isinstance(pair, Crank) else None


def _base(
    draft: Draft,
    positions: Positions,
    velocities: Motion,
    pairs: Sequence[DrivenPair],
    link: int,
    sense: int,
) -> _Base | None:
    """Return what a link's couples are converted by; None if the link does not turn.

    A link that slides on another turns with it, and takes its segment.
    """
    rate = velocities.rates.get(link)
    if rate is None:
        return None
    for crank in (one for one in map(_crank, pairs) if one is not None):
        if rate == velocities.rates.get(crank.link):
            pole, image = velocities.driven[crank.link]
            length = crank.drawn_arm(draft, positions)
            axis = positions.bodies[crank.link].axis
            own = sense * crank.drive.sense
            return _Base(draft.uses(image)[1], length, pole, image, axis, own)
    for wheel in positions.wheels:
        if rate == velocities.rates[wheel.leg.link]:
            start, segment = pivot_image(velocities, wheel.leg), velocities.readings[link]
            end = velocities.pitches[link]
            return _Base(segment, wheel.leg.length, start, end, wheel.leg.line, sense)
    for leg in _arms_of_plates(draft, positions):
        if rate == velocities.rates.get(leg.link):
            start, end, _ = draft.uses(segment := velocities.readings[leg.link])
            return _Base(segment, leg.length, start, end, leg.line, sense)
    every = groups_of(positions.closings, VIEW)
    for closing, held in ((one, k) for one in every for k in one.arms):
        if isinstance(held, PinLeg) and rate == velocities.rates.get(held.link):
            start = velocities.ends.get(held.link) or pivot_image(velocities, held)
            end = pin_image(velocities, closing, held)
            return _Base(velocities.readings[held.link], held.length, start, end, held.line, sense)
    return None


def _arms_of_plates(draft: Draft, positions: Positions) -> Iterator[PinLeg]:
    """Yield the lines of plates to their special points, about which the plans turn them."""
    for closing in with_plates(positions.closings, VIEW):
        yield from special_point(draft, closing).legs
