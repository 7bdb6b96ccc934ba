"""What tests of the board share."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from graphic_tmm.board.dimensions import fault
from graphic_tmm.board.formula import FORMULAS
from graphic_tmm.board.grammar import OPERATIONS


@pytest.fixture
def apart() -> Iterator[None]:
    """What a test declares is gone afterwards."""
    kept = dict(OPERATIONS), dict(FORMULAS)
    yield
    for table, before in zip((OPERATIONS, FORMULAS), kept, strict=True):
        table.clear()
        table.update(before)  # type: ignore[call-overload]
    fault.cache_clear()
