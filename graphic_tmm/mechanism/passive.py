"""Passive links: they double what others hold already, so that their pairs are left out of W.

A passive link stands where its letters on other links stand: two of them, or one and a guide.
"""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.mechanism.groups import Pair
from graphic_tmm.mechanism.records import Link, Mechanism


class Hold(NamedTuple):
    """How a passive link is held: by its turning pairs, and by its sliding pair if it has one.

    The other link of a turning pair is the earliest of those that bear its letter.
    """

    link: Link
    pins: tuple[Pair, ...]
    guide: Pair | None

    @property
    def pairs(self) -> tuple[Pair, ...]:
        """All of its pairs."""
        return self.pins if self.guide is None else (*self.pins, self.guide)


def holds(mechanism: Mechanism) -> tuple[Hold, ...]:
    """Return how the passive links are held, in the order of their numbers."""
    return tuple(
        _hold(mechanism, link) for link in sorted(mechanism.passive, key=lambda one: one.number)
    )


def _hold(mechanism: Mechanism, link: Link) -> Hold:
    pins = []
    for letter in link.points:
        on = [n for n, body in mechanism.by_number.items() if letter in body.points]
        pins += [Pair("R", letter, (link.number, body)) for body in on[:1]]
    guides = [Pair("P", one.guide.name, (link.number, one.on), one) for one in link.slides]
    return Hold(link, tuple(pins), next(iter(guides), None))
