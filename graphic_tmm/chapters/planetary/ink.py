"""The planetary train in ink: circles and scheme on one axis, velocities beside them, their plan below.

Everything stands where the log has it; what a step leaves is read off the log, bodies are those that the plan
tells. The lines of projection run from the circles to the zero line.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import shapely

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.chapters.planetary.formulas import next_satellite
from graphic_tmm.chapters.planetary.ink_circles import (
    circle_letters,
    circle_rules,
    draw_circle_bodies,
)
from graphic_tmm.chapters.planetary.ink_numbers import BESIDE, TrainInk
from graphic_tmm.chapters.planetary.ink_rates import (
    draw_pole,
    picture_letters,
    picture_rules,
    rate_letters,
    rate_rules,
)
from graphic_tmm.chapters.planetary.ink_scheme import draw_scheme, occupied, spots
from graphic_tmm.chapters.planetary.pictures import VIEW
from graphic_tmm.chapters.planetary.plan import Planetary
from graphic_tmm.chapters.planetary.rates import RATES, VELOCITIES
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Wanted
from graphic_tmm.paper.figure import body, figure, showing
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.lettering.letters import (
    letter,
)
from graphic_tmm.paper.rules import rule_of
from graphic_tmm.paper.seen import Seen
from graphic_tmm.paper.shapes import box
from graphic_tmm.paper.views import wrapped

NAME = "planetary"
VIEWS = (VIEW, VELOCITIES, RATES)
"""The plans that are drawn as one."""
TRACELESS = frozenset({next_satellite.name})
"""Operations that leave no trace: the axis of a satellite is there already."""
PITCH = 0.6
"""Clear height between the lines of a caption, of the height of its letters."""
COLUMN = 24.0
"""Lines below the plan of rates wider than it are broken, but not into shorter ones; of their height."""
BELOW = (5.0, 8.0, 9.0)
"""From the views, the axis and the pole down to their captions, mm."""


class Captions(NamedTuple):
    """Lines of lettering (mark-up) below the two views, the picture of velocities, the plan of rates."""

    views: Sequence[str] = ()
    velocities: Sequence[str] = ()
    rates: Sequence[str] = ()


def draw_planetary_ink(
    construction: Construction,
    reading: Reading,
    made: Planetary,
    captions: Captions,
    title: str,
    heights: Heights,
) -> Drawing:
    """Return the train in two views with the picture of linear and the plan of angular velocities.

    ``reading``: everything of the train's log. The first line of each caption is its title.
    """
    seen = Seen(construction, reading, VIEWS, range(made.train.satellites))
    ink = TrainInk(seen, made, heights)
    traces = figure(seen, showing(circle_rules(ink) | picture_rules(ink) | rate_rules(ink)))
    strokes = (*traces.staying, *draw_circle_bodies(ink), *_scheme(ink), *draw_pole(ink))
    wanted = [*_numbers(ink), *circle_letters(ink), *picture_letters(ink), *rate_letters(ink)]
    return Drawing(
        NAME,
        title,
        strokes,
        tuple(_with_steps(ink, _captions(ink, captions))),
        rubbed=traces.rubbed,
        shows=VIEWS,
        numbers=tuple((k, str(k + 1)) for k in seen.positions),
        wanted=tuple(wanted),
    )


def _bodies(ink: TrainInk) -> Mapping[str, tuple[Mark, ...]]:
    """What the bodies of the scheme stand on, by their names."""
    told = [figure for kind in ("disc", "pair", "arm") for figure in ink.figures(kind)]
    return {figure.name: figure.marks for figure in told}


def _scheme(ink: TrainInk) -> Iterator[Ink]:
    marks = _bodies(ink)
    rims = [mark for wheel in ink.wheels[1:-1] for mark in marks[wheel]]
    for name, strokes in draw_scheme(ink.scheme):
        on = (*rims, *marks[name]) if name == "H" else marks[name]
        yield from body(strokes, "carrier" if name == "H" else "wheel", on)


def _numbers(ink: TrainInk) -> Iterator[Wanted]:
    """The numbers of the wheels in the scheme, the letter of its carrier."""
    marks = _bodies(ink)
    for name, (at, toward) in spots(ink.scheme).items():
        of = tuple(mark.slot for mark in marks[name])
        yield Wanted(name, at, ink.heights.point, BESIDE, toward, of)


def _with_steps(ink: TrainInk, captions: Sequence[Sequence[Label]]) -> Iterator[Label]:
    """Yield the captions: titles and scales come with the first step of a picture, results with its last."""
    for view, lines in zip(VIEWS, captions, strict=True):
        steps = [step.it.slot for step in ink.seen.steps if step.it.view == view and rule_of(step)]
        for k, one in enumerate(lines):
            yield one._replace(of=(steps[0 if k < 2 else -1],) if steps else ())


def _captions(ink: TrainInk, captions: Captions) -> list[list[Label]]:
    """The captions: below the two views, between picture and plan, below the plan.

    One that would stand on another, or on the pair behind the train, goes below it; that of the picture keeps
    clear of the scheme.
    """
    picture = [z.real for z in (*ink.zeros, *ink.tips)]
    rates = [z.real for z in (ink.foot, *ink.ends.values())]
    views = [ink.centre.real - ink.beyond, ink.scheme.right]
    low = min([ink.centre.imag - ink.beyond, *(side.far.imag for side in ink.scheme.pair.values())])
    heights = (low, ink.centre.imag, ink.pole.imag)
    half = (min(picture) + max(picture)) / 2 - ink.scheme.right - 2.0
    widths = (math.inf, 2 * half, max(max(rates) - min(rates), COLUMN * ink.heights.point))
    labels: list[list[Label]] = []
    taken = [shapely.box(*sides) for sides in occupied(ink.scheme)]
    for lines, xs, y, down, most in zip(
        captions, (views, picture, rates), heights, BELOW, widths, strict=True
    ):
        sizes = (ink.heights.title, *[ink.heights.point] * len(lines))
        told = [
            (part, size)
            for text, size in zip(lines, sizes, strict=False)
            for part in _broken(text, size, most)
        ]
        middle = (min(xs) + max(xs)) / 2
        block = _block(told, middle, y - down)
        if any(shapely.intersects(box(one), other) for one in block for other in taken):
            lowest = min(other.bounds[1] for other in taken)
            block = _block(told, middle, min(y - down, lowest - PITCH * ink.heights.point))
        labels.append(block)
        taken += [box(one) for one in block]
    return labels


def _broken(text: str, size: float, most: float) -> list[str]:
    """Return a line of a caption in lines no wider than ``most`` mm: an equality before its signs =."""
    first, *rest = text.split(" = ")
    if not rest:
        return wrapped(text, size, most)
    lines = [f"{first} = {rest[0]}"]
    for part in rest[1:]:
        longer = f"{lines[-1]} = {part}"
        if letter(longer, size=size).width <= most:
            lines[-1] = longer
        else:
            lines.append(f"= {part}")
    return lines


def _block(lines: Sequence[tuple[str, float]], middle: float, y: float) -> list[Label]:
    """Lines of a caption, each in its height, the first just below a height."""
    labels = []
    for text, size in lines:
        made = letter(text, size=size)
        y -= made.ascent
        labels.append(Label(text, complex(middle, y), size, "middle"))
        y -= made.descent + PITCH * size
    return labels
