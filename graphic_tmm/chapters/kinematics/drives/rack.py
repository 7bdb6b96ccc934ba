"""A rack that turns a wheel on the driven link: a crank whose angle follows from how far the rack has come."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.kinematics.bodies import Body
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.fitting.choice import Ledger
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.records import Sweep
from graphic_tmm.readers.task_sheet import SIZE, Given


@formula(
    why=said(
        "The wheel rolls on the rack: the arc of its pitch circle is as long as the way of the rack."
    )
)
def rolled(way: Number, radius: Number) -> Angle:
    """180°·{way}/(π·{radius})"""


@formula(
    why=said(
        "The wheel rolls on the rack: on its pitch circle a point is as fast as the rack, which is ω (ε) times "
        "{radius}."
    )
)
def by_rack(rate: Number, radius: Number) -> Number:
    """{rate}/{radius}"""


class Rack(Crank):
    """A wheel with its link, turned by a rack; its coordinate is how far that has come, m."""

    @classmethod
    def fits(cls, driven: Driven) -> bool:
        """Whether a rack turns the link."""
        return driven.pair.kind == "R" and driven.drive.rack > 0.0

    @property
    def radius(self) -> float:
        """The pitch radius of the wheel, m."""
        return self.drive.rack

    @property
    def sweep(self) -> Sweep:
        """As far as the wheel turns once."""
        return Sweep("s", "m", 0.0, math.tau * self.radius, False)

    def ask(self, draft: Draft) -> Mark:
        """Take how far the rack has come."""
        return draft.ask(Number, "s", "m")

    def _taken_radius(self, draft: Draft) -> Mark:
        return draft.constant(f"r_{self.link}", self.radius, "m")

    def stand(self, draft: Draft, bodies: dict[int, Body], at: Mark) -> None:
        """Draw the link at the angle by which the wheel has rolled."""
        angle = draft.draw(rolled, f"φ_{self.link}", at, self._taken_radius(draft), unit="°")
        super().stand(draft, bodies, angle)

    def turning(self, draft: Draft) -> Mark:
        """Calculate how fast the wheel turns, without its sign."""
        speed = self.take(draft, self.speed_letter, self.rates(signed=False), "m/s")
        radius = self._taken_radius(draft)
        return draft.draw(by_rack, f"ω_{self.link}", speed, radius, unit="1/s")

    def turning_back(self, draft: Draft) -> Mark:
        """Calculate how fast the wheel turns clockwise, with its sign."""
        back = self.take(draft, f"(−{self.speed_letter})", self.rates(signed=True), "m/s")
        radius = self._taken_radius(draft)
        return draft.draw(by_rack, f"(−ω_{self.link})", back, radius, unit="1/s")

    def gaining(self, draft: Draft) -> Mark:
        """Calculate the angular acceleration of the wheel."""
        gain = self.take(draft, self.gain_letter, self.gains, "m/s²")
        radius = self._taken_radius(draft)
        return draft.draw(by_rack, f"ε_{self.link}", gain, radius, unit="1/s²")

    @property
    def speed_letter(self) -> str:
        """The letter of the rack's speed."""
        return "v_r"

    @property
    def gain_letter(self) -> str:
        """The letter of the rack's acceleration."""
        return "a_r"

    @property
    def omega(self) -> float:
        """How fast the wheel turns, 1/s."""
        return abs(self.speed) / self.radius

    @property
    def epsilon(self) -> float:
        """The angular acceleration of the wheel, 1/s²."""
        return self.drive.acceleration / self.radius

    def rate_known(self, ledger: Ledger) -> Mark:
        """Write down ω = v/r."""
        speed = ledger.quantity(self.speed_letter, abs(self.speed), "m/s")
        radius = ledger.quantity(f"r_{self.link}", self.radius, "m")
        return ledger.calculated(by_rack, f"ω_{self.link}", speed, radius, unit="1/s")

    def epsilon_known(self, ledger: Ledger) -> Mark:
        """Write down ε = a/r."""
        gain = ledger.quantity(self.gain_letter, abs(self.drive.acceleration), "m/s²")
        radius = ledger.quantity(f"r_{self.link}", self.radius, "m")
        return ledger.calculated(by_rack, f"ε_{self.link}", gain, radius, unit="1/s²")

    @property
    def unit(self) -> str:
        """The unit of the rack's speed."""
        return "m/s"

    def given(self, language: str) -> Iterator[Given]:
        """Yield the radius of the wheel, the speed and the acceleration of the rack."""
        yield Given(f"r_{self.link}", self.radius, SIZE)
        yield from super().given(language)


DRIVE = Rack
