"""What is asked of instantaneous centres: the positions that are drawn, their scale (SI)."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Section, key
from graphic_tmm.scene.tasks import SectionKey

CENTRES = "centres"


@dataclass(frozen=True)
class CentresTask:
    """Instantaneous centres in some ``positions``, or ("all",); ``mu_l``: the scale of their scheme, m/mm."""

    positions: tuple[str, ...] = key(v.POSITIONS, "positions whose centres are drawn", [3])
    mu_l: float | None = key(v.MU_L, "the scale of lengths of their scheme", "0.005 m/mm", None)


ASKED: SectionKey[CentresTask] = SectionKey(CENTRES)

SECTIONS = (
    Section(CENTRES, CentresTask, "instantaneous centres of links", begin="positions = [1]"),
)
