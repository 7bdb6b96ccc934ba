"""Chapters that a scene asks for and that have no result: they are left out by name, and the rest is drawn."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said
from graphic_tmm.project import Plan, Project, own_boards, record
from graphic_tmm.scene.captions import Named
from graphic_tmm.scene.chapter import MECHANISM, Chapter
from graphic_tmm.scene.records import Scene


def in_doubt(boards: tuple[Drawn, ...]) -> bool:
    """Whether a chapter of what was drawn has no result."""
    return any(True for one in boards for _ in _without(one.project, one.reading))


def without_absent(scene: Scene) -> Scene | None:
    """Return the scene not asking for chapters that the exact hand finds no result of; None if there are none.

    It keeps, by chapter, a sentence that says so with the remedy.

    Raises
    ------
    SceneError
        If the scene asks for nothing else.
    """
    gone = {one.name: one for one in _absent(scene)}
    if not gone:
        return None
    told = {
        name: said(
            "{chapter}: it is left out; {remedy}",
            chapter=chapter_title(one),
            remedy=Plan.of(one).remedy,
        )
        for name, one in gone.items()
    }
    own = {place.name for one in gone.values() for place in one.places}
    if scene.shown_places <= own:
        faults = (Fault(name, scene.told.get(name, 0), says) for name, says in told.items())
        raise SceneError(scene.source, tuple(faults))
    sections = {section.name: None for one in gone.values() for section in one.sections}
    return replace(scene.asking(**sections), left_out={**scene.left_out, **told})


def chapter_title(chapter: Chapter) -> str:
    """Return what a chapter is called, English."""
    words = Named.of(chapter).captions
    return words.get(f"chapter {chapter.name}", words.get(chapter.name, chapter.name))


def _absent(scene: Scene) -> Iterator[Chapter]:
    boards = own_boards(scene)
    for board in (*((MECHANISM,) if scene.mechanism is not None else ()), *boards):
        project = record(scene, board)
        marks = [
            mark
            for one in project.chapters
            for mark in Plan.of(one).result(project.recorded[one.name])
        ]
        given: Mapping[object, object] = dict.fromkeys(project.construction.given, 1.0)
        reading = execute(project.construction, {**given, **project.given}, marks)  # type: ignore[dict-item]
        yield from _without(project, reading)


def _without(project: Project, reading: Reading) -> Iterator[Chapter]:
    """Yield the chapters of which no result is known."""
    for one in project.chapters:
        marks = [
            mark for mark in Plan.of(one).result(project.recorded[one.name]) if mark in reading
        ]
        if any(not np.isfinite(reading[mark]).any() for mark in marks):
            yield one
