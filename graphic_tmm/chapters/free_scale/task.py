"""What is asked of a plan of velocities to a free scale: by which link, in which position."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Section, key
from graphic_tmm.scene.tasks import SectionKey

FREE_SCALE = "free_scale"


@dataclass(frozen=True)
class FreeScaleTask:
    """Velocities by another driving link, to a free scale.

    ``link``: a leg of a plate that turns about the frame, None: the last of the first plate; ``at``: the
    position, None: the first.
    """

    link: int | None = key(
        v.LINK_NUMBER, "the leg that is taken as the driving link; left out: the last", 5, None
    )
    at: str | None = key(v.POSITION, "the position that is drawn; left out: the first", 1, None)


ASKED: SectionKey[FreeScaleTask] = SectionKey(FREE_SCALE)

SECTIONS = (
    Section(
        FREE_SCALE, FreeScaleTask,
        "velocities of a group of class III by another driving link, to a free scale",
        begin='at = 1',
    ),
)  # fmt: skip
