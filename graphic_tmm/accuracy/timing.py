"""Seconds of the processor that calls take, in a way that other work on the machine disturbs little.

Calls take turns, so that a disturbance that lasts hits a few of each and not all of one. A short call is made
several times a turn, each by itself (between two changes of process some run undisturbed), the first of them
uncounted; one that the clock does not resolve, in a batch. No garbage is collected meanwhile.
"""

from __future__ import annotations

import gc
import time
from collections.abc import Callable, Hashable, Iterator, Mapping
from contextlib import contextmanager, suppress
from math import ceil
from typing import Any, NamedTuple, TypeVar

import numpy as np

from graphic_tmm.errors import TmmError

CALLS, MORE = 5, 4
"""Turns of each call; and further ones of a call whose times scatter."""
BETWEEN = (1, 3)
"""Turns after which what is kept has one, too."""
TURN = 0.004
"""Seconds that a turn lasts; what is shorter is called several times."""
COOL = 0.01
"""The first call of a turn counts only if it lasts so long, s: what it has lost of the cache is little then."""
TICKS = 4
"""A batch lasts at least so many ticks of the clock, which is known to a quarter then."""
APART = 1.5
"""Quartiles that far apart are not believed."""
BUSY, SCATTERED = 1.15, 0.1
"""The machine is busy if so many times the seconds of the processor pass by the wall clock, or if that share of
what was timed scatters. Chosen by eye."""

Key = TypeVar("Key", bound=Hashable)
Calls = Mapping[Key, Callable[[], object]]
"""What is timed, by whatever it is told apart by."""


class Seconds(NamedTuple):
    """Seconds of the processor that a call takes, warm: least of ``calls``, quartiles, median."""

    least: float
    low: float
    median: float
    high: float
    calls: int = CALLS

    @property
    def doubtful(self) -> bool:
        """Whether they scatter, or were counted too few times, to be believed."""
        return self.calls < CALLS or not 0.0 < self.high <= APART * self.low

    def times(self, factor: float) -> Seconds:
        """Return the seconds of so many times the work."""
        least, low, median, high = (factor * each for each in self[:4])
        return Seconds(least, low, median, high, self.calls)


class Load(NamedTuple):
    """What else the machine did: seconds of the processor and of the wall clock, calls that scatter."""

    processor: float
    wall: float
    scattered: int
    calls: int

    @property
    def elsewhere(self) -> float:
        """The share of the wall clock that went to other work."""
        return max(1.0 - self.processor / self.wall, 0.0) if self.wall > 0.0 else 0.0

    @property
    def busy(self) -> bool:
        """Whether times had better be taken again on a quieter machine."""
        return self.wall > BUSY * self.processor or self.scattered > SCATTERED * self.calls


class _Row:
    """A call, how many of it are timed in a batch, and what each call took."""

    def __init__(self, call: Callable[[], object], batch: int = 1) -> None:
        self.call, self.batch, self.turns = call, batch, 0
        self.found: list[float] = []

    @property
    def seconds(self) -> Seconds:
        low, median, high = (float(x) for x in np.quantile(self.found, (0.25, 0.5, 0.75)))
        return Seconds(min(self.found), low, median, high, len(self.found))


class Stopwatch:
    """Times calls, and keeps in mind how busy the machine was.

    ``clock``: seconds of the processor; ``wall``: of the day. ``tick``: the least step of the clock, looked for
    if None.
    """

    def __init__(
        self,
        clock: Callable[[], float] = time.process_time,
        wall: Callable[[], float] = time.perf_counter,
        tick: float | None = None,
    ) -> None:
        self.clock, self.wall = clock, wall
        self.resolved = TICKS * (_tick(clock) if tick is None else tick)
        self._processor = self._wall = 0.0
        self._scattered = self._calls = 0
        self._kept: dict[Any, _Row] = {}

    @property
    def load(self) -> Load:
        """What else the machine did while this was timing."""
        return Load(self._processor, self._wall, self._scattered, self._calls)

    def in_turns(self, calls: Calls[Key]) -> dict[Key, Seconds]:
        """Return the seconds of each call, warm; what cannot be drawn is left out."""
        return self._seconds(dict(self._warmed(calls)))

    def keep(self, calls: Calls[Key]) -> None:
        """Time calls for a turn, and those kept before; they have other turns while something else is timed.

        So the turns of what is timed by the hundred are spread over all that the program does.
        """
        new = {key: call for key, call in calls.items() if key not in self._kept}
        self._kept |= dict(self._warmed(new))
        self._pass()

    def kept(self) -> dict[Any, Seconds]:
        """Return the seconds of the calls that were kept; they have what they still lack of their turns."""
        rows, self._kept = self._kept, {}
        return self._seconds(rows)

    def _warmed(self, calls: Calls[Key]) -> Iterator[tuple[Key, _Row]]:
        for key, call in calls.items():
            with suppress(TmmError):
                yield key, self._warm(call)

    def _pass(self) -> None:
        """Give what is kept a turn each."""
        for row in self._kept.values():
            if row.turns < CALLS:
                self._turn(row)

    def _seconds(self, rows: Mapping[Key, _Row]) -> dict[Key, Seconds]:
        """Return the seconds of rows, after as many turns as they lack, and more where they scatter."""
        for turn in range(CALLS + MORE):
            for row in rows.values():
                if row.turns < CALLS or row.seconds.doubtful:
                    self._turn(row)
            if turn in BETWEEN:
                self._pass()
        found = {key: row.seconds for key, row in rows.items()}
        self._calls += len(found)
        self._scattered += sum(one.doubtful for one in found.values())
        return found

    def once(self, calls: Calls[Key]) -> dict[Key, Seconds]:
        """Return the seconds of calls that are dear: of one each, doubtful therefore; see `in_turns`."""
        rows = {key: _Row(call) for key, call in calls.items()}
        for row in rows.values():
            with suppress(TmmError):
                self._turn(row)
        return {key: row.seconds for key, row in rows.items() if row.found}

    def _warm(self, call: Callable[[], object]) -> _Row:
        """Warm a call up; see how many of it the clock resolves."""
        start = self.wall()
        call()
        lasted = self.wall() - start
        if lasted < COOL:
            start = self.wall()
            call()
            lasted = min(lasted, self.wall() - start)
        return _Row(call, min(ceil(self.resolved / lasted), MANY) if lasted > 0.0 else MANY)

    def _turn(self, row: _Row) -> None:
        """Time calls for as long as a turn lasts; the first of short ones finds its data out of the cache."""
        spent, count, row.turns = 0.0, 0, row.turns + 1
        with _no_collection():
            while spent < TURN and count < MANY:
                seconds, count = self._timed(row), count + 1
                if count > 1 or seconds >= COOL:
                    row.found.append(seconds / row.batch)
                    spent += seconds

    def _timed(self, row: _Row) -> float:
        wall, start = self.wall(), self.clock()
        for _ in range(row.batch):
            row.call()
        seconds = self.clock() - start
        self._wall += self.wall() - wall
        self._processor += seconds
        return seconds


MANY = 1000
"""Calls of a batch, and batches of a turn, at most."""
LOOK = 0.05
"""Seconds by the wall clock for which the tick of a clock is looked for."""


def _tick(clock: Callable[[], float]) -> float:
    """Return the least step of a clock of the processor."""
    least, first, until = LOOK, clock(), time.perf_counter() + LOOK
    for _ in range(3):
        while (now := clock()) == first and time.perf_counter() < until:
            pass
        least, first = min(least, now - first or LOOK), now
    return least


@contextmanager
def _no_collection() -> Iterator[None]:
    """Hold off the collection of garbage."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()
