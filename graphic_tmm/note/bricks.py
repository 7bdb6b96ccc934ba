"""What sections are built of: the protocol of a plan, its figures, tables of columns and results.

The sections of chapters (`Page`) are built of these.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, pairwise

from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimals_of, fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import result_symbol, symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.columns import fits
from graphic_tmm.note.document import (
    Block,
    Figure,
    Heading,
    Letter,
    Number,
    Paragraph,
    Picture,
    Ref,
    Run,
    Runs,
    SideBySide,
    Source,
    Symbol,
    Table,
    Text,
    lettered,
    text,
)
from graphic_tmm.note.figures import (
    LEGIBLE,
    fit,
    going_on,
    is_figure,
    least_letter,
    picture,
    readable,
)
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.readers.columns import Column, Tabled, known_at
from graphic_tmm.readers.position_count import Finer, FinerRow, finer, is_sampled, sampled, told_off
from graphic_tmm.readers.rounding import ROUGH, Figures, rounded, rounded_figures
from graphic_tmm.readers.text import column_name
from graphic_tmm.scene.captions import captions, moving_or_not
from graphic_tmm.scene.chapter import Chapter, Place

ACROSS = 13
"""So many positions stand beside one another in a table of a page's width."""

NARROW = 3
"""A table of no more positions than these is narrow."""


SEE = said("The construction is shown in {}.")
TABLED = said("The working is given step by step in {}.")


def worked(drawn: Drawn) -> int:
    """Return the position (index) that is worked in full: the main one of those with the most plans."""
    rows = [*drawn.project.rows.values(), *drawn.project.told.values()]
    there = [k for k in drawn.all if k not in drawn.undrawn] or [0]
    counts = {k: sum(k in row for row in rows) for k in there}
    most = max(counts.values())
    return next(k for k in (drawn.main, *there) if counts.get(k) == most)


def by_ruler(drawn: Drawn) -> int:
    """Return how many decimals of a length (mm) the ruler of a drawing tells."""
    return ROUGH if drawn.hand.ruler is None else max(ROUGH, decimals_of(drawn.hand.ruler))


def heading(words: str, level: int = 2) -> Heading:
    """Return a numbered heading."""
    return Heading(level, text(words))


def referred(
    shown: Sequence[Figure], language: str, told: str = SEE, tables: Sequence[Table] = ()
) -> Paragraph:
    """Return the sentences that lead to figures, and to tables of calculations."""
    runs: list[Run] = []
    for words, ids in ((told, shown), (TABLED, tables)):
        if ids:
            before, behind = speaking(language)(words).split("{}")
            runs += [Text(" "), Text(before)] if runs else [Text(before)]
            first, *more = (one.id for one in ids)
            runs += [Ref(first, tuple(more)), Text(behind)]
    return Paragraph(tuple(runs))


def paired(blocks: Iterable[Block]) -> Iterator[Block]:
    """Yield the blocks of a section, figures that are narrow two and two beside one another."""
    held: list[Block | None] = list(blocks)
    places = [k for k, one in enumerate(held) if isinstance(one, Picture | SideBySide)]
    for k, other in pairwise(places):
        first, second = held[k], held[other]
        if isinstance(first, Picture) and isinstance(second, Picture) and fit((first, second)):
            (held[k],) = side_by_side((first, second))
            held[other] = None
    yield from (one for one in held if one is not None)


def side_by_side(shown: Sequence[Picture]) -> tuple[Figure, ...]:
    """Return views as one figure, beside one another; apart where their letters were too small to read."""
    if len(shown) < 2 or least_letter([one.drawing for one in shown]) < LEGIBLE:
        return tuple(shown)
    whole: list[Run] = []
    for k, one in enumerate(shown):
        whole += [Text("; ")] if k else []
        whole += [Letter(k), Text(") "), *_going_on(one.caption)]
    return (SideBySide(f"{shown[0].id}-beside", tuple(whole), tuple(shown)),)


