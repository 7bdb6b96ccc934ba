"""Pictures whose bodies turn: a cam with its follower, wheels in mesh, a train.

A chapter gives a view's ink sorted by rigid bodies, and how each moves as what drives it turns; what belongs to
none stands. A body is drawn once, as it is at the beginning of the turn: the page moves it as a whole.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.page.dense import drawn_exactly
from graphic_tmm.page.glyphs import Glyphs
from graphic_tmm.page.sentences import indexed
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Sheet, Stroke
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import plain
from graphic_tmm.paper.packing import Box, bounds
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.shapes import outline
from graphic_tmm.paper.write.svg import clean
from graphic_tmm.paper.write.svg_path import path_data
from graphic_tmm.scene.chapter import Answer

WHOLE = 360
"""A turn of what drives, degrees."""
STEP = 10
"""Every so many degrees it is looked how far bodies reach."""
EDGE = 4.0
"""White about a picture, mm."""
PLACES = 4
"""Decimals of a row of angles (degrees) or ways (mm): of a way, thinner than any line."""
Course = float | tuple[float, ...]
"""What goes with the turn: so much of it by degree, or a row that begins anew, one of each degree of a turn."""


class Rotation(NamedTuple):
    """A turn about a centre (complex, mm), counter-clockwise, degrees."""

    centre: complex
    angle: Course

    def moved(self, spots: Complexes, turn: float) -> Complexes:
        """Return where places come."""
        by = cmath.exp(1j * math.radians(along(self.angle, turn)))
        return self.centre + (spots - self.centre) * by


class Shift(NamedTuple):
    """A way in a direction (complex, of length 1), mm."""

    direction: complex
    far: Course

    def moved(self, spots: Complexes, turn: float) -> Complexes:
        """Return where places come."""
        return spots + self.direction * along(self.far, turn)


@dataclass(frozen=True)
class RigidBody:
    """Strokes that move as one: the first of its ``moves`` is its own, the next carries that.

    ``copies``: so many times, evenly about a ``centre``. ``letters`` go with it, upright.
    """

    strokes: tuple[Ink, ...]
    moves: tuple[Rotation | Shift, ...] = ()
    copies: int = 1
    centre: complex = 0j
    letters: tuple[Label, ...] = ()

    def moved(self, spots: Complexes, turn: float) -> Complexes:
        """Return where places of the body come when what drives it has turned so far (degrees)."""
        for move in self.moves:
            spots = move.moved(spots, turn)
        return spots


class TurningValue(NamedTuple):
    """What is told beside a picture: its letter and unit, decimals, how it goes with the turn."""

    letter: str
    unit: str
    places: int
    course: Course


@dataclass(frozen=True)
class TurningPicture:
    """A picture whose bodies turn.

    ``stands``: the ink that does not move, with letters; ``window``: what is seen of the picture (left, bottom,
    right, top, mm), None: all that its bodies reach.
    """

    title: str
    caption: str
    stands: Drawing
    bodies: tuple[RigidBody, ...]
    values: tuple[TurningValue, ...] = ()
    window: Box | None = None


@dataclass(frozen=True)
class TurningPictures(Answer):
    """The ``pictures`` of a chapter whose bodies turn."""

    stands: ClassVar[str] = "moving.PICTURES"
    pictures: Callable[[Drawn], Iterable[TurningPicture]] = lambda drawn: ()


def along(course: Course, turn: float) -> float:
    """Return what goes with the turn, there: between two degrees of a row in proportion."""
    if isinstance(course, tuple):
        return float(np.interp(turn % WHOLE, range(len(course) + 1), (*course, course[0])))
    return course * turn


def row(values: Reals) -> tuple[float, ...]:
    """Return a row, one of each degree of a turn, as the page is told it."""
    return tuple((np.round(values, PLACES) + 0.0).tolist())


def turning_pictures(made: DrawnScene) -> list[TurningPicture]:
    """Return the pictures of a scene whose bodies turn, drawn exactly: bodies touch."""
    return [
        picture
        for drawn in made.boards
        for chapter in drawn.project.chapters
        for picture in TurningPictures.of(chapter).pictures(drawn_exactly(drawn))
    ]


def turning_data(made: DrawnScene, sheets: Sequence[Sheet]) -> dict[str, Any] | None:
    """Return the pictures of a scene whose bodies turn as data; None if it has none."""
    glyphs = Glyphs()
    if not (figures := [_figure(one, glyphs) for one in turning_pictures(made)]):
        return None
    box = pens(sheets[0].format if sheets else "A1")
    return {
        "decimal": decimal_sign(made.scene.language),
        "pens": {
            name: [pen.width, list(pen.dashes), pen.fill, pen.colour] for name, pen in box.items()
        },
        "figures": figures,
        "glyphs": glyphs.made,
    }


def _figure(picture: TurningPicture, glyphs: Glyphs) -> dict[str, Any]:
    still = finished(picture.stands)
    left, low, right, top = picture.window or _reached(still, picture.bodies)
    box = (left - EDGE, -top - EDGE, right - left + 2 * EDGE, top - low + 2 * EDGE)
    return {
        "title": clean(plain(picture.title)),
        "caption": indexed(clean(picture.caption)),
        "box": [round(x, 2) for x in box],
        "still": _strokes(still.strokes),
        "stands": [glyphs.label(label) for label in still.labels],
        "bodies": [_body(body, glyphs) for body in picture.bodies],
        "values": [[indexed(one.letter), *one[1:]] for one in picture.values],
    }


def _body(body: RigidBody, glyphs: Glyphs) -> dict[str, Any]:
    found: dict[str, Any] = {
        "strokes": _strokes(body.strokes),
        "moves": [[isinstance(move, Rotation), *_place(move[0]), move[1]] for move in body.moves],
    }
    if body.copies > 1:
        found["copies"] = [body.copies, *_place(body.centre)]
    if body.letters:
        found["letters"] = [[*glyphs.label(one), *_place(one.at)] for one in body.letters]
    return found


def _strokes(strokes: Iterable[Ink]) -> list[list[Any]]:
    """Return strokes as data, those alike that follow one another as one path: pen, path, whether filled."""
    found: list[list[Any]] = []
    for stroke in strokes:
        filled = isinstance(stroke, Stroke) and stroke.filled
        data = path_data(stroke, 0.0)
        if found and found[-1][::2] == [stroke.pen, filled]:
            found[-1][1] += data
        else:
            found.append([stroke.pen, data, filled])
    return found


def _place(spot: complex) -> list[float]:
    """Return a place as data, y downward."""
    return [round(spot.real, 6) + 0.0, round(-spot.imag, 6) + 0.0]


def _reached(still: Drawing, bodies: Iterable[RigidBody]) -> Box:
    """Return the room that a picture takes over a turn, mm."""
    boxes = [bounds(still)]
    for body in bodies:
        own = np.array([spot for stroke in body.strokes for spot in outline(stroke)])
        for turn in range(0, WHOLE if body.moves else STEP, STEP):
            spots = body.moved(own, turn)
            x, y = spots.real, spots.imag
            boxes.append((float(x.min()), float(y.min()), float(x.max()), float(y.max())))
    lefts, lows, rights, tops = zip(*boxes, strict=True)
    return min(lefts), min(lows), max(rights), max(tops)
