"""What a picture of a construction is drawn with: done strokes thin, the new ones heavy; views made smaller."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import NamedTuple

from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Label
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.lettering.letters import plain
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.views import alone

FORMAT = "A4"
"""The format of the sheets: its pens and its heights of letters."""
HEIGHTS = Heights(3.5, 3.5, 2.5)
"""Heights of letters in pictures: the least of those in the hand, titles within a view no larger, mm."""
DONE: Mapping[str, str] = MappingProxyType(
    {
        "main": "thin",
        "medium": "thin",
        "thick": "thin",
        "rod": "over",
        "body": "outline",
        "joint": "pin",
    }
)
"""With what a stroke is drawn that was there before, by its own pen; others stay as they are."""
NEW: Mapping[str, str] = MappingProxyType({"thin": "main", "medium": "main", "over": "rod"})
"""With what a stroke of a step is drawn when it is new; what is part of a body has the body's own pens."""
ADDED = ("axis", "dimension", "hatching", "leader", "number")
"""Parts of views that are no lines of a construction: they are as thin when they are new."""
WORD = 4
"""What has no more letters is no line of a title."""
EPSILON = 1e-9
"""Lines of lettering nearer to one another, mm, stand on one."""
ROUND = 9
"""Places to which heights of letters are rounded, so that what was made larger and smaller is as it was."""


def in_hand(drawn: Drawn, factor: float) -> Drawn:
    """Return a board whose views, so many times as large, have the letters of a sheet in the hand."""
    scene = drawn.scene
    orders = tuple(replace(order, format=FORMAT) for order in scene.sheets)
    scene = replace(scene, sheets=orders, letters=HEIGHTS.times(1 / factor))
    return replace(drawn, project=replace(drawn.project, scene=scene))


class Bare(NamedTuple):
    """A view without the lines of its caption, and these lines (mark-up)."""

    view: Drawing
    told: tuple[str, ...]


def bare(view: Drawing, names: Sequence[str] = ()) -> Bare:
    """Return a view without its caption and without what a page would read of its strokes.

    ``names``: what the plans are called that it shows: their captions stand within it.
    """
    view = alone(view)
    below = _caption(view)
    within = [one for one in view.labels if one not in below and _inner(one, names)]
    caption = [*below, *within]
    view = view._replace(
        strokes=tuple(_mute(one) for one in view.strokes),
        rubbed=tuple(_mute(one) for one in view.rubbed),
        labels=tuple(label for label in view.labels if label not in caption),
        cell=None,
        apart=None,
        foot=0.0,
    )
    return Bare(view, tuple(label.text for label in caption))


def _inner(label: Label, names: Sequence[str]) -> bool:
    """Whether a line of lettering is the caption of a plan within a view: its name, or its scale factor."""
    text = plain(label.text)
    if len(text) <= WORD:
        return False
    return any(text in name for name in names) or (text.startswith("μ") and " = " in text)


def _caption(view: Drawing) -> list[Label]:
    """Return the lines below a view: its title and what stands below that; they name no mark of their own."""
    title = plain(view.title)
    heads = [one for one in view.labels if len(plain(one.text)) > WORD and plain(one.text) in title]
    lines = [one.at.imag + EPSILON for one in heads]
    foot = max(lines, default=bounds(view)[1] + view.foot - EPSILON)
    own = ((), *(one.of for one in heads))
    return [one for one in view.labels if one.of in own and one.at.imag < foot]


def _mute(stroke: Ink) -> Ink:
    return stroke._replace(title="", data=())


def enlarged(view: Drawing, factor: float) -> Drawing:
    """Return a view so many times as large, its letters and all; none becomes smaller than the least height."""
    return view._replace(
        strokes=tuple(times(one, factor) for one in view.strokes),
        rubbed=tuple(times(one, factor) for one in view.rubbed),
        labels=tuple(
            one._replace(
                at=one.at * factor, size=max(round(one.size * factor, ROUND), HEIGHTS.number)
            )
            for one in view.labels
        ),
    )


def times(stroke: Ink, factor: float) -> Ink:
    """Return a stroke so many times as large, about the origin."""
    if isinstance(stroke, Bezier):
        return stroke._replace(controls=tuple(c * factor for c in stroke.controls))
    path = tuple((x * factor, y * factor, bulge) for x, y, bulge in stroke.path)
    return stroke._replace(path=path, symbol=None)


def done(strokes: Iterable[Ink]) -> Iterator[Ink]:
    """Yield strokes as they are drawn in pictures after their own: thin."""
    for stroke in strokes:
        yield stroke._replace(pen=DONE.get(stroke.pen, stroke.pen))


def new(strokes: Iterable[Ink]) -> Iterator[Ink]:
    """Yield strokes as they are drawn in their own picture: those of the step heavy."""
    for stroke in strokes:
        if stroke.part in ADDED or (stroke.part and stroke.pen == "thin"):
            yield stroke
        else:
            yield stroke._replace(pen=NEW.get(stroke.pen, stroke.pen))
