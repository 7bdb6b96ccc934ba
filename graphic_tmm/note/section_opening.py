"""How a note begins: the title page, the contents behind it, the introduction in the author's words."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Block, Break, Contents, Heading, Runs, Table, paragraph, text
from graphic_tmm.scene.author import ASSIGNMENT, DIPLOMA, PROJECT, WORK, Author

NOTE = said("Explanatory note")
TO = {
    PROJECT: said("to the course project"),
    WORK: said("to the course work"),
    ASSIGNMENT: said("to the graphical assignment"),
    DIPLOMA: said("to the diploma project"),
}
"""What the note belongs to."""
SUBJECT = said("in the theory of mechanisms and machines")
DISCIPLINE = said("in the discipline “{discipline}”")
THEME = said("on the theme")
CODE = said("{designation}", context="note")
VARIANT = said("Variant {variant}")
STUDENT = said("Student of group {group}")
PEOPLE = (
    (said("Drawn"), "drawn_by"),
    (said("Checked"), "checked_by"),
    (said("Standards"), "standards_by"),
    (said("Approved"), "approved_by"),
)
"""Who signs, and the fields of the title block that tell their names."""
LINE = "____________"
EMPTY = "\N{NO-BREAK SPACE}"
"""What stands in a line that is left empty: a writer leaves out a paragraph of nothing."""


def title_page(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the title page and the contents; lines of which nothing is told are left out."""
    author, fields = made.scene.author, made.scene.title_block
    department = author.department or fields.get("organisation", "")
    for told in (author.ministry, author.university, department):
        if told:
            yield paragraph(told, "centre")
    yield paragraph(EMPTY, "space")
    yield from _called(made, language)
    yield paragraph(EMPTY, "space")
    yield _people(author, fields, language)
    yield paragraph(EMPTY, "space")
    foot = " ".join(str(one) for one in (author.city, author.year) if one)
    if foot:
        yield paragraph(foot, "centre")
    yield Break()
    yield Contents()


def frame_fields(made: DrawnScene, language: str) -> dict[str, str] | None:
    """Return what the title blocks of the pages tell; None where the author wants no frames."""
    author, fields = made.scene.author, made.scene.title_block
    if not author.frame:
        return None
    found = {**fields, "name": author.theme or fields.get("name") or made.scene.title}
    if designation := fields.get("designation"):
        found["designation"] = speaking(language)(CODE, designation=designation)
    return found


def _called(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield what the note is called: to what work it belongs, its theme, its designation."""
    _, author, fields = speaking(language), made.scene.author, made.scene.title_block
    formal = bool(author.kind_of_work or author.discipline or author.theme)
    name = author.theme or fields.get("name") or made.scene.title
    yield paragraph(_(NOTE), "title")
    to = _(TO[author.kind_of_work or PROJECT])
    if author.discipline:
        yield paragraph(to, "centre")
        yield paragraph(_(DISCIPLINE, discipline=author.discipline), "centre")
    else:
        yield paragraph(f"{to} {_(SUBJECT)}", "centre")
    if formal:
        yield paragraph(_(THEME), "centre")
    yield paragraph(name, "title")
    if not author.theme and name != made.scene.title:
        yield paragraph(made.scene.title, "centre")
    if designation := fields.get("designation"):
        yield paragraph(_(CODE, designation=designation) if formal else designation, "centre")
    if author.variant:
        yield paragraph(_(VARIANT, variant=author.variant), "centre")


def _people(author: Author, fields: Mapping[str, str], language: str) -> Table:
    """Return who signs: a line for each, with the name if it is told."""
    _ = speaking(language)
    rows: list[tuple[Runs, ...]] = []
    for role, key in PEOPLE:
        if key in ("drawn_by", "checked_by") or fields.get(key):
            group = key == "drawn_by" and author.group
            told = _(STUDENT, group=author.group) if group else _(role)
            rows.append((text(told), text(LINE), text(fields.get(key, "") or LINE)))
    return Table("people", (), (), tuple(rows), "lcl", (0.34, 0.33, 0.33), ruled=False)


INTRODUCTION = said("Introduction")


def introduction(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the introduction, in the author's words; nothing without any."""
    told = (*made.scene.author.machine, *made.scene.author.introduction)
    if told:
        yield Heading(1, text(speaking(language)(INTRODUCTION)), numbered=False)
        yield from map(paragraph, told)
