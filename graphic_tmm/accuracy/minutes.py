"""A user's own table of minutes, read from a TOML file: ``R1 = 0.1``, one elementary operation a line."""

from __future__ import annotations

from pathlib import Path

from graphic_tmm.accuracy.geometrography import ELEMENTARY
from graphic_tmm.errors import Fault, SceneError, first_of
from graphic_tmm.files import Kind
from graphic_tmm.language.said import said
from graphic_tmm.scene.document import document

MINUTES = Kind(
    said("a table of minutes"), said("name a TOML file with a line such as R1 = 0.1"), 100_000
)
LONGEST = 1e6
"""Minutes of one operation: two years."""
TOLD = 20
"""So many faults of a file are told."""


def read_minutes(file: str) -> dict[str, float]:
    """Return minutes by elementary operation; those that are left out keep their own.

    Raises
    ------
    SceneError
        If the file cannot be read (as `document`), names what is no elementary operation, or gives what is
        no number of minutes.
    """
    table = document(Path(file), MINUTES)[1]
    faults = []
    for name, value in table.items():
        if name not in ELEMENTARY:
            told = ", ".join(ELEMENTARY)
            faults.append(
                Fault(
                    name,
                    0,
                    said("there is no such elementary operation; there are {told}", told=told),
                )
            )
        elif isinstance(value, bool) or not isinstance(value, (int, float)) or not _able(value):
            faults.append(
                Fault(
                    name,
                    0,
                    said(
                        "write minutes as a number 0 to {longest:.0f}, such as 0.1", longest=LONGEST
                    ),
                )
            )
    if faults:
        raise SceneError(file, first_of(faults, TOLD))
    return {name: float(value) for name, value in table.items()}


def _able(value: float) -> bool:
    return 0 <= value <= LONGEST
