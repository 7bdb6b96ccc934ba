"""A view as a series of pictures: how large they are drawn, what each of them shows and tells."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.drawn import Drawn
from graphic_tmm.handout.ink import done, new
from graphic_tmm.handout.sized import Draw, Manner, fitting, whole
from graphic_tmm.handout.story import Told, story
from graphic_tmm.handout.words import letters_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Ink, Label
from graphic_tmm.paper.packing import Box, bounds
from graphic_tmm.readers.narration import Line
from graphic_tmm.scene.captions import view_name

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
    lines: tuple[Line, ...]
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
        ready = Line(0, speech(READY))
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


def _begun(made: Sequence[Told]) -> Iterator[tuple[int, Told]]:
    """Yield pictures with their numbers; where nothing is given, what is told of it goes with a step."""
    waiting: tuple[Line, ...] = ()
    for n, one in enumerate(made):
        if n == 0 and not one.picture.ink:
            waiting = one.lines
            continue
        yield n, one._replace(lines=(*waiting, *one.lines))
        waiting = ()


def _lines(one: Told, speech: Callable[..., str]) -> tuple[Line, ...]:
    """Return what a picture tells: the given and repetitions in a sentence of their own."""
    if one.picture.given:
        return (Line(0, speech(GIVEN)), *one.lines)
    if one.position:
        return (Line(0, speech(AGAIN, name=one.position)), *one.lines)
    return one.lines
