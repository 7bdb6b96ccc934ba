"""Seconds by clocks that are known: turns, batches, quartiles, scatter, other work on the machine."""

from __future__ import annotations

import gc
from collections.abc import Callable
from itertools import chain, repeat

import pytest

from graphic_tmm.accuracy.timing import CALLS, COOL, MORE, TICKS, TURN, Seconds, Stopwatch
from graphic_tmm.errors import TmmError

LONG = 2 * COOL
"""Seconds of a call that is a turn of its own."""


class Machine:
    """A machine on which calls take the seconds that are told; ``share``: what of the day they get."""

    def __init__(self, share: float = 1.0) -> None:
        self.processor, self.day, self.share = 0.0, 0.0, share
        self.calls: list[str] = []

    def work(self, seconds: float, name: str = "") -> None:
        self.calls.append(name)
        self.processor += seconds
        self.day += seconds / self.share

    def call(self, *seconds: float, name: str = "") -> Callable[[], None]:
        """Return a call that takes these seconds in turn, the last of them ever after."""
        each = chain(seconds, repeat(seconds[-1]))
        return lambda: self.work(next(each), name)

    def watch(self, tick: float = 1e-6) -> Stopwatch:
        return Stopwatch(lambda: self.processor, lambda: self.day, tick)


def test_a_long_call_is_timed_warm_five_times_and_the_least_is_told() -> None:
    """The first call is slower and counts for nothing."""
    machine = Machine()
    row = (9.0, 1.2, 1.1, 1.0, 1.4, 1.3)
    found = machine.watch().in_turns({"it": machine.call(*row)})["it"]
    assert found == pytest.approx((1.0, 1.1, 1.2, 1.3, CALLS))
    assert (found.doubtful, len(machine.calls)) == (False, 1 + CALLS)


def test_of_a_short_call_as_many_are_timed_as_fill_a_turn() -> None:
    """Two warm up; the first of each turn is not counted; each is timed by itself, so that one may be quick."""
    machine, short = Machine(), TURN / 9.5
    usual = [short] * 25
    found = machine.watch().in_turns({"it": machine.call(*usual, short / 2, short)})["it"]
    assert (found.least, found.low) == pytest.approx((short / 2, short))
    assert found.calls == CALLS * 10 + 1
    assert len(machine.calls) == 2 + CALLS + found.calls


def test_a_call_after_another_is_slow_and_that_is_not_counted() -> None:
    """What ran between two slices has left nothing in the cache: the next call takes three times as long."""
    machine, last = Machine(), [""]

    def call(name: str) -> Callable[[], None]:
        def run() -> None:
            machine.work(1e-4 * (1.0 if last[0] == name else 3.0))
            machine.day += (
                1.0 if not last[0] else 0.0
            )  # another process has its turn while this warms up
            last[0] = name

        return run

    found = machine.watch().in_turns({name: call(name) for name in "ab"})
    assert min(one.calls for one in found.values()) > CALLS
    assert [one.high for one in found.values()] == pytest.approx([1e-4, 1e-4])


