"""What can go wrong, told to a person.

::

    TmmError
    ├── SceneError            the scene file: every fault with its key, its line and the remedy
    ├── StructureError        the links and pairs do not make a mechanism that this board can draw
    ├── ConstructionError     a step of a construction was recorded wrongly, or cannot be drawn
    └── SheetError            the paper: a view that does not fit, a folder that cannot be written
        └── ViewError         a view that fits no sheet of its format
"""

from __future__ import annotations

import re
from typing import NamedTuple

LONGEST = 60
"""Of a key, and of a text of the scene that a message quotes, so many characters are shown."""


class TmmError(Exception):
    """The root of the tree: the command line prints its text and exits with status 2."""


class Fault(NamedTuple):
    """One fault of a scene file: the key's path, its line (0 if unknown), what is wrong and what to do."""

    key: str
    line: int
    message: str


class SceneError(TmmError):
    """All faults of a scene file at once."""

    def __init__(self, path: str, faults: tuple[Fault, ...]) -> None:
        self.path = path
        self.faults = faults
        super().__init__("\n".join(self._line(fault) for fault in faults))

    def _line(self, fault: Fault) -> str:
        place = f"{self.path}:{fault.line}" if fault.line else self.path
        message = re.sub(rf'"([^"]{{{LONGEST}}})[^"]{{4,}}"', r'"\1..."', fault.message)
        key = fault.key if len(fault.key) <= LONGEST else f"{fault.key[: LONGEST - 3]}..."
        return _printable(f"{place}: {key}: {message}" if key else f"{place}: {message}")


def _printable(text: str) -> str:
    """Return text that does nothing to a terminal: what is not printable as its escape."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


class StructureError(TmmError):
    """The links and pairs do not make a mechanism that this board can draw."""


class ConstructionError(TmmError):
    """A step was recorded wrongly, or cannot be drawn; names plan, step and letter."""


class SheetError(TmmError):
    """The paper: a view that does not fit, a folder that cannot be written."""


class ViewError(SheetError):
    """A view that fits no sheet of its format: its name and size (mm), so that a remedy can be told."""

    def __init__(self, message: str, view: str, size: tuple[float, float]) -> None:
        super().__init__(message)
        self.view, self.size = view, size
