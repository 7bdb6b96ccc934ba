"""Series of pictures as sheets tell them, asked of the drawings alone: what stands where, and what is read."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache

from graphic_tmm.board.record import Construction
from graphic_tmm.board.values import Point
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.handout.chosen import Chosen, chosen
from graphic_tmm.handout.handout import framed_series
from graphic_tmm.handout.series import Series, series
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Sheet, Stroke
from graphic_tmm.paper.lettering.letters import plain
from graphic_tmm.readers.protocol import plans
from support.boards import in_usual_size
from support.gallery import scene

LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉₊₋⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", 2 * "0123456789+−")


def spoken(name: str, language: str = "") -> DrawnScene:
    """A scene of the package, drawn in its usual size, in its own language or another one."""
    return _spoken(name, language or scene(name).language)


@cache
def _spoken(name: str, language: str) -> DrawnScene:
    own = scene(name).language == language
    return in_usual_size(scene(name) if own else replace(scene(name), language=language))


@cache
def told(name: str, language: str = "") -> tuple[tuple[Chosen, Series], ...]:
    """Every series of a scene of the package, with the view that it is of."""
    some = chosen(spoken(name, language), plans(), None)
    return tuple((one, series(one.drawn, one.draw, one.place, one.untold)) for one in some)


@cache
def papers(name: str, language: str = "") -> tuple[Sheet, ...]:
    """The sheets of every series of a scene of the package."""
    found = [one for _, one in told(name, language)]
    return tuple(framed_series(spoken(name, language).scene, found))


def drawn_last(log: Construction, view: Drawing) -> dict[int, set[int | None]]:
    """The steps that a view has ink or letters of, by slot: where each is drawn (None: in all positions).

    What stands on several marks is there with the last of them; names of points in one place with the first,
    which may be given.
    """
    order = {step.it.slot: n for n, step in enumerate(log.steps)}
    points = {one.slot for one in (*log.given, *(s.it for s in log.steps)) if one.kind is Point}
    places: dict[int, set[int | None]] = {}
    for one in (*view.strokes, *view.rubbed, *view.labels):
        there = [slot for slot in one.of if slot in order]
        named = isinstance(one, Label) and len(one.of) > 1 and points.issuperset(one.of)
        if named and one.text.count(", ") == len(one.of) - 1:
            there = [] if len(there) < len(one.of) else [min(there, key=order.__getitem__)]
        if there:
            places.setdefault(max(there, key=lambda slot: order[slot]), set()).add(one.position)
    return places


def shape_of(stroke: Ink) -> tuple[float, ...]:
    """Where a stroke lies, to a thousandth of a millimetre, whatever its pen."""
    if isinstance(stroke, Stroke):
        return tuple(round(x, 3) + 0.0 for vertex in stroke.path for x in vertex[:2])
    return tuple(round(x, 3) + 0.0 for z in stroke.controls for x in (z.real, z.imag))


def read(text: str) -> str:
    """Lettering or plain text as one reads it aloud: without what tells indices, brackets and spaces apart."""
    return re.sub(r"[\s_^(){}\\]", "", text.translate(LOWERED))


def lettered(drawing: Drawing) -> str:
    """All that is lettered on a drawing, read aloud."""
    return read("".join(plain(label.text) for label in drawing.labels))
