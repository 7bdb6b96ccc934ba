"""A chapter of the book: what it is, how it answers, what sheets can show of it.

A chapter is a folder of `graphic_tmm.chapters` whose package declares a `Chapter` called CHAPTER. It is found
by being there, and gone when its folder is. What a reader wants to know of chapters is declared in the reader's
room, as an `Answer`; a chapter answers in the file that the answer names, which is imported when a reader asks.
A chapter that has no such file has nothing to say to that reader. What it recorded is got by a key (`Recorded`)
that stands with its records.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Protocol, Self, TypeVar, cast

if TYPE_CHECKING:
    from graphic_tmm.scene.declare import Section


T = TypeVar("T")
MECHANISM = "mechanism"
"""The board on which everything is drawn that moves with the mechanism."""


class Holder(Protocol):
    """What holds what chapters recorded: a bench at first, a project and a drawn board afterwards."""

    @property
    def recorded(self) -> Mapping[str, Any]:
        """What was recorded, by chapter."""


@dataclass(frozen=True)
class Recorded(Generic[T]):
    """What a chapter recorded on a board, by the name of the chapter."""

    chapter: str

    def of(self, holder: Holder) -> T | None:
        """Return what was made; None if the chapter was not called for."""
        made: T | None = holder.recorded.get(self.chapter)
        return made

    def on(self, holder: Holder) -> T:
        """Return what was made where it is known to have been."""
        made: T = holder.recorded[self.chapter]
        return made


def aside(chapter: str) -> str:
    """Return the name under which is held (see `Recorded`) what a chapter calculated beside its drawing."""
    return f"{chapter} aside"


@dataclass(frozen=True)
class Place:
    """What a sheet can show, by the name that scenes write.

    ``rank``: where it stands on a sheet that does not say what stands there; 0 where only a sheet that names
    it shows it. ``shows``: the plans of which it shows something, ``beside``: those of which it does so where
    they are drawn. ``together``: it is these places, one after the other. ``attends``: it stands behind this
    one even where no sheet asks for it; ``tells``: a part of another place stands behind this one, on the
    sheet that shows it. ``asks``: how a task asks for it, a sentence each, where it always does so alike.
    """

    name: str
    rank: int = 0
    shows: tuple[str, ...] = ()
    beside: tuple[str, ...] = ()
    together: tuple[str, ...] = ()
    attends: str = ""
    tells: str = ""
    asks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Answer:
    """What a reader asks of chapters: a subclass declares it, with what holds where a chapter says nothing.

    ``stands``: the file of a chapter's folder and the name in it where the chapter's answer stands.
    """

    stands: ClassVar[str]

    @classmethod
    def of(cls, chapter: Chapter) -> Self:
        """Return what a chapter answers.

        Raises
        ------
        TypeError
            If something else stands there.
        """
        return cast(Self, _answer(chapter, cls))  # type: ignore[arg-type]


@dataclass(frozen=True, eq=False)
class Chapter:
    """What a chapter is.

    ``number``: its place in the book, and in everything that is read. ``board``: on which board it stands, ""
    for none: then what it draws is told by a scene alone. ``builds_on``: the chapters whose marks it uses,
    which therefore record before it. ``places``: what sheets can show of it. ``sections``: what scenes may
    write for it; the first that does not only give something asks for the chapter. ``always``: it is recorded
    for every mechanism, whatever sheets show. ``drive``: "crank" where it takes only mechanisms that one crank
    drives, all round, "even" where any that goes evenly will do. ``answers``: to readers, of a
    chapter that has no ``folder``: the name of its package, set where it is found.
    """

    name: str
    number: int
    board: str = MECHANISM
    builds_on: tuple[str, ...] = ()
    places: tuple[Place, ...] = ()
    sections: tuple[Section, ...] = ()
    always: bool = False
    drive: str = ""
    answers: tuple[Answer, ...] = ()
    folder: str = ""

    @property
    def asking(self) -> Section | None:
        """The section that asks for what it shows; None if it has none, or is always there."""
        if self.always:
            return None
        return next((section for section in self.sections if not section.gives), None)


@cache
def _answer(chapter: Chapter, kind: type[Answer]) -> Answer:
    own = next((one for one in chapter.answers if isinstance(one, kind)), None)
    if own is not None or not chapter.folder:
        return own or kind()
    file, _, name = kind.stands.partition(".")
    if find_spec(f"{chapter.folder}.{file}") is None:
        return kind()
    answer = getattr(import_module(f"{chapter.folder}.{file}"), name, None) or kind()
    if not isinstance(answer, kind):
        raise TypeError(f"{chapter.folder}.{kind.stands} is no {kind.__name__}")
    return answer


_ADDED: list[Chapter] = []


@cache
def chapters(board: str | None = None) -> tuple[Chapter, ...]:
    """Return the chapters that there are, in the order of the book; only those of a ``board`` if it is told."""
    found = sorted((*_discovered(), *_ADDED), key=lambda chapter: chapter.number)
    return tuple(one for one in found if board is None or one.board == board)


def boards() -> tuple[str, ...]:
    """Return the boards on which chapters stand, in the order of the book."""
    return tuple(dict.fromkeys(one.board for one in chapters() if one.board))


@cache
def places() -> Mapping[str, tuple[Chapter, Place]]:
    """Return what sheets can show, by name, each with its chapter."""
    return {place.name: (one, place) for one in chapters() for place in one.places}


def _forget() -> None:
    chapters.cache_clear()
    places.cache_clear()


def in_order(board: str) -> tuple[Chapter, ...]:
    """Return the chapters of a board in the order in which they record: each behind those it builds on."""
    there = {one.name: one for one in chapters(board)}
    found: dict[str, Chapter] = {}

    def enter(one: Chapter) -> None:
        for name in one.builds_on:
            if name in there and name not in found:
                enter(there[name])
        found.setdefault(one.name, one)

    for one in there.values():
        enter(one)
    return tuple(found.values())


@cache
def _discovered() -> tuple[Chapter, ...]:
    book = import_module("graphic_tmm.chapters")
    rooms = sorted(module.name for module in pkgutil.iter_modules(book.__path__))
    return tuple(
        replace(import_module(f"{book.__name__}.{room}").CHAPTER, folder=f"{book.__name__}.{room}")
        for room in rooms
    )


@cache
def whole_book() -> None:
    """Import all of every chapter, late as it may be: every operation and every formula is known then."""
    book = import_module("graphic_tmm.chapters")
    for module in pkgutil.walk_packages(book.__path__, f"{book.__name__}."):
        import_module(module.name)


@contextmanager
def added(chapter: Chapter) -> Iterator[None]:
    """Add a chapter that stands elsewhere, as long as the context lasts."""
    _ADDED.append(chapter)
    _forget()
    try:
        yield
    finally:
        _ADDED.remove(chapter)
        _forget()
