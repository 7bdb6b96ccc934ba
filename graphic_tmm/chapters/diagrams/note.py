"""The section of kinematic diagrams in a note: ordinates, chords or tangents against a pole; what follows."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from graphic_tmm.board.charts import Chart
from graphic_tmm.chapters.diagrams import note_words as words
from graphic_tmm.chapters.diagrams.note_words import intervals, middles_table
from graphic_tmm.chapters.diagrams.plan import Kinematic
from graphic_tmm.chapters.diagrams.record import BESIDE, Aside
from graphic_tmm.chapters.diagrams.task import CALCULATED, VIEWS
from graphic_tmm.chapters.diagrams.views import diagram_views
from graphic_tmm.language.symbols import symbol as lettered
from graphic_tmm.note.bricks import heading
from graphic_tmm.note.document import Block, Paragraph, Ref, Runs, Symbol
from graphic_tmm.note.figures import readable
from graphic_tmm.note.page import COLUMNS, Page, Put
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.scene.captions import captions


class DiagramPage(Page[Kinematic]):
    """The diagrams of a point; the position and the interval behind it are worked in full."""

    tables = (COLUMNS,)

    @cached_property
    def aside(self) -> Aside:
        """What was calculated beside the diagrams."""
        return BESIDE.on(self.drawn)

    @cached_property
    def explained(self) -> set[Sequence[str]]:
        """The ways of drawing diagrams that were told step by step."""
        return set()

    def views(self) -> Sequence[Drawing]:
        """Return the diagrams."""
        return readable(self.drawn, diagram_views)

    def concludes(self) -> Iterator[Runs]:
        """Yield how far what was found is off the plans, and how far an integral is from closing."""
        for segment in self.columns:
            symbol, _sign, kind = segment.partition("_")
            if kind not in ("", "difference") or symbol == self.recorded.first:
                continue
            if kind:
                yield from self.extreme(words.APART, segment, "apart", symbol=Symbol(symbol))
            else:
                yield from self.extreme(words.EXTREME[symbol], segment)
        end = self.recorded.charts["S"].end if "S" in self.recorded.charts else None
        if end is not None:
            yield self.sentence(words.CLOSED, end=end)

    def blocks(self) -> Iterator[Block]:
        """Yield what is told: the base, diagram by diagram, the results."""
        charts, first = self.recorded.charts, self.recorded.first
        yield self.says(
            words.OF, point=self.recorded.order.point, given=self._quantity(charts[first])
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
        yield self.head(words.BASE)
        base, over_time = self.recorded.base, self.recorded.order.over == "time"
        yield self.says(words.TIME if over_time else words.ANGLE)
        if over_time:
            yield from self.worked_out(self.aside.time)
        by_scale = self.drawn.construction.step(base.length) is not None
        yield self.says(words.BY_SCALE if by_scale else words.BY_LENGTH, table=Ref("table-scales"))
        yield from self.worked_out(base.length if by_scale else base.mu)
        yield self.says(words.DIVIDED, count=base.intervals)
        yield from self.worked_out(self.aside.interval)

    def _laid_off(self, chart: Chart) -> Iterator[Block]:
        yield self._heading(chart)
        way = words.FROM_VELOCITIES if self.recorded.first == "V" else words.FROM_POSITIONS
        mu = self.letter(chart.mu)
        yield self.says(way, quantity=self._quantity(chart), mu=mu, value=chart.mu)
        yield from self.worked_out(self.recorded.laid)
        yield self.says(words.SMOOTH)

    def _derived(self, chart: Chart) -> Iterator[Block]:
        yield self._heading(chart)
        source = self.recorded.charts["V" if chart.symbol == "a" else "S"]
        over = "t" if self.recorded.order.over == "time" else "φ"
        letter = f"{lettered(chart.symbol, self.language)} = d{source.symbol}/d{over}"
        yield self.says(words.DERIVATIVE, self._both(source, chart), derivative=Symbol(letter))
        yield self.says(words.POLE)
        yield from self._pole(chart)
        if chart.symbol in self.recorded.middles:
            yield from self._chords(chart, source)
        else:
            yield self._list(words.TANGENTS, source, chart)
        yield from self._worked(chart)

    def _chords(self, chart: Chart, source: Chart) -> Iterator[Block]:
        yield self._list(words.CHORDS, source, chart)
        told, middle = self.of(CALCULATED), self.aside.middles[chart.symbol]
        called = intervals(self.drawn, self.recorded)
        if told is None or not called:
            return
        k = self.at if self.at in called else next(iter(called))
        length = self.number(middle.ordinate, k)
        yield self.says(words.INTERVAL, interval=called[k], length=length)
        yield from self.worked_out(middle.value, at=k)
        places = self.rounded[chart.symbol].places
        yield from middles_table(told, chart, middle, called, places)

    def _integrated(self, chart: Chart) -> Iterator[Block]:
        yield self._heading(chart)
        source = self.recorded.charts["V"]
        yield self.says(words.INTEGRAL, self._both(source, chart))
        yield from self._pole(chart)
        yield self._list(words.SUCCESSION, source, chart)
        yield from self._worked(chart)
        if chart.end is not None:
            yield self.says(words.CLOSURE, end=chart.end)

    def _worked(self, chart: Chart) -> Iterator[Block]:
        """Yield the ordinate of a diagram in the position that is worked, and what it stands for."""
        if None in (row[self.at] for row in self.columns[chart.symbol].first_figures):
            return
        length, value = self.cell(chart.symbol, mm=True), self.cell(chart.symbol)
        yield self.says(words.READ, length=length, mu=chart.mu, value=value)

    def _places(self) -> Iterator[Block]:
        """Yield where positions outside the row stand on the base."""
        if self.aside.places:
            yield self.says(words.EXTRA)
        for place in self.aside.places:
            yield from self.worked_out(place.distance)

    def _results(self) -> Iterator[Block]:
        first = self.recorded.first
        compared = any(k.endswith("_plan") and k[0] != first for k in self.columns)
        yield self.head(words.COMPARED if compared else words.RESULTS)
        yield from self.tabled()
        for segment in self.columns:
            if segment in self.recorded.charts:
                of = self._quantity(self.recorded.charts[segment])
                yield from map(Paragraph, self.extreme(words.GREATEST, segment, of=of))

    # ------------------------------------------------------------ bricks

    def _list(self, steps: Sequence[str], source: Chart, chart: Chart) -> Block:
        """Return how a diagram is drawn, step by step; of a second one that it is drawn alike."""
        put = {**self._both(source, chart), "distance": self.recorded.poles[chart.symbol]}
        if steps in self.explained:
            return self.says(words.ALIKE, put)
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
