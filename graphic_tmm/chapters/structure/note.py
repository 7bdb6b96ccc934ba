"""The section of structure in a note: links, pairs with their class, W, groups, the formula, the class."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.structure import PARTS, STRUCTURE
from graphic_tmm.chapters.structure.record import MOBILITY, Mobility
from graphic_tmm.chapters.structure.table import WORDS, link_name, pair_name
from graphic_tmm.chapters.structure.views import part_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure, dissect
from graphic_tmm.note.bricks import filled, in_columns, referred, side_by_side
from graphic_tmm.note.calculations import without_letters
from graphic_tmm.note.document import (
    Block,
    Display,
    Formula,
    Paragraph,
    Run,
    Symbol,
    Table,
    Text,
    text,
)
from graphic_tmm.note.figures import WALL, in_hand, picture
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.note.steps import NumberSource, calculated
from graphic_tmm.paper.lettering.letters import escape

MOVING = said(
    "The mechanism has {n} moving links and {p} pairs of class 5; pairs of class 4 there are none. "
    "Its mobility by Chebyshev's formula:"
)
ONE_DRIVE = said(
    "One link has to be driven: link {link}. Taken off with the frame it leaves groups that add no freedom."
)
GROUP = said("group {name}: class II, order 2, kind {kind}")
DRIVEN = said("driving link {name}: class I")
ATTACHED = said("In the order of their attachment the parts are shown in {}; the mobility of each:")
LINKS, PAIRS = said("Links of the mechanism"), said("Kinematic pairs of the mechanism")


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of structure."""
    mechanism = drawn.scene.mechanism
    assert mechanism is not None
    structure, found = dissect(mechanism), MOBILITY.of(drawn)
    words = WORDS[language]
    yield _links(mechanism, structure, language)
    yield _pairs(mechanism, structure, language)
    if found is not None:
        yield from _mobility(drawn, structure, found, language)
    yield Paragraph(text(f"{words['formula']}: {structure.formula}."))
    yield Paragraph(text(f"{words['class II' if structure.groups else 'class I']}."))


def _mobility(
    drawn: Drawn, structure: Structure, found: Mobility, language: str
) -> Iterator[Block]:
    """Yield W of the mechanism and of each part that it comes apart into, with its figure."""
    _ = speaking(language)
    told = NumberSource(drawn.board, drawn.construction, drawn.reading, STRUCTURE, 0, language)
    n, p5, _higher = _step(told, found.whole).uses
    put: dict[str, Run] = {"n": told.number(n), "p": told.number(p5)}
    yield Paragraph(filled(_(MOVING), put))
    yield Display((_calculated(told, found.whole),))
    yield Paragraph(filled(_(ONE_DRIVE), {"link": Text(str(structure.driver))}))
    held = in_hand(drawn, WALL)
    shown = {
        f"part-{name}": view for name, view in zip(found.parts, part_views(held, True), strict=True)
    }
    kinds = {group.name: group.kind for group in structure.groups}
    pictures, formulas = [], []
    for name, mark in found.parts.items():
        title = _(GROUP, name=name, kind=kinds[name]) if name in kinds else _(DRIVEN, name=name)
        pictures.append(picture(shown[f"part-{name}"], language)._replace(caption=text(title)))
        formulas.append(_calculated(told, mark))
    parts = side_by_side(pictures)
    yield referred(parts, language, ATTACHED)
    yield Display((formulas[0], *map(without_letters, formulas[1:])))
    yield from parts


def _step(told: NumberSource, mark: Mark) -> Step:
    found = told.log.step(mark)
    assert found is not None
    return found


def _calculated(told: NumberSource, mark: Mark) -> Formula:
    found = calculated(told, _step(told, mark))
    assert found is not None
    return found


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
    return in_columns(Table("table-links", text(speaking(language)(LINKS)), heads, rows, "cll"), 2)


def _pairs(mechanism: Mechanism, structure: Structure, language: str) -> Table:
    words = WORDS[language]
    rows = []
    for pair in structure.pairs:
        name = pair_name(pair, mechanism)
        joined = ",".join(str(k) for k in sorted(pair.links))
        index = f"{words[pair.kind + ' index']}_{{{escape(name)}}}({joined})"
        kind = words[f"kind {pair.kind}"]
        cells = [joined, kind, words["lower"], words["one freedom"]]
        rows.append(((Symbol(escape(name)),), *map(text, cells), (Symbol(index),)))
    heads = ("letter", "joined", "kind", "contact", "freedoms", "index")
    told = tuple(text(words[head]) for head in heads)
    return Table("table-pairs", text(speaking(language)(PAIRS)), told, tuple(rows), "ccllcc")


NOTE = Noted(section=note, places=(PARTS,))
