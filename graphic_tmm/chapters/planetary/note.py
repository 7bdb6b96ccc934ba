"""The section of a planetary train in a note; what follows: its ratio by the teeth and as drawn."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.planetary.plan import PLANETARY_PLAN
from graphic_tmm.chapters.planetary.table import verdict
from graphic_tmm.chapters.planetary.task import PLANETARY_TRAIN
from graphic_tmm.drawn import Drawn, results_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, result_number, results
from graphic_tmm.note.document import Block, Runs
from graphic_tmm.note.section_chapter import Noted, from_log
from graphic_tmm.scene.chapter import chapters

RATIO = said("The ratio of the train is {due} by its teeth and {drawn} as drawn, {apart} apart.")
NAMES = {
    "due": "planetary_ratio",
    "drawn": "planetary_ratio_drawn",
    "apart": "planetary_difference",
}


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of the train: what is measured on it stands where it is measured."""
    own = next(one for one in chapters() if one.name == PLANETARY_TRAIN)
    yield from from_log(drawn, own, language, tables=False)
    yield from results(drawn, own, language)


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield how near the drawn ratio comes to that of the teeth."""
    results = results_of(drawn, PLANETARY_PLAN.on(drawn).results)
    if set(NAMES.values()) <= set(results):
        put = {key: result_number(drawn, results, name, language) for key, name in NAMES.items()}
        yield filled(speaking(language)(RATIO), put)


def _concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    yield from concludes(drawn, language)
    yield from verdict(drawn, language)


NOTE = Noted(section=note, concludes=_concludes)
