"""The task sheets of the scenes of the package, each made once: in Russian and in English by turns."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache

from graphic_tmm.classroom.tasks.task import task_sheets
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.document import document
from graphic_tmm.scene.packaged import SCENE
from support.gallery import ALL, SHEETS, scene


def languages_of(name: str, many: Callable[[int, int], int]) -> tuple[str, ...]:
    """Return the language that a scene's task is told in; both when measured."""
    return ("ru", "en") if many(1, 0) else (_own(name),)


def papers(name: str, language: str = "") -> tuple[Sheet, ...]:
    """Return the sheets of a scene's task, readings wanted."""
    return _papers(name, language or _own(name))


def sheets(name: str, language: str = "") -> tuple[str, ...]:
    """Return the same as SVG."""
    return _written(name, language or _own(name))


def _own(name: str) -> str:
    return ("ru", "en")[ALL.index(name) % 2]


@cache
def _papers(name: str, language: str) -> tuple[Sheet, ...]:
    told = replace(scene(name), language=language)
    found = task_sheets(told, *document(SHEETS / name / "scene.toml", SCENE), readings=True)
    return tuple(found)


@cache
def _written(name: str, language: str) -> tuple[str, ...]:
    return tuple(map(svg, _papers(name, language)))
