"""What a view of a board shows, and the view with its letters and its caption."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.record import Mark
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.views import captioned


def subject(drawn: Drawn, title: str, *places: str, name: str = "") -> Subject:
    """Return a board as what a view shows, lettered as on the sheets of its ``places``; see `heights`."""
    high, language = heights(drawn.scene, *places), drawn.scene.language
    return Subject(drawn.construction, drawn.reading, title, high, language, name)


def with_caption(
    view: Drawing, on: Subject, lettered: bool, *lines: str, known: Sequence[Mark] = ()
) -> Drawing:
    """Return a view with its letters placed, its title and more lines below it; see `finished`, `captioned`."""
    placed, high = finished(view, lettered), on.heights
    return captioned(placed, on.title, *lines, heights=high, known=known)
