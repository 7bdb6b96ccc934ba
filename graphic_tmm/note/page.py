"""A chapter in the note: its section, from its log, figures, columns and results; what follows from it.

A chapter that says more than its log derives a page of its own: its order, its sentences, its conclusions.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from string import Formatter
from types import MappingProxyType
from typing import Generic, TypeVar

from graphic_tmm.board.record import Mark
from graphic_tmm.drawn import Drawn, Results, single
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import EXACTLY, fixed, number
from graphic_tmm.language.symbols import plain
from graphic_tmm.language.units import unit
from graphic_tmm.note.bricks import (
    column_source,
    columns,
    figures_of,
    heading,
    referred,
    results,
    written,
)
from graphic_tmm.note.document import (
    Block,
    Figure,
    Heading,
    Item,
    Listed,
    Number,
    Paragraph,
    Picture,
    Run,
    Runs,
    Source,
    Symbol,
    Table,
    Text,
    text,
)
from graphic_tmm.note.figures import is_figure, picture
from graphic_tmm.note.plans import LogPage, section, shown_and_listed
from graphic_tmm.note.protocol import Known
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.readers.columns import Column, Tabled
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.readers.rounding import Figures, decimals, rounded_figures
from graphic_tmm.readers.text import column_name
from graphic_tmm.scene.captions import Named, captions
from graphic_tmm.scene.chapter import Chapter

T = TypeVar("T")
Put = Run | Mark | str | int
"""What stands for a name in a sentence: a mark's value with its unit, a run, words, a count."""
Words = str | Sequence[str]
COLUMNS, RESULTS = "columns", "results"
"""The tables of a section."""


def title(chapter: Chapter, language: str) -> str:
    """Return what the section of a chapter is called."""
    words = captions(language)
    return plain(words.get(f"chapter {chapter.name}", words.get(chapter.name, chapter.name)))


