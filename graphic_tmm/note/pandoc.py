"""A note as pandoc's document: blocks become elements of its tree (JSON), so that no text is ever parsed again.

pandoc is called once a format, with the tree on its standard input. Numbers of sections, figures and tables are
words of the document, the same in all formats.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from graphic_tmm.errors import SheetError
from graphic_tmm.language.catalogue import code_of, speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.note.document import (
    Block,
    Break,
    Contents,
    Display,
    Document,
    Formula,
    Heading,
    Letter,
    Listed,
    Number,
    Paragraph,
    Picture,
    Ref,
    Run,
    SideBySide,
    Symbol,
    Table,
    Text,
    letter_of,
    numbered,
    runs_of,
    walk,
)
from graphic_tmm.note.tex import one_word, spelt, tex
from graphic_tmm.note.widths import packed

API = [1, 23, 1]
"""The version of pandoc's tree that is written."""
NONE: list[Any] = ["", [], []]
"""An element without id, classes and attributes."""
ALIGN = {"l": "AlignLeft", "c": "AlignCenter", "r": "AlignRight"}
FIGURE, TABLE = said("Figure {number} — "), said("Table {number} — ")
FIGURE_AT, TABLE_AT = said("figure {number}"), said("table {number}")

Tree = dict[str, Any]


class ContentsEntry(NamedTuple):
    """A heading in the contents: its level, its id, what it says."""

    level: int
    id: str
    text: str


Outline = tuple[ContentsEntry, ...]

CONTENTS = said("Contents")
"""The heading of the outline."""


class Target(NamedTuple):
    """A format as pandoc is asked for it: its name there, options, and what it has of its own.

    ``picture``: the inline that shows a figure, ``contents`` and ``break_page``: blocks; ``styled``: a
    paragraph of the title page, ``tabled``: a table as it stands,
    ``part``: a heading without a number. ``captioned``: a figure and its caption
    are one; ``figure``: what they are instead. ``styled_rows``: parts beside one another and their caption are
    paragraphs of the styles of a figure. ``linked``: places in it have names. ``word``: a word of plain text,
    with what pandoc does not escape. ``headed``: the first cell of a row is its head.
    """

    name: str
    picture: Callable[[Picture], Tree]
    contents: Callable[[Outline], list[Tree]]
    break_page: Callable[[], list[Tree]]
    options: tuple[str, ...] = ()
    styled: Callable[[Tree, str], list[Tree]] = lambda block, style: styled(block, style)
    tabled: Callable[[Tree, Table], list[Tree]] = lambda made, table: [made]
    part: Callable[[Tree], list[Tree]] = lambda heading: [heading]
    captioned: bool = True
    linked: bool = True
    headed: bool = False
    figure: Callable[[Picture | SideBySide, Tree], list[Tree]] | None = None
    styled_rows: bool = False
    word: Callable[[str], list[Tree]] = lambda word: _plain(word)


