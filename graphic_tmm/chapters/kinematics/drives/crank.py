"""A crank: a link that turns about a fixed pivot by an angle that is given."""

from __future__ import annotations

import cmath
import math

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.operations.formulas import product, product_of_squares, to_board
from graphic_tmm.board.operations.instruments import lay_off, parallel, ray, square
from graphic_tmm.board.record import Mark, between
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import (
    Body,
    Positions,
    draw_points,
    stand,
)
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair, Sizes
from graphic_tmm.chapters.kinematics.motion import Base, Hanging, Motion, component, image_letter
from graphic_tmm.chapters.kinematics.velocity_lines import VelocityLines
from graphic_tmm.fitting.choice import Ledger
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.records import TURN, Sweep


@formula(why=said("The normal and the tangential acceleration are square to each other."))
def whole(normal: Number, tangential: Number) -> Number:
    """√({normal}² + {tangential}²)"""


class Crank(DrivenPair):
    """A crank; its coordinate is its angle from the x axis, degrees."""

    @classmethod
    def fits(cls, driven: Driven) -> bool:
        """Whether a pair turns by itself."""
        return driven.pair.kind == "R" and not driven.drive.rack

    @property
    def pivot(self) -> str:
        """The letter of its pivot."""
        return self.pair.name

    @property
    def pin(self) -> str:
        """The letter of its pin."""
        return self.driven.pin

    @property
    def arm(self) -> complex:
        """The way from pivot to pin in its own axes, m."""
        points = self.mechanism.by_number[self.link].points
        return points[self.pin] - points[self.pivot]

    @property
    def sweep(self) -> Sweep:
        """A whole turn."""
        return TURN

    def ask(self, draft: Draft) -> Mark:
        """Take its angle."""
        return draft.ask(Angle, "φ", "°")

    def stand(self, draft: Draft, bodies: dict[int, Body], at: Mark) -> None:
        """Draw it at an angle."""
        link, pivot, pin = self.mechanism.by_number[self.link], self.pivot, self.pin
        frame = bodies[self.mechanism.frame.number]
        line = draft.draw(ray, f"({pivot}{pin})", frame.marks[pivot], at, why=why.CRANK)
        turned = math.degrees(cmath.phase(self.arm))
        body = bodies[self.link] = Body(link, link.points[pivot], turned, lambda: line)
        stand(body, pivot, frame.marks[pivot], link.points[pivot])
        length = draft.length(f"{pivot}{pin}", abs(self.arm))
        end = draft.draw(lay_off, pin, line, length, why=why.CRANK_PIN)
        stand(body, pin, end, link.points[pin])
        draw_points(draft, body, pivot)

    def arm_ends(self, positions: Positions) -> tuple[Mark, ...]:
        """Return pivot and pin."""
        return self.led(positions)

    def led(self, positions: Positions) -> tuple[Mark, Mark]:
        """Return pivot and pin."""
        body = positions.bodies[self.link]
        return body.marks[self.pivot], body.marks[self.pin]

    def real_arm(self, draft: Draft, positions: Positions) -> Mark:
        """Return the mark of its real length l_OA, m."""
        return self._arm_of(draft, positions.bodies[self.link])

    def _arm_of(self, draft: Draft, body: Body) -> Mark:
        return draft.uses(draft.uses(body.marks[self.pin])[1])[0]

    def drawn_arm(self, draft: Draft, positions: Positions) -> Mark:
        """Return the mark of its length on the board."""
        return draft.uses(positions.bodies[self.link].marks[self.pin])[1]

    def velocity(self, positions: Positions, plan: Motion, lines: VelocityLines) -> None:
        """Draw the velocity of its pin."""
        draft, pole, number = lines.draft, plan.images.pole, self.link
        pivot, pin = self.pivot, self.pin
        body = positions.bodies[number]
        draft.say(f"v_{pin} = ω_{number}·l_{{{pivot}{pin}}},  v_{pin} ⊥ {pivot}{pin}")
        omega = plan.speeds[number] = self.turning(draft)
        arm = self.real_arm(draft, positions)
        because = why.POSSIBLE_SPEED if self.mechanism.at_rest else why.SPEED_OF_PIN
        velocity = draft.draw(product, f"v_{pin}", omega, arm, unit="m/s", why=because)
        segment = between(pole, image_letter(pin))
        length = draft.draw(to_board, segment, velocity)
        sense = self.drive.sense
        if lines.turned:
            op, way, because = parallel, sense * lines.sense, why.VELOCITY_OF_PIN_TURNED
        else:
            op, way, because = square, sense, why.VELOCITY_OF_PIN
        line = draft.draw(op, f"({segment})", pole, body.axis, sense=way, why=because)
        image = draft.draw(lay_off, image_letter(pin), line, length, why=why.VECTOR)
        plan.measured.add(image)
        plan.driven[number] = pole, image
        base = Base(body.marks[pivot], body.marks[pin], pole, image)
        plan.images.hang(body, Hanging(base.A, pole, base), {pivot: pole, pin: image})
        plan.images.complete(body)
        plan.rates[number] = omega if sense > 0 else self.turning_back(draft)

    @property
    def speed_letter(self) -> str:
        """The letter of its speed."""
        return f"ω_{self.link}"

    @property
    def gain_letter(self) -> str:
        """The letter of its angular acceleration."""
        return f"ε_{self.link}"

    def turning(self, draft: Draft) -> Mark:
        """Take how fast it turns, without its sign."""
        return self.take(draft, self.speed_letter, self.rates(signed=False), "1/s")

    def turning_back(self, draft: Draft) -> Mark:
        """Take how fast it turns clockwise, with its sign."""
        return self.take(draft, f"(−ω_{self.link})", self.rates(signed=True), "1/s")

    def gaining(self, draft: Draft) -> Mark:
        """Take its angular acceleration."""
        return self.take(draft, f"ε_{self.link}", self.gains, "1/s²")

    def acceleration(
        self, draft: Draft, positions: Positions, velocities: Motion, plan: Motion
    ) -> None:
        """Draw the acceleration of its pin."""
        pole, number, pivot, pin = plan.images.pole, self.link, self.pivot, self.pin
        body, letter, epsilon = positions.bodies[number], image_letter(pin), self.drive.acceleration
        arm, end = self.real_arm(draft, positions), pole
        if not self.mechanism.at_rest:
            first = f"n{number}" if epsilon else letter
            end = self._normal(draft, velocities, plan, body, first)
        if epsilon:
            draft.say(f"a_{{{pin}}}^{{t}} = ε_{number}·l_{{{pivot}{pin}}},  ⊥ {pivot}{pin}")
            plan.rates[number] = self.gaining(draft)
            name_t, gain = f"a_{{{pin}}}^{{t}}", plan.rates[number]
            value = draft.draw(product, name_t, gain, arm, unit="m/s²", why=why.TANGENTIAL_OF_PIN)
            segment = between(end, letter)
            length = draft.draw(to_board, segment, value)
            component(draft, length, "t", letter)
            line = draft.draw(
                square, f"({segment})", end, body.axis, sense=1, why=why.ACROSS_THE_CRANK
            )
            image = draft.draw(lay_off, letter, line, length, why=why.VECTOR)
        else:
            image = end
            plan.measured.add(image)
        base = Base(body.marks[pivot], body.marks[pin], pole, image)
        plan.images.hang(body, Hanging(base.A, pole, base), {pivot: pole, pin: image})
        plan.images.complete(body)

    def _normal(
        self, draft: Draft, velocities: Motion, plan: Motion, body: Body, first: str
    ) -> Mark:
        """Lay off the normal acceleration of its pin; return its end, lettered ``first``."""
        number, pivot, pin = self.link, self.pivot, self.pin
        epsilon, pole, arm = self.drive.acceleration, plan.images.pole, self._arm_of(draft, body)
        normal_of = f"a_{{{pin}}}^{{n}}" if epsilon else f"a_{pin}"
        draft.say(f"{normal_of} = ω_{number}²·l_{{{pivot}{pin}}},  {pin} → {pivot}")
        because = why.NORMAL_OF_PIN if epsilon else why.GAIN_OF_PIN
        known = velocities.speeds[number], arm
        value = draft.draw(product_of_squares, normal_of, *known, unit="m/s²", why=because)
        segment = between(pole, first)
        length = draft.draw(to_board, segment, value)
        inward = draft.draw(
            parallel, f"({segment})", pole, body.axis, sense=-1, why=why.TO_THE_PIVOT
        )
        end = draft.draw(lay_off, first, inward, length, why=why.VECTOR)
        if epsilon:
            component(draft, length, "n", image_letter(pin))
        return end

    @property
    def sizes(self) -> Sizes[float]:
        """Its length, the speed and the acceleration of its pin."""
        arm, own = abs(self.arm), 0.0 if self.mechanism.at_rest else self.omega
        return Sizes(arm, self.omega * arm, abs(own**2 + 1j * self.epsilon) * arm)

    @property
    def omega(self) -> float:
        """How fast it turns, 1/s."""
        return abs(self.speed)

    @property
    def epsilon(self) -> float:
        """Its angular acceleration, 1/s²."""
        return self.drive.acceleration

    @property
    def segments(self) -> Sizes[str]:
        """OA, pa, πa."""
        small = image_letter(self.pin)
        return Sizes(f"{self.pivot}{self.pin}", f"p{small}", f"π{small}")

    def length_known(self, ledger: Ledger) -> Mark:
        """Write down its length."""
        return ledger.quantity(f"l_{{{self.segments.length}}}", abs(self.arm), "m")

    def rate_known(self, ledger: Ledger) -> Mark:
        """Write down its angular velocity (1/s)."""
        return ledger.speed(str(self.link), self.speed)

    def speed_known(self, ledger: Ledger) -> Mark:
        """Write down v = ω·l."""
        known = self.rate_known(ledger), self.length_known(ledger)
        return ledger.calculated(product, f"v_{self.pin}", *known, unit="m/s")

    def gain_known(self, ledger: Ledger) -> Mark | None:
        """Write down ω²·l, ε·l, or what both come to; nothing of what stands, or is listed by positions."""
        if self.listed or not self.sizes.acceleration:
            return None
        arm, pin, parts = self.length_known(ledger), self.pin, list[Mark]()
        if not self.mechanism.at_rest:
            letter = f"a_{{{pin}}}^{{n}}" if self.epsilon else f"a_{pin}"
            known = self.rate_known(ledger), arm
            parts.append(ledger.calculated(product_of_squares, letter, *known, unit="m/s²"))
        if self.epsilon:
            known = self.epsilon_known(ledger), arm
            parts.append(ledger.calculated(product, f"a_{{{pin}}}^{{t}}", *known, unit="m/s²"))
        both = len(parts) == 2
        return ledger.calculated(whole, f"a_{pin}", *parts, unit="m/s²") if both else parts[0]

    def epsilon_known(self, ledger: Ledger) -> Mark:
        """Write down its angular acceleration without its sign (1/s²)."""
        return ledger.quantity(f"ε_{self.link}", abs(self.epsilon), "1/s²")

    @property
    def unit(self) -> str:
        """The unit of its speed."""
        return "1/s"


DRIVE = Crank
