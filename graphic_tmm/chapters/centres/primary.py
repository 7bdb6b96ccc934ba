"""The centres that are there at once: pins, guides at infinity, the pitch points of wheels that roll."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from typing import Any

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.instruments import square
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.centres import words as why
from graphic_tmm.chapters.centres.formulas import carry_point
from graphic_tmm.chapters.centres.network import GUIDE, PIN, WHEEL, Centre, Network
from graphic_tmm.chapters.kinematics.bodies import GuideLeg, PinLeg, incline_by
from graphic_tmm.chapters.kinematics.drives.slider import Slider
from graphic_tmm.chapters.kinematics.plan import KinematicPlans
from graphic_tmm.mechanism.records import Slide


class Scheme:
    """The scheme of centres: points of the plan of positions as they stand in it, each carried over once."""

    def __init__(self, draft: Draft, plans: KinematicPlans, network: Network, mu: Mark) -> None:
        self.draft, self.plans, self.network, self.mu = draft, plans, network, mu
        self.points: dict[Mark, Mark] = {}

    def point(self, of: Mark) -> Mark:
        """Return a point of the plan of positions in the scheme."""
        if of not in self.points:
            factors = self.draft.mu_l, self.mu
            self.points[of] = self.network.draw(carry_point, of.letter, of, *factors, free=True)
        return self.points[of]

    def images(self, link: int) -> Mapping[Mark, Mark]:
        """Return the points of a link in the scheme, with their images on the plan of velocities."""
        velocities, body = self.plans.velocities, self.plans.positions.bodies[link]
        assert velocities is not None
        images = velocities.images.by_letter[link]
        return {
            self.point(mark): images[letter]
            for letter, mark in body.marks.items()
            if letter in images and letter in body.link.points
        }

    def primary(self) -> None:
        """Enter the centres of all pairs."""
        pinned: dict[str, list[int]] = {}
        for number, body in self.plans.positions.bodies.items():
            for letter in body.link.points:
                pinned.setdefault(letter, []).append(number)
        for letter, links in pinned.items():
            for both in combinations(links, 2):
                mark = self.point(self.plans.positions.bodies[both[0]].marks[letter])
                self.network.enter(Centre(self.network.pair(*both), mark, False, PIN))
        for wheel in self.plans.positions.wheels:
            if wheel.span is None:
                pair = self.network.pair(wheel.rolling.on, wheel.leg.link)
                self.network.enter(Centre(pair, self.point(wheel.pitch), False, WHEEL))
        for first, second, through, guide in self._guides():
            pair = self.network.pair(first, second)
            if pair not in self.network.centres:
                if guide not in self.network.values:
                    self.network.values |= trial_values(self.draft, [guide])
                name = f"({through.name}P_{{{pair[0]}{pair[1]}}})"
                line = self.network.draw(square, name, through, guide, why=why.AT_INFINITY)
                self.network.enter(Centre(pair, line, True, GUIDE))

    def _guides(self) -> Iterator[tuple[int, int, Mark, Mark]]:
        """Yield two links that slide on each other, a point of the scheme there, the line of the guide."""
        positions, mechanism = self.plans.positions, self.plans.mechanism
        along = dict[tuple[int, int], Mark]()
        for closing in positions.closings:
            for leg in closing.legs:
                if isinstance(leg, GuideLeg):
                    along[leg.link, leg.on] = leg.line
                elif isinstance(leg, PinLeg) and leg.rod:
                    yield leg.link, leg.rod, self.point(leg.pivot), leg.line
        for pair in self.plans.pairs:
            if isinstance(pair, Slider):
                along[pair.link, mechanism.frame.number] = pair.path(positions, self.draft.uses)
        for number, body in positions.bodies.items():
            for slide in body.link.slides:
                if self.network.of(number, slide.on) is not None:
                    continue
                marks = [body.marks[k] for k in body.link.points]
                through = self.point(marks[0] if marks else self._any(slide))
                line = along.get((number, slide.on)) or self._drawn(slide)
                yield number, slide.on, through, line

    def _any(self, slide: Slide) -> Mark:
        return next(iter(self.plans.positions.bodies[slide.on].marks.values()))

    def _drawn(self, slide: Slide) -> Mark:
        """Draw a guide that no plan has drawn yet."""
        body = self.plans.positions.bodies[slide.on]
        through = self.point(self._any(slide))
        bend = slide.guide.angle - body.angle
        return incline_by(self.draft, slide.guide.name, through, body.axis, bend)


def trial_values(draft: Draft, marks: Sequence[Mark]) -> dict[Mark, Any]:
    """Return marks in the positions of the row, at 1 m and 1 m/s a mm."""
    log = draft.board.construction()
    reading = execute(log, {**dict.fromkeys(log.given, 1.0), **draft.given}, marks)
    return {mark: reading[mark] for mark in marks}
