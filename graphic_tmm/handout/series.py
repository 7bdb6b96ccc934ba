"""A view as a series of pictures: how large they are drawn, what each of them shows and tells."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import NamedTuple

import shapely

from graphic_tmm.drawn import Drawn
from graphic_tmm.handout.ink import Bare, bare, done, enlarged, new
from graphic_tmm.handout.story import StoryPicture, story
from graphic_tmm.handout.words import letters_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Ink, Label
from graphic_tmm.paper.packing import Box, bounds
from graphic_tmm.paper.shapes import box
from graphic_tmm.readers.narration import ProtocolLine
from graphic_tmm.scene.captions import view_name

FACTORS = (10.0, 5.0, 4.0, 2.5, 2.0, 1.0, 1 / 2, 1 / 2.5, 1 / 4, 1 / 5, 1 / 10, 1 / 20, 1 / 50)
"""How many times larger a view may be drawn: the row of ГОСТ 2.302 and ISO 5455."""
REPEATED = 2.0
"""Pictures of other positions are at least so many times smaller."""

Draw = Callable[[float, bool], Drawing]
"""A view for a picture so many times as large; lettered? else with about the room that its letters take."""


class Manner(NamedTuple):
    """How pictures stand on a sheet: in how many columns, whether their sentences stand beside them.

    ``width``, ``height``: the room of a picture; ``text``: the width of its sentences, mm.
    """

    columns: int
    beside: bool
    width: float
    height: float
    text: float


GAP = 6.0
"""Between columns, and between a picture and sentences beside it, mm."""
FULL = 174.0
"""Of a sheet's width, mm."""
COLUMN = (FULL - GAP) / 2
WIDER = 100.0
"""The width of a picture that has its sentences beside it, mm."""
_BELOW, _BESIDE = (
    Manner(2, False, COLUMN, 70.0, COLUMN),
    Manner(1, True, WIDER, 64.0, FULL - WIDER - GAP),
)
MANNERS = (
    (_BELOW, 1 / 2),
    (_BESIDE, 1 / 2),
    (_BELOW, 1 / 2.5),
    (_BESIDE, 1 / 2.5),
    (_BELOW._replace(height=165.0), 1 / 2),
    (_BESIDE._replace(height=95.0), 1 / 2),
    (Manner(1, False, FULL, 85.0, FULL), 1 / 2),
    (_BELOW._replace(height=165.0), 1 / 4),
    (Manner(1, False, FULL, 85.0, FULL), 1 / 4),
    (Manner(1, False, FULL, 185.0, FULL), 1 / 2.5),
)
"""In this order they are tried, each with how small a view may become for it: four to six pictures on a sheet,
three, two, one. Chosen by eye."""


class Sized(NamedTuple):
    """A view as large as it is drawn: how many times larger than on its own sheet, how it stands."""

    bare: Bare
    factor: float
    manner: Manner


def fitting(draw: Draw, names: Sequence[str]) -> Sized:
    """Return a view in the first manner in which it is not much smaller and its letters have room.

    ``names``: see `bare`.

    Where there is none, it is as large as a sheet holds it.
    """

    @cache
    def at(factor: float, lettered: bool = True) -> Bare:
        made = bare(draw(factor, lettered), names)
        return made._replace(view=enlarged(made.view, factor))

    x0, y0, x1, y1 = bounds(whole(at(1.0, False).view)._replace(labels=()))

    def holds(manner: Manner, factor: float, lettered: bool) -> bool:
        if factor * (x1 - x0) > manner.width or factor * (y1 - y0) > manner.height:
            return False
        left, low, right, high = bounds(whole(at(factor, lettered).view))
        return right - left <= manner.width and high - low <= manner.height

    usual = crowded(at(1.0).view)

    def largest(manner: Manner, least: float) -> float:
        tried = (one for one in FACTORS if one >= least)
        return next((f for f in tried if holds(manner, f, False) and holds(manner, f, True)), 0.0)

    for manner, least in MANNERS:
        factor = largest(manner, least)
        if factor and crowded(at(factor).view) <= usual:
            return Sized(at(factor), factor, manner)
    factor = largest(manner, 0.0) or FACTORS[-1]
    return Sized(at(factor), factor, manner)


