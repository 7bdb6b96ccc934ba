"""What is asked of hodographs: the points, that of accelerations, the analogues."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Said, Section, key
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

HODOGRAPH = "hodograph"
TABLE = "hodograph table"
"""The place of the tables."""


@dataclass(frozen=True)
class HodographTask:
    """Hodographs of the velocities of ``points``.

    ``accelerations``: of these, too; ``analogues``: dS/dφ and d²S/dφ² of the points are told.
    """

    points: tuple[str, ...] = key(
        v.LETTERS, "the points whose velocities are carried to a pole", ["C"]
    )
    accelerations: bool = key(
        v.SWITCH, "whether the hodographs of accelerations are drawn, too", True, False
    )
    analogues: bool = key(
        v.SWITCH, "whether the analogues dS/dφ and d²S/dφ² of the points are told", True, False
    )


def _check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    """Every letter that is none."""
    for k, letter in enumerate(asked.points):
        yield from parts.moves((HODOGRAPH, "points", k), letter)
    yield from parts.intervals(HODOGRAPH)


ASKED: SectionKey[HodographTask] = SectionKey(HODOGRAPH)

SECTIONS = (
    Section(
        HODOGRAPH, HodographTask, "hodographs of velocities and accelerations; analogues",
        begin='points = ["B"]', check=_check,
    ),
)  # fmt: skip
