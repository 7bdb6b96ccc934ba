"""Chapters that a scene asks for and that have no result: they are left out by name, and the rest is drawn."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Mark
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
    why = {one.name: (one, remedy) for one, remedy in _absent(scene)}
    gone = {name: one for name, (one, _) in why.items()}
    if not gone:
        return None
    told = {
        name: said(
            "{chapter}: it is left out; {remedy}",
            chapter=chapter_title(one),
            remedy=why[name][1],
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


def _absent(scene: Scene) -> Iterator[tuple[Chapter, str]]:
    boards = own_boards(scene)
    for board in (*((MECHANISM,) if scene.mechanism is not None else ()), *boards):
        project = record(scene, board)
        marks = [mark for one in project.chapters for mark in _telling(one, project)]
        given: Mapping[object, object] = dict.fromkeys(project.construction.given, 1.0)
        reading = execute(project.construction, {**given, **project.given}, marks)  # type: ignore[dict-item]
        yield from _without(project, reading)


def _telling(one: Chapter, project: Project) -> list[Mark]:
    """Return the marks that tell whether a chapter has a result, and why it has none."""
    plan, made = Plan.of(one), project.recorded[one.name]
    return [*plan.result(made), *(mark for mark, _ in plan.causes(made))]


def _without(project: Project, reading: Reading) -> Iterator[tuple[Chapter, str]]:
    """Yield the chapters of which no result is known, and why."""
    for one in project.chapters:
        plan, made = Plan.of(one), project.recorded[one.name]
        lost = {
            mark
            for mark in _telling(one, project)
            if mark in reading and not np.isfinite(reading[mark]).any()
        }
        if not lost.isdisjoint(plan.result(made)):
            causes = (remedy for mark, remedy in plan.causes(made) if mark in lost)
            yield one, next(causes, plan.remedy)
