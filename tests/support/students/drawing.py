"""How a student draws: steps with operands that a mind may mistake.

A step is told with all that it takes (lengths, segments, directions by their names), a `Mind` may take
something else, and the student goes on with what he then has.
"""

from __future__ import annotations

import numpy as np

from support.another_hand import met, sense
from support.students.records import POLES, A, Operands, P, Page, V, Way
from support.students.tools import Tools


class Student(Tools):
    """One drawing of a mechanism, position after position; a machine's script calls the steps."""

    def draw(self) -> Student:
        """Draw all positions."""
        for k in range(self.machine.positions):
            self.k = k
            self.page = Page({}, {}, {}, {})
            self.pages.append(self.page)
            self.machine.script(self)
        if self.machine.whole is not None:
            self.machine.whole(self)
        return self

    # ---- the plan of positions ------------------------------------------------------------------------------

    def crank(self, letter: str, length: str) -> None:
        take = self.take(
            P, letter, "crank", length=length, turn=1, first=0.0, count=self.k, part=1.0
        )
        part = take["part"] * 2 * np.pi / self.machine.positions
        angle = take["turn"] * (take["count"] * part + take["first"])
        reach = self.opened(self.given[take["length"]])
        self.put(P, letter, reach * self.ray("OA", np.exp(1j * angle)))

    def swing(self, letter: str, by: str, about: str, side: int) -> None:
        """Strike two arcs: the link ``by`` from its drawn end, the rocker ``about`` from its pivot."""
        take = self.take(P, letter, "meeting", by=by, about=about, side=side)
        start, pivot = self.at(P, by[0]), self.at(P, about[0])
        base = pivot - start
        r, q = self.opened(self.given[take["by"]]), self.opened(self.given[take["about"]])
        foot = (r**2 - q**2 + abs(base) ** 2) / (2 * abs(base))
        height = np.sqrt(r**2 - foot**2)
        self.put(P, letter, start + base / abs(base) * (foot + take["side"] * 1j * height))

    def slide(self, letter: str, by: str, low: float, side: int) -> None:
        """Strike an arc that cuts a guide parallel to x at the height ``low``."""
        take = self.take(P, letter, "meeting", by=by, side=side, low=low)
        start, r = self.at(P, by[0]), self.opened(self.given[take["by"]])
        reach = take["side"] * np.sqrt(r**2 - (take["low"] - start.imag) ** 2)
        self.put(P, letter, complex(start.real + reach, take["low"]))

    def place(self, letter: str, start: str, end: str, shape: complex) -> None:
        """Mark a point of a link whose place in it is known."""
        take = self.take(P, letter, "place", start=start, end=end, shape=shape)
        self._alike(P, letter, take)

    # ---- plans of velocities and accelerations --------------------------------------------------------------

    def image(self, plan: str, letter: str, start: str, end: str, shape: complex) -> None:
        """Find a point by similarity."""
        take = self.take(plan, letter, "image", start=start, end=end, shape=shape)
        self._alike(plan, letter, take)

    def _alike(self, plan: str, letter: str, take: Operands) -> None:
        a, b = self.at(plan, take["start"]), self.at(plan, take["end"])
        self.put(plan, letter, a + (b - a) * take["shape"])

    def lay(
        self, plan: str, letter: str, name: str, mm: float, start: str, way: Way, sign: float
    ) -> None:
        """Lay a calculated length off along a direction."""
        take = self.take(
            plan, name, "laid", start=start, way=way, sense=1.0, ago=0, factor=1.0, sign=sign
        )
        ray = self.ray(name, self.way(take["way"], take["ago"])) * take["sign"] * take["sense"]
        start_ = take["start"]
        self.put(plan, letter, self.at(plan, start_) + self.opened(mm) * take["factor"] * ray)

    def meet(self, plan: str, letter: str, *rays: tuple[str, str, Way]) -> None:
        """Draw two rays (name, start, way) and mark where they meet."""
        ends = []
        for name, start, way in rays:
            take = self.take(plan, name, "ray", start=start, way=way, ago=0, letter=letter, off=0.0)
            along = self.way(take["way"], take["ago"]) * np.exp(1j * np.radians(take["off"]))
            ends += [self.at(plan, take["start"]), self.ray(name, along)]
        across = abs((ends[1].conjugate() * ends[3]).imag)
        self.put(plan, letter, met(*ends) if across > 1e-3 else complex(np.nan, np.nan))

    # ---- what is read and calculated ------------------------------------------------------------------------

    def read(self, plan: str, name: str, start: str, end: str, whose: str = "read") -> float:
        """Measure a segment from point to point."""
        take = self.take(plan, name, whose, start=start, end=end, ago=0)
        ago = take["ago"]
        way = self.at(plan, take["end"], ago) - self.at(plan, take["start"], ago)
        if plan in (V, A) and take["start"] == POLES[plan]:
            way -= self.hand.pole
        return self.page.write(plan, name, self.ruled(f"{plan} {name}", abs(way)))

    def turns(self, plan: str, start: str, end: str, way: Way) -> float:
        """Return the sense in which a vector turns a link whose direction is known."""
        return sense(self.at(plan, end) - self.at(plan, start), self.way(way))

    def rate(self, plan: str, name: str, of: str, link: str, sign: float) -> None:
        """Calculate ω or ε of a link from a segment and the link's length."""
        take = self.take(
            plan, name, "rate", of=of, link=link, sense=1.0, factor=1.0, power=-1, mu=plan, ago=0,
            then=0,
        )  # fmt: skip
        number = self.noted(plan, take["of"], take["ago"]) * self.mu[take["mu"]]
        number *= (self.length(take["link"], take["then"]) * self.mu[P]) ** take["power"]
        self.page.rates[plan, name] = sign * take["sense"] * take["factor"] * number

    def before(self, ago: int) -> list[Page]:
        """Return the pages up to an earlier one."""
        return self.pages[: len(self.pages) - ago] or self.pages[:1]

    def noted(self, plan: str, name: str, ago: int) -> float:
        """Return what was noted of a segment, now or on the last plan before."""
        for page in reversed(self.before(ago)):
            if (plan, name) in page.lengths:
                return page.lengths[plan, name]
        raise KeyError((plan, name))

    def length(self, link: str, ago: int = 0) -> float:
        """Return the length of a link, mm: measured where it changes."""
        measured = self.before(ago)[-1].lengths.get((P, link))
        return float(self.given[link]) if measured is None else measured

    def crank_speed(self, name: str, link: str) -> float:
        """Calculate the mm of the crank pin's velocity."""
        take = self.take(
            V, name, "speed", link=link, factor=1.0, power=1, mu=V, omega=self.given["omega"]
        )
        v = (
            take["factor"]
            * take["omega"]
            * (self.given[take["link"]] * self.mu[P]) ** take["power"]
        )
        return self.page.write(V, name, v / self.mu[take["mu"]])

    def crank_acceleration(self, name: str, link: str) -> float:
        take = self.take(
            A, name, "speed", link=link, factor=1.0, power=1, mu=A, omega=self.given["omega"],
            square=2,
        )  # fmt: skip
        a = take["factor"] * take["omega"] ** take["square"]
        a *= (self.given[take["link"]] * self.mu[P]) ** take["power"]
        return self.page.write(A, name, a / self.mu[take["mu"]])

    def normal(self, name: str, of: str, link: str) -> float:
        """Calculate the mm of a normal component v²/l."""
        take = self.take(A, name, "normal", of=of, link=link, square=2, factor=1.0, power=-1, ago=0,
                         mu=A, then=0)  # fmt: skip
        v = self.before(take["ago"])[-1].lengths[V, take["of"]] * self.mu[V]
        a = take["factor"] * v ** take["square"]
        a *= (self.length(take["link"], take["then"]) * self.mu[P]) ** take["power"]
        return self.page.write(A, name, a / self.mu[take["mu"]])

    def coriolis(self, name: str, of: str, rate: str) -> float:
        """Calculate the mm of a Coriolis component 2ωv."""
        take = self.take(A, name, "Coriolis", of=of, rate=rate, factor=2.0, mu=A, power=1, ago=0)
        page = self.before(take["ago"])[-1]
        rates = {"omega1": self.given["omega"], **{n: w for (_, n), w in page.rates.items()}}
        a = take["factor"] * abs(rates[take["rate"]]) ** take["power"]
        a *= self.page.lengths[V, take["of"]] * self.mu[V]
        return self.page.write(A, name, a / self.mu[take["mu"]])
