"""The synthesis: how the lengths of the mechanism follow from the task."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.execute import execute
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.note.bricks import heading
from graphic_tmm.note.document import Block
from graphic_tmm.note.protocol import Manner, protocol_blocks
from graphic_tmm.note.steps import Told
from graphic_tmm.readers.protocol import SYNTHESIS
from graphic_tmm.readers.protocol import synthesis as found_for
from graphic_tmm.scene.captions import view_name


def synthesis(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the section of the synthesis, if the scene states a task."""
    found = found_for(made.scene)
    if found is None:
        return
    reading = execute(found.construction, found.given)
    yield heading(view_name(SYNTHESIS, language), 1)
    yield from protocol_blocks(
        Told(SYNTHESIS, found.construction, reading, SYNTHESIS, 0, language), Manner()
    )
