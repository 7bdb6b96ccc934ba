"""Tasks and keys of variants as pieces of work: a task sheet and its key never stand in one folder."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path as File
from typing import NamedTuple

from graphic_tmm.board.scales import Scale
from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.template import short_of
from graphic_tmm.classroom.batch.work import Done, Work
from graphic_tmm.classroom.making import OPERATION, Request
from graphic_tmm.classroom.tasks.sentences import SCALES, families
from graphic_tmm.classroom.tasks.task import task_sheets
from graphic_tmm.classroom.variants.start import begun
from graphic_tmm.classroom.variants.variant import Base, Variant, scene_of, source_of, text_of
from graphic_tmm.errors import Fault, SceneError, first_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.lettering.letters import missing
from graphic_tmm.scene.document import quoted
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.splice import set_to

FORMATS = ("svg", "pdf", "png")
"""What the sheets of a task can be written as."""
KEYS = ("sheets", "table", "page", "note")
"""What a key can hold, besides the scene of its variant."""
MAKES = {"sheets": "draw", "table": "table", "page": "page", "note": "note"}
MOST = 20
"""So many faults of a table are told."""
TABLE = said("readings", context="file")
"""What a table of readings is called behind its variant."""
TASKS, SOLVED = "tasks", "keys"
"""The folders of the tasks, and of the keys."""


class Task(NamedTuple):
    """What a task is made of: what its sheets are called, the scene's text and where it would stand.

    ``language``: "" for the scene's own; ``readings``: a table of readings is handed in, too, to be filled in
    with what is measured: the scale factors are given then, those of the key. ``start``: see `works`.
    """

    name: str
    text: str
    source: str
    formats: tuple[str, ...] = ("svg",)
    language: str = ""
    readings: bool = False
    start: str = ""


def works(
    base: Base,
    variants: Sequence[Variant],
    table: str = "",
    *,
    formats: tuple[str, ...] = ("svg",),
    keys: tuple[str, ...] = ("sheets", "table"),
    notes: tuple[str, ...] = ("html",),
    start: str = "",
    language: str = "",
    readings: bool = False,
) -> list[Work]:
    """Return the works of the tasks of variants, and of their keys; of the scene itself if there are none.

    ``table``: where the variants are from, for messages. ``formats``: of all sheets. ``keys``: what keys hold,
    of `KEYS`; none at all if that is empty; ``notes``: the formats of their notes. ``start``: the
    composition that keys begin with, see `start_of`; "": each is composed by itself.

    Raises
    ------
    SceneError
        If the scene of a variant is not good: every fault of all of them, at its line of the table.
    """
    _refuse(base, variants, table)
    found = list[Work]()
    for one in variants or (None,):
        name = base.name if one is None else one.name
        text = base.text if one is None else _named(base, one, text_of(base, one, table))
        source = str(base.file if one is None else source_of(base, one))
        given = Task(name, text, source, formats, language, readings, start)
        found.append(Work(f"{TASKS}/{name}", f"{__name__}:task", given))
        if keys:
            makes = ("scene", *(MAKES[key] for key in keys))
            asked = Request(
                text,
                source,
                makes,
                formats,
                notes=notes,
                composition=start,
                lent=one is not None,
                language=language,
            )
            key = f"{SOLVED}/{name}"
            found.append(Work(key, OPERATION, (key, asked)))
    return found


def _named(base: Base, variant: Variant, text: str) -> str:
    """Return the text of a variant that bears its own name where the scene tells the number of its own."""
    note = base.doc.get("note")
    told = isinstance(note, dict) and "variant" in note
    return set_to(text, ("note", "variant"), quoted(variant.name)) if told else text


def _refuse(base: Base, variants: Sequence[Variant], table: str) -> None:
    faults = list[Fault]()
    for one in variants:
        try:
            scene_of(base, one, table, missing=missing)
        except SceneError as error:
            faults += error.faults
    if faults:
        raise SceneError(table or str(base.file), first_of(faults, MOST))


def task(given: Task) -> Done:
    """Make the sheets of a task.

    Raises
    ------
    TmmError
        If the scene is not good, or its mechanism cannot be drawn.
    """
    text, files = given.text, dict[str, str | bytes]()
    scene = _scene(given, text)
    own = _scene(given._replace(language=""), text).language if given.language else ""
    made, found = begun(scene, given.start, own) if given.readings else (None, None)
    if made is not None and found is not None and cells(made):
        table = f"{given.name}-{speaking(scene.language)(TABLE)}.csv"
        tables = short_of(scene, table, pictured=False, given=found.composition)
        files.update({f"{TASKS}/{name}": rows for name, rows in tables.items()})
        text = _scaled(text, found.scales)
        scene = _scene(given, text)
    sheets = task_sheets(scene, text, tomllib.loads(text), readings=given.readings)
    return Done({**_files(sheets, f"{TASKS}/{given.name}", given.formats), **files})


def _scene(given: Task, text: str) -> Scene:
    scene = judged(text.encode("utf-8"), File(given.source), missing=missing)
    return scene.spoken_in(given.language)


def _scaled(text: str, scales: Mapping[str, Scale]) -> str:
    """Return the text of a scene that gives the scale factors of its plans, as they are drawn."""
    there = tomllib.loads(text).get(SCALES, {})
    drawn = {f"mu_{one.symbol.removeprefix('μ_')}": one for one in scales.values()}
    for family in families().values():
        key = family[0]
        if key in drawn and not any(name in there for name in family):
            value = f"{drawn[key].value:g} {drawn[key].unit}"
            text = set_to(text, (SCALES, key), quoted(value))
    return text


def _files(sheets: Sequence[Sheet], stem: str, formats: Sequence[str]) -> dict[str, str | bytes]:
    """Return sheets as files: one each, but one PDF of all."""
    from graphic_tmm.paper.write.export import pdf, png
    from graphic_tmm.paper.write.svg import svg

    one: dict[str, Callable[[Sheet], str | bytes]] = {"svg": svg, "png": png}
    files: dict[str, str | bytes] = {}
    for form in formats:
        if form == "pdf":
            files[f"{stem}.pdf"] = pdf(sheets)
            continue
        for k, sheet in enumerate(sheets, 1):
            files[f"{stem}.{form}" if len(sheets) == 1 else f"{stem}-{k}.{form}"] = one[form](sheet)
    return files
