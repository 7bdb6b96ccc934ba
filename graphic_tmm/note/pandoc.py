"""A note as pandoc's document: blocks become elements of its tree (JSON), so that no text is ever parsed again.

pandoc is called once a format, with the tree on its standard input. Numbers of sections, figures and tables are
words of the document, the same in all formats.
"""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator, Sequence
from typing import Any

from graphic_tmm.errors import SheetError, installing
from graphic_tmm.language.catalogue import code_of, speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.note.columns import shares
from graphic_tmm.note.document import (
    Block,
    Break,
    Contents,
    Display,
    Document,
    Figure,
    Formula,
    Heading,
    Letter,
    Listed,
    Number,
    Paragraph,
    Ref,
    Run,
    SideBySide,
    Symbol,
    Table,
    Text,
    letter_of,
    numbered,
    runs_of,
    short_numbers,
    walk,
)
from graphic_tmm.note.target import (
    LEADING,
    NONE,
    RAGGED,
    ContentsEntry,
    Outline,
    Target,
    Tree,
    as_words,
    classed,
    of,
)
from graphic_tmm.note.tex import one_word, spelt, tex
from graphic_tmm.note.widths import packed, pieces, wholes, width

API = [1, 23, 1]
"""The version of pandoc's tree that is written."""
UNSEEN: list[Any] = ["", [], [["typst:stroke", "none"], ["typst:inset", "0pt"]]]
"""A cell without lines and white (typst)."""
ALIGN = {"l": "AlignLeft", "c": "AlignCenter", "r": "AlignRight"}
BOXED = 55.0
"""Pieces of a formula wider than this, letters, may be parted anywhere."""
FIGURE, TABLE = said("Figure {number} — "), said("Table {number} — ")
CONTINUED = said("Table {number}, continued")
FIGURE_AT = said("figure {number}", "figures {number}")
TABLE_AT = said("table {number}", "tables {number}")


