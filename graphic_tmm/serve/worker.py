"""A process that draws: one task at a time, the urgent first; ended, and begun anew, when one takes too long.

A task that holds it for long while others wait is broken off as well, and begun again when nobody waits: one
giant among the scenes of a folder keeps nobody from the others.

It is told a function of `jobs` and what it is called with, and answers with what that returns. Ctrl-C of the
terminal does not reach it: who began it ends it.
"""

from __future__ import annotations

import asyncio
import gc
import itertools
import multiprocessing
import os
import signal
import time
import traceback
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from graphic_tmm.errors import TRACEBACK, own_fault
from graphic_tmm.language.said import said
from graphic_tmm.serve.limits import BEGINNING, MEMORY, WAITING

T = TypeVar("T")
NICE = 5
"""By so much what is patient stands back."""
PATIENCE = 5.0
"""s that a task may keep others waiting: three times what a sheet of the package's own scenes takes."""
LAST = 1_000
"""The urgency of a task that has kept others waiting; everything else comes before it."""
SLOW = 10
"""A task may take so many times its seconds of the processor by the clock: others are at work, too."""
LOOK = 0.1
"""So often, s, it is looked whether others wait."""
QUIET, BUSY = 0.5, 10
"""After so many s without a task, or after so many tasks, what is left of them is taken away."""


class TooLong(Exception):
    """A task took longer than it may: the seconds."""


class Gone(Exception):
    """The process ended in a task, or there is no room for one more."""


class Broken(Exception):
    """A task met an error that nobody has foreseen: what is told of it."""


class _Yields(Exception):
    """A task has kept others waiting for too long."""


class _Job(NamedTuple):
    urgency: int
    number: int
    job: Callable[..., Any]
    given: tuple[Any, ...]
    limit: float
    answer: asyncio.Future[Any]


class Worker:
    """A process that draws, as those see it who give it tasks.

    ``first``: what it does when it is begun, which counts for no task. ``patient``: it leaves the processor to
    what is more urgent.
    """

    def __init__(self, first: Callable[[], object] = int, *, patient: bool = False) -> None:
        self._first, self._patient = first, patient
        self._waiting: asyncio.PriorityQueue[_Job] = asyncio.PriorityQueue(WAITING)
        self._queued: dict[int, _Job] = {}
        self._numbers = itertools.count()
        self._thread = ThreadPoolExecutor(1)
        self._process: Any = None
        self._line: Connection | None = None
        self._closed = False
        self._turns: asyncio.Task[None] | None = None

    async def ask(self, job: Callable[..., T], *given: Any, limit: float, urgency: int = 1) -> T:
        """Return what a function returns that is called there; the least urgency comes first.

        Raises
        ------
        TooLong
            If it takes longer than ``limit``, s of the processor where the system tells those.
        Gone
            If the process ends in it (memory), or too many tasks wait.
        Broken
            If it raises.
        """
        if self._closed:
            raise Gone
        if self._turns is None:
            self._turns = asyncio.create_task(self._take_turns())
        answer: asyncio.Future[T] = asyncio.get_running_loop().create_future()
        asked = _Job(urgency, next(self._numbers), job, given, limit, answer)
        self._queue(asked)
        return await answer

    def _queue(self, asked: _Job) -> None:
        try:
            self._waiting.put_nowait(asked)
        except asyncio.QueueFull:
            _give(asked.answer, Gone())
        else:
            self._queued[asked.number] = asked

    async def _take_turns(self) -> None:
        loop = asyncio.get_running_loop()
        while True:
            asked = await self._waiting.get()
            del self._queued[asked.number]
            if asked.answer.done():
                continue
            try:
                found = await loop.run_in_executor(self._thread, self._exchanged, asked)
            except _Yields:
                self._queue(asked._replace(urgency=LAST))
            except (TooLong, Gone, Broken) as error:
                _give(asked.answer, error)
            else:
                _give(asked.answer, found)

    def close(self) -> None:
        """End the process at once, whatever it does."""
        self._closed = True
        if self._turns is not None:
            self._turns.cancel()
        self._kill()
        self._thread.shutdown(wait=False, cancel_futures=True)

    # ------------------------------------------------------------ in the thread

    def _exchanged(self, asked: _Job) -> Any:
        try:
            line = self._begun()
            line.send((asked.job, asked.given))
            self._await(line, asked)
            fine, found = line.recv()
        except (EOFError, OSError):
            self._end()
            raise Gone from None
        except (TooLong, _Yields):
            self._end()
            raise
        if not fine:
            raise Broken(found)
        return found

    def _await(self, line: Connection, asked: _Job) -> None:
        """Await an answer; raises TooLong beyond its limit, _Yields if others have waited too long for it."""
        begun, worked = time.monotonic(), _worked(self._process.pid)
        limit = asked.limit if worked is None else SLOW * asked.limit
        while (spent := time.monotonic() - begun) < limit:
            if line.poll(min(LOOK, limit - spent)):
                return
            if worked is not None and (_worked(self._process.pid) or 0.0) - worked > asked.limit:
                break
            patience = 0.0 if asked.urgency == LAST else PATIENCE
            if spent > patience and self._keeps_waiting(asked):
                raise _Yields
        raise TooLong(asked.limit)

    def _keeps_waiting(self, asked: _Job) -> bool:
        """Whether something waits that is as urgent, and has kept nobody waiting itself."""
        waiting = (one for one in self._queued.copy().values() if not one.answer.done())
        return any(one.urgency <= asked.urgency and one.urgency != LAST for one in waiting)

    def _begun(self) -> Connection:
        """Return the line to the process, which is begun if there is none."""
        if self._line is None or not self._process.is_alive():
            self._end()
            context = multiprocessing.get_context("spawn")
            self._line, far = context.Pipe()
            self._process = context.Process(target=_works, args=(far, self._patient), daemon=True)
            _track()
            _deaf()
            self._process.start()
            far.close()
            if self._closed:
                raise EOFError
            self._line.send((self._first, ()))
            if not self._line.poll(BEGINNING):
                raise EOFError
            self._line.recv()
        return self._line

    def _end(self) -> None:
        self._kill()
        self._process = None
        line, self._line = self._line, None
        if line is not None:
            with suppress(OSError):
                line.close()

    def _kill(self) -> None:
        process = self._process
        if process is None or process.pid is None:
            return
        if process.is_alive() and hasattr(os, "killpg"):
            with suppress(OSError):
                os.killpg(process.pid, signal.SIGKILL)  # what it has begun itself, too
        process.kill()
        process.join(1.0)