class _Writer:
    """Writes one document as the tree of one format."""

    def __init__(self, document: Document, target: Target) -> None:
        self.document, self.target = document, target
        self.speech = speaking(document.language)
        self.numbers = numbered(document)
        self.put = spelt if target.name in MARKDOWN else one_word

    def tree(self) -> Tree:
        meta = {
            "title": {"t": "MetaInlines", "c": _words(self.document.title)},
            "lang": {"t": "MetaString", "c": code_of(self.document.language)},
        }
        blocks = [one for k, b in enumerate(self.document.blocks) for one in self.block(b, k)]
        return {"pandoc-api-version": API, "meta": meta, "blocks": blocks}

    def outline(self) -> Outline:
        found = []
        for k, block in enumerate(self.document.blocks):
            if isinstance(block, Heading):
                words = "".join(self.plain(run) for run in block.runs)
                number = self.numbers.headings.get(k, "")
                found.append(ContentsEntry(block.level, _section(k), f"{number} {words}".strip()))
        return tuple(found)

    # ------------------------------------------------------------ blocks

    def block(self, block: Block, k: int = 0) -> list[Tree]:
        if isinstance(block, Heading):
            made = self.heading(block, k)
            return [made] if block.numbered else self.target.part(made)
        if isinstance(block, Paragraph):
            told = _of("Para", self.inlines(block.runs))
            style = block.style or _set_as(block)
            return self.target.styled(told, style) if style else [told]
        if isinstance(block, Display):
            return [_of("Para", [self.row(one)]) for one in packed(block.formulas)]
        if isinstance(block, Listed):
            return list(self.listed(block))
        if isinstance(block, Table):
            made = self.table(block)
            return self.target.tabled(made, block)
        if isinstance(block, Picture | SideBySide):
            return self.figure(block)
        if isinstance(block, Contents):
            return self.target.contents(self.outline())
        assert isinstance(block, Break)
        return self.target.break_page()

    def heading(self, block: Heading, k: int) -> Tree:
        number = self.numbers.headings.get(k)
        told = _words(f"{number} ") if number else []
        classes = [] if block.numbered else ["unnumbered"]
        return _of(
            "Header",
            [block.level, [_section(k), classes, []], [*told, *self.inlines(block.runs)]],
        )

    def listed(self, block: Listed) -> Iterator[Tree]:
        items = [[one for b in item.blocks for one in self.block(b)] for item in block.items]
        labels = [item.label for item in block.items]
        if all(labels):
            start = int(labels[0].partition("–")[0])
            style = [start, {"t": "Decimal"}, {"t": "OneParen"}]
            yield _of("OrderedList", [style, items])
        else:
            yield _of("BulletList", items)

    def table(self, block: Table) -> Tree:
        aligned = [
            [{"t": ALIGN[a]}, _of("ColWidth", w) if w else {"t": "ColWidthDefault"}]
            for a, w in zip(block.align, block.widths or [0.0] * len(block.align), strict=True)
        ]
        caption = []
        if block.ruled:
            number = self.speech(TABLE, number=self.numbers.tables[block.id])
            caption = [_of("Plain", [*_words(number), *self.inlines(block.caption)])]
        rows = [[self.cell(cell) for cell in row] for row in block.rows]
        heads = [_row([self.cell(cell) for cell in block.heads])] if any(block.heads) else []
        attributes = [
            block.id if self.target.linked else "",
            [] if block.ruled else ["unruled"],
            [],
        ]
        return _of(
            "Table",
            [
                attributes,
                [None, caption],
                aligned,
                [NONE, heads],
                [[NONE, self.row_heads(block), [], [_row(row) for row in rows]]],
                [NONE, []],
            ],
        )

    def row_heads(self, block: Table) -> int:
        """Return how many cells of a row are its head: none where two rows stand beside one another."""
        half = len(block.heads) // 2
        folded = half > 0 and block.heads[:half] == block.heads[half:]
        return int(self.target.headed and any(block.heads) and not folded)

    def cell(self, runs: Sequence[Run]) -> list[Any]:
        inside = [_of("Plain", self.inlines(runs))] if runs else []
        return [NONE, {"t": "AlignDefault"}, 1, 1, inside]

    def figure(self, block: Picture | SideBySide) -> list[Tree]:
        number = self.speech(FIGURE, number=self.numbers.figures[block.id])
        caption = [*_words(number), *self.inlines(block.caption)]
        parts = block.parts if isinstance(block, SideBySide) else (block,)
        shown = [one for part in parts for one in (self.target.picture(part), {"t": "Space"})][:-1]
        if not self.target.captioned:
            return [_of("Para", shown), _of("Para", caption)]
        if self.target.figure is not None:
            return self.target.figure(block, _of("Plain", caption))
        if isinstance(block, SideBySide) and self.target.styled_rows:
            row = classed(_of("Para", shown), "Captioned Figure", block.id)
            return [row, classed(_of("Para", caption), "Image Caption")]
        whole = [[block.id, [], []], [None, [_of("Plain", caption)]], [_of("Plain", shown)]]
        return [_of("Figure", whole)]

    # ------------------------------------------------------------ runs

    def inlines(self, runs: Sequence[Run]) -> list[Tree]:
        return [one for run in runs for one in self.inline(run)]

    def inline(self, run: Run) -> list[Tree]:
        if isinstance(run, Formula | Symbol):
            return [self.math(run)]
        if isinstance(run, Number):
            return [_of("Str", self.plain(run))]
        if isinstance(run, Letter):
            return [_of("Str", letter_of(run.of, self.document.language))]
        if isinstance(run, Ref):
            words = _words(self.plain(run))
            to = self.numbers.wholes.get(run.to, run.to)
            return [_of("Link", [NONE, words, [f"#{to}", ""]])] if self.target.linked else words
        if not isinstance(run, Text):
            return []
        inside = _words(run.text, self.target.word)
        if run.style == "strong":
            return [_of("Strong", inside)]
        return [_of("Emph", inside)] if run.style else inside

    def plain(self, run: Run) -> str:
        """Return a run as plain words."""
        if isinstance(run, Number):
            told = unit(run.unit, self.document.language)
            return run.text + (told if told in ("", "°") else f"\u00a0{told}")
        if isinstance(run, Ref):
            if run.to in self.numbers.figures:
                return self.speech(FIGURE_AT, number=self.numbers.figures[run.to])
            return self.speech(TABLE_AT, number=self.numbers.tables[run.to])
        return run.text if isinstance(run, Text) else ""

    def row(self, beside: Sequence[Formula]) -> Tree:
        """Return formulas beside one another on a line of their own."""
        told = [tex(one, self.document.language, self.put) for one in beside]
        return _of("Math", [{"t": "DisplayMath"}, r";\qquad ".join(told)])

    def math(self, one: Formula | Symbol) -> Tree:
        """Return a formula among words."""
        return _of("Math", [{"t": "InlineMath"}, tex(one, self.document.language, self.put)])


