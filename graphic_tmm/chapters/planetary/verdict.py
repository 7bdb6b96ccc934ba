"""That a train fulfils all conditions on its teeth, in words: no other is drawn."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.planetary.beside import BESIDE
from graphic_tmm.chapters.planetary.plan import PLANETARY_PLAN
from graphic_tmm.drawn import Drawn, Results, results_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, result_number
from graphic_tmm.note.document import Runs

SEVERAL = said(
    "All conditions of the train hold: its wheels have a common axis, {taken} satellites are fewer than touch "
    "(at most {most} have room) and can be put in, no tooth is undercut."
)
ONE = said("All conditions of the train hold: its wheels have a common axis, no tooth is undercut.")


def train_results(drawn: Drawn) -> Results:
    """Return the results of a train, with the ratios of its meshes and how many satellites have room."""
    beside = BESIDE.on(drawn)
    found = dict(PLANETARY_PLAN.on(drawn).results)
    found |= {f"planetary_mesh_{k}": mark for k, mark in enumerate(beside.stopped, 1)}
    if beside.most is not None:
        found["planetary_most"] = beside.most
    return results_of(drawn, found)


def verdict(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield one sentence: a train that breaks a condition is refused."""
    found, _ = train_results(drawn), speaking(language)
    if "planetary_most" not in found:
        yield filled(_(ONE), {})
        return
    names = {"taken": "planetary_satellites", "most": "planetary_most"}
    put = {key: result_number(drawn, found, name, language) for key, name in names.items()}
    yield filled(_(SEVERAL), put)
