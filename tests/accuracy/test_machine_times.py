"""What a user asks for, timed: the work of the commands, at half and twice the number of positions too."""

from __future__ import annotations

from typing import Any

import pytest
from support import gallery
from support.tasks import scales

from graphic_tmm.accuracy import machine_times as machine
from graphic_tmm.accuracy.drawing import References
from graphic_tmm.accuracy.machine_times import DEAR, DRAWN, SCALED, machine_times
from graphic_tmm.accuracy.measure import Measure
from graphic_tmm.accuracy.timing import CALLS, Calls, Key, Seconds, Stopwatch
from graphic_tmm.board.execute import Program
from graphic_tmm.paper.compose import search


class Fixed(Stopwatch):
    """Makes every call once and says that it takes a second, or ``dear`` is so."""

    def __init__(self, seconds: float) -> None:
        super().__init__(tick=1e-6)
        self.each = seconds
        self.keys: list[object] = []

    def in_turns(self, calls: Calls[Key]) -> dict[Key, Seconds]:
        self.keys += calls
        return {key: self._called(call, CALLS) for key, call in calls.items()}

    def once(self, calls: Calls[Key]) -> dict[Key, Seconds]:
        self.keys += calls
        return {key: self._called(call, 1) for key, call in calls.items()}

    def _called(self, call: Any, calls: int) -> Seconds:
        call()
        return Seconds(self.each, self.each, self.each, self.each, calls)


def times(name: str, seconds: float = DEAR / 2) -> dict[tuple[str, int], Seconds]:
    scene = gallery.scene(name)
    measure = Measure(scales(name), References(scene, scales(name)))
    watch = Fixed(seconds)
    rows = machine_times(scene, measure, watch)
    assert len(watch.keys) == len(rows)  # nothing is timed twice
    return {(one.what, one.positions): one.seconds for one in rows}


@pytest.mark.slow
def test_log_table_sheets_and_drawings_are_timed_at_half_and_twice_the_positions() -> None:
    found = times("slider-diagrams")
    whats = ("log", "table", "sheets", "drawings")
    assert list(found) == [(what, n) for what in whats for n in (4, 8, 16)]
    assert not any(one.doubtful for one in found.values())
    assert found["drawings", 8].least == pytest.approx(SCALED / DRAWN * found["log", 8].least)


@pytest.mark.slow
def test_what_is_dear_is_timed_once_away_from_the_scene_s_own_positions() -> None:
    found = times("slider-diagrams", 2 * DEAR)
    assert {key for key, one in found.items() if one.doubtful} == {k for k in found if k[1] != 8}


@pytest.mark.slow
def test_numbers_that_the_scene_cannot_be_drawn_at_are_left_out() -> None:
    """Four positions have not those that the crank-rocker names; the wheels of a planetary gear have no row."""
    assert {n for _, n in times("crank-rocker")} == {8, 16}
    assert len({n for _, n in times("planetary")}) == 1


def test_what_is_timed_is_the_work_of_the_commands(monkeypatch: pytest.MonkeyPatch) -> None:
    """The table and the sheets of a scene with so many positions, whole; the log by one hand and by many."""
    done: list[tuple[str, int]] = []

    def spied(of: Any, what: str, count: Any) -> Any:
        def run(*given: Any, **choice: Any) -> Any:
            done.append((what, count(*given, **choice)))
            return of(*given, **choice)

        return run

    files = spied(machine.sheet_files, "sheets", lambda scene, **_: scene.row.count)
    monkeypatch.setattr(machine, "sheet_files", files)
    told = spied(machine.table, "table", lambda made, form: made.scene.row.count)
    monkeypatch.setattr(machine, "table", told)
    run = spied(Program.run, "run", lambda program, given, hand=None, **_: hand and hand.trials)
    monkeypatch.setattr(Program, "run", run)
    times("slider-diagrams")
    for what in ("sheets", "table"):
        assert sorted(n for name, n in done if name == what) == [4, 8, 16]
    assert [n for what, n in done if what == "run" and n].count(DRAWN) == 3


@pytest.mark.slow
def test_every_table_and_sheet_is_drawn_as_of_a_scene_never_seen() -> None:
    """That a sheet holds these boxes was found by the call before; a person who waits has none before."""
    counts = []
    for _ in range(2):
        times("slider-diagrams")
        counts.append(search._fitting.cache_info())
    assert counts[0] == counts[1]
    assert counts[0].misses > 0
