"""What a task asks of a pair of gears, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.gears.given import given, stated
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the dimensions, the meshing, the contact ratio, the sliding."""
    _ = speaking(language)
    yield from (_(one) for one in (_DIMENSIONS, _MESHING, _CONTACT, _SLIDING))


_DIMENSIONS = said("The dimensions of the gear pair are calculated.")
_MESHING = said(
    "The meshing is drawn: the line of action with its working part, the construction of the "
    "flanks, three teeth of each wheel, the active flanks."
)
_CONTACT = said("The contact ratio is found from the drawing and by the formula.")
_SLIDING = said("The diagram of specific sliding is drawn.")


TASK_SHEET = TaskSheet(
    given=given,
    stated=stated,
    wanted={"gears": asks},
)
