"""A million positions stay in bounded memory (memory is not time: it may be asserted)."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest


@pytest.mark.slow
def test_a_million_positions_take_less_than_500_mb() -> None:
    run = runpy.run_path(str(Path(__file__).with_name("run.py")))
    _, peak = run["peak_of_million"]()
    assert peak < 500