def _going_on(caption: Runs) -> Runs:
    """Return a caption as it stands behind a letter: with a small one, unless it begins with a name."""
    first, *rest = caption
    return (
        (first._replace(text=going_on(first.text)), *rest) if isinstance(first, Text) else caption
    )


def figures_of(drawn: Drawn, place: Place, at: int, language: str) -> tuple[Picture, ...]:
    """Return the figures of a place of sheets; of those drawn for each position that at ``at`` (index)."""
    found = [view for view in drawings(drawn, place) if is_figure(view)]
    kept = [view for view in found if view.position in (None, at) or not _drawn_at(view, found, at)]
    return tuple(picture(view, language) for view in kept)


def _drawn_at(view: Drawing, found: Iterable[Drawing], at: int) -> bool:
    """Whether the same is drawn in another position, too: at ``at``."""
    return any(other.position == at and other.shows == view.shows for other in found)


def drawings(drawn: Drawn, place: Place) -> list[Drawing]:
    """Return the views of a place, lettered for a page; kept beside the drawing."""
    kept: dict[str, list[Drawing]] = drawn.cache.setdefault("note drawings", {})
    if place.name not in kept:
        draw = drawing_of(place.name)
        kept[place.name] = readable(drawn, lambda held: draw(held, True))
    return kept[place.name]


# ---------------------------------------------------------------- tables


