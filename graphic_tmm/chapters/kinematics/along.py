"""What other chapters draw along the guides of the plan of positions, beside the mechanism, to its scale."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted
from graphic_tmm.scene.chapter import Answer


class AlongGuide(NamedTuple):
    """Ink along a guide, letters that want a place, what is told of it under the plan (mark-up), or ""."""

    strokes: tuple[Ink, ...]
    wanted: tuple[Wanted, ...]
    told: str


@dataclass(frozen=True)
class AlongGuides(Answer):
    """What a chapter draws along guides, clear of a plan of positions that is drawn."""

    stands: ClassVar[str] = "views.ALONG"
    draw: Callable[[Drawn, Drawing], Iterable[AlongGuide]] = lambda drawn, view: ()


def with_guides(drawn: Drawn, view: Drawing) -> tuple[Drawing, list[str]]:
    """Return a plan of positions with what chapters draw along its guides, and what they tell of it."""
    told = list[str]()
    for chapter in drawn.project.chapters:
        for one in AlongGuides.of(chapter).draw(drawn, view):
            view = view._replace(
                strokes=(*view.strokes, *one.strokes), wanted=(*view.wanted, *one.wanted)
            )
            told += [one.told] if one.told else []
    return view, told
