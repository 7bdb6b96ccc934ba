"""The section of a gear pair in a note: dimensions in full, of the meshing what is calculated and read."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.gears.findings import verdict
from graphic_tmm.chapters.gears.table import gear_results
from graphic_tmm.chapters.gears.task import GEARS
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, result_number
from graphic_tmm.note.document import Block, Runs
from graphic_tmm.note.section_chapter import Noted, from_log
from graphic_tmm.scene.chapter import chapters

MESHING = "gear"
"""The view of the meshing: its teeth are drawn by the same steps many times."""
RATIO = said("The contact ratio is {due} by the formula and {drawn} as drawn, {apart} apart.")


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of the gear pair."""
    own = next(one for one in chapters() if one.name == GEARS)
    yield from from_log(drawn, own, language, (MESHING,), tables=False)


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield how near the drawn contact ratio comes to that of the formula."""
    results = gear_results(drawn)
    names = {
        "due": "contact_ratio",
        "drawn": "contact_ratio_drawn",
        "apart": "contact_ratio_difference",
    }
    put = {key: result_number(drawn, results, name, language) for key, name in names.items()}
    yield filled(speaking(language)(RATIO), put)


def _concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    yield from concludes(drawn, language)
    yield from verdict(drawn, language)


NOTE = Noted(section=note, concludes=_concludes)