def _set_as(block: Paragraph) -> str:
    """Return how a paragraph is set: with calculations its lines are not spread; one may lead to a formula."""
    if any(isinstance(run, Formula) and len(run.sides) > 2 for run in block.runs):
        return RAGGED
    last = block.runs[-1] if block.runs else None
    return LEADING if isinstance(last, Text) and last.text.endswith(":") else ""


def parts(document: Document) -> list[str]:
    """Return the ids of the headings without numbers."""
    return [
        _section(k)
        for k, block in enumerate(document.blocks)
        if isinstance(block, Heading) and not block.numbered
    ]


def formulas(document: Document) -> int:
    """Return how many formulas a note has as it is written: beside one another they are one."""
    found = 0
    for block in walk(document.blocks):
        if isinstance(block, Display):
            found += len(packed(block.formulas))
        else:
            found += sum(isinstance(run, Formula | Symbol) for run in runs_of(block))
    return found


MARKDOWN = ("gfm+tex_math_dollars", "markdown")


def _of(kind: str, content: object) -> Tree:
    return {"t": kind, "c": content}


def _section(k: int) -> str:
    return f"section-{k}"


def _row(cells: list[Any]) -> list[Any]:
    return [NONE, cells]


def styled(block: Tree, style: str) -> list[Tree]:
    """Return a paragraph of a style; how it is set is of no account but on pages."""
    return [block] if style in (RAGGED, LEADING) else [classed(block, style)]


RAGGED, LEADING = "ragged", "leading"
"""How a paragraph is set whose lines are not spread; one that stays with what follows it."""


def classed(block: Tree, style: str, id: str = "") -> Tree:
    """Return a block as one of a class, which is a style to a word processor."""
    return _of("Div", [[id, [style], [["custom-style", style]]], [block]])


def _plain(word: str) -> list[Tree]:
    return [_of("Str", word)]


def _words(text: str, word: Callable[[str], list[Tree]] = _plain) -> list[Tree]:
    """Return plain text as words and spaces; lines that are broken stay so."""
    found: list[Tree] = []
    for k, line in enumerate(text.split("\n")):
        if k:
            found.append({"t": "LineBreak"})
        for j, one in enumerate(line.split(" ")):
            if j:
                found.append({"t": "Space"})
            found += word(one) if one else []
    return found


def escaped(form: str, strange: re.Pattern[str]) -> Callable[[str], list[Tree]]:
    """Return how words are written in a format with a backslash before what would mean something there."""

    def word(text: str) -> list[Tree]:
        found: list[Tree] = []
        done = 0
        for match in strange.finditer(text):
            found += [_of("Str", text[done : match.start()])] if match.start() > done else []
            found.append(raw(form, f"\\{match[0]}"))
            done = match.end()
        return [*found, _of("Str", text[done:])] if done < len(text) else found

    return word


def raw(form: str, text: str, *, block: bool = False) -> Tree:
    """Return what a format takes as it is written."""
    return _of("RawBlock" if block else "RawInline", [form, text])


def written(
    document: Document, target: Target, *, out: str = "-", folder: str | None = None
) -> bytes:
    """Return a document as pandoc writes it in a format.

    Raises
    ------
    SheetError
        If pandoc is not installed, or refuses the document.
    """
    tree = json.dumps(_Writer(document, target).tree(), ensure_ascii=False)
    command = [program(), "-f", "json", "-t", target.name, "--fail-if-warnings", "-o", out]
    ended = subprocess.run(
        [*command, *target.options],
        input=tree.encode("utf-8"),
        capture_output=True,
        check=False,
        cwd=folder,
        env={**os.environ, "SOURCE_DATE_EPOCH": "315532800"},
    )
    if ended.returncode:
        what = " ".join(ended.stderr.decode("utf-8", "replace").split())[:300]
        raise SheetError(
            said("pandoc cannot write the note as {form}: {what}", form=target.name, what=what)
        )
    return ended.stdout


def program() -> str:
    """Return where pandoc is.

    Raises
    ------
    SheetError
        If it is not installed.
    """
    try:
        import pypandoc

        return str(pypandoc.get_pandoc_path())
    except (ImportError, OSError) as error:
        raise SheetError(said('a note needs pandoc: pip install "graphic-tmm[note]"')) from error
