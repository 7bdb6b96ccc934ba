"""What a construction of one's own leaves on paper, as one picture: its views beside one another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Figure, Mark
from graphic_tmm.board.values import Point
from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Drawing, Ink, Sheet, circle, line
from graphic_tmm.paper.figure import added, body, figure
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import Named, finished, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.rules import LEAST, PRICK
from graphic_tmm.paper.seen import Seen, finite
from graphic_tmm.paper.symbols.dimensions import arrow
from graphic_tmm.paper.views import captioned
from graphic_tmm.scene.captions import view_name

LINK, VECTOR = "link", "vector"
"""What marks can stand for together: a link by its points, a vector from a point to another."""
FORMAT = "A4"
"""The format whose pens and letters are used: a picture of one's own is held in the hand."""
EDGE, GAP = 8.0, 14.0
"""White about a picture, and between two views of it, mm."""


def picture(
    log: Construction, reading: Reading, title: str, language: str, *, helping: bool
) -> Sheet:
    """Return the picture of a construction, in true mm; ``helping``: with what only helped.

    Raises
    ------
    SheetError
        If nothing of it can be drawn.
    """
    views = dict.fromkeys(mark.view for mark in (*log.given, *(step.it for step in log.steps)))
    drawn = [_drawing(log, reading, view, language, helping=helping) for view in views]
    drawn = [one for one in drawn if one.strokes or one.labels]
    if not drawn:
        raise SheetError(said("nothing is drawn on the board yet, or nothing of it can be drawn"))
    if len(drawn) > 1:
        drawn = [captioned(one, one.title) for one in drawn]
    boxes = [bounds(one) for one in drawn]
    low, high = min(box[1] for box in boxes), max(box[3] for box in boxes)
    placed, at = [], EDGE
    for one, (left, _, right, _) in zip(drawn, boxes, strict=True):
        placed.append(one.moved(complex(at - left, EDGE - low)))
        at += right - left + GAP
    width, height = at - GAP + EDGE, high - low + 2 * EDGE
    return Sheet("board", title, FORMAT, width, height, tuple(placed), language)


def _drawing(
    log: Construction, reading: Reading, view: str, language: str, *, helping: bool
) -> Drawing:
    seen = Seen(log, reading, (view,), range(reading.positions))
    traces = figure(seen, helping=helping)
    strokes = [*traces.staying, *traces.rubbed] if helping else list(traces.staying)
    points = [
        mark for mark in (*log.given, *(step.it for step in seen.steps)) if mark.kind is Point
    ]
    points = [mark for mark in points if mark.view == view]
    for one in log.figures:
        if one.view == view:
            strokes += _body(seen, one)
    for mark in points:
        spots = dict.fromkeys(filter(finite, (seen.point(mark, k) for k in _places(seen, mark))))
        strokes += added((circle("thin", at, PRICK) for at in spots), "point")
    wanted = lettered(shared(_names(seen, points, language)), HEIGHTS[FORMAT].point)
    return finished(Drawing(view, view_name(view, language), tuple(strokes), wanted=tuple(wanted)))


def _places(seen: Seen, mark: Mark) -> Sequence[int]:
    """Return the positions in which a point stands somewhere else."""
    return seen.positions if seen.reading[mark].shape[1] > 1 else seen.positions[:1]


def _names(seen: Seen, points: Sequence[Mark], language: str) -> Iterator[Named]:
    """Yield the letters of points, each in its first position: more would hide the rest."""
    for mark in points:
        text, there = markup(symbol(mark.name, language)), _places(seen, mark)
        k = next((k for k in there if finite(seen.point(mark, k))), None)
        if text and k is not None:
            yield Named(seen.point(mark, k), text, (mark.slot,), k if len(there) > 1 else None)


def _body(seen: Seen, of: Figure) -> Iterator[Ink]:
    """Yield a link or a vector in all positions; a link is heavy in the first of them alone."""
    pen = "main"
    for k in seen.positions:
        spots = [seen.point(mark, k) for mark in of.marks]
        if not finite(*spots):
            continue
        strokes: Sequence[Ink] = (line(pen, *spots, closed=len(spots) > 2),)
        pen = "thin"
        if of.kind == VECTOR:
            far = abs(spots[1] - spots[0]) > LEAST
            strokes = arrow(spots[0], spots[1], "medium") if far else ()
        yield from body(strokes, of.kind, of.marks, k)
