"""What the section of kinematic diagrams says: base, ordinates, intervals and their middles, results."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from graphic_tmm.board.charts import Chart
from graphic_tmm.chapters.diagrams.plan import Kinematic
from graphic_tmm.chapters.diagrams.record import Middle
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.document import Runs, Symbol, Table, text
from graphic_tmm.note.steps import NumberSource
from graphic_tmm.scene.captions import captions

OF = said(
    "The diagrams of point {point} show one turn of the crank. {given} is taken from the plans, the other "
    "diagrams are found from it graphically."
)
BASE, RESULTS = said("Base of the diagrams"), said("Results of the diagrams")
COMPARED = said("Results, comparison with the plans")
TIME = said("Along the base time is laid off. The crank turns evenly; a turn takes")
ANGLE = said("Along the base the angle of the crank is laid off: one turn is 2π rad.")
BY_SCALE = said("To the scale factor chosen ({table}) one turn is as long as")
BY_LENGTH = said("The length of the base is taken, so its scale factor is")
DIVIDED = said(
    "The base is divided into {count} equal parts, as many as the turn has positions; through their bounds "
    "lines are drawn parallel to the axis of ordinates. A part is as long as"
)
FROM_VELOCITIES = said(
    "The velocities of the point are measured on the velocity plans and laid off on the lines through the "
    "bounds, up or down by their sense along the guide, to the scale factor {mu} = {value}. In position "
    "{position}:"
)
FROM_POSITIONS = said(
    "The displacements of the point are measured along the guide, on the plan of positions, from the zero "
    "position on, and laid off on the lines through the bounds, up or down by their sense, to the scale factor "
    "{mu} = {value}. In position {position}:"
)
SMOOTH = said(
    "The points are joined by a smooth curve. After the turn everything repeats itself, so the curve ends as "
    "high as it began."
)
DERIVATIVE = said("As {derivative}, the diagram of {given} is differentiated.")
POLE = said(
    "The pole distance may be any; it is chosen so that the diagram is clear. It is tied to the scale factors:"
)
CHORDS = (
    said("over each interval the arc of the diagram of {given} is replaced by its chord;"),
    said("to the left of the origin, on the axis of the base, the pole is marked at {distance};"),
    said("through the pole rays are drawn parallel to the chords, up to the axis of ordinates;"),
    said(
        "the points found there are carried across, parallel to the base, to the middles of their intervals, "
        "for a chord has the mean slope of its interval;"
    ),
    said("the points over the middles are joined by a smooth curve: the diagram of {of}."),
)
TANGENTS = (
    said("over each bound the tangent to the diagram of {given} is drawn;"),
    said("to the left of the origin, on the axis of the base, the pole is marked at {distance};"),
    said("through the pole rays are drawn parallel to the tangents, up to the axis of ordinates;"),
    said("the points found there are carried across, parallel to the base, to their bounds;"),
    said("the points are joined by a smooth curve: the diagram of {of}."),
)
INTEGRAL = said(
    "The displacement is the integral of the velocity: the area below the diagram of {given} is summed up, "
    "interval by interval."
)
SUCCESSION = (
    said(
        "to the left of the origin of the diagram of {given}, on the axis of the base, the pole is marked at "
        "{distance};"
    ),
    said(
        "the mean ordinate of each interval is carried across to the axis of ordinates, and a ray is drawn "
        "there from the pole;"
    ),
    said(
        "over the intervals segments are drawn parallel to these rays, each from where the one before ended;"
    ),
    said("the points found are joined by a smooth curve: the diagram of {of}."),
)
ALIKE = said("The diagram of {of} is drawn in the same way, with the pole at {distance}.")
INTERVAL = said("Over the interval {interval} the ray cuts off {length}; this stands for")
MIDDLES = said("Ordinates over the middles of the intervals")
READ = said("In position {position} the ordinate is {length}; times {mu} this is {value}.")
CLOSURE = said(
    "After a turn the point is back, so the integral should end at 0. It ends at {end}: so large is the error "
    "of the drawing."
)
EXTRA = said(
    "Positions outside the row stand on the base as the crank pin divides the arc of their interval:"
)
GREATEST = said("{of} is largest in size in position {position}: {value}.")
APART = said(
    "The diagram of {symbol} differs from the plans by {apart} at most (position {position})."
)
CLOSED = said("After a turn the integrated diagram of S ends at {end}: it should end at 0.")
EXTREME = {
    "S": said("The displacement is largest in size in position {position}: {value}."),
    "V": said("The velocity is largest in size in position {position}: {value}."),
    "a": said("The acceleration is largest in size in position {position}: {value}."),
}


ACROSS = 12
"""How many intervals stand in one table beside one another."""
LEAD, WIDEST = 0.12, 0.1
"""Shares of the text's width: of each head of a row, and of a column at most."""


def intervals(drawn: Drawn, made: Kinematic) -> dict[int, str]:
    """Return what the intervals that can be drawn are called, by the position at which they begin."""
    names, count = drawn.names, made.base.intervals
    after = [*names[1:count], str(count)]
    return {k: f"{names[k]}–{after[k]}" for k in range(count) if k not in drawn.undrawn}


def middles_table(
    told: NumberSource, chart: Chart, middle: Middle, intervals: Mapping[int, str], digits: int
) -> Iterator[Table]:
    """Yield the middles of intervals: mm, and what they stand for, to some decimals."""
    language = told.language
    names, title, row = captions(language), speaking(language)(MIDDLES), list(intervals)
    letter = (Symbol(symbol(chart.symbol, language)),)
    for start in range(0, len(row), ACROSS):
        part = row[start : start + ACROSS]
        heads = (text(names["value"]), text(names["unit"]), *(text(intervals[k]) for k in part))
        rows = []
        for mark, of, places in ((middle.ordinate, "mm", 1), (middle.value, chart.unit, digits)):
            cells: list[Runs] = []
            for k in part:
                one = told._replace(place=k).number(mark)
                written = one._replace(text=fixed(one.value, places, language))
                cells.append((written,) if math.isfinite(one.value) else text("—"))
            rows.append((letter, text(unit(of, language)), *cells))
        again = f" ({names['continued']})" if start else ""
        id, align = f"table-middles-{chart.symbol}-{start}", "lc" + "c" * len(part)
        wide = (LEAD, LEAD, *[min((1.0 - 2 * LEAD) / len(part), WIDEST)] * len(part))
        yield Table(id, text(title + again), heads, tuple(rows), align, wide)
