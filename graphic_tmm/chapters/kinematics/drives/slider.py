"""A slider: a link that slides along a fixed guide by a length that is given."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.draft import ROUNDING, Draft
from graphic_tmm.board.operations.formulas import run_out, to_board
from graphic_tmm.board.operations.instruments import lay_off, parallel
from graphic_tmm.board.record import Mark, between
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import (
    Body,
    Positions,
    draw_guide,
    draw_points,
    nearest,
    stand,
)
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair, Sizes, Uses, reach
from graphic_tmm.chapters.kinematics.motion import Hanging, Motion, image_letter
from graphic_tmm.chapters.kinematics.velocity_lines import VelocityLines
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.units import small, unit
from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.guides import direction, level, turn
from graphic_tmm.mechanism.records import Sweep
from graphic_tmm.readers.task_sheet import given_figure

_COUNTED = said("{letter} is counted along {guide}; {point} stands at {letter} = {size}.")


class Slider(DrivenPair):
    """A slider; its coordinate is how far its point has come along the guide from where that is told, m."""

    @classmethod
    def fits(cls, driven: Driven) -> bool:
        """Whether a link slides on the frame."""
        return driven.pair.kind == "P" and not driven.telescopes

    @property
    def pin(self) -> str:
        """The letter of its point."""
        return self.driven.pin

    @property
    def own(self) -> complex:
        """Its point in its own axes, m."""
        return self.mechanism.by_number[self.link].points[self.pin]

    @property
    def sweep(self) -> Sweep:
        """As far to both sides as all links together reach."""
        most = reach(self.mechanism)
        return Sweep("s", "m", -most, most, False)

    def ask(self, draft: Draft) -> Mark:
        """Take how far it has come."""
        return draft.ask(Number, "s", "m")

    def stand(self, draft: Draft, bodies: dict[int, Body], at: Mark) -> None:
        """Draw it so far along its guide."""
        link, pair = self.mechanism.by_number[self.link], self.pair
        frame = bodies[self.mechanism.frame.number]
        height = level(pair, link.number, self.own)
        guide = draw_guide(draft, frame, pair, height, pair.name)
        off = self._begins(height)[1]
        if off:
            back = draft.take(Number, f"(−{pair.name}_{{0}})", -off, "m")
            at = draft.draw(run_out, "s′", at, back, unit="m", why=why.FROM_ITS_LINE)
        end = draft.draw(
            lay_off,
            self.pin,
            guide,
            draft.draw(to_board, "[s]", at, draft.mu_l),
            why=why.DRIVEN_PIN,
        )

        def axis() -> Mark:
            return draft.draw(parallel, f"({link.number})", end, guide, why=why.SLIDER_AXIS)

        body = bodies[link.number] = Body(link, self.own, direction(pair, link.number), axis)
        stand(body, self.pin, end, self.own)
        draw_points(draft, body, self.pin)
        draft.figure("slider", str(link.number), end, guide)
        draft.figure("guide", str(frame.link.number), end, guide)

    def _begins(self, height: float) -> tuple[str, float]:
        """Return the point at which the drawn guide begins, and how far from that by which it is told, m."""
        slide, frame = self.pair.slide, self.mechanism.frame
        assert slide is not None
        point = nearest(frame.number, frame.points, self.pair, height)
        begins = frame.points[point]
        away = (begins - slide.guide.through) * turn(-slide.guide.angle)
        straight = abs(away.real) <= ROUNDING * max(abs(away), abs(begins))
        return point, 0.0 if straight else away.real

    def stated(self, language: str) -> Iterator[str]:
        """Tell where a point of the frame stands on the line along which it is counted."""
        point, away = self._begins(level(self.pair, self.link, self.own))
        size, mm = small(away, language)
        yield speaking(language)(
            _COUNTED,
            letter=self.sweep.letter,
            guide=self.pair.name,
            point=point,
            size=f"{given_figure(size, language)} {unit(mm, language)}",
        )

    def led(self, positions: Positions) -> tuple[Mark, Mark]:
        """Return the first point of the frame, and its own point."""
        frame = positions.bodies[self.mechanism.frame.number]
        return next(iter(frame.marks.values())), positions.bodies[self.link].marks[self.pin]

    def path(self, positions: Positions, uses: Uses) -> Mark:
        """Return the line of its guide."""
        return uses(positions.bodies[self.link].marks[self.pin])[0]

    def velocity(self, positions: Positions, plan: Motion, lines: VelocityLines) -> None:
        """Draw the velocity of its point."""
        draft, pole, letter = lines.draft, plan.images.pole, image_letter(self.pin)
        draft.say(f"{self.speed_letter} ∥ {self.pair.name}")
        speed = self.take(draft, self.speed_letter, self.rates(signed=True), "m/s")
        plan.speeds[self.link] = speed
        segment = between(pole, letter)
        length = draft.draw(to_board, segment, speed)
        line = lines.along(f"({segment})", pole, self.path(positions, draft.uses), True)
        image = draft.draw(lay_off, letter, line, length, why=why.VECTOR)
        if self.drive.speed > 0.0:  # against its guide its length is yet to be read
            plan.measured.add(image)
        plan.driven[self.link] = pole, image
        self._hang(positions, plan, image)

    def _hang(self, positions: Positions, plan: Motion, image: Mark) -> None:
        """Enter it into a plan: all its points move alike."""
        body = positions.bodies[self.link]
        plan.images.hang(body, Hanging(body.marks[self.pin], image, None), {self.pin: image})
        plan.images.complete(body)

    def acceleration(
        self, draft: Draft, positions: Positions, velocities: Motion, plan: Motion
    ) -> None:
        """Draw the acceleration of its point; none where it slides evenly."""
        pole, letter = plan.images.pole, image_letter(self.pin)
        if not self.drive.acceleration:
            self._hang(positions, plan, pole)
            return
        draft.say(f"{self.gain_letter} ∥ {self.pair.name}")
        gain = self.take(draft, self.gain_letter, self.gains, "m/s²")
        segment = between(pole, letter)
        length = draft.draw(to_board, segment, gain)
        path = self.path(positions, draft.uses)
        line = draft.draw(parallel, f"({segment})", pole, path, sense=1, why=why.ACCELERATION_ALONG)
        image = draft.draw(lay_off, letter, line, length, why=why.VECTOR)
        if np.all(np.asarray(self.gains) > 0.0):
            plan.measured.add(image)
        self._hang(positions, plan, image)

    @property
    def segments(self) -> Sizes[str]:
        """Of its velocity and its acceleration: pb, πb."""
        small = image_letter(self.pin)
        return Sizes("", f"p{small}", f"π{small}")


DRIVE = Slider
