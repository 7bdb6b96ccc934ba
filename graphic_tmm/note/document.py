"""What a note consists of: blocks of runs of text; every figure knows where it was read; their numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.board.formula_text import Node
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing

OTHERS = -1
"""The place of a scale factor of the positions that have none of their own."""


class Source(NamedTuple):
    """Where a number was read.

    ``kind``: "mark" (``name`` is its slot, ``place`` the index of a position in the reading of ``view``),
    "column" (``name``: plan and segment; ``factor``: 0 mm, 1 SI), "result", "given", "scale" (``name``: its
    view, ``place``: of a position, or of all `OTHERS`) or "scene" (``name`` says what).
    """

    kind: str
    board: str
    name: str
    place: int = 0
    view: str = ""
    factor: int = -1


class Symbol(NamedTuple):
    """Mark-up, as `paper.lettering` reads it: a letter, or an equation of vectors."""

    markup: str


class Number(NamedTuple):
    """A number as it is written, its unit ("" for none), where it was read, its value there."""

    text: str
    unit: str
    source: Source
    value: float


Leaf = Symbol | Number


class Tree(NamedTuple):
    """A formula's text as a tree; ``put``: what stands for its names."""

    node: Node
    put: Mapping[str, Leaf]


class Formula(NamedTuple):
    """Sides one after another with the sign between them; ``behind`` follows after a comma.

    ``follows``: it goes on with the formula before it, so that it begins with ``lead``, or with the sign if
    that is "". ``flat``: it stands among words, fractions with a stroke.
    """

    sides: tuple[Leaf | Tree, ...]
    sign: str = "="
    behind: tuple[Symbol, ...] = ()
    follows: bool = False
    lead: str = ""
    flat: bool = False


class Text(NamedTuple):
    """Letters in a row, as they are; ``style``: "", "strong", "emphasis"."""

    text: str
    style: str = ""


class Ref(NamedTuple):
    """A reference to a figure or a table by its id; ``more``: others of its kind, named with it."""

    to: str
    more: tuple[str, ...] = ()


class Letter(NamedTuple):
    """The letter of a part of a figure, by its number from 0: а, б; a, b in others."""

    of: int


class Once(NamedTuple):
    """Words that are said once in a note, whatever letters they are said of: ``key`` tells them again."""

    key: str
    runs: tuple[Run, ...]


Run = Text | Formula | Number | Symbol | Ref | Letter | Once
Runs = tuple[Run, ...]


class Heading(NamedTuple):
    """A heading; ``numbered``: as a section of the main part, else as a centred part of the note."""

    level: int
    runs: Runs
    numbered: bool = True


class Paragraph(NamedTuple):
    """A paragraph; ``style``: "" or one of the title page ("title", "centre", "above")."""

    runs: Runs
    style: str = ""


class Display(NamedTuple):
    """Formulas, each on a line of its own."""

    formulas: tuple[Formula, ...]


class Item(NamedTuple):
    """An item of a list: its number as it is told ("" in a list without), what it says."""

    label: str
    blocks: tuple[Block, ...]


class Listed(NamedTuple):
    """Items below one another."""

    items: tuple[Item, ...]


class Table(NamedTuple):
    """A ruled table: its id, its caption, heads, rows of cells; ``align``: "l", "c", "r" of each column.

    ``widths``: shares of the text's width, () for as wide as its words need.
    ``ruled``: with lines and a number. ``long``: it may go on over pages however few its rows are.
    ``of``: the id of the table that it is a further part of, whose number it has.
    """

    id: str
    caption: Runs
    heads: tuple[Runs, ...]
    rows: tuple[tuple[Runs, ...], ...]
    align: str
    widths: tuple[float, ...] = ()
    ruled: bool = True
    long: bool = False
    of: str = ""


class Picture(NamedTuple):
    """A view as a figure: its id, its caption, what it is called to those who do not see it."""

    id: str
    caption: Runs
    drawing: Drawing
    alt: str


