"""What can go wrong, told to a person.

::

    TmmError
    ├── SceneError            the scene file: every fault with its key, its line and the remedy
    ├── StructureError        the links and pairs do not make a mechanism that this board can draw
    ├── ConstructionError     a step of a construction was recorded wrongly, or cannot be drawn
    └── SheetError            the paper: a view that does not fit, a folder that cannot be written
"""

from __future__ import annotations

from typing import NamedTuple


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
        return (
            f"{place}: {fault.key}: {fault.message}" if fault.key else f"{place}: {fault.message}"
        )


class StructureError(TmmError):
    """The links and pairs do not make a mechanism that this board can draw."""


class ConstructionError(TmmError):
    """A step was recorded wrongly, or cannot be drawn; names plan, step and letter."""


class SheetError(TmmError):
    """The paper: a view that does not fit, a folder that cannot be written."""
