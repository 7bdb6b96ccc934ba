"""A user's own table of minutes, read from a TOML file: ``R1 = 0.1``, one elementary operation a line."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path

from graphic_tmm.accuracy.geometrography import ELEMENTARY
from graphic_tmm.errors import Fault, SceneError


def read_minutes(file: str) -> dict[str, float]:
    """Return minutes by elementary operation; those that are left out keep their own.

    Raises
    ------
    SceneError
        If the file is no TOML, names what is no elementary operation, or gives what is no number of minutes.
    """
    try:
        table = tomllib.loads(Path(file).read_bytes().decode("utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        says = f"this is not TOML ({error}); write a line such as R1 = 0.1 for each operation"
        raise SceneError(file, (Fault("", 0, says),)) from error
    faults = []
    for name, value in table.items():
        if name not in ELEMENTARY:
            told = ", ".join(ELEMENTARY)
            faults.append(
                Fault(name, 0, f"there is no such elementary operation; there are {told}")
            )
        elif isinstance(value, bool) or not isinstance(value, (int, float)) or not _able(value):
            faults.append(Fault(name, 0, "write minutes as a number, 0 or more, such as 0.1"))
    if faults:
        raise SceneError(file, tuple(faults))
    return {name: float(value) for name, value in table.items()}


def _able(value: float) -> bool:
    return math.isfinite(value) and value >= 0.0