def test_a_coarse_clock_times_calls_in_batches() -> None:
    """A clock that ticks by 16 ms sees nothing of a call of 1 ms."""
    machine, tick = Machine(), 1 / 64
    coarse = Stopwatch(lambda: machine.processor // tick * tick, lambda: machine.day, tick)
    found = coarse.in_turns({"it": machine.call(1e-3)})["it"]
    assert found.least == pytest.approx(1e-3, rel=1 / TICKS)
    assert found.high == pytest.approx(1e-3, rel=1 / TICKS)


def test_calls_take_turns_so_that_a_disturbance_hits_a_few_of_each() -> None:
    machine = Machine()
    machine.watch().in_turns({name: machine.call(LONG, name=name) for name in "ab"})
    assert "".join(machine.calls) == "ab" + "ab" * CALLS


def test_what_scatters_is_timed_more_often_and_marked_if_it_still_does() -> None:
    machine = Machine()
    once = (1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 1.0)
    watch = machine.watch()
    found = watch.in_turns(
        {
            "calm": machine.call(1.0, 1.4, name="calm"),
            "settles": machine.call(*once, name="settles"),
            "wild": machine.call(1.0, *(1.0, 2.0) * CALLS, name="wild"),
        }
    )
    assert {name: one.doubtful for name, one in found.items()} == {
        "calm": False,
        "settles": False,
        "wild": True,
    }
    assert machine.calls.count("calm") == 1 + CALLS
    assert 1 + CALLS < machine.calls.count("settles") < 1 + CALLS + MORE
    assert machine.calls.count("wild") == 1 + CALLS + MORE == 1 + found["wild"].calls
    assert (watch.load.scattered, watch.load.calls) == (1, 3)


def test_what_is_kept_has_its_turns_spread_over_what_else_is_timed() -> None:
    machine = Machine()
    watch = machine.watch()
    watch.keep({"first": machine.call(LONG, 2 * LONG, LONG, name="k")})
    watch.keep({"first": machine.call(9.0), "second": machine.call(LONG, name="s")})
    watch.in_turns({"other": machine.call(LONG, name="o")})
    found = watch.kept()
    assert "".join(machine.calls) == "kk" + "sks" + "o" + "ooks" + "ooks" + "o" + "ks" + "s"
    assert [found[name].least for name in ("first", "second")] == pytest.approx([LONG, LONG])
    assert found["first"].calls == found["second"].calls == CALLS
    assert watch.load.calls == 3
    assert watch.kept() == {}


@pytest.mark.parametrize(
    ("seconds", "doubtful"),
    [
        (Seconds(1.0, 1.0, 1.2, 1.5), False),
        (Seconds(1.0, 1.0, 1.2, 1.51), True),
        (Seconds(0.1, 1.0, 1.2, 1.5), False),  # the least may be far below
        (Seconds(1.0, 1.0, 1.0, 1.0, CALLS - 1), True),
        (Seconds(0.0, 0.0, 0.0, 0.0), True),
    ],
)
def test_seconds_are_doubted_by_their_quartiles_and_number(
    seconds: Seconds, doubtful: bool
) -> None:
    assert seconds.doubtful is doubtful


def test_seconds_of_ten_times_the_work() -> None:
    assert Seconds(1.0, 2.0, 3.0, 4.0, 7).times(10.0) == (10.0, 20.0, 30.0, 40.0, 7)


@pytest.mark.parametrize(("share", "busy"), [(1.0, False), (0.95, False), (0.6, True)])
def test_other_work_is_seen_by_the_clock_on_the_wall(share: float, busy: bool) -> None:
    machine = Machine(share)
    watch = machine.watch()
    found = watch.in_turns({"long": machine.call(1.0), "short": machine.call(1e-4)})
    assert watch.load.elsewhere == pytest.approx(1.0 - share)
    assert watch.load.busy is busy
    assert found["long"].least == pytest.approx(1.0)  # the processor's own seconds


def test_a_machine_whose_times_scatter_is_busy_though_nobody_waits() -> None:
    machine = Machine()
    watch = machine.watch()
    calls = {k: machine.call(1.0, *(1.0, 2.0) * CALLS * MORE) for k in range(2)}
    watch.in_turns({**calls, **{k: machine.call(1.0) for k in range(2, 9)}})
    assert watch.load.elsewhere == 0.0
    assert watch.load.busy


def test_a_dear_call_is_timed_once_and_marked() -> None:
    machine = Machine()
    found = machine.watch().once({"dear": machine.call(2.0)})["dear"]
    assert found == (2.0, 2.0, 2.0, 2.0, 1)
    assert (found.doubtful, len(machine.calls)) == (True, 1)


def test_what_cannot_be_drawn_is_left_out() -> None:
    machine = Machine()

    def refused() -> None:
        raise TmmError("it locks")

    calls = {"it": machine.call(1.0), "refused": refused}
    assert list(machine.watch().in_turns(calls)) == list(machine.watch().once(calls)) == ["it"]


@pytest.mark.parametrize("enabled", [True, False])
def test_no_garbage_is_collected_meanwhile_and_then_as_before(enabled: bool) -> None:
    machine, seen = Machine(), []

    def run() -> None:
        seen.append(gc.isenabled())
        machine.work(1.0)

    before = gc.isenabled()
    try:
        (gc.enable if enabled else gc.disable)()
        machine.watch().in_turns({"it": run})
        assert gc.isenabled() is enabled
    finally:
        (gc.enable if before else gc.disable)()
    assert not any(seen[1:])


def test_the_clock_of_this_machine_ticks() -> None:
    watch = Stopwatch()
    assert 0.0 < watch.resolved < 1.0
    assert watch.load == (0.0, 0.0, 0, 0)