class ReadyPicture(NamedTuple):
    """A figure that is SVG already, without a head of XML: its id, its caption, its size on the page, mm."""

    id: str
    caption: Runs
    svg: str
    width: float
    height: float
    alt: str


class SideBySide(NamedTuple):
    """Views beside one another as one figure: its id, what it shows; each view is a part with a letter."""

    id: str
    caption: Runs
    parts: tuple[Picture, ...]


class Contents(NamedTuple):
    """The table of contents."""


class Break(NamedTuple):
    """A new page."""


Figure = Picture | ReadyPicture | SideBySide
Block = Heading | Paragraph | Display | Listed | Table | Figure | Contents | Break


class Document(NamedTuple):
    """A note: its title, its language, its blocks; what title blocks of its pages say, if they have any."""

    title: str
    language: str
    blocks: tuple[Block, ...]
    frame: Mapping[str, str] | None = None


def text(words: str, style: str = "") -> Runs:
    """Return plain text as runs."""
    return (Text(words, style),) if words else ()


def paragraph(words: str, style: str = "") -> Paragraph:
    """Return a paragraph of plain text."""
    return Paragraph(text(words), style)


def walk(blocks: Sequence[Block]) -> Iterator[Block]:
    """Yield blocks, those in lists among them, and the parts of figures."""
    for block in blocks:
        yield block
        if isinstance(block, Listed):
            for item in block.items:
                yield from walk(item.blocks)
        elif isinstance(block, SideBySide):
            yield from block.parts


def runs_of(block: Block) -> Iterator[Run]:
    """Yield the runs of a block, without those of blocks within it."""
    if isinstance(block, Heading | Paragraph):
        yield from block.runs
    elif isinstance(block, Display):
        yield from block.formulas
    elif isinstance(block, Figure):
        yield from block.caption
    elif isinstance(block, Table):
        yield from block.caption
        for row in (block.heads, *block.rows):
            for cell in row:
                yield from cell


def once(blocks: Sequence[Block]) -> tuple[Block, ...]:
    """Return blocks in which what is to be said once is said where it comes first; empty paragraphs go."""
    known: set[str] = set()
    found: list[Block] = []
    for block in blocks:
        if isinstance(block, Paragraph):
            block = block._replace(runs=_said(block.runs, known))
            if not block.runs:
                continue
        elif isinstance(block, Listed):
            items = (one._replace(blocks=once(one.blocks)) for one in block.items)
            block = block._replace(items=tuple(items))
        elif isinstance(block, Table):
            rows = tuple(
                tuple(_said(cell, known) or text("—" if cell else "") for cell in row)
                for row in block.rows
            )
            block = block._replace(rows=rows)
        if isinstance(block, Display) and found and isinstance(found[-1], Display):
            block = Display((*found.pop().formulas, *block.formulas))  # type: ignore[union-attr]
        found.append(block)
    return tuple(found)


_LETTER = re.compile(
    r"(?<![^\W\d_])(?:\[?[^\W\d_]+(?:\^\{?[A-Z]\}?|_\{?[^\W²³]+\*?\}?)\]?[′″]?|(?!A[0-4])[a-zA-Z]\d)"
    r"(?![^\W²])²?"
)
"""A letter with an index among words: K_v, ω_max², [r_1], z3; A1 is a format of paper."""


def lettered(words: str, style: str = "") -> Runs:
    """Return words with the letters among them, which have an index, as symbols."""
    found: list[Run] = []
    end = 0
    for one in _LETTER.finditer(words):
        found += text(words[end : one.start()], style)
        found.append(Symbol(_braced(one[0])))
        end = one.end()
    return (*found, *text(words[end:], style))


def _braced(letter: str) -> str:
    """Return a letter as mark-up: an index of several signs is one, a square is raised."""
    return re.sub(r"_([\w*]{2,})", r"_{\1}", ends_apart(letter.replace("²", "^2")))


