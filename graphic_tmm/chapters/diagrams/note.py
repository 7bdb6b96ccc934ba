"""The section of kinematic diagrams in a note: ordinates, chords or tangents against a pole; what follows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.board.charts import Chart
from graphic_tmm.chapters.diagrams import note_words as words
from graphic_tmm.chapters.diagrams.note_words import intervals, middles_table
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN, Kinematic
from graphic_tmm.chapters.diagrams.record import BESIDE
from graphic_tmm.chapters.diagrams.table import diagram_columns
from graphic_tmm.chapters.diagrams.task import CALCULATED, VIEWS
from graphic_tmm.chapters.diagrams.views import diagram_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.symbols import symbol as lettered
from graphic_tmm.note.bricks import columns, filled, greatest, heading, referred, worked
from graphic_tmm.note.document import (
    Block,
    Item,
    Listed,
    Number,
    Picture,
    Ref,
    Run,
    Runs,
    Source,
    Symbol,
    Text,
)
from graphic_tmm.note.figures import is_figure, picture, readable
from graphic_tmm.note.plans import Page
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.note.steps import NumberSource
from graphic_tmm.readers.rounding import rounded_figures as as_told
from graphic_tmm.scene.captions import captions


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield how far what was found is off the plans, and how far an integral is from closing."""
    made, _ = DIAGRAMS_PLAN.of(drawn), speaking(language)
    if made is None:
        return
    for column in diagram_columns(drawn):
        symbol, _sign, kind = column.segment.partition("_")
        if kind not in ("", "difference") or symbol == made.first:
            continue
        found = greatest(drawn, column, language)
        if found is not None and not kind:
            yield filled(_(words.EXTREME[symbol]), {"value": found[0], "position": Text(found[1])})
        elif found is not None:
            apart, position = found
            put: dict[str, Run] = {
                "symbol": Symbol(symbol),
                "apart": apart,
                "position": Text(position),
            }
            yield filled(_(words.APART), put)
    end = made.charts["S"].end if "S" in made.charts else None
    if end is not None:
        view = made.charts["S"].view
        told = NumberSource(drawn.board, drawn.construction, drawn.reading, view, 0, language)
        yield filled(_(words.CLOSED), {"end": told.number(end, unit=True)})


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of kinematic diagrams."""
    made = DIAGRAMS_PLAN.of(drawn)
    if made is not None:
        yield from _Page(drawn, made, language).blocks()


class _Page(Page):
    """The diagrams of a point, the position and the interval behind it that are worked in full."""

    def __init__(self, drawn: Drawn, made: Kinematic, language: str) -> None:
        super().__init__(drawn, language, worked(drawn))
        self.made, self.beside = made, BESIDE.on(drawn)
        found = tuple(diagram_columns(drawn))
        written = zip(found, as_told(found), strict=True)
        self.columns = {one.segment: (one, figures) for one, figures in written}
        self.first, self.told = made.first, set[Sequence[str]]()

    def blocks(self) -> Iterator[Block]:
        """Yield what is told: the base, diagram by diagram, the results."""
        shown = self._figures()
        first, point = self.made.charts[self.first], Text(self.made.order.point)
        wanted = [k for k in ("S", "V", "a") if k in self.made.charts and k != self.first]
        put: dict[str, Run] = {"point": point, "given": self._quantity(first)}
        yield self.says(words.OF, put)
        if shown:
            yield referred(shown, self.language)
        yield from self._base()
        yield from self._laid_off(first)
        for symbol in sorted(wanted, key=lambda k: (k == "S", "SVa".index(k))):
            tell = self._integrated if self._is_integral(symbol) else self._derived
            yield from tell(self.made.charts[symbol])
        yield from shown
        yield from self._places()
        yield from self._results()

    # ------------------------------------------------------------ parts

    def _base(self) -> Iterator[Block]:
        yield heading(self.speech(words.BASE))
        told = self.of(CALCULATED)
        base, over_time = self.made.base, self.made.order.over == "time"
        own = self.of(base.length.view)
        if told is None or own is None:
            return
        yield self.says(words.TIME if over_time else words.ANGLE)
        if over_time:
            yield from self.worked_out(told, self.beside.time)
        by_scale = any(step.it == base.length for step in own.log.steps)
        chosen: dict[str, Run] = {"table": Ref("table-scales")}
        yield self.says(words.BY_SCALE if by_scale else words.BY_LENGTH, chosen)
        yield from self.worked_out(own, base.length if by_scale else base.mu)
        put: dict[str, Run] = {"count": Text(str(base.intervals))}
        yield self.says(words.DIVIDED, put)
        yield from self.worked_out(told, self.beside.interval)

    def _laid_off(self, chart: Chart) -> Iterator[Block]:
        yield self._heading(chart)
        told = self.of(chart.view)
        if told is None:
            return
        put: dict[str, Run] = {
            "quantity": self._quantity(chart),
            "mu": told.symbol(chart.mu),
            "value": told.number(chart.mu, unit=True),
            "position": Text(self.drawn.names[self.at]),
        }
        way = words.FROM_VELOCITIES if self.first == "V" else words.FROM_POSITIONS
        yield self.says(way, put)
        yield from self.worked_out(told, self.made.laid)
        yield self.says(words.SMOOTH)

    def _derived(self, chart: Chart) -> Iterator[Block]:
        yield self._heading(chart)
        told, source = self.of(chart.view), self._source(chart)
        if told is None:
            return
        over = Text("t" if self.made.order.over == "time" else "φ")
        put: dict[str, Run] = {
            "of": self._quantity(chart),
            "given": self._quantity(source),
            "derivative": Symbol(
                f"{lettered(chart.symbol, self.language)} = d{source.symbol}/d{over.text}"
            ),
        }
        yield self.says(words.DERIVATIVE, put)
        yield self.says(words.POLE)
        yield from self._pole(told, chart)
        if chart.symbol in self.made.middles:
            yield from self._chords(chart, source)
        else:
            yield self._list(words.TANGENTS, source, chart)
        yield from self._worked(told, chart)

    def _chords(self, chart: Chart, source: Chart) -> Iterator[Block]:
        yield self._list(words.CHORDS, source, chart)
        told, middle = self.of(CALCULATED), self.beside.middles[chart.symbol]
        called = intervals(self.drawn, self.made)
        if told is None or not called:
            return
        k = self.at if self.at in called else next(iter(called))
        here = told._replace(place=k)
        put: dict[str, Run] = {
            "interval": Text(called[k]),
            "length": here.number(middle.ordinate, unit=True),
        }
        yield self.says(words.INTERVAL, put)
        yield from self.worked_out(here, middle.value)
        places = self.columns[chart.symbol][1].places
        yield from middles_table(told, chart, middle, called, places)

    def _integrated(self, chart: Chart) -> Iterator[Block]:
        yield self._heading(chart)
        told = self.of(chart.view)
        if told is None:
            return
        put: dict[str, Run] = {
            "of": self._quantity(chart),
            "given": self._quantity(self.made.charts["V"]),
        }
        yield self.says(words.INTEGRAL, put)
        yield from self._pole(told, chart)
        yield self._list(words.SUCCESSION, self.made.charts["V"], chart)
        yield from self._worked(told, chart)
        if chart.end is not None:
            yield self.says(words.CLOSURE, {"end": told.number(chart.end, unit=True)})

    def _worked(self, told: NumberSource, chart: Chart) -> Iterator[Block]:
        """Yield the ordinate of a diagram in the position that is worked, and what it stands for."""
        column, figures = self.columns[chart.symbol]
        mm, value = (row[self.at] for row in column.first_figures)
        if mm is None or value is None:
            return
        source = Source("column", self.drawn.board, f"{column.plan}/{column.segment}", self.at)
        length = fixed(figures.mm[self.at], figures.mm_places, self.language)
        quantity = fixed(figures.value[self.at], figures.places, self.language)
        put: dict[str, Run] = {
            "position": Text(self.drawn.names[self.at]),
            "length": Number(length, "mm", source._replace(factor=0), mm),
            "mu": told.number(chart.mu, unit=True),
            "value": Number(quantity, column.unit, source._replace(factor=1), value),
        }
        yield self.says(words.READ, put)

    def _places(self) -> Iterator[Block]:
        """Yield where positions outside the row stand on the base."""
        told = self.of(CALCULATED)
        if told is None or not self.beside.places:
            return
        yield self.says(words.EXTRA)
        for place in self.beside.places:
            yield from self.worked_out(told, place.distance)

    def _results(self) -> Iterator[Block]:
        found = tuple(column for column, _ in self.columns.values())
        compared = any(c.segment.endswith("_plan") and c.segment[0] != self.first for c in found)
        yield heading(self.speech(words.COMPARED if compared else words.RESULTS))
        yield from columns(self.drawn, found, self.language)
        for column in found:
            if column.segment in self.made.charts and (
                most := greatest(self.drawn, column, self.language)
            ):
                put: dict[str, Run] = {
                    "of": self._quantity(self.made.charts[column.segment]),
                    "value": most[0],
                    "position": Text(most[1]),
                }
                yield self.says(words.GREATEST, put)

    # ------------------------------------------------------------ bricks

    def _list(self, steps: Sequence[str], source: Chart, chart: Chart) -> Block:
        """Return how a diagram is drawn, step by step; of a second one that it is drawn alike."""
        told, pole = self.of(chart.view), self.made.poles[chart.symbol]
        put: dict[str, Run] = {
            "given": self._quantity(source),
            "of": self._quantity(chart),
            "distance": told.number(pole, unit=True) if told is not None else Text(""),
        }
        if steps in self.told:
            return self.says(words.ALIKE, put)
        self.told.add(steps)
        return Listed(tuple(Item("", (self.says(one, put),)) for one in steps))

    def _pole(self, told: NumberSource, chart: Chart) -> Iterator[Block]:
        """Yield how the pole distance follows from the scale factors, or one of these from it."""
        for step in told.log.steps:
            if step.it in (chart.mu, self.made.poles[chart.symbol]):
                yield from self.worked_out(told._replace(view=step.it.view), step.it)

    def _is_integral(self, symbol: str) -> bool:
        return symbol == "S" and self.first == "V"

    def _source(self, chart: Chart) -> Chart:
        return self.made.charts["V" if chart.symbol == "a" else "S"]

    def _quantity(self, chart: Chart) -> Symbol:
        return Symbol(lettered(chart.symbol, self.language))

    def _heading(self, chart: Chart) -> Block:
        return heading(
            captions(self.language)[VIEWS[chart.symbol]].format(point=self.made.order.point)
        )

    def _figures(self) -> tuple[Picture, ...]:
        shown = readable(self.drawn, diagram_views)
        return tuple(picture(one, self.language) for one in shown if is_figure(one))


NOTE = Noted(section=note, concludes=concludes)
