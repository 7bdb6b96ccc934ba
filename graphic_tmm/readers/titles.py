"""What the views of a recorded project are called."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import ClassVar

from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.scene.captions import view_name
from graphic_tmm.scene.chapter import Answer, Holder


@dataclass(frozen=True)
class Protocols(Answer):
    """What a chapter tells protocols.

    ``views``: the views of the board that each of its plans is drawn in. ``equations``: a view -> lines that
    stand before its protocol. ``titles``: a view -> what it is called in the protocol of what was made, where
    that tells more.
    """

    stands: ClassVar[str] = "table.PROTOCOL"
    views: Callable[[Project], Mapping[str, Iterable[str]]] = lambda project: {}
    equations: Callable[[Drawn, str, str], Iterable[str]] = lambda drawn, view, language: ()
    titles: Callable[[Holder, str, str], str] = lambda holder, view, language: ""


def title_of(project: Project, view: str, language: str) -> str:
    """Return what a view is called, as plain text; a chapter may tell more of it by what was made."""
    titles = (Protocols.of(one).titles(project, view, language) for one in project.chapters)
    return next((title for title in titles if title), "") or view_name(view, language)
