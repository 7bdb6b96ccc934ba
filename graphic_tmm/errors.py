"""Errors, each a message to a person.

::

    TmmError
    ├── SceneError            a file that is read: every fault with its key, its line and the remedy
    ├── StructureError        the links and pairs do not make a mechanism that this board can draw
    ├── ConstructionError     a step of a construction was recorded wrongly, or cannot be drawn
    ├── SheetError            the paper: a view that does not fit, a folder that cannot be written
    │   └── ViewError         a view that fits no sheet of its format
    ├── AbsentError           a name that is asked for and is not there (a KeyError, too)
    ├── MissingError          a package that is needed and not installed (an ImportError, too)
    └── BareError             the program runs without its docstrings, of which its sentences are made
"""

from __future__ import annotations

import errno
import re
import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Any, NamedTuple

from graphic_tmm.language.said import Said, joined, said

TRACEBACK = "GRAPHIC_TMM_TRACEBACK"
"""The variable of the environment by which a fault of the program shows where it is."""
LONGEST = 60
"""Greatest number of characters that a message quotes of a key or of a text of the scene."""


_QUOTED = re.compile(r'(?<!\w)"(.*?)"(?!\w)', re.DOTALL)
"""What a message quotes: a quotation mark after a letter does not open, one before a letter does not close."""


class TmmError(Exception):
    """The root of the tree: the command line prints its text and exits with status 2."""

    def in_language(self, speech: Callable[[str], str]) -> str:
        """Return the message in a language."""
        return speech(self.args[0])


class Fault(NamedTuple):
    """One fault of a file: the key's path, its line (0 if unknown), what is wrong and what to do."""

    key: str
    line: int
    message: str

    def for_reader(self, speech: Callable[[str], str]) -> Fault:
        """Return the fault as a person sees it: in a language, quotations not longer than they help."""
        key = self.key if len(self.key) <= LONGEST else f"{self.key[: LONGEST - 3]}..."
        message = _QUOTED.sub(_shortened, speech(self.message))
        return Fault(printable(key), self.line, printable(message))


def first_of(faults: Sequence[Fault], most: int, count: int = 0) -> tuple[Fault, ...]:
    """Return the first faults of a file; if there are more (``count``, or all those given), how many."""
    more = max(count, len(faults)) - most
    told = tuple(faults[:most])
    if more > 0:
        told += (
            Fault(
                "",
                0,
                said(
                    "and {n} more fault; put these right first",
                    "and {n} more faults; put these right first",
                    n=more,
                ),
            ),
        )
    return told


class SceneError(TmmError):
    """All faults of a file that is read at once."""

    def __init__(self, path: str, faults: tuple[Fault, ...]) -> None:
        self.path = path
        self.faults = faults
        super().__init__(self.in_language(str))

    def in_language(self, speech: Callable[[str], str]) -> str:
        """Return all faults in a language, each on a line of its own."""
        return "\n".join(self._line(fault, speech) for fault in self.faults)

    def _line(self, fault: Fault, speech: Callable[[str], str]) -> str:
        place = f"{self.path}:{fault.line}" if fault.line else self.path
        shown = fault.for_reader(speech)
        told = f"{shown.key}: {shown.message}" if shown.key else shown.message
        return f"{printable(place)}: {told}"


