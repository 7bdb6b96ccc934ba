"""The section of forces in a note: loads, each group with its moments and its polygon, the lever."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.forces.detached import Polygon
from graphic_tmm.chapters.forces.friction import pin_sentences
from graphic_tmm.chapters.forces.ink_balances import driver_rows, group_rows, lever_rows
from graphic_tmm.chapters.forces.lever import VIEW as LEVER
from graphic_tmm.chapters.forces.loads import VIEW as LOADS
from graphic_tmm.chapters.forces.note_sums import Kept, applied, compared, sums
from graphic_tmm.chapters.forces.plan import FORCES_PLAN, Forces
from graphic_tmm.chapters.forces.table import DIFFERENCE, force_columns
from graphic_tmm.chapters.forces.views import EXACTLY, force_views, lever_views, vectors_of
from graphic_tmm.chapters.forces.words import called
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimals_of, number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain
from graphic_tmm.note.bricks import (
    asked_number,
    columns,
    filled,
    heading,
    referred,
    side_by_side,
    worked,
)
from graphic_tmm.note.document import (
    Block,
    Display,
    Formula,
    Number,
    Paragraph,
    Picture,
    Run,
    Runs,
    Source,
    Symbol,
    Text,
    paragraph,
    text,
)
from graphic_tmm.note.figures import WALL, in_hand, is_figure, picture
from graphic_tmm.note.plans import at_position, section, section_table, shown_and_listed
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.seen import Seen
from graphic_tmm.scene.captions import captions

MOMENTS = said("Equilibrium of moments:")
CLOSED = said("Equilibrium of forces; the polygon closes where the lines of the unknown ones meet:")
IDLE = said("All forces are zero: there is no polygon.")
WORKED = said("The calculation is worked in full for position {position}.")
FRICTION = "friction"
AGREE = said(
    "In position {position} the lever differs from the force plans by {apart} % (limit {limit} %): within it."
)
APART = said(
    "In position {position} the lever differs from the force plans by {apart} % (limit {limit} %): beyond it."
)


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of forces."""
    made = FORCES_PLAN.of(drawn)
    if made is None:
        return
    page = _Page(drawn, made, language)
    yield paragraph(speaking(language)(WORKED, position=drawn.names[page.at]))
    yield from (Paragraph(text(plain(pin))) for pin in pin_sentences(drawn, language))
    yield from section_table(drawn, LOADS, page.at, language)
    plans = KINEMATICS_PLAN.on(drawn)
    crank = plans.structure.driver
    pivot = plans.positions.bodies[crank].marks[plans.structure.pivot]
    for solved in made.groups:
        rows = group_rows(page.writer, made, solved)
        yield from page.detached(solved.closing.group.name, solved.polygon, rows)
    rows = driver_rows(page.writer, made, pivot, crank)
    yield from page.detached(str(crank), made.driven.polygon, rows)
    yield from section_table(drawn, FRICTION, page.at, language)
    yield from page.lever()
    yield from columns(drawn, force_columns(drawn), language)


class _Page:
    """The position that is told, and what is written of it."""

    def __init__(self, drawn: Drawn, made: Forces, language: str) -> None:
        self.drawn, self.made, self.language = drawn, made, language
        at = worked(drawn)
        there = [k for k in made.places if k not in drawn.undrawn]
        self.at = at if at in there or not there else there[0]
        seen = Seen(drawn.construction, drawn.reading, (), [self.at])
        ruler = drawn.hand.ruler
        decimals = EXACTLY if ruler is None else decimals_of(ruler)
        self.writer = Kept(seen, self.at, language, decimals)
        held = in_hand(drawn, WALL)
        views = [*force_views(held, True), *lever_views(held, True)]
        self.views = {view.name: view for view in views if is_figure(view)}

    def figures(self, *names: str) -> tuple[Picture, ...]:
        """Return those of some views that are drawn."""
        position = self.drawn.names[self.at]
        wanted = [f"{name}-{position}" for name in names]
        return tuple(picture(self.views[k], self.language) for k in wanted if k in self.views)

    def detached(self, name: str, polygon: Polygon, rows: Iterator[object]) -> Iterator[Block]:
        """Yield what is told of a group or of the driving link: its figure, its moments, its polygon."""
        _, language = speaking(self.language), self.language
        title = called(f"group {name}", _)
        yield heading(title)
        shown = side_by_side(self.figures(f"group-{name}", f"forces-{name}"))
        found = section(self.drawn, polygon.view, self.at, language)
        scaled = polygon.view in self.drawn.scales and found is not None
        told = (found,) if scaled and found is not None else ()
        blocks = list(shown_and_listed(told, polygon.view, title, language, shown))
        yield from blocks[:1]
        yield from self.moments(rows)
        yield Paragraph(text(_(CLOSED if scaled else IDLE)))
        if scaled:
            yield Display((Formula((Symbol(vectors_of(polygon, language)),)),))
        yield from blocks[1:]

    def moments(self, rows: Iterator[object]) -> Iterator[Block]:
        """Yield the equations of moments among rows that are written."""
        for _ in rows:
            pass
        found = tuple(sums(self.writer, self.drawn.board))
        if found:
            yield Paragraph(text(speaking(self.language)(MOMENTS)))
            yield Display(found)

    def lever(self) -> Iterator[Block]:
        """Yield what is told of the lever: how loads stand on it, its figure, its moments, the comparison."""
        language, made = self.language, self.made
        yield heading(captions(language)[LEVER])
        shown = self.figures(LEVER)
        if shown:
            yield referred(shown, language)
        told = at_position(self.drawn, LEVER, self.at, language)
        if told is not None:
            yield from applied(told, made.lever)
        yield from shown
        yield from self.moments(iter(lever_rows(self.writer, made)))
        if told is not None:
            yield from compared(told, made.difference)


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield, for each position that is asked for, whether the lever agrees with the force plans."""
    made, _ = FORCES_PLAN.of(drawn), speaking(language)
    if made is None:
        return
    column = next(one for one in force_columns(drawn) if one.segment.endswith(DIFFERENCE))
    for k in made.places:
        apart = column.first_figures[1][k] if k not in drawn.undrawn else None
        if apart is None:
            continue
        said_ = AGREE if apart <= made.order.limit else APART
        source = Source("column", drawn.board, f"{column.plan}/{column.segment}", k, "", 1)
        put: dict[str, Run] = {
            "position": Text(drawn.names[k]),
            "apart": Number(number(apart, language, 2), "", source, apart),
            "limit": asked_number(drawn, "forces", "limit", "", language),
        }
        yield filled(_(said_), put)


NOTE = Noted(section=note, concludes=concludes)
