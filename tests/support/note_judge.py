"""What nobody should read in a note: told as faults, whatever scene it is of.

Formulas are read as they are printed, in TeX, and worked out by `support.tex_sums`; words as they stand.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from itertools import pairwise

from graphic_tmm.board.formula_text import Node
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.note.document import (
    Block,
    Break,
    Display,
    Document,
    Formula,
    Heading,
    Paragraph,
    Picture,
    Run,
    Symbol,
    Table,
    Text,
    Tree,
    runs_of,
    walk,
)
from graphic_tmm.note.tex import spelt, tex
from graphic_tmm.scene.records import Scene
from support.notes import words_of
from support.tex_sums import Unread, Worked, sides_of, worked_out

SPARE = 1.02
"""How much further than its rounding a sum may be off: figures are rounded more than once."""
INTERNATIONAL = {"ln", "sin", "cos", "arcsin", "arccos", "arctg", "inv", "arcinv", "sgn", "const"}
INTERNATIONAL |= {"max", "min"}
"""What Russian books write in Latin letters, too."""
NEVER = {
    "no number": r"\b(?:nan|NaN|inf)\b",
    "no value": r"\b(?:None|True|False)\b",
    "a nanometre on a metre": r"10⁻¹[²³⁴⁵⁶⁷⁸⁹]|\de-\d\d",
    "mark-up": r"[_^]\{|\{\w+\}|\\_",
    "two signs": r"[-+−] ?−|[-+−] -",
}
"""Shapes that no words of a note have, by what is wrong with them."""


def faults(made: DrawnScene, document: Document) -> Iterator[str]:
    """Yield what is wrong with a note, one line each."""
    blocks = list(walk(document.blocks))
    yield from _hollow(document.blocks)
    yield from _repeated(blocks, document.language)
    yield from _words(blocks, _own(made.scene), document.language)
    for formula in formulas(document):
        yield from _formula(formula, document.language)
    for block in blocks:
        for run in runs_of(block):
            if isinstance(run, Formula) and _of_itself(run):
                yield f"one letter on both sides: {tex(run, document.language, spelt)}"


def formulas(document: Document) -> Iterator[str]:
    """Yield the formulas of a note in TeX, each as one line, however it is broken."""
    for block in walk(document.blocks):
        yield from formulas_of(block, document.language)


def formulas_of(block: Block, language: str) -> Iterator[str]:
    """Yield the formulas of a block."""
    if isinstance(block, Display):
        yield from _joined(block, language)
    else:
        found = (run for run in runs_of(block) if isinstance(run, Formula))
        yield from (tex(run, language, spelt) for run in found)


def sum_of(formula: str) -> tuple[list[Worked], bool]:
    """Return what the sides of a formula with figures come to, and whether all come to the last of them."""
    known = []
    for side in sides_of(formula):
        try:
            known.append(worked_out(side.split(r"\quad")[0].rstrip(", ")))
        except Unread:
            continue
    if len(known) < 2:
        return known, True
    *others, last = known
    digit = _last_digit(sides_of(formula)[-1])
    apart = (
        abs(one.value - last.value) - max(SPARE * (one.off + last.off), SPARE * digit)
        for one in others
    )
    return known, all(far <= 1e-12 * abs(last.value) for far in apart)


def _last_digit(result: str) -> float:
    """Return what the last digit of a result is worth that was cut to fewer: 0,618; 0 of any other."""
    told = re.match(r"\D{0,8}?(\d+)(?:\{,\}|\.)(\d+)", result.strip())
    cut = told is not None and len((told[1] + told[2]).lstrip("0")) in (2, 3)
    return 10.0 ** -len(told[2]) if told is not None and cut else 0.0


def _joined(block: Display, language: str) -> list[str]:
    found: list[str] = []
    for one in block.formulas:
        told = tex(one, language, spelt)
        if one.follows and found:
            found[-1] += f" {told}"
        else:
            found.append(told)
    return found


def _formula(formula: str, language: str) -> Iterator[str]:
    known, right = sum_of(formula)
    if not right:
        yield f"its figures give {[one.value for one in known]}: {formula}"
    if re.search(r"[-+] -|nan|inf\b|None", formula):
        yield f"two signs, or no number: {formula}"
    for word in re.findall(r"\\(?:text|mathrm)\{([^{}]*)\}", formula):
        yield from (f"{one!r} in {formula}" for one in _foreign(word, language))


def _of_itself(one: Formula) -> bool:
    """Whether a formula finds a letter by the same letter."""
    first, *others = one.sides
    trees = (side for side in others if isinstance(side, Tree))
    told = (tree.put.get(name) for tree in trees for name in _names(tree.node))
    return isinstance(first, Symbol) and first in told


def _names(node: Node) -> Iterator[str]:
    if node.head == "name":
        yield node.word
    for part in node.parts:
        yield from _names(part)


def _hollow(blocks: tuple[Block, ...]) -> Iterator[str]:
    """Yield headings below which nothing stands, tables without rows, paragraphs without words."""
    for one, behind in zip(blocks, (*blocks[1:], Break()), strict=True):
        ended = isinstance(behind, Break) or (
            isinstance(behind, Heading) and isinstance(one, Heading) and behind.level <= one.level
        )
        if isinstance(one, Heading) and ended:
            yield f"nothing stands below the heading {_plain(one.runs)!r}"
        if isinstance(one, Table) and not one.rows:
            yield f"a table without rows: {one.id}"
        if isinstance(one, Paragraph) and not one.style and not _plain(one.runs).strip():
            yield "a paragraph without words"


def _repeated(blocks: list[Block], language: str) -> Iterator[str]:
    """Yield displays that stand twice in a row, rows of a table that do."""
    for one, behind in pairwise(blocks):
        if isinstance(one, Display | Paragraph) and one == behind and _plain(tuple(runs_of(one))):
            yield f"told twice: {_plain(tuple(runs_of(one)))[:80]!r}"
    for block in blocks:
        if isinstance(block, Table):
            rows = Counter(repr(row) for row in block.rows if any(row))
            yield from (
                f"{block.id} has a row twice: {row[:90]}" for row, n in rows.items() if n > 1
            )


def _words(blocks: list[Block], own: list[str], language: str) -> Iterator[str]:
    for block in blocks:
        runs = list(runs_of(block))
        told = [_bare("".join(map(_written, runs)), own)]
        told += [_bare(block.alt, own)] if isinstance(block, Picture) else []
        for words in told:
            yield from (f"{one!r} in {words[:120]!r}" for one in _foreign(words, language))
        told[0] = "  ".join(run.text for run in runs if isinstance(run, Text))
        for words in told:
            yield from (
                f"{what} in {words[:120]!r}"
                for what, shape in NEVER.items()
                if re.search(shape, words)
            )


def _written(run: Run) -> str:
    return run.text if isinstance(run, Text) else run.markup if isinstance(run, Symbol) else " · "


def _bare(words: str, own: list[str]) -> str:
    """Return words without those that are the scene's own, whose letters a note sets as symbols."""
    words = words.translate(_UNBRACED)
    for name in own:
        words = words.replace(name.translate(_UNBRACED), " ")
    return words


_UNBRACED = str.maketrans("", "", "{}")


def _foreign(words: str, language: str) -> list[str]:
    """Return the words that are of another language."""
    if language == "ru":
        quoted = re.sub(r'"[^"]*"|\[[^\]]*\]', " ", words)  # what is to be written into a scene
        found = re.findall(r"(?<![\w_^])[a-z]{3,}(?![\w_])", quoted)
        return [one for one in found if one not in INTERNATIONAL]
    return re.findall(r"[А-Яа-яё]{2,}", words)


def _own(scene: Scene) -> list[str]:
    """Return the words that are the scene's own, the longest first."""
    found = {scene.title, *scene.title_block.values(), *words_of(scene.author)}
    if scene.mechanism is not None:
        found |= {link.name or "" for link in scene.mechanism.by_number.values()}
    return sorted(filter(None, found), key=len, reverse=True)


def _plain(runs: tuple[Run, ...]) -> str:
    return "".join(run.text if isinstance(run, Text) else "·" for run in runs)