def _worked(process: int) -> float | None:
    """Return how long a process has had the processor, s; None where the system does not tell."""
    try:
        told = Path(f"/proc/{process}/stat").read_text("utf-8").rpartition(")")[2].split()
    except OSError:
        return None
    return sum(map(int, told[_TIMES])) / os.sysconf("SC_CLK_TCK")


_TIMES = slice(11, 15)
"""Where that stands behind the name, ticks: its own, the system's for it, and those of what it began."""


def _track() -> None:
    """Begin what counts resources of processes: begun by the first of these, it would let Ctrl-C in again."""
    if os.name == "posix":
        from multiprocessing import resource_tracker

        resource_tracker.ensure_running()


def _deaf() -> None:
    """Let Ctrl-C pass this thread by, and so, from its first moment, the process that it begins."""
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})


def _give(answer: asyncio.Future[Any], found: object) -> None:
    if answer.done():  # nobody waits for it any more
        return
    if isinstance(found, BaseException):
        answer.set_exception(found)
    else:
        answer.set_result(found)


# ---------------------------------------------------------------- in the process


def _works(line: Connection, patient: bool) -> None:
    """Answer tasks until nobody is there who gives them."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if hasattr(os, "setsid"):
        os.setsid()
    if patient and hasattr(os, "nice"):
        os.nice(NICE)
    _hold_to(MEMORY)
    gc.disable()  # what is in circles is taken away when nobody waits
    for number in itertools.count(1):
        try:
            if number % BUSY == 0 or not line.poll(QUIET):
                gc.collect()
            job, given = line.recv()
            line.send(_answer(job, given))
        except (EOFError, OSError):
            return


def _answer(job: Callable[..., Any], given: tuple[Any, ...]) -> tuple[bool, Any]:
    """Return whether a task ended well, and what it gives; else what is told of its error."""
    try:
        return True, job(*given)
    except MemoryError:
        return False, said("this takes more memory than it may: ask for less of it")
    except Exception as error:
        if os.environ.get(TRACEBACK):
            traceback.print_exception(error)
        return False, own_fault(error)


def _hold_to(memory: int) -> None:
    """Let this process have so much memory, where the system can do that."""
    try:
        import resource
    except ImportError:
        return
    with suppress(OSError, ValueError):
        _, most = resource.getrlimit(resource.RLIMIT_AS)
        resource.setrlimit(resource.RLIMIT_AS, (memory, most))
