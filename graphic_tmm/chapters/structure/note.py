"""The section of structure in a note: links, pairs with their class, W, groups, the formula, the class."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.chapters.structure import PARTS, REPLACING
from graphic_tmm.chapters.structure.record import MOBILITY, Mobility
from graphic_tmm.chapters.structure.replacing import replaced_formula
from graphic_tmm.chapters.structure.table import (
    LINK_HEADS,
    PAIR_HEADS,
    WORDS,
    aside_lines,
    link_rows,
    otherwise_lines,
    pair_rows,
)
from graphic_tmm.chapters.structure.views import part_views
from graphic_tmm.chapters.structure.views_replacing import replacing_views
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain
from graphic_tmm.mechanism.structure import Structure
from graphic_tmm.note.bricks import in_columns, referred, side_by_side
from graphic_tmm.note.calculations import without_letters
from graphic_tmm.note.document import Block, Display, Runs, Symbol, Table, paragraph, text
from graphic_tmm.note.figures import readable
from graphic_tmm.note.page import Page
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.drawing import Drawing

MOVING = said(
    "The mechanism has {n} moving links and {p} pairs of class 5; it has no pairs of class 4. "
    "Its mobility by Chebyshev's formula:"
)
HIGHER = said(
    "The mechanism has {n} moving links, {p} pairs of class 5, and {p4} of class 4: wheels in mesh. Its "
    "mobility by Chebyshev's formula:"
)
FLEXIBLE = said(
    "The mechanism has {n} moving links, {p} pairs of class 5, and {p4} of class 4: wheels in mesh or joined "
    "by a belt or a chain, which takes one freedom as a mesh does. Its mobility by Chebyshev's formula:"
)
WHEEL = said("Wheel {name}: a lower and a higher pair")
BELTED = said("Wheel {name}: a lower pair and a flexible link, which counts as a higher one")
ONE_DRIVE = said(
    "One link has to be driven: link {link}. Without it and the frame there remain groups of zero mobility."
)
SEVERAL_DRIVES = said(
    "Several links have to be driven: links {links}. Without them and the frame there remain groups of zero "
    "mobility."
)
TELESCOPED = said(
    "A rod and its cylinder are one link of a group, as long as the drive makes it; in the cylinder the rod "
    "moves with one freedom."
)
DRIVEN = said("Driving link {name}: class I")
DRIVEN_ROD = said("Rod in its cylinder {name}: class I")
ATTACHED = said("The parts are shown in {} in the order of their attachment; the mobility of each:")
REPLACED = said(
    "In place of each higher pair a link with two turning pairs moves the wheels as it does at that moment, "
    "velocities and accelerations alike: from one end of the line of action to the other, where the base "
    "circles touch it, or along the pulling run of a belt. The replacing linkage is shown in {}; its mobility:"
)
LINKS, PAIRS = said("Links of the mechanism"), said("Kinematic pairs of the mechanism")


Cells = tuple[Runs, ...]


class StructurePage(Page[Structure]):
    """A mechanism as it comes apart into its parts."""

    def views(self) -> list[Drawing]:
        """Return the parts, in the order of their attachment."""
        return readable(
            self.drawn,
            lambda held: part_views(held, True),
            lambda held: replacing_views(held, True),
        )

    def blocks(self) -> Iterator[Block]:
        """Yield links, pairs, the mobility, the formula of structure, the class."""
        mechanism, structure, language = self.drawn.scene.mechanism, self.recorded, self.language
        assert mechanism is not None
        found, words = MOBILITY.of(self.drawn), WORDS[language]
        links = [tuple(map(text, row)) for row in link_rows(mechanism, structure, language)]
        yield in_columns(self._table("links", LINKS, LINK_HEADS, links, "cll"), self.language, 2)
        pairs = [
            ((Symbol(letter),), *map(text, cells), (Symbol(index),))
            for letter, *cells, index in pair_rows(mechanism, structure, language)
        ]
        yield self._table("pairs", PAIRS, PAIR_HEADS, pairs, "ccllcc")
        if found is not None:
            yield from self._mobility(structure, found)
        for line in aside_lines(mechanism, structure, language):
            yield paragraph(f"{plain(line)}.")
        yield paragraph(f"{words['formula']}: {structure.formula}.")
        yield paragraph(f"{words[f'class {structure.numeral}']}.")
        for line in otherwise_lines(mechanism, structure, language):
            yield paragraph(f"{line}.")
        if found is not None and found.replaced:
            shown = side_by_side(self.figures(*self.pictures))
            yield referred(shown, self.language, REPLACED)
            yield from self.worked_out(*found.replacing.values())
            yield paragraph(f"{words['formula']}: {replaced_formula(structure)}.")
            yield from shown

    def _mobility(self, structure: Structure, found: Mobility) -> Iterator[Block]:
        """Yield W of the mechanism and of each part that it comes apart into, with its figure."""
        whole = self.drawn.construction.step(found.whole)
        assert whole is not None
        n, p5, higher = whole.uses
        if structure.wheels:
            flexible = any(one.mesh.belted for one in structure.wheels)
            yield self.says(FLEXIBLE if flexible else HIGHER, n=n, p=p5, p4=higher)
        else:
            yield self.says(MOVING, n=n, p=p5)
        yield from self.worked_out(found.whole)
        driven = structure.driven
        if len(driven) == 1:
            yield self.says(ONE_DRIVE, link=structure.first.link)
        else:
            yield self.says(SEVERAL_DRIVES, links=", ".join(str(one.link) for one in driven))
        rods = {one.name for one in driven if one.telescopes}
        if rods:
            yield self.says(TELESCOPED)
        groups = {group.name: group.described for group in structure.groups}
        called = dict.fromkeys(rods, DRIVEN_ROD)
        called |= {one.name: BELTED if one.mesh.belted else WHEEL for one in structure.wheels}
        titles = [
            self.sentence(groups[name])
            if name in groups
            else self.sentence(called.get(name, DRIVEN), name=name)
            for name in found.parts
        ]
        names = [name for name in self.pictures if name.startswith("part-")]
        shown = zip(self.figures(*names), titles, strict=True)
        parts = side_by_side([one._replace(caption=caption) for one, caption in shown])
        yield referred(parts, self.language, ATTACHED)
        for block in self.worked_out(*found.parts.values()):
            assert isinstance(block, Display)
            first, *others = block.formulas
            yield Display((first, *map(without_letters, others)))
        yield from parts

    def _table(
        self, name: str, title: str, heads: Sequence[str], rows: Sequence[Cells], align: str
    ) -> Table:
        words = WORDS[self.language]
        told = tuple(text(words[head]) for head in heads)
        return Table(f"table-{name}", text(self.speech(title)), told, tuple(rows), align)


NOTE = Noted(StructurePage, places=(PARTS, REPLACING))
