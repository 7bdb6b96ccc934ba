"""Where a mechanism locks, and its motion there in digits."""

from __future__ import annotations

from typing import Any

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np

from graphic_tmm.mechanism.records import Mechanism
from support import oracle
from support.drawn import board
from support.hard_judge import DIGITS


def locks(mechanism: Mechanism, start: float) -> float | None:
    """Return up to which crank angle (degrees) a mechanism assembles from ``start`` on; None if it turns."""
    sheet = board(mechanism)

    def there(angles: list[float]) -> Any:
        found = sheet.read([angles])["r"].values()
        return np.logical_and.reduce(
            [np.isfinite(np.broadcast_to(v, (len(angles),))) for v in found]
        )

    rows = [start + k for k in range(360)]
    bad = np.flatnonzero(~there(rows))
    if not bad.size:
        return None
    low, high = rows[bad[0] - 1], rows[bad[0]]
    for _ in range(44):
        middle = (low + high) / 2
        low, high = (middle, high) if there([middle])[0] else (low, middle)
    return low


def solved_at(mechanism: Mechanism, degrees: float) -> tuple[dict[int, Any], Any] | None:
    """Return poses (floats) and rates in digits, near to where the board stands; None where it does not."""
    read = board(mechanism).read([[degrees]])["r"]
    at = {letter: complex(z[0]) for (letter, _), z in read.items()}
    if not np.isfinite(list(at.values())).all():
        return None
    start = oracle.poses_from_points(mechanism, degrees, at)

    def phi() -> Any:
        return mp.mpf(degrees) * mp.pi / 180

    try:
        return dict(start), oracle.solve_digits(mechanism, phi, start, dps=DIGITS)
    except oracle.OracleError:
        return None
