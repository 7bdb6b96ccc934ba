"""The literature: as the author lists it; else the books that the chapters follow, and standards."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import code_of, speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Block, Heading, Item, Listed, paragraph, text
from graphic_tmm.scene.captions import Named

LITERATURE = said("Literature")
BOOKS: dict[str, str] = {
    "artobolevsky": said(
        "Artobolevsky I. I. Theory of Mechanisms and Machines. 4th ed. Moscow: Nauka, 1988 (in Russian)."
    ),
    "popov": said(
        "Popov S. A., Timofeev G. A. Course Projects in the Theory of Mechanisms and the Mechanics of "
        "Machines. Moscow: Vysshaya Shkola, 1999 (in Russian)."
    ),
    "assur": said(
        "Assur L. V. An Investigation of Plane Linkages with Lower Pairs by their Structure and "
        "Classification. Moscow: Academy of Sciences, 1952 (in Russian)."
    ),
    "contour": said("GOST 13755-2015. Cylindrical involute gears. Basic rack."),
    "geometry": said("GOST 16532-70. Cylindrical involute gears of external meshing. Geometry."),
    "scales": said("GOST 2.302-68. Unified system of design documents. Scales."),
    "lines": said("GOST 2.303-68. Unified system of design documents. Lines."),
    "letters": said("GOST 2.304-81. Unified system of design documents. Letters."),
    "iso scales": said("ISO 5455. Technical drawings. Scales."),
    "iso lines": said("ISO 128-2. Technical product documentation. Basic conventions for lines."),
    "iso letters": said("ISO 3098-1. Technical product documentation. Lettering."),
}
"""By the names under which chapters name them."""
ESKD, ISO = ("scales", "lines", "letters"), ("iso scales", "iso lines", "iso letters")
"""What every sheet is drawn by: a Russian one, another."""


def literature(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the literature: the author's list, else in the order in which chapters call for it."""
    told = made.scene.author.literature or _called_for(made, language)
    yield Heading(1, text(speaking(language)(LITERATURE)), numbered=False)
    yield Listed(tuple(Item(str(k), (paragraph(one),)) for k, one in enumerate(told, 1)))


def _called_for(made: DrawnScene, language: str) -> list[str]:
    """Return the books that the chapters of a note follow, and the standards of every sheet."""
    chapters = sorted(
        {one.number: one for drawn in made.boards for one in drawn.project.chapters}.values(),
        key=lambda one: one.number,
    )
    named = dict.fromkeys(key for one in chapters for key in Named.of(one).sources)
    keys = (*named, *(ESKD if code_of(language) == "ru" else ISO))
    return [speaking(language)(BOOKS[key]) for key in keys]
