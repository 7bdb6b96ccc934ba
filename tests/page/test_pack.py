"""Rows packed as bytes: they come back to a thousandth of a millimetre, and are always the same bytes."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.page.pack import UNIT, Packer, held, packed, unpacked


def _rows(seed: int) -> list[np.ndarray]:
    source = np.random.default_rng(seed)
    at = np.radians(np.arange(360.0))
    rows = [
        source.uniform(-200, 200)
        + source.uniform(0, 100) * np.cos(source.integers(1, 4) * at + source.uniform(0, 6))
        for _ in range(12)
    ]
    rows += [rows[0] + source.uniform(-50, 50) for _ in range(6)]
    return [*rows, np.full(360, 12.3456), np.where(at > 3.0, np.nan, rows[1])]


@pytest.mark.parametrize("seed", range(5))
def test_rows_come_back_to_a_thousandth(seed: int) -> None:
    packer = Packer()
    rows = _rows(seed)
    told = [packer.put(row) for row in rows]
    kept = unpacked(packed(packer.rows), [row.size for row in packer.rows])
    for row, where in zip(rows, told, strict=True):
        back = kept[where[0]] + where[1] if len(where) > 1 else np.full(row.size, where[0])
        assert np.nanmax(np.abs(back * UNIT - row)) <= UNIT * (1 + 1e-6)


def test_alike_rows_are_kept_once_and_what_stays_is_a_number() -> None:
    packer = Packer()
    told = [packer.put(row) for row in _rows(1)]
    assert len(packer.rows) <= 13
    assert told[18] == [12346]
    assert {where[0] for where in told[12:18]} == {0}


def test_the_same_rows_are_the_same_bytes() -> None:
    first, second = Packer(), Packer()
    for row in _rows(2):
        first.put(row)
        second.put(row)
    assert packed(first.rows) == packed(second.rows)


def test_smooth_rows_take_little() -> None:
    packer = Packer()
    for row in _rows(3):
        packer.put(row)
    import gzip

    assert len(gzip.compress(packed(packer.rows), 9, mtime=0)) < 1.2 * sum(
        r.size for r in packer.rows
    )


def test_gaps_hold_what_was_before_them() -> None:
    row = np.array([np.nan, 1.0, np.nan, np.nan, 4.0, np.nan])
    np.testing.assert_array_equal(held(row), [1.0, 1.0, 1.0, 1.0, 4.0, 4.0])
    np.testing.assert_array_equal(held(np.full(3, np.nan)), np.zeros(3))


def test_what_needs_more_than_32_bits_is_refused() -> None:
    with pytest.raises(OverflowError, match="32 bits"):
        packed([np.array([0, 2**40, 0])])