def columns(drawn: Drawn, some: Iterable[Column], language: str) -> Iterator[Table]:
    """Yield tables of columns, plan by plan: mm and quantities, positions across."""
    words = captions(language)
    for (plan, at), group in groupby(some, key=lambda one: (one.plan, one.at)):
        cells = [one.without(drawn.undrawn) if not at else one for one in group]
        names = [name for name, _ in at] or list(drawn.names)
        shown = known_at(cells)
        table = f"table {plan}" if f"table {plan}" in words else plan
        title = moving_or_not(words, table, drawn.scene.at_rest)
        if not shown:
            continue
        count = -(-len(shown) // ACROSS)
        while True:
            across = -(-len(shown) // count)
            parts = [shown[k : k + across] for k in range(0, len(shown), across)]
            tables = [_block(drawn, plan, cells, names, part, title, language) for part in parts]
            tables[1:] = [one._replace(of=tables[0].id) for one in tables[1:]]
            if across < 2 or all(fits(one, language) for one in tables):
                break
            count += 1
        yield from tables


def _block(
    drawn: Drawn,
    plan: str,
    cells: Sequence[Column],
    names: Sequence[str],
    shown: Sequence[int],
    title: str,
    language: str,
) -> Table:
    words = captions(language)
    heads = (
        text(words["value"]),
        text(words["unit"]),
        *(text(names[k]) for k in shown),
    )
    rows: list[tuple[Runs, ...]] = []
    for column, figures in zip(cells, rounded_figures(cells), strict=True):
        name = column_name(column, language)
        if column.drawn:
            lengths = _cells(drawn, column, figures, shown, language, mm=True)
            rows.append((_lettered(name), _unit("mm", language), *lengths))
            name = symbol(column.quantity, language) if column.quantity else name
        values = _cells(drawn, column, figures, shown, language, mm=False)
        rows.append((_lettered(name), _unit(column.unit, language), *values))
    id = f"table-{plan}-{shown[0]}".replace(" ", "-")
    align = "lc" + "c" * len(shown)
    made = Table(id, text(title), heads, tuple(rows), align)
    return in_columns(made, language) if len(shown) <= NARROW else made


TALL = 5
"""A narrow table of more rows than these stands in parts beside one another."""


def in_columns(one: Table, language: str, most: int = 3) -> Table:
    """Return a narrow table in two or three parts, ``most``, beside one another if it has many rows."""
    if len(one.rows) > TALL:
        for times in range(most, 1, -1):
            if fits(several := _in_parts(one, times), language):
                return several
    return one


def _in_parts(one: Table, times: int) -> Table:
    """Return a table in parts beside one another."""
    count = len(one.rows)
    each = -(-count // times)
    none: tuple[Runs, ...] = ((),) * len(one.heads)
    filled = (*one.rows, *[none] * (each * times - count))
    rows = tuple(
        tuple(cell for part in range(times) for cell in filled[part * each + k])
        for k in range(each)
    )
    return one._replace(heads=one.heads * times, rows=rows, align=one.align * times)


def _lettered(name: str) -> Runs:
    return (Symbol(markup(name)),)


def _unit(name: str, language: str) -> Runs:
    return text(unit(name, language) or "—")


def _cells(
    drawn: Drawn,
    column: Column,
    figures: Figures,
    shown: Sequence[int],
    language: str,
    *,
    mm: bool,
) -> Iterator[Runs]:
    """Yield the cells of a row: figures as the sheet's table tells them, each with where it stands."""
    lengths, values = column.first_figures
    row = lengths if mm else values
    for k in shown:
        value = row[k]
        if value is None:
            yield text("—")
            continue
        source = column_source(drawn, column, k, mm=mm)
        yield (Number(written(drawn, figures, value, k, language, mm=mm), "", source, value),)


def written(
    drawn: Drawn, figures: Figures, value: float, k: int, language: str, *, mm: bool
) -> str:
    """Return a figure of a column in a position (index): a quantity as tables tell it, mm as a ruler does."""
    if not mm:
        return fixed(figures.value[k], figures.places, language)
    places = by_ruler(drawn)
    return fixed(rounded(value, places), places, language)


def column_source(drawn: Drawn, column: Column, k: int, *, mm: bool = False) -> Source:
    """Return where a column holds a figure in a position (index): its mm, or its quantity."""
    name = f"{column.plan}/{column.segment}"
    return Source("column", drawn.board, name, k, "", 0 if mm else 1)


def results(drawn: Drawn, chapter: Chapter, language: str) -> Iterator[Block]:
    """Yield the table of a chapter's results."""
    words, rows = captions(language), []
    curved = bool(FinerRow.of(chapter).by_positions)
    fine = finer(drawn) if curved else None
    for name, (value, of) in single(Tabled.of(chapter).results(drawn)).items():
        told = Number(number(value, language), "", Source("result", drawn.board, name), value)
        row = (_result(name, chapter.name, language), (told,), _unit(of, language))
        rows.append((*row, *(_divided(drawn, name, fine, language) if fine is not None else ())))
    if not rows:
        return
    names = ["value", "figure", "unit", *(("finer row", "off") if fine is not None else ())]
    heads = tuple(text(words[name]) for name in names)
    id, title = f"table-results-{chapter.name}", text(words["results"])
    yield in_columns(Table(id, title, heads, tuple(rows), "lcccc"[: len(heads)]), language)
    if off := told_off(drawn, language) if curved else ():
        yield Paragraph(lettered("; ".join(off) + "."))
    if curved and sampled(drawn):
        yield Paragraph(text(is_sampled(language)))


def _divided(drawn: Drawn, name: str, fine: Finer, language: str) -> Iterator[Runs]:
    """Yield the cells that tell what a finer row gives for a result, and how far it is off."""
    if name not in fine.due:
        yield from (text("—"), text("—"))
        return
    due, off = fine.due[name][0], 100.0 * fine.off[name]
    yield (Number(number(due, language), "", Source("due", drawn.board, name), due),)
    yield (Number(fixed(off, 1, language), "", Source("off", drawn.board, name), off),)


def _result(name: str, chapter: str, language: str) -> Runs:
    """Return what a result is called: a letter as a symbol, words as words."""
    caption = captions(language).get(name)
    if caption is None:
        return (Symbol(result_symbol(name.removeprefix(f"{chapter}_"), language)),)
    told = symbol(caption, language)
    return lettered(told) if " " in told else (Symbol(told),)
