"""The section of forces in a note: loads, each group with its moments and its polygon, the lever."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import product

from graphic_tmm.chapters.forces.detached import Polygon
from graphic_tmm.chapters.forces.friction import pin_sentences
from graphic_tmm.chapters.forces.ink_balances import driver_rows, group_rows, lever_rows
from graphic_tmm.chapters.forces.lever import VIEW as LEVER
from graphic_tmm.chapters.forces.loads import VIEW as LOADS
from graphic_tmm.chapters.forces.note_sums import Kept, applied, sums
from graphic_tmm.chapters.forces.plan import Forces
from graphic_tmm.chapters.forces.statics import Solved
from graphic_tmm.chapters.forces.table import ADVANTAGE, TOOL, names_of
from graphic_tmm.chapters.forces.views import (
    EXACTLY,
    force_views,
    lever_called,
    lever_views,
    vectors_of,
)
from graphic_tmm.chapters.forces.wheels import SolvedWheel
from graphic_tmm.chapters.forces.words import called
from graphic_tmm.language.numbers import decimals_of
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain
from graphic_tmm.note.bricks import heading, side_by_side, worked
from graphic_tmm.note.document import Block, Display, Formula, Picture, Runs, Symbol, paragraph
from graphic_tmm.note.figures import readable
from graphic_tmm.note.page import COLUMNS, Page
from graphic_tmm.note.plans import section, shown_and_listed
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.seen import Seen

MOMENTS = said("Equilibrium of moments:")
SPECIAL = said(
    "What holds legs {first} and {second} along their lines passes through the special point {point}: about it "
    "only what holds the third leg is unknown."
)
SPECIAL_OF_PLATES = said(
    "What links {first} and {second} bear along their lines passes through the special point {point}: about it "
    "each of both plates is balanced as a link is about its inner pin. What acts on the first of them alone "
    "then parts what both links bear."
)
CLOSED = said("Equilibrium of forces; the polygon closes where the lines of the unknown ones meet:")
IDLE = said("All forces are zero: there is no polygon.")
WORKED = said("The calculation is worked in full for position {position}.")
AGAINST = said("Against the balancing force found by the force plans:")
FRICTION = "friction"
LEAVES = said(
    "What the force plans leave at the drive, as a share of what the known loads are there:"
)
LEFT = said(
    "In position {position} the force plans leave {apart} % at the drive (limit {limit} %): within it."
)
TOO_MUCH = said(
    "In position {position} the force plans leave {apart} % at the drive (limit {limit} %): beyond it."
)
AGREE = said(
    "In position {position} the lever differs from the force plans by {apart} % (limit {limit} %): within it."
)
APART = said(
    "In position {position} the lever differs from the force plans by {apart} % (limit {limit} %): beyond it."
)
AGREE_OF = said(
    "In position {position} the lever of link {link} differs from the force plans by {apart} % (limit "
    "{limit} %): within it."
)
APART_OF = said(
    "In position {position} the lever of link {link} differs from the force plans by {apart} % (limit "
    "{limit} %): beyond it."
)
HELD = said(
    "On its plan the other drives are held: what holds them does no work, and one drive alone balances the "
    "loads."
)
SOUGHT = said(
    "In position {position} the force that is sought is {P_tool}, the mechanical advantage {advantage}."
)


class ForcePage(Page[Forces]):
    """Forces in one position, and what is written of it."""

    tables = (COLUMNS,)

    @cached_property
    def at(self) -> int:
        """The position (index) that is worked, else the first in which forces are found."""
        at = worked(self.drawn)
        there = [k for k in self.recorded.places if k not in self.drawn.undrawn]
        return at if at in there or not there else there[0]

    @cached_property
    def writer(self) -> Kept:
        """What writes the sums of moments of the position."""
        drawn = self.drawn
        seen = Seen(drawn.construction, drawn.reading, (), [self.at])
        ruler = drawn.hand.ruler
        decimals = EXACTLY if ruler is None else decimals_of(ruler)
        return Kept(seen, self.at, self.language, decimals)

    def views(self) -> list[Drawing]:
        """Return groups, polygons, the lever."""
        return readable(
            self.drawn, lambda held: [*force_views(held, True), *lever_views(held, True)]
        )

    def blocks(self) -> Iterator[Block]:
        """Yield what is told: loads, group by group, the driving link, friction, the lever."""
        made = self.recorded
        yield self.says(WORKED)
        yield from (paragraph(plain(pin)) for pin in pin_sentences(self.drawn, self.language))
        yield from self.view(LOADS)
        for solved in made.groups:
            rows = group_rows(self.writer, made, solved)
            yield from self._detached(solved.polygon, rows, tuple(self._special(solved)))
        for driven in made.driven:
            if driven.alone is not None:
                rows = driver_rows(self.writer, made, driven)
                yield from self._detached(driven.alone.polygon, rows)
        yield from self.view(FRICTION)
        yield from self._lever()
        yield from self.tabled()

    def _here(self, *names: str) -> tuple[Picture, ...]:
        """Return figures of the position."""
        return self.figures(*(f"{name}-{self.position}" for name in names))

    def _special(self, solved: Solved | SolvedWheel) -> Iterator[Block]:
        """Yield why moments of a plate are taken about its special point too."""
        if isinstance(solved, SolvedWheel) or solved.special is None:
            return
        point, told = solved.special.point, self.of(solved.special.point.view)
        if told is not None:
            first, second = (str(leg.link) for leg in solved.special.crossing)
            says = SPECIAL if solved.special.third is not None else SPECIAL_OF_PLATES
            yield self.says(says, first=first, second=second, point=told.symbol(point))

    def _detached(
        self, polygon: Polygon, rows: Iterator[object], more: tuple[Block, ...] = ()
    ) -> Iterator[Block]:
        """Yield what is told of a group or of the driving link: its figure, its moments, its polygon.

        ``more``: what is told before its moments.
        """
        name = polygon.of.name
        title = called(f"group {name}", self.speech)
        yield heading(title)
        shown = side_by_side(self._here(f"group-{name}", f"forces-{name}"))
        found = section(self.drawn, polygon.view, self.at, self.language)
        scaled = polygon.view in self.drawn.scales and found is not None
        told = (found,) if scaled and found is not None else ()
        blocks = list(shown_and_listed(told, polygon.view, title, self.language, shown))
        yield from blocks[:1]
        yield from more
        yield from self._moments(rows)
        yield self.says(CLOSED if scaled else IDLE)
        if scaled:
            vectors = vectors_of(self.drawn, polygon, self.language)
            yield Display(tuple(Formula((Symbol(one),)) for one in vectors))
        yield from blocks[1:]

    def _moments(self, rows: Iterator[object]) -> Iterator[Block]:
        """Yield the equations of moments among rows that are written."""
        for _ in rows:
            pass
        found = tuple(sums(self.writer, self.drawn.board))
        if found:
            yield self.says(MOMENTS)
            yield Display(found)

    def _lever(self) -> Iterator[Block]:
        """Yield what is told of each lever: how loads stand on it, its figure, its moments, the comparison."""
        tool = self.recorded.tool
        for one in self.recorded.balanced:
            lever = one.lever
            yield heading(lever_called(self.drawn, one))
            if one.view != LEVER:
                yield self.says(HELD)
            shown = self._here(one.view.replace(" ", "-"))
            yield from self.leads(shown, *applied(self, lever, tool))
            yield from self._moments(iter(lever_rows(self.writer, lever, tool)))
            if lever.balance != lever.force:
                yield from self.worked_out(lever.balance)
            if self.of(one.view) is not None:
                yield self.says(AGAINST if tool is None else LEAVES)
                yield from self.worked_out(one.difference)

    def concludes(self) -> Iterator[Runs]:
        """Yield, for each position that is asked for, whether the lever agrees with the force plans."""
        made, several = self.recorded, len(self.recorded.balanced) > 1
        for k, one in product(made.places, made.balanced):
            segment, link = names_of(made, one).difference, str(one.driven.pair.link)
            value = self.columns[segment].first_figures[1][k]
            if k in self.drawn.undrawn or value is None:
                continue
            within = value <= made.order.limit
            words = (AGREE_OF if within else APART_OF) if several else AGREE if within else APART
            if made.tool is not None:
                words = LEFT if within else TOO_MUCH
            apart = self.quantity(segment, k, 2)._replace(unit="")
            position, limit = self.drawn.names[k], self.ordered("limit")
            of = {"link": link} if several else {}
            yield self.sentence(words, of, position=position, apart=apart, limit=limit)
            if made.tool is not None:
                found = {name: self.quantity(name, k) for name in (TOOL, ADVANTAGE)}
                yield self.sentence(SOUGHT, found, position=position)


NOTE = Noted(ForcePage)
