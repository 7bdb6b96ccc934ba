"""The planetary train in ink: circles and scheme on one axis, velocities beside them, their plan below.

Everything stands where the log has it; lines of projection run from the circles to the zero line.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import shapely

from graphic_tmm.board.execute import Reading
from graphic_tmm.chapters.planetary.ink_circles import circle_letters, draw_circles
from graphic_tmm.chapters.planetary.ink_numbers import BESIDE, OVER, SIZE, TrainInk
from graphic_tmm.chapters.planetary.ink_rates import (
    draw_picture,
    draw_rates,
    picture_letters,
    rate_letters,
)
from graphic_tmm.chapters.planetary.ink_scheme import draw_scheme, spots
from graphic_tmm.chapters.planetary.plan import Planetary
from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Stroke, Wanted, line
from graphic_tmm.paper.labels import box, interrupt, leaders, place
from graphic_tmm.paper.lettering.letters import (
    letter,
)
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.views import wrapped

NAME = "planetary"
CAPTION, PITCH = 3.5, 2.0
"""Letters of a caption, and clear height between its lines, mm."""
BELOW = (5.0, 8.0, 9.0)
"""From the views, the axis and the pole down to their captions, mm."""
ROOM = 8.0
"""Room for letters about the views before they have their places, mm."""


class Captions(NamedTuple):
    """Lines of lettering (mark-up) below the two views, the picture of velocities, the plan of rates."""

    views: Sequence[str] = ()
    velocities: Sequence[str] = ()
    rates: Sequence[str] = ()


def draw_planetary_ink(
    reading: Reading,
    made: Planetary,
    captions: Captions,
    title: str,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return the train in two views with the picture of linear and the plan of angular velocities.

    ``reading``: everything of the train's log. Unlettered, the drawing has room for its letters.
    """
    ink = TrainInk(reading, made)
    strokes: list[Stroke | Bezier] = [*draw_circles(ink), *draw_scheme(ink.scheme)]
    strokes += [*_levels(ink), *draw_picture(ink), *draw_rates(ink)]
    texts = tuple(_captions(ink, captions))
    if not lettered:
        left, low, right, high = bounds(Drawing(NAME, title, tuple(strokes), texts))
        cell = (left - ROOM, low - ROOM, right + ROOM, high + ROOM)
        return Drawing(NAME, title, tuple(strokes), cell=cell)
    numbers = spots(ink.scheme).items()
    wanted = [Wanted(text, at, SIZE, BESIDE, toward) for text, (at, toward) in numbers]
    wanted += [*circle_letters(ink), *picture_letters(ink), *rate_letters(ink)]
    labels = place(wanted, strokes, texts)
    whole = (*labels, *texts)
    return Drawing(NAME, title, interrupt([*strokes, *leaders(wanted, labels)], whole), whole)


def _levels(ink: TrainInk) -> list[Stroke]:
    """The main axis through both views, the levels of O, A, B and C as far as the zero line."""
    right = complex(ink.scheme.right + OVER, ink.centre.imag)
    strokes = [line("centre", ink.centre - ink.beyond, right), line("thin", right, ink.zeros[0])]
    return strokes + [line("thin", a, b) for a, b in zip(ink.points, ink.zeros[1:], strict=True)]


def _captions(ink: TrainInk, captions: Captions) -> list[Label]:
    """The captions: below the two views, between picture and plan, below the plan.

    One that would stand on another goes below it; that of the picture keeps clear of the scheme.
    """
    picture = [z.real for z in (*ink.zeros, *ink.tips)]
    rates = [z.real for z in (ink.foot, *ink.ends.values())]
    views = [ink.centre.real - ink.beyond, ink.scheme.right]
    heights = (ink.centre.imag - ink.beyond, ink.centre.imag, ink.pole.imag)
    half = (min(picture) + max(picture)) / 2 - ink.scheme.right - PITCH
    widths = (math.inf, 2 * half, math.inf)
    labels: list[Label] = []
    for lines, xs, y, down, most in zip(
        captions, (views, picture, rates), heights, BELOW, widths, strict=True
    ):
        broken = [part for text in lines for part in wrapped(text, CAPTION, most)]
        middle = (min(xs) + max(xs)) / 2
        block = _block(broken, middle, y - down)
        if any(shapely.intersects(box(one), box(other)) for one in block for other in labels):
            lowest = min(shapely.bounds(box(label))[1] for label in labels)
            block = _block(broken, middle, min(y - down, lowest - PITCH))
        labels += block
    return labels


def _block(lines: Sequence[str], middle: float, y: float) -> list[Label]:
    """Lines of a caption, the first just below a height."""
    labels = []
    for text in lines:
        made = letter(text, size=CAPTION)
        y -= made.ascent
        labels.append(Label(text, complex(middle, y), CAPTION, "middle"))
        y -= made.descent + PITCH
    return labels