class Page(LogPage, Generic[T]):
    """A chapter on a drawn board, told in one position; without more than this, what the log tells of it.

    ``T`` is what the chapter recorded. ``calculated``: views of which only what is calculated or read is told.
    ``tables``: those at the end of the section. ``by_results``: conclusions whose names are those of results;
    each is drawn where all of its results are there. ``letters``: what sentences always find by these names.
    """

    calculated: tuple[str, ...] = ()
    tables: tuple[str, ...] = (COLUMNS, RESULTS)
    by_results: tuple[str, ...] = ()
    letters: Mapping[str, Run] = MappingProxyType({})

    def __init__(self, drawn: Drawn, chapter: Chapter, language: str, known: Known) -> None:
        """``known``: what was told before: sentences, reasons, formulas; what is told here is entered."""
        super().__init__(drawn, language, known)
        self.chapter, self.speech = chapter, speaking(language)

    @property
    def recorded(self) -> T:
        """What the chapter recorded."""
        plan: T = self.drawn.recorded[self.chapter.name]
        return plan

    @property
    def position(self) -> str:
        """What the position that is worked is called."""
        return self.drawn.names[self.at]

    # ------------------------------------------------------------ what a chapter says of its own

    def blocks(self) -> Iterator[Block]:
        """Yield the section: figures, plans as a table, columns, results."""
        places = (one for one in self.chapter.places if one.name in self.drawn.scene.called)
        shown = [
            one
            for place in places
            if not place.together
            for one in figures_of(self.drawn, place, self.at, self.language)
        ]
        found = (
            section(
                self.drawn,
                view,
                self.at,
                self.language,
                self.known,
                bare=view in self.calculated,
                brief=True,
            )
            for view in self._views()
        )
        name = f"{self.drawn.board}-{self.chapter.name}"
        called = title(self.chapter, self.language)
        sections = [one for one in found if one is not None]
        yield from shown_and_listed(sections, name, called, self.language, shown)
        yield from self.tabled()

    def concludes(self) -> Iterator[Runs]:
        """Yield what follows, a sentence each."""
        for sentence in self.by_results:
            names = {name for _, name, _, _ in Formatter().parse(sentence) if name is not None}
            if names <= set(self.results):
                yield self.sentence(sentence)

    def views(self) -> Iterable[Drawing]:
        """Return the views that its figures are pictures of."""
        return ()

    def _views(self) -> list[str]:
        """Return the chapter's views of the log, plan by plan; those of a part in the log's order."""
        project = self.drawn.project
        there = dict.fromkeys(step.it.view for step in self.drawn.construction.steps)
        listed = Protocols.of(self.chapter).views(project)
        own = [view for plan in Named.of(self.chapter).plans for view in listed.get(plan, ())]
        if not own and len(project.chapters) == 1:
            own = list(there)
        return [view for view in dict.fromkeys(own) if view in there]

    # ------------------------------------------------------------ sentences

    def sentence(self, words: Words, put: Mapping[str, Put] | None = None, /, **named: Put) -> Runs:
        """Return a sentence, or several, its names filled: by what is ``put``, else by results."""
        known: dict[str, Put] = {**self.letters, **(put or {}), **named}
        several = (words,) if isinstance(words, str) else words
        runs: list[Run] = []
        for letters, name, _, _ in Formatter().parse(" ".join(map(self.speech, several))):
            runs += text(letters)
            runs += [self._run(name, known)] if name is not None else []
        return tuple(runs)

    def says(
        self, words: Words, put: Mapping[str, Put] | None = None, /, **named: Put
    ) -> Paragraph:
        """Return it as a paragraph."""
        return Paragraph(self.sentence(words, put, **named))

    def steps(self, sentences: Sequence[str], put: Mapping[str, Put] | None = None) -> Listed:
        """Return what is done, step by step."""
        return Listed(tuple(Item("", (self.says(one, put),)) for one in sentences))

    def head(self, words: str) -> Heading:
        """Return a heading below that of the section."""
        return heading(self.speech(words))

    def _run(self, name: str, known: Mapping[str, Put]) -> Run:
        if name not in known:
            return Text(self.position) if name == "position" else self.result(name)
        put = known[name]
        if isinstance(put, Mark):
            return self.number(put)
        return Text(str(put)) if isinstance(put, str | int) else put

    # ------------------------------------------------------------ numbers

    def number(self, mark: Mark, at: int | None = None, *, size: bool = False) -> Number:
        """Return the value of a mark with its unit; its ``size`` only."""
        source = self.of(mark.view, at)
        assert source is not None
        found = source.number(mark, unit=True)
        return _size(found) if size else found

    def letter(self, mark: Mark) -> Symbol:
        """Return the letter of a mark."""
        source = self.of(mark.view)
        assert source is not None
        return source.symbol(mark)

    @cached_property
    def results(self) -> Results:
        """The results of the chapter by name."""
        return Tabled.of(self.chapter).results(self.drawn)

    def result(self, name: str) -> Number:
        """Return a result with its unit."""
        value, of = single({name: self.results[name]})[name]
        source = Source("result", self.drawn.board, name)
        told = round(value, EXACTLY) if of == "%" else value
        return Number(number(told, self.language), of, source, value)

    def ordered(self, key: str, of: str = "") -> Number:
        """Return what the chapter's section of the scene orders by a key, with its unit."""
        section = self.chapter.name
        value = float(getattr(self.drawn.scene.tasks[section], key))
        source = Source("asked", self.drawn.board, f"{section}.{key}")
        return Number(number(value, self.language), of, source, value)

    # ------------------------------------------------------------ columns

    @cached_property
    def columns(self) -> Mapping[str, Column]:
        """The columns of the chapter by segment."""
        return {one.segment: one for one in Tabled.of(self.chapter).columns(self.drawn)}

    @cached_property
    def rounded(self) -> Mapping[str, Figures]:
        """Their figures as tables tell them."""
        figures = rounded_figures(list(self.columns.values()))
        return dict(zip(self.columns, figures, strict=True))

    def cell(self, segment: str, *, mm: bool = False) -> Number:
        """Return what a table tells of a column in the position that is worked: mm, or the quantity."""
        column, figures = self.columns[segment], self.rounded[segment]
        value = column.first_figures[0 if mm else 1][self.at]
        assert value is not None
        source = column_source(self.drawn, column, self.at, mm=mm)
        digits = written(self.drawn, figures, value, self.at, self.language, mm=mm)
        return Number(digits, "mm" if mm else column.unit, source, value)

    def greatest(self, segment: str) -> tuple[Number, str] | None:
        """Return the value of a column that is greatest in size, and the position where it stands."""
        column = self.columns.get(segment)
        if column is None:
            return None
        undrawn = () if column.at else self.drawn.undrawn
        values = column.without(undrawn).first_figures[1]
        there = [(abs(value), -k) for k, value in enumerate(values) if value is not None]
        if not there:
            return None
        k = -max(there)[1]
        names = [name for name, _ in column.at] or list(self.drawn.names)
        return self.quantity(segment, k), names[k]

    def quantity(self, segment: str, k: int, digits: int = 3) -> Number:
        """Return the quantity that a column holds in a position (index), to so many significant digits."""
        column = self.columns[segment]
        value = column.first_figures[1][k]
        assert value is not None
        source = column_source(self.drawn, column, k)
        return Number(number(value, self.language, digits), column.unit, source, value)

    def extreme(
        self, words: Words, segment: str, name: str = "value", *, size: bool = False, **put: Put
    ) -> Iterator[Runs]:
        """Yield a sentence of a column's value that is greatest in size, called ``name``, and its position.

        ``size``: without its sign.
        """
        most = self.greatest(segment)
        if most is not None:
            value = _size(most[0]) if size else most[0]
            yield self.sentence(words, {name: value, "position": most[1], **put})

    def tabled(self) -> Iterator[Block]:
        """Yield the tables at the end of the section."""
        if COLUMNS in self.tables:
            some = Tabled.of(self.chapter).columns(self.drawn)
            yield from columns(self.drawn, some, self.language)
        if RESULTS in self.tables:
            yield from results(self.drawn, self.chapter, self.language)

    def upright(
        self, id: str, caption: str, some: Sequence[tuple[Column, bool]], places: Sequence[int]
    ) -> Table:
        """Return a table with a row for each position (index); ``some``: columns, whether in mm."""
        heads = [text(captions(self.language)["position"])]
        for column, mm in some:
            name = markup(column_name(column, self.language))
            of = unit("mm" if mm else column.unit, self.language)
            heads.append((Symbol(name), Text(f", {of}")))
        rows = tuple(
            (text(self.drawn.names[k]), *(self._upright_cell(one, k, mm) for one, mm in some))
            for k in places
        )
        return Table(id, text(self.speech(caption)), tuple(heads), rows, "c" * len(heads))

    def _upright_cell(self, column: Column, k: int, mm: bool) -> Runs:
        row = column.first_figures[0 if mm else 1]
        value = row[k]
        if value is None:
            return text("—")
        digits = fixed(value, 1 if mm else decimals(row), self.language)
        return (Number(digits, "", column_source(self.drawn, column, k, mm=mm), value),)

    # ------------------------------------------------------------ figures

    @cached_property
    def pictures(self) -> dict[str, Picture]:
        """Its figures by the names of their views; those that were shown are gone."""
        there = (view for view in self.views() if is_figure(view))
        return {view.name: picture(view, self.language) for view in there}

    def figures(self, *names: str) -> tuple[Picture, ...]:
        """Return those of some figures that are drawn and not shown yet."""
        return tuple(self.pictures.pop(name) for name in names if name in self.pictures)

    def leads(self, shown: Sequence[Figure], *between: Block) -> Iterator[Block]:
        """Yield the sentence that leads to figures, what stands ``between``, the figures."""
        if shown:
            yield referred(shown, self.language)
        yield from between
        yield from shown


def _size(one: Number) -> Number:
    """Return a number without its sign."""
    if one.value >= 0.0:
        return one
    kind = {"mark": "size", "column": "size of column"}[one.source.kind]
    read = one.source._replace(kind=kind)
    return one._replace(text=one.text.removeprefix("−"), source=read, value=-one.value)
