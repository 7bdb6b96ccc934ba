"""Rows of a report: runs of lines read back."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.checking.report.rows import runs


@given(st.lists(st.integers(0, 60)))
def test_runs_of_lines_read_back(lines: list[int]) -> None:
    text = runs(lines)
    back: set[int] = set()
    for piece in text.removesuffix(", …").split(", ") if text else []:
        low, _, high = piece.partition("–")
        back |= set(range(int(low), int(high or low) + 1))
    due = {line for line in lines if line}
    assert back == due if "…" not in text else back < due
