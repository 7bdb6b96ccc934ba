"""The section of structure in a note: links, pairs with their class, W, groups, the formula, the class."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.formula_text import Node
from graphic_tmm.chapters.structure.roles import link_name, pair_name
from graphic_tmm.chapters.structure.tables import WORDS
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Group, Structure, dissect
from graphic_tmm.note.bricks import filled
from graphic_tmm.note.document import (
    Block,
    Display,
    Formula,
    Number,
    Paragraph,
    Runs,
    Source,
    Symbol,
    Table,
    Text,
    Tree,
    text,
)
from graphic_tmm.paper.lettering.letters import escape

CLASS = said("Class")
MOVING = said(
    "The mechanism has {n} moving links and {p} pairs of class 5; pairs of class 4 there are none. "
    "Its mobility by Chebyshev's formula:"
)
ONE_DRIVE = said(
    "One link has to be driven: link {link}. Taken off with the frame it leaves groups that add no freedom; in "
    "the order of their attachment:"
)
GROUP = said("group {name}: class II, order 2, kind {kind}")
FORMULA = said("The formula of structure:")
WHOLE = said("The class of the mechanism is the highest of its groups: {class_}.")
LINKS, PAIRS = said("Links of the mechanism"), said("Kinematic pairs of the mechanism")


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of structure."""
    mechanism = drawn.scene.mechanism
    assert mechanism is not None
    structure = dissect(mechanism)
    _ = speaking(language)
    yield _links(mechanism, structure, language)
    yield _pairs(mechanism, structure, language)
    n, p = structure.moving, len(structure.pairs)
    yield Paragraph(_counted(_(MOVING), drawn.board, n=n, p=p))
    yield Display((_mobility(drawn, structure),))
    yield Paragraph(_counted(_(ONE_DRIVE), drawn.board, link=structure.driver))
    for group in structure.groups:
        yield Paragraph(text(_(GROUP, name=group.name, kind=group.kind) + ":"))
        yield Display((_free(drawn, group),))
    yield Paragraph(text(f"{_(FORMULA)} {structure.formula}."))
    yield Paragraph(text(_(WHOLE, class_="II" if structure.groups else "I")))


def _counted(told: str, board: str, **counts: int | str) -> Runs:
    """Return a sentence with counts in it; each of them is a number of the structure."""
    put = {
        name: Text(value) if isinstance(value, str) else _count(board, name, value)
        for name, value in counts.items()
    }
    return filled(told, put)


def _count(board: str, name: str, value: int) -> Number:
    return Number(str(value), "", Source("structure", board, name), float(value))


def _mobility(drawn: Drawn, structure: Structure) -> Formula:
    """Return W = 3n − 2p5 − p4 with its numbers."""
    n, p, w = structure.moving, len(structure.pairs), structure.mobility
    put = {"n": _count(drawn.board, "n", n), "p": _count(drawn.board, "p", p)}
    figures = Tree(_chebyshev("n", "p"), put)
    return Formula((Symbol("W"), Symbol("3·n − 2·p_5 − p_4"), figures, _count(drawn.board, "W", w)))


def _free(drawn: Drawn, group: Group) -> Formula:
    """Return that a group of two links and three pairs adds no freedom."""
    links = _count(drawn.board, f"links {group.name}", len(group.links))
    pairs = _count(drawn.board, f"pairs {group.name}", len(group.legs) + 1)
    figures = Tree(_chebyshev("n", "p"), {"n": links, "p": pairs})
    name = f"W_{{{group.name.replace('-', '–')}}}"
    return Formula((Symbol(name), figures, _count(drawn.board, f"W {group.name}", 0)))


def _chebyshev(links: str, pairs: str) -> Node:
    def times(figure: str, name: str) -> Node:
        return Node("·", (Node("figure", (), figure), Node("name", (), name)))

    both = Node("−", (times("3", links), times("2", pairs)))
    return Node("−", (both, Node("figure", (), "0")))


def _links(mechanism: Mechanism, structure: Structure, language: str) -> Table:
    words, frame = WORDS[language], mechanism.frame
    links = sorted((*mechanism.links, frame), key=lambda link: (link is frame, link.number))
    rows = tuple(
        (
            text(str(link.number)),
            text(link_name(mechanism, structure, link, language)),
            text(words["fixed" if link is frame else "movable"]),
        )
        for link in links
    )
    heads = text(words["number"]), text(words["link"]), text(words["mobility"])
    return Table("table-links", text(speaking(language)(LINKS)), heads, rows, "cll")


def _pairs(mechanism: Mechanism, structure: Structure, language: str) -> Table:
    words = WORDS[language]
    rows = []
    for pair in structure.pairs:
        name = pair_name(pair, mechanism)
        joined = ",".join(str(k) for k in sorted(pair.links))
        index = f"{words[pair.kind + ' index']}_{{{escape(name)}}}({joined})"
        cells = text(joined), text(words[f"kind {pair.kind}"]), text("5"), (Symbol(index),)
        rows.append(((Symbol(escape(name)),), *cells))
    heads = [words["letter"], words["joined"], words["kind"], speaking(language)(CLASS)]
    told = tuple(text(head) for head in (*heads, words["index"]))
    return Table("table-pairs", text(speaking(language)(PAIRS)), told, tuple(rows), "cclcc")
