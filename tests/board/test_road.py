"""Which road is taken hangs on what is asked for alone."""

from __future__ import annotations

import pytest

from graphic_tmm.board import road as module
from graphic_tmm.board.road import MANY, PAYS, Road, road


@pytest.mark.parametrize("count", [2, MANY, PAYS])
def test_what_is_asked_for_is_done(count: int) -> None:
    assert road(True, 100, count) is Road.LOOPS
    assert road(False, 100, count) is (Road.STEPS if count == 2 else Road.LINES)


def test_else_the_work_decides() -> None:
    assert road(None, 100, PAYS // 100) is Road.LOOPS
    assert road(None, 100, PAYS // 100 - 1) is Road.LINES
    assert road(None, 100, MANY) is Road.LINES
    assert road(None, 100, MANY - 1) is Road.STEPS


def test_without_the_translator_all_is_executed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "translator", lambda: False)
    assert road(None, 100, PAYS) is Road.LINES


def test_rows_of_sheets_are_executed_step_by_step() -> None:
    """A turn by tenths of a degree of a log that fills ten sheets."""
    assert road(None, 5_000, 3_600) is Road.STEPS
