"""What is asked of Klein's construction: the slider, the positions, points of the rod."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Said, Section, key
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

KLEIN, RITTERHAUS, BOTH = "klein", "ritterhaus", "both"
"""Views of the board, and what a scene writes for one of them or for both."""
VIEWS = (KLEIN, RITTERHAUS)
TABLE = "klein table"
"""The place of the table."""
_WAYS = v.choice(BOTH, *VIEWS, оба=BOTH, Клейна=KLEIN, Риттерхауза=RITTERHAUS)


@dataclass(frozen=True)
class KleinTask:
    """Constructions of a slider-crank.

    ``slider``: the letter of the point that slides; None: of the first slider-crank. ``positions``: their
    numbers, or ("all",). ``points``: points of the rod whose velocities and accelerations are found besides.
    ``construction``: one of `VIEWS`, or both.
    """

    slider: str | None = key(
        v.LETTER, "the point of the slider; left out: of the first slider-crank", "B", None
    )
    positions: tuple[str, ...] = key(
        v.POSITIONS, "the positions in which it is drawn", [2, 5], ("all",)
    )
    points: tuple[str, ...] = key(
        v.LETTERS, "points of the rod whose velocity and acceleration are found too", ["S2"], ()
    )
    construction: str = key(_WAYS, "whose construction is drawn", "klein", BOTH)

    @property
    def views(self) -> tuple[str, ...]:
        """The constructions that are drawn."""
        return VIEWS if self.construction == BOTH else (self.construction,)


def _check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    """Every letter that is none."""
    if asked.slider is not None:
        yield from parts.moves((KLEIN, "slider"), asked.slider)
    for k, letter in enumerate(asked.points):
        yield from parts.moves((KLEIN, "points", k), letter)


ASKED: SectionKey[KleinTask] = SectionKey(KLEIN)

SECTIONS = (
    Section(
        KLEIN, KleinTask, "Klein's and Ritterhaus's constructions of a slider-crank",
        begin='slider = "B"', check=_check,
    ),
)  # fmt: skip
