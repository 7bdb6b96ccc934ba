"""A view made ready: letters find their places, thin lines give way; points in one place share a label."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from graphic_tmm.paper.drawing import Drawing, Wanted
from graphic_tmm.paper.label_places import CLEAR
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.packing import bounds

TOGETHER = 0.35
"""Points nearer than this, mm, share one label."""


def finished(view: Drawing, lettered: bool = True) -> Drawing:
    """Return a view with its wanted letters placed; not ``lettered``: with about the room that they take.

    What is wanted nowhere (NaN, infinite) is left out.
    """
    view = view._replace(wanted=tuple(one for one in view.wanted if cmath.isfinite(one.at)))
    if not view.wanted:
        return view
    if not lettered:
        boxes = [_about(one) for one in view.wanted]
        if view.strokes or view.labels or view.cell is not None:
            boxes.append(bounds(view._replace(wanted=())))
        sides = list(zip(*boxes, strict=True))
        cell = (min(sides[0]), min(sides[1]), max(sides[2]), max(sides[3]))
        return view._replace(cell=cell, wanted=())
    labels = place(view.wanted, view.strokes, view.labels)
    whole = (*view.labels, *labels)
    strokes = interrupt([*view.strokes, *leaders(view.wanted, labels)], whole)
    return view._replace(strokes=strokes, labels=whole, wanted=())


def _about(one: Wanted) -> tuple[float, float, float, float]:
    """Return about where a letter will stand: beside its point, on the preferred side if there is one."""
    made = letter(one.text, size=one.size)
    wide, high = made.width / 2 + CLEAR, (made.ascent + made.descent) / 2 + CLEAR
    at = one.at
    if one.toward:
        way = one.toward / abs(one.toward)
        reach = 1.0 / max(abs(way.real) / wide, abs(way.imag) / high, 1e-9)
        at += way * (one.radius + reach)
    else:
        wide, high = wide + one.radius, high + one.radius
    return at.real - wide, at.imag - high, at.real + wide, at.imag + high


class Named(NamedTuple):
    """A point that is to be lettered: where it is, mm; what it is called (mark-up); its mark and position."""

    at: complex
    text: str
    of: tuple[int, ...] = ()
    position: int | None = None


def shared(points: Iterable[Named], together: float = TOGETHER) -> list[Named]:
    """Return points with those in one place as one, their names in the order met, each name once.

    It belongs to the last of their positions: then all of them are there. What is not there is left out.
    """
    groups: list[list[Named]] = []
    for one in points:
        if not cmath.isfinite(one.at):
            continue
        near = next((group for group in groups if abs(group[0].at - one.at) < together), None)
        if near is None:
            groups.append([one])
        else:
            near.append(one)
    return [_joined(group) for group in groups]


def _joined(group: Sequence[Named]) -> Named:
    texts = dict.fromkeys(one.text for one in group)
    slots = dict.fromkeys(slot for one in group for slot in one.of)
    position = max((one.position for one in group if one.position is not None), default=None)
    return Named(group[0].at, ", ".join(texts), tuple(slots), position)


def lettered(
    points: Iterable[Named], size: float, radius: float = 1.0, away_from: complex | None = None
) -> list[Wanted]:
    """Return the letters wanted at points, preferably on the side away from a place (mm) if one is told."""
    return [
        Wanted(
            one.text,
            one.at,
            size,
            radius,
            0j if away_from is None else one.at - away_from,
            one.of,
            one.position,
        )
        for one in points
    ]