class _Writer:
    """Writes one document as the tree of one format."""

    def __init__(self, document: Document, target: Target) -> None:
        self.document, self.target = document, target
        self.speech = speaking(document.language)
        self.numbers = numbered(document)
        self.put = spelt if target.name in MARKDOWN else one_word

    def tree(self) -> Tree:
        meta = {
            "title": {"t": "MetaInlines", "c": as_words(self.document.title)},
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
            told = of("Para", self.inlines(block.runs))
            style = block.style or _set_as(block) or (LEADING if self.leads(k) else "")
            return self.target.styled(told, style) if style else [told]
        if isinstance(block, Display):
            return [one for rows in wholes(packed(block.formulas)) for one in self.whole(rows)]
        if isinstance(block, Listed):
            return list(self.listed(block))
        if isinstance(block, Table):
            made = self.table(block)
            return self.target.tabled(made, block)
        if isinstance(block, Figure):
            return self.figure(block)
        if isinstance(block, Contents):
            return self.target.contents(self.outline())
        assert isinstance(block, Break)
        return self.target.break_page()

    def leads(self, k: int) -> bool:
        """Whether a formula follows the block of a place: what leads to it stays with it."""
        following = self.document.blocks[k + 1 : k + 2] if k else ()
        return any(isinstance(one, Display) for one in following)

    def whole(self, rows: Sequence[Sequence[Formula]]) -> list[Tree]:
        """Return a formula line by line, or some beside one another."""
        told = [of("Para", [self.row(one)]) for one in rows]
        return self.target.whole(told) if len(told) > 1 else told

    def heading(self, block: Heading, k: int) -> Tree:
        number = self.numbers.headings.get(k)
        told = as_words(f"{number} ") if number else []
        classes = [] if block.numbered else ["unnumbered"]
        return of(
            "Header",
            [block.level, [_section(k), classes, []], [*told, *self.inlines(block.runs)]],
        )

    def listed(self, block: Listed) -> Iterator[Tree]:
        items = [[one for b in item.blocks for one in self.block(b)] for item in block.items]
        labels = [item.label for item in block.items]
        if all(labels):
            start = int(labels[0].partition("–")[0])
            style = [start, {"t": "Decimal"}, {"t": "OneParen"}]
            yield of("OrderedList", [style, items])
        else:
            yield of("BulletList", items)

    def table(self, block: Table) -> Tree:
        aligned = [
            [{"t": ALIGN[a]}, of("ColWidth", w) if w else {"t": "ColWidthDefault"}]
            for a, w in zip(block.align, self.widths(block), strict=True)
        ]
        caption = []
        if block.ruled:
            told = self.speech(
                CONTINUED if block.of else TABLE, number=self.numbers.tables[block.id]
            )
            whole = [*as_words(told), *(() if block.of else self.inlines(block.caption))]
            caption = [of("Plain", whole)]
        rows = [[self.cell(cell) for cell in row] for row in block.rows]
        heads = [_row([self.cell(cell) for cell in block.heads])] if any(block.heads) else []
        if heads and block.ruled and self.target.continued is not None:
            words = self.speech(CONTINUED, number=self.numbers.tables[block.id])
            inside = [of("Plain", [self.target.continued(block.id, words)])]
            heads.insert(0, _row([[UNSEEN, {"t": "AlignLeft"}, 1, len(block.heads), inside]]))
        attributes = [
            block.id if self.target.linked else "",
            [] if block.ruled else ["unruled"],
            [],
        ]
        return of(
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

    def widths(self, block: Table) -> tuple[float, ...]:
        """Return what the columns take of the text's width, 0 where the format finds that."""
        if block.widths:
            return block.widths
        if self.target.measured:
            return shares(block, self.document.language)
        return (0.0,) * len(block.align)

    def row_heads(self, block: Table) -> int:
        """Return how many cells of a row are its head: none where two rows stand beside one another."""
        half = len(block.heads) // 2
        folded = half > 0 and block.heads[:half] == block.heads[half:]
        return int(self.target.headed and any(block.heads) and not folded)

    def cell(self, runs: Sequence[Run]) -> list[Any]:
        inside = [of("Plain", self.inlines(runs))] if runs else []
        return [NONE, {"t": "AlignDefault"}, 1, 1, inside]

    def figure(self, block: Figure) -> list[Tree]:
        number = self.speech(FIGURE, number=self.numbers.figures[block.id])
        caption = [*as_words(number), *self.inlines(block.caption)]
        parts = block.parts if isinstance(block, SideBySide) else (block,)
        shown = [one for part in parts for one in (self.target.picture(part), {"t": "Space"})][:-1]
        if not self.target.captioned:
            return [of("Para", shown), of("Para", caption)]
        if self.target.figure is not None:
            return self.target.figure(block, of("Plain", caption))
        if isinstance(block, SideBySide) and self.target.styled_rows:
            row = classed(of("Para", shown), "Captioned Figure", block.id)
            return [row, classed(of("Para", caption), "Image Caption")]
        whole = [[block.id, [], []], [None, [of("Plain", caption)]], [of("Plain", shown)]]
        return [of("Figure", whole)]

    # ------------------------------------------------------------ runs

    def inlines(self, runs: Sequence[Run]) -> list[Tree]:
        return [one for run in runs for one in self.inline(run)]

    def inline(self, run: Run) -> list[Tree]:
        if isinstance(run, Symbol):
            return [self.math(run)]
        if isinstance(run, Formula):
            return list(self.formula(run))
        if isinstance(run, Number):
            return [of("Str", self.plain(run))]
        if isinstance(run, Letter):
            return [of("Str", letter_of(run.of, self.document.language))]
        if isinstance(run, Ref):
            words = as_words(self.plain(run))
            to = self.numbers.wholes.get(run.to, run.to)
            return [of("Link", [NONE, words, [f"#{to}", ""]])] if self.target.linked else words
        if not isinstance(run, Text):
            return []
        inside = as_words(run.text, self.target.word)
        if run.style == "strong":
            return [of("Strong", inside)]
        return [of("Emph", inside)] if run.style else inside

    def plain(self, run: Run) -> str:
        """Return a run as plain words."""
        if isinstance(run, Number):
            told = unit(run.unit, self.document.language)
            return run.text + (told if told in ("", "°") else f"\u00a0{told}")
        if isinstance(run, Ref):
            return self.referred(run)
        return run.text if isinstance(run, Text) else ""

    def referred(self, to: Ref) -> str:
        """Return what figures or tables are called: their kind once, behind it their numbers."""
        ids = self.whole_figures((to.to, *to.more))
        if to.to in self.numbers.figures:
            told = short_numbers([self.numbers.figures[one] for one in ids])
            words = FIGURE_AT
        else:
            told = list(dict.fromkeys(str(self.numbers.tables[one]) for one in ids))
            words = TABLE_AT
        lettered = len(told) > 1 and any("," in one for one in told)
        number = ("; " if lettered else ", ").join(told)
        return self.speech(words, number=number, n=len(told))

    def whole_figures(self, ids: Sequence[str]) -> list[str]:
        """Return ids, a figure for its parts where all of them are there."""
        whole = self.numbers.wholes
        short = {of for part, of in whole.items() if part not in ids}
        found = (whole[one] if one in whole and whole[one] not in short else one for one in ids)
        return list(dict.fromkeys(found))

    def row(self, beside: Sequence[Formula]) -> Tree:
        """Return formulas beside one another on a line of their own."""
        told = [tex(one, self.document.language, self.put) for one in beside]
        return of("Math", [{"t": "DisplayMath"}, r";\qquad ".join(told)])

    def formula(self, one: Formula) -> Iterator[Tree]:
        """Yield a formula among words, in pieces if the format parts it where it likes."""
        if self.target.piece is None:
            yield self.math(one)
            return
        for k, piece in enumerate(pieces(one)):
            if k:
                yield {"t": "Space"}
            short = sum(map(width, piece.sides)) < BOXED
            yield from self.target.piece(self.math(piece)) if short else [self.math(piece)]

    def math(self, one: Formula | Symbol) -> Tree:
        """Return a formula among words."""
        return of("Math", [{"t": "InlineMath"}, tex(one, self.document.language, self.put)])


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


def formulas(document: Document, *, parted: bool = False) -> int:
    """Return how many formulas a note has as it is written: beside one another they are one.

    ``parted``: those among words are counted in pieces.
    """
    found = 0
    for block in walk(document.blocks):
        if isinstance(block, Display):
            found += len(packed(block.formulas))
        else:
            runs = [run for run in runs_of(block) if isinstance(run, Formula | Symbol)]
            found += len(runs)
            if parted:
                found += sum(len(pieces(run)) - 1 for run in runs if isinstance(run, Formula))
    return found


MARKDOWN = ("gfm+tex_math_dollars", "markdown")


def _section(k: int) -> str:
    return f"section-{k}"


def _row(cells: list[Any]) -> list[Any]:
    return [NONE, cells]


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
        raise SheetError(
            said("a note needs pandoc: {remedy}", remedy=installing("[note]"))
        ) from error
