"""A million positions stay in bounded memory (memory is not time: it may be asserted)."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).parent))


@pytest.mark.slow
def test_a_million_positions_take_less_than_500_mb() -> None:
    import growth

    assert growth.peak_of_million() < 500


@pytest.mark.slow
def test_memory_beyond_the_results_does_not_grow() -> None:
    import growth

    assert growth.beyond(1 << 19) < 1.1 * growth.beyond(1 << 17)
