"""A chapter of the book: what it asks of a scene, what it records on a board. Nobody outside names one.

A chapter is a folder of `graphic_tmm.chapters` whose package declares a `Chapter` called CHAPTER. It is found by
being there, and gone when its folder is. What a chapter asks for and what it made are got by keys (`Asked`,
`Made`) that stand beside its records.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

if TYPE_CHECKING:
    from collections.abc import Mapping

    from graphic_tmm.scene.records import Scene

T = TypeVar("T")


@dataclass(frozen=True)
class Asked(Generic[T]):
    """What a section of a scene asks for, by the name of the section."""

    section: str

    def of(self, scene: Scene) -> T | None:
        """Return what the scene asks for; None if it has no such section."""
        found: T | None = scene.tasks.get(self.section)
        return found

    def put(self, scene: Scene, task: T | None) -> Scene:
        """Return the scene asking for ``task`` instead; None: not asking."""
        return scene.asking(**{self.section: task})


class Holder(Protocol):
    """What holds what chapters made: a bench while it is recorded, a drawn board afterwards."""

    @property
    def made(self) -> Mapping[str, Any]:
        """What was made, by chapter."""


@dataclass(frozen=True)
class Made(Generic[T]):
    """What a chapter made on a board, by the name of the chapter."""

    chapter: str

    def of(self, holder: Holder) -> T | None:
        """Return what was made; None if the chapter was not called for."""
        found: T | None = holder.made.get(self.chapter)
        return found


@dataclass(frozen=True)
class Chapter:
    """What a chapter declares of itself.

    ``number``: its place in the book; what stands on one board is recorded in this order.
    """

    name: str
    number: int


_ADDED: list[Chapter] = []


def chapters() -> tuple[Chapter, ...]:
    """Return the chapters that there are, in the order of the book."""
    return tuple(sorted((*_found(), *_ADDED), key=lambda chapter: chapter.number))


@cache
def _found() -> tuple[Chapter, ...]:
    book = import_module("graphic_tmm.chapters")
    rooms = sorted(module.name for module in pkgutil.iter_modules(book.__path__))
    return tuple(import_module(f"{book.__name__}.{room}").CHAPTER for room in rooms)


@contextmanager
def added(chapter: Chapter) -> Iterator[None]:
    """Add a chapter that stands elsewhere, as long as the context lasts."""
    _ADDED.append(chapter)
    try:
        yield
    finally:
        _ADDED.remove(chapter)
