"""Views made ready for the sheet: captions below them, cells of one size, stacks."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import TABLE, Drawing, Heading, Label, Stand, Within
from graphic_tmm.paper.formats import HEIGHTS, Heights
from graphic_tmm.paper.lettering.letters import escape, letter
from graphic_tmm.paper.packing import bounds, in_pieces

BELOW = 0.7
"""Clear height between two lines of a caption, and between it and its view, of the height of its capitals."""
COLUMN = 12.0
"""A title wider than its view, and than the lines below it, is broken, but never into lines shorter than this,
of its height."""
EARLY = 0.5
"""A line is broken behind a comma where that leaves no less of its width."""
NUMERALS = "0123456789*°.,"
"""What the number of a position consists of."""
TOUCH = 1e-6
"""What is lower than a view by no more than this, mm, still stands in it."""
RULED = 1
"""Decimals of a length, mm, that is laid off by a ruler."""
STACK = 4.0
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
            value = number(round(float(reading[step.uses[1]][0, 0]), RULED), language)
            found[step.uses[1]] = f"{step.uses[1].name} = {value}"
    return found


def in_rows(
    views: Sequence[Drawing],
    block: str,
    title: str,
    told: Sequence[tuple[str, str]],
    heights: Heights,
    below: str = "",
) -> list[Drawing]:
    """Return views that stand in rows, in order, each with its own box; ``below``: under another block.

    ``told``: of each its number and its scale factor. Their heading, the ``title`` with the scale factor that
    they share, stands above them once, and each has its number below it; one alone has its own title.
    """
    if len(views) == 1:
        own = captioned(views[0], escape(views[0].title), told[0][1], heights=heights)
        return [own._replace(stand=Stand(block, "row", below))]
    scales = {scale for _, scale in told}
    shared = scales.pop() if len(scales) == 1 else ""
    heading = Heading(title, shared, (heights.title, heights.point))
    stand = Stand(block, "row", below, heading=heading)
    return [
        captioned(view, number, *([] if shared else [scale]), heights=heights)._replace(stand=stand)
        for view, (number, scale) in zip(views, told, strict=True)
    ]


def alone(view: Drawing) -> Drawing:
    """Return a view of a row as it stands by itself: with its own title and its scale factor below it."""
    heading = view.stand.heading
    if heading is None:
        return view
    low = bounds(view)[1] + view.foot - TOUCH
    below = [label for label in view.labels if label.at.imag < low]
    bare = view._replace(
        labels=tuple(label for label in view.labels if label not in below),
        cell=None,
        foot=0.0,
        stand=view.stand._replace(heading=None),
    )
    own = [heading.scale] if heading.scale else [label.text for label in below[1:]]
    title, point = heading.sizes
    sizes = Heights(point, title, point)
    return captioned(bare, escape(view.title), *own, heights=sizes)


def noted(views: Sequence[Drawing], block: str) -> list[Drawing]:
    """Return what is said of a block of views, its equations: behind its rows, else where there is room."""
    return [view._replace(stand=Stand(block, "note")) for view in views]


def paired(views: Sequence[Drawing]) -> list[Drawing]:
    """Return views that stand side by side, in order of positions: a figure and what belongs to it."""
    stand = Stand(views[0].name, "pair", position=views[0].position or 0)
    return [view._replace(stand=stand) for view in views]


def captioned(
    view: Drawing,
    *lines: str,
    heights: Heights = HEIGHTS["A4"],
    known: Sequence[Mark] = (),
) -> Drawing:
    """Return a view with lines of lettering below it: in the middle, below a table from its left edge.

    The first of them is the title, broken where it is much wider than its view and the lines below it; a table
    has its own above it.
    Where a sheet is too narrow, all lines are broken, and the view comes apart if it can. ``known``: the marks
    that the lines after the second one state: the lines appear with them.
    """
    view, of = view._replace(cell=bounds(view)), tuple(mark.slot for mark in known)
    left, _, right, _ = bounds(view)
    if view.role == TABLE:
        most, size = max(right - left, COLUMN * heights.number), heights.number
        told = [_Line(part, size) for text in lines for part in wrapped(text, size, most)]
    else:
        below = (letter(text, size=heights.point).width for text in lines[1:])
        wide = max(right - left, *below, 0.0)
        titles = [_titled(text, heights.title, wide) for text in lines[:1]]
        told = [_Line(part, heights.title) for parts in titles for part in parts]
        told += [_Line(text, heights.point, of if k else ()) for k, text in enumerate(lines[1:])]

    def apart(within: Within) -> list[Drawing]:
        *first, last = in_pieces(view, within)
        return [
            *first,
            _above(
                [one._replace(text=p) for one in told for p in wrapped(*one[:2], within.width)],
                last,
            ),
        ]

    return _above(told, view)._replace(apart=apart)


def _titled(text: str, size: float, width: float) -> list[str]:
    """Return a title in lines, broken where it is wider than ``width``.

    Of a series only the numbers at the end differ: either all titles of it are broken, or none is.
    """
    stem = letter(text.rstrip(NUMERALS), size=size).width
    most = max(width, COLUMN * size)
    return [text] if stem + 2 * size <= most else _even(text, size, min(stem, most))


def _even(text: str, size: float, most: float) -> list[str]:
    """Return mark-up in as few lines as ``most`` mm allow, of which the longest is as short as can be."""
    lines = wrapped(text, size, most)
    while len(lines) > 1:
        longest = max(letter(line, size=size).width for line in lines)
        other = wrapped(text, size, longest - 0.1)
        if len(other) > len(lines) or max(letter(o, size=size).width for o in other) >= longest:
            break
        lines = other
    return lines


class _Line(NamedTuple):
    """A line of a caption: what it says, its height, mm; the slots of the marks with which it appears."""

    text: str
    size: float
    of: tuple[int, ...] = ()


def _above(lines: Sequence[_Line], view: Drawing) -> Drawing:
    """Return a view with lines below it, each in its height; it does not come apart."""
    left, bottom, right, top = bounds(view)
    low = bottom
    tabular, middle = view.role == TABLE, (left + right) / 2
    anchor = "start" if tabular else "middle"
    # leaning tops reach out at the right, tails at the left
    labels, widest = list(view.labels), 0.0
    for text, size, of in lines:
        made = letter(text, size=size)
        low -= made.ascent + BELOW * size
        tail = max(0.0, -made.left)
        at = left + tail if tabular else middle
        labels.append(Label(text, complex(at, low), size, anchor, of=of))
        low -= made.descent
        half = max(made.right - made.width / 2, tail + made.width / 2)
        widest = max(widest, tail + made.right if tabular else 2 * half)
    foot = view.foot + bottom - low
    reach = max(right - left, widest) / 2
    cell = (middle - reach, low, middle + reach, top)
    if tabular:
        cell = (left, low, max(right, left + widest), top)
    return view._replace(labels=tuple(labels), cell=cell, apart=None, foot=foot)


_COMMA, _WORD, _SPACE = map(re.compile, (", ", r"(?<![\d=]) (?![\d=])", " "))
"""Where lines are broken, the best places first."""


def wrapped(text: str, size: float, width: float) -> list[str]:
    """Return mark-up in lines no wider than ``width`` mm, broken behind commas, else at spaces.

    A number stays with the word before it and with its unit, an equals sign with both sides, if they can.
    """
    if letter(text, size=size).width <= width:
        return [text]
    for mark in (_COMMA, _WORD, _SPACE):
        heads = [found.end() - 1 for found in mark.finditer(text) if _outside(text[: found.end()])]
        fitting = [k for k in heads if letter(text[:k], size=size).width <= width]
        # a comma that comes early would leave a line next to empty
        early = fitting and letter(text[: fitting[-1]], size=size).width < EARLY * width
        if fitting and not (early and mark is _COMMA):
            cut = fitting[-1]
            return [text[:cut], *wrapped(text[cut + 1 :], size, width)]
    return [text]


def _outside(head: str) -> bool:
    """Whether what follows a piece of mark-up stands outside braces."""
    return head.count("{") == head.count("}")


def _untold(chosen: Sequence[int]) -> Sequence[str]:
    """Return no caption: each view has its own."""
    return ()


def stacked(
    name: str,
    views: Sequence[Drawing],
    told: Callable[[Sequence[int]], Sequence[str]] = _untold,
    heights: Heights = HEIGHTS["A4"],
) -> Drawing:
    """Return drawings one below the other as one, their origins above each other.

    Where no sheet is so high as many as fit stand one below the other; all parts are equally wide, so that the
    origins of those at one edge stand above each other too. ``told``: the lines of the caption of a part, by
    the indices of its views; see `captioned`.
    """
    boxes = [bounds(view) for view in views]
    left, right = min(b[0] for b in boxes), max(b[2] for b in boxes)
    wide = [
        view._replace(cell=(left, low, right, high))
        for view, (_, low, _, high) in zip(views, boxes, strict=True)
    ]

    def column(chosen: Sequence[int], name: str) -> Drawing:
        made, lines = _below_another([wide[k] for k in chosen], name), told(chosen)
        return captioned(made, *lines, heights=heights) if lines else made

    def apart(within: Within) -> list[Drawing]:
        room = max((high for w, high in within.sizes if w >= right - left), default=0.0)
        parts: list[list[int]] = []
        for k in range(len(views)):
            more = [*parts[-1], k] if parts else []
            if more and _height(column(more, name)) <= room:
                parts[-1] = more
            else:
                parts.append([k])
        if len(parts) == 1:
            parts = [[k] for k in range(len(views))]
        return [column(part, views[part[0]].name) for part in parts]

    return column(range(len(views)), name)._replace(apart=apart)


def _height(view: Drawing) -> float:
    _, low, _, high = bounds(view)
    return high - low


def _below_another(views: Sequence[Drawing], name: str) -> Drawing:
    """Return drawings one below the other as one, their origins above each other."""
    moved, top = [], 0.0
    for view in views:
        _, low, _, high = bounds(view)
        moved.append(_begun(view).moved(1j * (top - high)))
        top -= high - low + STACK
    left, _, right, _ = bounds(moved[0])
    return Drawing(
        name,
        "; ".join(view.title for view in views),
        tuple(stroke for view in moved for stroke in view.strokes),
        tuple(label for view in moved for label in view.labels),
        (left, top + STACK, right, 0.0),
        stand=views[0].stand,
        rubbed=tuple(stroke for view in moved for stroke in view.rubbed),
        shows=tuple(dict.fromkeys(shown for view in moved for shown in view.shows)),
        origins=tuple(at for view in moved for at in view.origins),
        role=views[0].role,
    )


def _begun(view: Drawing) -> Drawing:
    """Return a view that is to be one of several: what it adds comes with the marks that it begins with."""
    if not view.begins:
        return view
    of = view.begins
    return view._replace(
        strokes=tuple(s if s.of else s._replace(of=of) for s in view.strokes),
        labels=tuple(one if one.of else one._replace(of=of) for one in view.labels),
    )
