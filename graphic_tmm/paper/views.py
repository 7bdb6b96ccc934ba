"""Views made ready for the sheet: captions below them, cells of one size, stacks."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing, Label, Within
from graphic_tmm.paper.lettering.heights import HEIGHTS, Heights
from graphic_tmm.paper.lettering.letters import (
    letter,
)
from graphic_tmm.paper.packing import bounds, settled

BELOW = 0.7
"""Clear height between two lines of a caption, and between it and its view, of the height of its capitals."""
COLUMN = 12.0
"""A title wider than its view is broken, but never into lines shorter than this, of its height."""
STACK = 5.0
"""Clear height between two diagrams of a stack, mm."""


def mu_text(scale: Scale, language: str) -> str:
    """Return a scale factor as the field writes it: μ_v = 0,1 (м/с)/мм."""
    return f"{scale.symbol} = {number(scale.value, language)} {unit(scale.unit, language)}"


def pole_figures(log: Construction, reading: Reading, view: str, language: str) -> dict[Mark, str]:
    """Return the pole distances of a view (Length) as they are dimensioned: H_V = 20."""
    found = {}
    for pole in log.roles(view, roles.POLE):
        step = log.step(pole)
        if step is not None:
            found[step.uses[1]] = length_figure(reading, step.uses[1], language)
    return found


def length_figure(reading: Reading, length: Mark, language: str) -> str:
    """Return a length as it is dimensioned on a drawing, with its letter: H_V = 20."""
    return f"{length.name} = {number(float(reading[length][0, 0]), language)}"


def in_cells(views: Sequence[Drawing]) -> list[Drawing]:
    """Return views that each take a cell of one size, with their ink in the middle, so that rows align."""
    boxes = [bounds(view) for view in views]
    width = max((right - left for left, _, right, _ in boxes), default=0.0)
    height = max((top - low for _, low, _, top in boxes), default=0.0)
    made = []
    for view, (left, low, right, top) in zip(views, boxes, strict=True):
        x, y = (left + right - width) / 2, (low + top - height) / 2
        made.append(view._replace(cell=(x, y, x + width, y + height)))
    return made


def captioned(view: Drawing, *lines: str, heights: Heights = HEIGHTS["A4"]) -> Drawing:
    """Return a view with lines of lettering below it: in the middle, below a table from its left edge.

    The first of them is the title, broken where it is much wider than its view; a table has its own above it.
    Where a sheet is too narrow, all lines are broken, and the view comes apart if it can.
    """
    left, _, right, _ = bounds(view)
    if view.name.startswith("table"):
        told = [(text, heights.number) for text in lines]
    else:
        widest = max(right - left, COLUMN * heights.title)
        told = [(part, heights.title) for part in _broken(lines[:1], heights.title, widest)]
        told += [(text, heights.point) for text in lines[1:]]

    def apart(within: Within) -> list[Drawing]:
        *first, last = settled(view, within)
        return [
            *first,
            _above([(p, s) for t, s in told for p in _broken([t], s, within.width)], last),
        ]

    return _above(told, view)._replace(apart=apart)


def _broken(lines: Sequence[str], size: float, width: float) -> list[str]:
    return [part for text in lines for part in wrapped(text, size, width)]


def _above(lines: Sequence[tuple[str, float]], view: Drawing) -> Drawing:
    """Return a view with lines below it, each in its height; it does not come apart."""
    left, low, right, top = bounds(view)
    tabular, middle = view.name.startswith("table"), (left + right) / 2
    at, anchor = (left, "start") if tabular else (middle, "middle")
    labels, widest = list(view.labels), 0.0
    for text, size in lines:
        made = letter(text, size=size)
        low -= made.ascent + BELOW * size
        labels.append(Label(text, complex(at, low), size, anchor))
        low -= made.descent
        widest = max(widest, made.width)
    reach = max(right - left, widest) / 2
    cell = (middle - reach, low, middle + reach, top)
    if tabular:
        cell = (left, low, max(right, left + widest), top)
    return view._replace(labels=tuple(labels), cell=cell, apart=None)


def wrapped(text: str, size: float, width: float) -> list[str]:
    """Return mark-up in lines no wider than ``width`` mm, broken behind commas, else at spaces."""
    if letter(text, size=size).width <= width:
        return [text]
    for mark in (", ", " "):
        ends = [k for k, _ in enumerate(text) if text.startswith(mark, k) and _outside(text[:k])]
        heads = [k + len(mark) - 1 for k in ends]
        fitting = [k for k in heads if letter(text[:k], size=size).width <= width]
        if fitting:
            cut = fitting[-1]
            return [text[:cut], *wrapped(text[cut + 1 :], size, width)]
    return [text]


def _outside(head: str) -> bool:
    """Whether what follows a piece of mark-up stands outside braces."""
    return head.count("{") == head.count("}")


def stacked(name: str, views: Sequence[Drawing]) -> Drawing:
    """Return drawings one below the other as one, their origins above each other.

    Where no sheet is so high they stand by themselves.
    """
    moved, top = [], 0.0
    for view in views:
        _, low, _, high = bounds(view)
        moved.append(view.moved(1j * (top - high)))
        top -= high - low + STACK
    boxes = [bounds(view) for view in moved]
    cell = (
        min(b[0] for b in boxes),
        min(b[1] for b in boxes),
        max(b[2] for b in boxes),
        max(b[3] for b in boxes),
    )
    return Drawing(
        name,
        "; ".join(view.title for view in views),
        tuple(stroke for view in moved for stroke in view.strokes),
        tuple(label for view in moved for label in view.labels),
        cell,
        lambda _: views,
        rubbed=tuple(stroke for view in moved for stroke in view.rubbed),
        shows=tuple(dict.fromkeys(shown for view in moved for shown in view.shows)),
    )