def ends_apart(letters: str) -> str:
    """Return the letters of a segment with the index of its first end by itself: c_1d_1, N_2P, O_2O'_2."""
    return _ENDS.sub(r"_{\1}", letters)


_ENDS = re.compile(r"(?<=^[A-Za-z])_(\d)(?=[A-Za-z]['′]?(?:_\d)?(?:·μ)?$)")


def _said(runs: Runs, known: set[str]) -> Runs:
    """Return runs without what was said; a space before what is gone goes with it."""
    found: list[Run] = []
    for run in runs:
        if isinstance(run, Text) and not run.style:
            found += lettered(run.text)
        elif not isinstance(run, Once):
            found.append(run)
        elif run.key not in known:
            known.add(run.key)
            found += _said(run.runs, known)
        elif found and found[-1] == Text(" "):
            found.pop()
    while found and found[0] == Text(" "):
        found.pop(0)
    return tuple(found)


def leaves(one: Run | Tree) -> Iterator[Leaf]:
    """Yield the symbols and numbers of a run."""
    if isinstance(one, Symbol | Number):
        yield one
    elif isinstance(one, Tree):
        yield from one.put.values()
    elif isinstance(one, Formula):
        for side in (*one.sides, *one.behind):
            yield from leaves(side)


def numbers(document: Document) -> Iterator[Number]:
    """Yield every number of a note."""
    yield from (leaf for leaf in _leaves_of(document) if isinstance(leaf, Number))


def symbols(document: Document) -> Iterator[Symbol]:
    """Yield every symbol of a note."""
    yield from (leaf for leaf in _leaves_of(document) if isinstance(leaf, Symbol))


def _leaves_of(document: Document) -> Iterator[Leaf]:
    for block in walk(document.blocks):
        for run in runs_of(block):
            yield from leaves(run)


LETTERS = said("abcdefghi")
"""The parts of a figure."""


class Numbered(NamedTuple):
    """The numbers of a note: headings by their place among the blocks, figures and tables by id.

    ``wholes``: the id of the figure that a part of one belongs to, by that of the part.
    """

    headings: Mapping[int, str]
    figures: Mapping[str, str]
    tables: Mapping[str, int]
    wholes: Mapping[str, str]


def numbered(document: Document) -> Numbered:
    """Return the numbers of sections, figures and tables, in order."""
    headings: dict[int, str] = {}
    counts: list[int] = []
    for k, block in enumerate(document.blocks):
        if isinstance(block, Heading) and block.numbered:
            counts = [*counts[: block.level], *[0] * (block.level - len(counts))]
            counts[block.level - 1] += 1
            headings[k] = ".".join(map(str, counts))
    figures: dict[str, str] = {}
    tables: dict[str, int] = {}
    wholes: dict[str, str] = {}
    count = 0
    for block in document.blocks:
        if isinstance(block, Figure):
            count += 1
            figures[block.id] = str(count)
        if isinstance(block, SideBySide):
            for k, part in enumerate(block.parts):
                figures[part.id] = f"{count}, {letter_of(k, document.language)}"
                wholes[part.id] = block.id
        elif isinstance(block, Table) and block.ruled:
            tables[block.id] = tables[block.of] if block.of else len({*tables.values()}) + 1
    return Numbered(headings, figures, tables, wholes)


def short_numbers(told: Sequence[str]) -> list[str]:
    """Return the numbers of figures, of parts of one figure its number once.

    >>> short_numbers(["7", "8"]), short_numbers(["13, а", "13, б", "14, а"])
    (['7', '8'], ['13, а, б', '14, а'])
    """
    parts: dict[str, list[str]] = {}
    for one in told:
        whole, _, letter = one.partition(", ")
        parts.setdefault(whole, []).extend([letter] if letter else [])
    return [", ".join([whole, *letters]) for whole, letters in parts.items()]


def letter_of(k: int, language: str) -> str:
    """Return the letter of a part of a figure, by its number from 0."""
    return speaking(language)(LETTERS)[k]
