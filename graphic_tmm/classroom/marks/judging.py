"""A hand-in judged, as a piece of work: its report, its row; and what is due of other variants."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.pencil.reading import questions as asked_for
from graphic_tmm.checking.photo.picture import Sent
from graphic_tmm.checking.photographed import Photographed, photographed
from graphic_tmm.checking.pictures import laid
from graphic_tmm.checking.readings.read import readings_of
from graphic_tmm.checking.records import Report, Taken
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.json import json_report
from graphic_tmm.classroom.batch.work import Done, Work
from graphic_tmm.classroom.marks.row import Row, dues, row_of, text
from graphic_tmm.classroom.variants.start import begun, drawn_by, kept_composition
from graphic_tmm.errors import Fault, SceneError, SheetError, TmmError
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.lettering.letters import missing
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

REPORTS, ROWS = "reports", "rows"
"""The folders of the reports, a page and a JSON each, and of the rows."""


class By(NamedTuple):
    """By what is judged, as the options of `check`."""

    hand: str = "student"
    points: str = "paper"
    trials: int = 400
    doubtful: float = 0.97
    wrong: float = 5.0
    scales: tuple[str, ...] = ()
    turns: tuple[str, ...] = ()


class Task(NamedTuple):
    """A scene to judge by: what its file holds and where that would stand, the language that is asked for.

    ``composition``: that of its sheets, as its file holds it, "" for none; ``lent``: that of the scene that it
    is a variant of, with which its own begins.
    """

    text: str
    source: str
    language: str = ""
    composition: str = ""
    lent: bool = False


class Given(NamedTuple):
    """A hand-in with all that its judgement hangs on.

    ``tables``: names and bytes of files; ``photographs``: paths with the number of the sheet (0: by turns) and
    the digest of what is there. Their bytes travel apart: of a class they would fill the memory.
    """

    file: str
    task: Task
    by: By
    tables: tuple[tuple[str, bytes], ...]
    photographs: tuple[tuple[str, int, str], ...] = ()


def work(given: Given) -> Work:
    """Return the work of judging a hand-in."""
    brings = dict.fromkeys((path, digest) for path, _, digest in given.photographs)
    return Work(given.file, f"{__name__}:judge", given, tuple(brings))


def judge(given: Given, photographs: Mapping[str, bytes] | None = None) -> Done:
    """Judge a hand-in; one that cannot be read is a row that tells why, without a report.

    ``photographs``: their bytes by path.
    """
    try:
        report, row = _judged(given, photographs or {})
    except TmmError as error:
        language = scene_of(given.task).language
        row, files = Row(skipped=error.in_language(speaking(language))), {}
    else:
        name = f"{REPORTS}/{given.file}"
        files = {f"{name}.html": html_report(report), f"{name}.json": json_report(report)}
    return Done({f"{ROWS}/{given.file}.json": text(row), **files})


def scene_of(task: Task) -> Scene:
    """Return the scene of a task; raises as `scene.read.read`."""
    scene = judged(task.text.encode("utf-8"), Path(task.source), missing=missing)
    return scene.spoken_in(task.language)


@lru_cache(maxsize=8)
def composition_of(task: Task) -> Composition | None:
    """Return the composition of a task's sheets; raises TmmError if its variant cannot be drawn."""
    if task.lent:
        own = scene_of(task._replace(language=""))
        return begun(scene_of(task), task.composition, own.language)[1].composition
    return kept_composition(task.composition, task.source)


@lru_cache(maxsize=2)
def checker(task: Task, by: By) -> Checker:
    """Return by what drawings of a scene are checked, found once for a class that draws one."""
    return Checker(
        scene_of(task),
        hand=by.hand,
        points=by.points,
        trials=by.trials,
        limits=Limits(by.doubtful, by.wrong),
        given=sizes_of(task),
        scales=by.scales,
        turns=by.turns,
    )


def sizes_of(task: Task) -> Composition | None:
    """Return a composition by which a task's figures are those of its sheets."""
    if task.lent:
        return drawn_by(scene_of(task._replace(language="")), task.composition)
    return composition_of(task)


def _judged(given: Given, photographs: Mapping[str, bytes]) -> tuple[Report, Row]:
    """Return the report on a hand-in and its row; its tables count, or else its photographs."""
    if given.tables:
        taken, notes = _read(given)
        by = given.by
    else:
        taken, notes = _seen(given, photographs)
        by = given.by._replace(points="photo")
    source = given.tables[0][0] if given.tables else given.photographs[0][0]
    of = checker(given.task, by)
    found = of.of(taken, source)
    speech = speaking(of.scene.language)
    told = (*found.report.notes, *map(speech, notes))
    report = found.report._replace(notes=told)
    return report, row_of(of.made, found._replace(report=report))


def _read(given: Given) -> tuple[tuple[Taken, ...], list[str]]:
    """Return the readings of the tables, those of a further one numbered on, and notes."""
    taken: list[Taken] = []
    notes: list[str] = []
    for name, data in given.tables:
        new = readings_of(Path(name), data)
        first = max((one.line for one in taken), default=0)
        if taken and new:
            notes.append(said("Lines from {first} on: {name}.", first=first + 1, name=name))
        keys = {one.at for one in taken}
        again = [one for one in new if one.at in keys]
        if again:
            says = said("{segment}: this is in another file, too", segment=again[0].segment)
            raise SceneError(name, (Fault("", again[0].line, says),))
        taken += [one._replace(line=one.line + first) for one in new]
    if not taken:
        says = said("there is no reading in it: fill in the figures")
        raise SceneError(given.tables[0][0], (Fault("", 0, says),))
    if given.photographs:
        notes.append(said("The readings of the tables were judged, not the photographs."))
    return tuple(taken), notes


def _seen(given: Given, photographs: Mapping[str, bytes]) -> tuple[tuple[Taken, ...], list[str]]:
    """Return what the photographs show, and what they do not."""
    scene, composition = scene_of(given.task), composition_of(given.task)
    taken: list[Taken] = []
    notes: list[str] = []
    for turn, (path, sheet, _) in enumerate(given.photographs, 1):
        shown = laid(scene, Sent(path, photographs[path]), "", sheet or turn, composition)
        notes += shown.flat.warnings
        seen = photographed(shown, {}, given.by.hand)
        if seen is not None:
            notes += asked_for(seen.found, scene.language)
            taken += _numbered(seen, taken)
    if not taken:
        says = said("{file}: no point of a plan is seen in the photograph", file=path)
        raise SheetError(says)
    return tuple(taken), notes


def _numbered(seen: Photographed, taken: Sequence[Taken]) -> list[Taken]:
    """Return the points that a further photograph shows, if an earlier one does not, numbered on."""
    keys, first = {one.key for one in taken}, max((one.line for one in taken), default=0)
    return [one._replace(line=one.line + first) for one in seen.taken if one.key not in keys]


def place(variant: str) -> str:
    """Return the name of the file of a variant's row."""
    return f"{ROWS}/variants/{variant}.json"


def work_of_dues(variant: str, task: Task) -> Work:
    """Return the work of drawing a variant exactly."""
    return Work(f"variants/{variant}.json", f"{__name__}:due", (variant, task))


def due(given: tuple[str, Task]) -> Done:
    """Draw a variant exactly: a row that has nothing but what is due; that too if it cannot be drawn."""
    variant, task = given
    try:
        row = Row(dues=dues(make(scene_of(task), exact=True, given=sizes_of(task))))
    except TmmError:
        row = Row()
    return Done({place(variant): text(row)})
