"""What a task asks of forces by instantaneous centres."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.advantage.task import ADVANTAGE
from graphic_tmm.chapters.centres.task import ASKED as CENTRES_ASKED
from graphic_tmm.chapters.forces.task import ASKED
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene

_MOMENT = said(
    "The balancing moment and the mechanical advantage are found by the instantaneous centres and compared "
    "with the force plans and with the lever."
)
_FORCE = said(
    "The balancing force and the mechanical advantage are found by the instantaneous centres and compared "
    "with the force plans and with the lever."
)
_TOOL = said(
    "The unknown force and the mechanical advantage are found by the instantaneous centres and compared with "
    "the lever."
)


def assignments(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the balance by centres where a scene asks for centres and for forces."""
    order, _ = ASKED.of(scene), speaking(language)
    if order is None or CENTRES_ASKED.of(scene) is None:
        return
    if order.unknown is not None:
        yield _(_TOOL)
    else:
        yield _(_MOMENT if order.balance == "moment" else _FORCE)


TASK_SHEET = TaskSheet(given=lambda scene: (), wanted={ADVANTAGE: assignments})
