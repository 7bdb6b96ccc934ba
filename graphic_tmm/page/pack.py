"""Rows of numbers as few bytes: a thousandth of a millimetre, alike rows once, second differences.

A row that is another one and a distance is that row; one that stays is a number. What is left is told by how
its steps change, which is little, byte plane by byte plane, so that the many zeros stand together.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals

UNIT = 0.001
"""What is told, mm."""
_ALIKE = 0.0004
"""A row that differs so little from a number, beside its rounding, stays, mm."""

Ints = NDArray[np.int64]


class Packer:
    """Takes rows of one length, (place,), gives back by what they are told, keeps each kind of row once."""

    def __init__(self) -> None:
        self.rows: list[Ints] = []
        self._known: dict[tuple[int, bytes], list[int]] = {}
        self._exact: list[Reals] = []

    def put(self, row: Reals, unit: float = UNIT) -> list[int]:
        """Return [a number] of a row that stays, [row, a distance] of one that is kept; in units.

        Where nothing is (NaN) anything is told: the last that was there.
        """
        filled = held(row) / unit
        first = round(float(filled[0]))
        if np.abs(filled - first).max() <= 0.5 + _ALIKE / UNIT:
            return [first]
        shape = filled - filled[0]
        for k in self._known.get(self._key(shape), []):
            whole = round(float(filled[0]) - float(self.rows[k][0]))
            if np.abs(self.rows[k] + whole - filled).max() <= 1.0:
                return [k, whole]
        self.rows.append(np.rint(filled).astype(np.int64))
        self._known.setdefault(self._key(shape), []).append(len(self.rows) - 1)
        return [len(self.rows) - 1, 0]

    def _key(self, shape: Reals) -> tuple[int, bytes]:
        """Return by what rows that may be alike are found: two steps of theirs, coarsely."""
        return shape.size, np.rint(shape[[shape.size // 3, shape.size // 2]] / 50.0).tobytes()


def held(row: Reals) -> Reals:
    """Return a row whose gaps hold what was before them."""
    there = np.isfinite(row)
    if not there.any():
        return np.zeros_like(row)
    before = np.maximum.accumulate(np.where(there, np.arange(row.size), -1))
    return np.asarray(row[np.where(before < 0, int(np.argmax(there)), before)])


def packed(rows: Sequence[Ints]) -> bytes:
    """Return rows of whole numbers as bytes: second differences, their sign in the last bit, four byte planes.

    Raises OverflowError for a number that needs more than 32 bits.
    """
    told = np.concatenate([_second(row) for row in rows]) if rows else np.zeros(0, np.int64)
    signed = np.where(told < 0, -2 * told - 1, 2 * told)
    if signed.size and int(signed.max()) >= 1 << 32:
        raise OverflowError("a row jumps by more than 32 bits tell")
    return signed.astype("<u4").view(np.uint8).reshape(-1, 4).T.tobytes()


def _second(row: Ints) -> Ints:
    return np.diff(row, n=2, prepend=(0, 0))


def unpacked(data: bytes, lengths: Iterable[int]) -> list[Ints]:
    """Return the rows that were `packed`, by their lengths; the page's program does the same."""
    planes = np.frombuffer(data, np.uint8).reshape(4, -1)
    signed = np.ascontiguousarray(planes.T).view("<u4")[:, 0].astype(np.int64)
    told = np.where(signed % 2, -(signed + 1) // 2, signed // 2)
    found, begun = [], 0
    for length in lengths:
        found.append(told[begun : begun + length].cumsum().cumsum())
        begun += length
    return found
