"""A student's tools: a hand whose slips come from a stream of their own, points, directions.

Every slip is drawn from a stream of its drawing, position and name, so that a drawing with a mistake and the
honest one have the same slips wherever they agree.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any
from zlib import crc32

import numpy as np

from support.another_hand import Pencil
from support.students.records import (
    POLES,
    Hand,
    Machine,
    Mind,
    Operands,
    P,
    Page,
    Step,
    Way,
    honest,
)


class _Stream:
    """Numbers of a hand; what `Pencil` asks of a generator."""

    def __init__(self, hand: Hand, seed: tuple[int, ...]) -> None:
        self.hand, self.of = hand, np.random.default_rng(seed)

    def standard_normal(self, size: int | None = None) -> Any:
        if self.hand.tails is None:
            return self.of.standard_normal(size)
        # as wide as a normal one at the median
        return self.of.standard_t(self.hand.tails, size) * 0.88


class Tools:
    """A hand with its slips, and what stands on the paper so far."""

    def __init__(
        self,
        machine: Machine,
        hand: Hand,
        seed: int,
        mind: Mind = honest,
        given: Mapping[str, Any] | None = None,
    ) -> None:
        self.machine, self.hand, self.seed, self.mind = machine, hand, seed, mind
        self.mu = dict(machine.mu)
        self.given: dict[str, Any] = {**machine.given, **(given or {})}
        self.pen = Pencil(
            np.random.default_rng(seed), hand.ruler, swing=hand.swing, slip=hand.slip,
            pointing=hand.pointing,
        )  # fmt: skip
        self.k = 0
        self.steps: list[Step] = []
        self.pages: list[Page] = []
        self.page = Page({}, {}, {}, {})

    @property
    def accelerated(self) -> bool:
        return self.k in self.machine.accelerated

    # ---- what every step does -------------------------------------------------------------------------------

    def take(self, plan: str, name: str, kind: str, **takes: Any) -> Operands:
        """Tell a step; return what the student takes for it."""
        step = Step(plan, name, kind, takes, self.k)
        self.steps.append(step)
        return {**takes, **self.mind(step)}

    def _slips(self, what: str) -> Pencil:
        self.pen.rng = _Stream(self.hand, (self.seed, self.k, crc32(what.encode())))  # type: ignore[assignment]
        return self.pen

    def ray(self, what: str, along: complex) -> complex:
        return self._slips(f"ray {what}").ray(what, along)

    def ruled(self, what: str, length: float) -> float:
        """Read a length, never negative, off the ruler."""
        pen = self._slips(f"read {what}")
        return pen.read(complex(length * self.hand.copy))

    def signed(self, what: str, length: float) -> float:
        """Read an ordinate with its sign."""
        pen = self._slips(f"read {what}")
        return pen.rounded(length * self.hand.copy + pen.slip * pen.rng.standard_normal())

    def spot(self, what: str, z: complex, pole: complex = 0j) -> tuple[float, float]:
        return self._slips(f"spot {what}").spot((z - pole) * self.hand.copy)

    def opened(self, length: float) -> float:
        """Return a length as the compass lays it off."""
        return length * self.hand.compass

    # ---- what is drawn --------------------------------------------------------------------------------------

    def at(self, plan: str, letter: str, ago: int = 0) -> complex:
        """Return where a point stands; poles at 0. ``ago``: on the plan of an earlier position."""
        pages = self.pages[: len(self.pages) - ago] or self.pages[:1]
        for page in reversed(pages):
            if (plan, letter) in page.points:
                return page.points[plan, letter]
            if letter == POLES.get(plan) or (plan, letter) == (P, "O"):
                return 0j
            if letter in self.given:
                return complex(self.given[letter])
        raise KeyError((plan, letter))

    def vector(self, plan: str, letters: str, ago: int = 0) -> complex:
        return self.at(plan, letters[1], ago) - self.at(plan, letters[0], ago)

    def way(self, way: Way, ago: int = 0) -> complex:
        """Return the direction that a way names."""
        how, of = way
        guides = {"x": 1 + 0j, "y": 1j}
        along = guides[of] if of in guides else self.vector(P, of, ago)
        if along == 0:
            along = 1 + 0j
        return along / abs(along) * (1j if how == "square" else 1.0)

    def put(self, plan: str, letter: str, z: complex) -> complex:
        self.page.points[plan, letter] = complex(z)
        return complex(z)
