"""The section of kinematic diagrams in a note: ordinates, chords or tangents against a pole; what follows."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.diagrams.plan import Kinematic
from graphic_tmm.chapters.diagrams.record import BESIDE, Aside, Middle
from graphic_tmm.chapters.diagrams.task import VIEWS
from graphic_tmm.chapters.diagrams.views import diagram_views
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol as lettered
from graphic_tmm.language.units import unit
from graphic_tmm.note.bricks import heading
from graphic_tmm.note.document import Block, Paragraph, Ref, Runs, Symbol, Table, text
from graphic_tmm.note.figures import readable
from graphic_tmm.note.page import COLUMNS, Page, Put
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.scene.captions import captions

OF = said(
    "The diagrams of point {point} show one turn of the crank. {given} is taken from the plans, the other "
    "diagrams are found from it graphically."
)
BASE, RESULTS = said("Base of the diagrams"), said("Results of the diagrams")
COMPARED = said("Results, comparison with the plans")
OF_LARGEST = said("Δ is the difference from the plans in % of the largest value that they give.")
TIME = said("Along the base time is laid off. The crank turns evenly; a turn takes")
ANGLE = said("Along the base the angle of the crank is laid off: one turn is 2π rad.")
BY_SCALE = said("To the scale factor chosen ({table}) one turn is as long as")
BY_LENGTH = said("The length of the base is taken, so its scale factor is")
DIVIDED = said(
    "The base is divided into {count} equal parts, as many as the row has intervals; through their bounds "
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
OF_ROW: Mapping[str, str] = {
    OF: said(
        "The diagrams of point {point} go from the first position of the row to its last. {given} is taken "
        "from the plans, the other diagrams are found from it graphically."
    ),
    TIME: said(
        "Along the base time is laid off. The drive goes evenly; from the first position to the last it takes"
    ),
    ANGLE: said(
        "Along the base the angle of the crank is laid off, from the first position to the last."
    ),
    BY_SCALE: said("To the scale factor chosen ({table}) the row is as long as"),
    SMOOTH: said("The points are joined by a smooth curve."),
}
"""What is said of a row that does not come back to where it began."""
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


class DiagramPage(Page[Kinematic]):
    """The diagrams of a point; the position and the interval behind it are worked in full."""

    tables = (COLUMNS,)

    @cached_property
    def side_calculation(self) -> Aside:
        """What was calculated beside the diagrams."""
        return BESIDE.on(self.drawn)

    @cached_property
    def explained(self) -> set[Sequence[str]]:
        """The ways of drawing diagrams that were told step by step."""
        return set()

    def views(self) -> Sequence[Drawing]:
        """Return the diagrams."""
        return readable(self.drawn, lambda held: diagram_views(held, True))

    def concludes(self) -> Iterator[Runs]:
        """Yield how far what was found is off the plans, and how far an integral is from closing."""
        for segment in self.columns:
            symbol, _sign, kind = segment.partition("_")
            if kind not in ("", "difference") or symbol == self.recorded.first:
                continue
            if kind:
                yield from self.extreme(APART, segment, "apart", size=True, symbol=Symbol(symbol))
            else:
                yield from self.extreme(EXTREME[symbol], segment)
        end = self.recorded.charts["S"].end if "S" in self.recorded.charts else None
        if end is not None:
            yield self.sentence(CLOSED, end=end)

    def blocks(self) -> Iterator[Block]:
        """Yield what is told: the base, diagram by diagram, the results."""
        charts, first = self.recorded.charts, self.recorded.first
        yield self.says(
            self._said(OF), point=self.recorded.order.point, given=self._quantity(charts[first])
        )
        yield from self.leads(self.figures(*self.pictures), *self._diagrams())
        yield from self._places()
        yield from self._results()

    # ------------------------------------------------------------ parts

    def _diagrams(self) -> Iterator[Block]:
        """Yield the base, the diagram that is laid off, those that are found from it."""
        charts, first = self.recorded.charts, self.recorded.first
        yield from self._base()
        yield from self._laid_off(charts[first])
        wanted = [k for k in "SVa" if k in charts and k != first]
        for symbol in sorted(wanted, key=lambda k: k == "S"):
            integral = symbol == "S" and first == "V"
            yield from (self._integrated if integral else self._derived)(charts[symbol])

    def _base(self) -> Iterator[Block]:
        yield self.head(BASE)
        base, over_time = self.recorded.base, self.recorded.order.over == "time"
        yield self.says(self._said(TIME if over_time else ANGLE))
        if over_time:
            yield from self.worked_out(self.side_calculation.time)
        by_scale = self.drawn.construction.step(base.length) is not None
        yield self.says(self._said(BY_SCALE) if by_scale else BY_LENGTH, table=Ref("table-scales"))
        yield from self.worked_out(base.length if by_scale else base.mu)
        yield self.says(DIVIDED, count=base.intervals)
        yield from self.worked_out(self.side_calculation.interval)

    def _laid_off(self, chart: Chart) -> Iterator[Block]:
        yield self._heading(chart)
        way = FROM_VELOCITIES if self.recorded.first == "V" else FROM_POSITIONS
        mu = self.letter(chart.mu)
        yield self.says(way, quantity=self._quantity(chart), mu=mu, value=chart.mu)
        yield from self.worked_out(self.recorded.laid)
        yield self.says(self._said(SMOOTH))

    def _derived(self, chart: Chart) -> Iterator[Block]:
        yield self._heading(chart)
        source = self.recorded.charts["V" if chart.symbol == "a" else "S"]
        over = "t" if self.recorded.order.over == "time" else "φ"
        letter = f"{lettered(chart.symbol, self.language)} = d{source.symbol}/d{over}"
        yield self.says(DERIVATIVE, self._both(source, chart), derivative=Symbol(letter))
        yield self.says(POLE)
        yield from self._pole(chart)
        if chart.symbol in self.recorded.middles:
            yield from self._chords(chart, source)
        else:
            yield self._list(TANGENTS, source, chart)
        yield from self._worked(chart)

    def _chords(self, chart: Chart, source: Chart) -> Iterator[Block]:
        yield self._list(CHORDS, source, chart)
        middle, called = self.side_calculation.middles[chart.symbol], self._intervals()
        if not called:
            return
        k = self.at if self.at in called else next(iter(called))
        length = self.number(middle.ordinate, k)
        yield self.says(INTERVAL, interval=called[k], length=length)
        yield from self.worked_out(middle.value, at=k)
        yield from self._middles(chart, middle, called)

    def _intervals(self) -> dict[int, str]:
        """Return what the intervals that can be drawn are called, by the position at which they begin."""
        names, count = self.drawn.names, self.recorded.base.intervals
        end = str(int(names[0]) + count) if names[0].isdigit() else names[0]
        after = [*names[1:count], end if self.recorded.base.closed else names[count]]
        return {k: f"{names[k]}–{after[k]}" for k in range(count) if k not in self.drawn.undrawn}

    def _middles(
        self, chart: Chart, middle: Middle, intervals: Mapping[int, str]
    ) -> Iterator[Table]:
        """Yield the middles of intervals: mm, and what they stand for, to the decimals of the diagram."""
        names, row = captions(self.language), list(intervals)
        sorts = (
            (middle.ordinate, "mm", 1),
            (middle.value, chart.unit, self.rounded[chart.symbol].places),
        )
        for start in range(0, len(row), ACROSS):
            part = row[start : start + ACROSS]
            heads = (text(names["value"]), text(names["unit"]), *(text(intervals[k]) for k in part))
            rows = tuple(
                (
                    (self._quantity(chart),),
                    text(unit(of, self.language)),
                    *(self._middle(mark, k, places) for k in part),
                )
                for mark, of, places in sorts
            )
            id, align = f"table-middles-{chart.symbol}", "lc" + "c" * len(part)
            title = text(self.speech(MIDDLES))
            yield Table(f"{id}-{start}", title, heads, rows, align, of=f"{id}-0" if start else "")

    def _middle(self, mark: Mark, k: int, places: int) -> Runs:
        value = self.number(mark, k)
        if not math.isfinite(value.value):
            return text("—")
        return (value._replace(text=fixed(value.value, places, self.language), unit=""),)

    def _integrated(self, chart: Chart) -> Iterator[Block]:
        yield self._heading(chart)
        source = self.recorded.charts["V"]
        yield self.says(INTEGRAL, self._both(source, chart))
        yield from self._pole(chart)
        yield self._list(SUCCESSION, source, chart)
        yield from self._worked(chart)
        if chart.end is not None:
            yield self.says(CLOSURE, end=chart.end)

    def _worked(self, chart: Chart) -> Iterator[Block]:
        """Yield the ordinate of a diagram in the position that is worked, and what it stands for."""
        if None in (row[self.at] for row in self.columns[chart.symbol].first_figures):
            return
        length, value = self.cell(chart.symbol, mm=True), self.cell(chart.symbol)
        yield self.says(READ, length=length, mu=chart.mu, value=value)

    def _places(self) -> Iterator[Block]:
        """Yield where positions outside the row stand on the base."""
        if self.side_calculation.places:
            yield self.says(EXTRA)
        for place in self.side_calculation.places:
            yield from self.worked_out(place.distance)

    def _results(self) -> Iterator[Block]:
        first = self.recorded.first
        compared = any(k.endswith("_plan") and k[0] != first for k in self.columns)
        yield self.head(COMPARED if compared else RESULTS)
        if compared:
            yield self.says(OF_LARGEST)
        yield from self.tabled()
        for segment in self.columns:
            if segment in self.recorded.charts:
                of = self._quantity(self.recorded.charts[segment])
                yield from map(Paragraph, self.extreme(GREATEST, segment, of=of))

    # ------------------------------------------------------------ bricks

    def _said(self, of_turn: str) -> str:
        """Return a sentence on a turn, or what is said instead of another row."""
        return of_turn if self.recorded.base.closed else OF_ROW[of_turn]

    def _list(self, steps: Sequence[str], source: Chart, chart: Chart) -> Block:
        """Return how a diagram is drawn, step by step; of a second one that it is drawn alike."""
        put = {**self._both(source, chart), "distance": self.recorded.poles[chart.symbol]}
        if steps in self.explained:
            return self.says(ALIKE, put)
        self.explained.add(steps)
        return self.steps(steps, put)

    def _pole(self, chart: Chart) -> Iterator[Block]:
        """Yield how the pole distance follows from the scale factors, or one of these from it."""
        for step in self.drawn.construction.steps:
            if step.it in (chart.mu, self.recorded.poles[chart.symbol]):
                yield from self.worked_out(step.it)

    def _both(self, source: Chart, chart: Chart) -> Mapping[str, Put]:
        return {"given": self._quantity(source), "of": self._quantity(chart)}

    def _quantity(self, chart: Chart) -> Symbol:
        return Symbol(lettered(chart.symbol, self.language))

    def _heading(self, chart: Chart) -> Block:
        return heading(
            captions(self.language)[VIEWS[chart.symbol]].format(point=self.recorded.order.point)
        )


NOTE = Noted(DiagramPage)
