"""What is ruled on an empty sheet, by which its frame is known again in a photograph."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes
from graphic_tmm.paper.drawing import Drawing, Sheet, Stroke
from graphic_tmm.paper.frame.frame import NAME, drawing_area
from graphic_tmm.paper.ruled import Box

SHORTEST = 4.0
"""mm: shorter lines of a title block tell nothing."""
EDGE = 1.0
"""mm: what is ruled nearer to the edge of the paper is where it is cut."""


class Ruled(NamedTuple):
    """What is ruled on an empty sheet, mm: its ``frame``, the ``paper``, lines (n, 2) beside the frame's."""

    frame: Box
    paper: Box
    lines: Complexes


def ruled(sheet: Sheet, first: bool) -> Ruled:
    """Return what is ruled on a sheet, the ``first`` of its scene or a further one."""
    frame = drawing_area(sheet.format, sheet.language, first).inner
    paper = Box(0.0, 0.0, sheet.width, sheet.height)
    found = [
        line
        for drawing in sheet.drawings
        if drawing.name == NAME
        for line in _lines(drawing)
        if abs(line[1] - line[0]) >= SHORTEST
        and not _cut(line, paper)
        and not any(_upon(line, *side) for side in _sides(frame))
    ]
    return Ruled(frame, paper, np.array(found, np.complex128).reshape(-1, 2))


def _lines(drawing: Drawing) -> Iterator[tuple[complex, complex]]:
    for stroke in drawing.strokes:
        if isinstance(stroke, Stroke):
            points = [complex(x, y) for x, y, _ in stroke.path]
            yield from pairwise([*points, points[0]] if stroke.closed else points)


def _sides(box: Box) -> Iterator[tuple[complex, complex]]:
    corners = [complex(x, y) for x in (box.left, box.right) for y in (box.bottom, box.top)]
    for one, two in ((0, 1), (0, 2), (1, 3), (2, 3)):
        yield corners[one], corners[two]


def _cut(line: tuple[complex, complex], paper: Box) -> bool:
    """Whether a line is where the paper is cut, or without it."""
    return any(
        z.real < paper.left + EDGE
        or z.real > paper.right - EDGE
        or z.imag < paper.bottom + EDGE
        or z.imag > paper.top - EDGE
        for z in line
    )


def _upon(line: tuple[complex, complex], foot: complex, head: complex) -> bool:
    """Whether a line lies upon another."""
    way = (head - foot) / abs(head - foot)
    return all(abs(((z - foot) / way).imag) < 1e-6 for z in line)