def smaller(factor: float) -> float:
    """Return the standard factor of pictures that only repeat those of another.

    >>> smaller(1.0), smaller(0.4)
    (0.5, 0.2)
    """
    return next((one for one in FACTORS if one <= factor / REPEATED), FACTORS[-1])


def whole(view: Drawing) -> Drawing:
    """Return a view with what is rubbed out of it."""
    return view._replace(strokes=(*view.strokes, *view.rubbed))


def crowded(view: Drawing) -> int:
    """Return how many pairs of letters stand on one another."""
    there = [box(label) for label in view.labels]
    pairs = shapely.STRtree(there).query(there, predicate="overlaps")
    return int(pairs.shape[1]) // 2


GIVEN = said("Given: what is there before the first step.")
READY = said("Ready: what only helped is rubbed out.")
AGAIN = said("The same in position {name}.")


class Picture(NamedTuple):
    """A picture as it is drawn: its number, its ink and letters (mm, as large as it stands), what it tells.

    ``marks``: slots of the marks whose steps are done in it; ``again``: in another position than the first.
    """

    number: int
    ink: tuple[Ink, ...]
    letters: tuple[Label, ...]
    lines: tuple[ProtocolLine, ...]
    marks: tuple[int, ...] = ()
    again: bool = False


class Series(NamedTuple):
    """A view, picture by picture.

    ``told``: lines of its caption (mark-up); ``factor``: how many times larger it is than on its own sheet;
    ``box``: of all pictures together, mm; ``manner``: how they stand on a sheet; ``letters``: see
    `words.letters_of`. ``ready``: the last picture is the view without what only helped.
    """

    name: str
    title: str
    told: tuple[str, ...]
    factor: float
    box: Box
    manner: Manner
    pictures: tuple[Picture, ...]
    letters: dict[str, str]
    language: str
    ready: bool = False


def series(drawn: Drawn, draw: Draw, place: int, untold: frozenset[int] = frozenset()) -> Series:
    """Return the series of a view that begins with a position (index); ``untold``: see `story`."""
    language = drawn.scene.language
    names = [view_name(name, language) for name in draw(1.0, False).shows]
    speech = speaking(language)
    sized = fitting(draw, names)
    view = sized.bare.view
    made = _begun(story(drawn, view, place, language, untold))
    found: list[Picture] = []
    before: list[Ink] = []
    letters: list[Label] = []
    for n, one in made:
        ink = one.picture.ink
        fresh = done(ink) if one.picture.given else new(ink)
        letters += one.picture.letters
        shown, lines, marks = (*done(before), *fresh), _lines(one, speech), one.picture.marks
        found.append(Picture(n, shown, tuple(letters), lines, marks, one.picture.again))
        before += ink
    if view.rubbed:
        ready = ProtocolLine(0, speech(READY))
        found.append(Picture(found[-1].number + 1, view.strokes, view.labels, (ready,)))
    log, title = drawn.construction, view.title
    return Series(
        view.name,
        title,
        sized.bare.told,
        sized.factor,
        bounds(whole(view)),
        sized.manner,
        tuple(found),
        dict(letters_of(log, language)),
        language,
        bool(view.rubbed),
    )


def _begun(made: Sequence[StoryPicture]) -> Iterator[tuple[int, StoryPicture]]:
    """Yield pictures with their numbers; where nothing is given, what is told of it goes with a step."""
    waiting: tuple[ProtocolLine, ...] = ()
    for n, one in enumerate(made):
        if n == 0 and not one.picture.ink:
            waiting = one.lines
            continue
        yield n, one._replace(lines=(*waiting, *one.lines))
        waiting = ()


def _lines(one: StoryPicture, speech: Callable[..., str]) -> tuple[ProtocolLine, ...]:
    """Return what a picture tells: the given and repetitions in a sentence of their own."""
    if one.picture.given:
        return (ProtocolLine(0, speech(GIVEN)), *one.lines)
    if one.position:
        return (ProtocolLine(0, speech(AGAIN, name=one.position)), *one.lines)
    return one.lines
