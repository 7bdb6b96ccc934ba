"""The title page: who sets the task, what the note is called, who made it; and the contents behind it."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Block, Break, Contents, Runs, Table, paragraph, text

NOTE = said("Explanatory note")
TO = said("to the course project in the theory of mechanisms and machines")
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
    """Yield the title page and the contents."""
    _, fields = speaking(language), dict(made.scene.title_block)
    if organisation := fields.get("organisation"):
        yield paragraph(organisation, "centre")
    yield paragraph(EMPTY, "space")
    yield paragraph(_(NOTE), "title")
    yield paragraph(_(TO), "centre")
    yield paragraph(fields.get("name") or made.scene.title, "title")
    if fields.get("name") and fields["name"] != made.scene.title:
        yield paragraph(made.scene.title, "centre")
    if designation := fields.get("designation"):
        yield paragraph(designation, "centre")
    yield paragraph(EMPTY, "space")
    rows: list[tuple[Runs, ...]] = [
        (text(_(role)), text(LINE), text(fields.get(key, "") or LINE))
        for role, key in PEOPLE
        if key in ("drawn_by", "checked_by") or fields.get(key)
    ]
    yield Table("people", (), (), tuple(rows), "lcl", (0.34, 0.33, 0.33), ruled=False)
    yield paragraph(EMPTY, "space")
    yield Break()
    yield Contents()