def printable(text: str) -> str:
    """Return a line that does nothing to a terminal: what is not printable as its escape."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


def _shortened(match: re.Match[str]) -> str:
    text = match[1]
    return f'"{text[:LONGEST]}..."' if len(text) > LONGEST + 3 else match[0]


class DrawnRemedy(NamedTuple):
    """A way out drawn small: lines from point to point, m; what is written then, by keys of a scene."""

    lines: tuple[tuple[complex, ...], ...]
    values: tuple[tuple[str, str], ...]


class StructureError(TmmError):
    """The links and pairs do not make a mechanism that this board can draw.

    ``keys``: those of a scene that it speaks of, as people write them: ``drive.zero``, ``link 3, side``; within
    an item of a list its own key alone. ``says``: the message without its ``head``, the section or the key that
    stands before it. ``pictures``: the ways out, where it lists some that can be drawn.
    """

    def __init__(
        self, message: str, *keys: str, head: str = "", pictures: tuple[DrawnRemedy, ...] = ()
    ) -> None:
        super().__init__(joined(": ", (head, message)) if head else message)
        self.keys, self.says, self.head, self.pictures = keys, message, head, pictures

    def inside(self, item: str) -> StructureError:
        """Return the error as one of an item of a list, ``load 2``."""
        keys = tuple(key if "." in key else f"{item}, {key}" for key in self.keys)
        return StructureError(self.says, *(keys or (item,)), head=self.head, pictures=self.pictures)


class ConstructionError(TmmError):
    """A step was recorded wrongly, or cannot be drawn; names plan, step and letter."""


class SheetError(TmmError):
    """The paper: a view that does not fit, a folder that cannot be written."""


class ViewError(SheetError):
    """A view that fits no sheet of its format, so that a remedy can be told.

    ``view``: its name; ``size``: mm; ``shows``: the views of the log of which it is the picture.
    """

    def __init__(
        self, message: str, view: str, size: tuple[float, float], shows: tuple[str, ...] = ()
    ) -> None:
        super().__init__(message)
        self.view, self.size, self.shows = view, size, shows


class AbsentError(TmmError, KeyError):
    """A name that is asked for and is not there: a table, a segment, a position, a result."""

    __str__ = Exception.__str__


class MissingError(TmmError, ImportError):
    """A package that is needed and is not installed."""

    __str__ = Exception.__str__


def in_single_file() -> bool:
    """Whether the program runs as one file that brings its own Python (PyInstaller sets the attribute)."""
    return bool(getattr(sys, "frozen", False))


def installing(package: str) -> str:
    """Return what installs a package, or an extra of this one: ``[pdf]``; a single file holds neither."""
    named = f'"graphic-tmm{package}"' if package.startswith("[") else package
    command = f"pip install {named}"
    if not in_single_file():
        return command
    return said("this single file has no such package; where Python is: {command}", command=command)


def needed(module: str, package: str) -> Any:
    """Return a module that may be missing.

    Raises
    ------
    MissingError
        If it is: how its package is installed.
    """
    try:
        return import_module(module)
    except ImportError as error:
        says = said(
            "this needs the package {package}: {remedy}",
            package=package,
            remedy=installing(package),
        )
        raise MissingError(says) from error


_REASONS = {
    errno.ENOENT: said("there is no such file or folder"),
    errno.EACCES: said("permission denied"),
    errno.EPERM: said("permission denied"),
    errno.EROFS: said("the disk can only be read"),
    errno.ENOSPC: said("no space is left on the disk"),
    errno.ENOTDIR: said("a file stands where a folder should be"),
    errno.EEXIST: said("a file stands where a folder should be"),
    errno.EISDIR: said("a folder stands there"),
    errno.ENAMETOOLONG: said("the name is too long"),
    errno.EADDRINUSE: said("the port is taken"),
    errno.EADDRNOTAVAIL: said("this computer has no such address"),
}


def reason_of(error: OSError | ValueError) -> str:
    """Return why the system refuses a file or an address; in its own words what people hardly meet."""
    if isinstance(error, OSError):
        own = error.strerror
        if isinstance(own, Said):
            return own
        return _REASONS.get(error.errno or 0) or str(own or error).lower()
    return said("no file can be called so")


def own_fault(error: BaseException) -> str:
    """Return the message on an unforeseen error: it is the program's, not the person's."""
    what = " ".join(f"{type(error).__name__}: {error}".split()).rstrip(":")
    return said(
        "a fault of the program, not of the input ({what}); "
        "set {variable}=1 to see where, and report it",
        what=what[:200],
        variable=TRACEBACK,
    )


class BareError(TmmError):
    """Python runs with ``-OO``, without docstrings, from which the sentences of steps are built."""

    def __init__(self) -> None:
        super().__init__(
            said(
                "python -OO throws away the texts of which the sentences are made; run it without "
                "-OO"
            )
        )
