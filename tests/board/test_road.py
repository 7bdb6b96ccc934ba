"""Whether a log is compiled depends on what is asked for alone."""

from __future__ import annotations

import pytest

from graphic_tmm.board import execute as module
from graphic_tmm.board.execute import PAYS, compiles


@pytest.mark.parametrize("count", [2, PAYS])
@pytest.mark.parametrize("fast", [True, False])
def test_what_is_asked_for_is_done(count: int, fast: bool) -> None:
    assert compiles(fast, 100, count) is fast


def test_else_the_work_decides() -> None:
    assert compiles(None, 100, PAYS // 100)
    assert not compiles(None, 100, PAYS // 100 - 1)


def test_without_the_translator_all_is_executed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "translator", lambda: False)
    assert not compiles(None, 100, PAYS)


def test_rows_of_sheets_are_executed_step_by_step() -> None:
    """A turn by tenths of a degree of a log that fills ten sheets."""
    assert not compiles(None, 5_000, 3_600)
