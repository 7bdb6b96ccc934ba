"""The process that draws: what is urgent first, what takes too long is ended, what breaks is told."""

from __future__ import annotations

import asyncio
import os
import signal
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import pytest
from support.served import run

from graphic_tmm.serve import worker as workers
from graphic_tmm.serve.worker import Broken, Gone, TooLong, Worker


@asynccontextmanager
async def working() -> AsyncIterator[Worker]:
    worker = Worker()
    try:
        yield worker
    finally:
        worker.close()


def test_what_takes_too_long_is_ended_and_the_next_begins_anew() -> None:
    async def serving() -> None:
        async with working() as worker:
            first = await worker.ask(os.getpid, limit=30)
            assert first != os.getpid()
            assert await worker.ask(os.getpid, limit=30) == first
            with pytest.raises(TooLong):
                await worker.ask(time.sleep, 60, limit=0.1)
            second = await worker.ask(os.getpid, limit=30)
            assert second not in (first, os.getpid())
            with pytest.raises(ProcessLookupError):
                os.kill(first, 0)
            with pytest.raises(Gone):
                await worker.ask(os._exit, 1, limit=30)
            assert await worker.ask(len, "abc", limit=30) == 3

    run(serving)


@pytest.mark.skipif(not os.path.exists("/proc/self/stat"), reason="the system does not tell it")
def test_a_limit_is_of_the_processor_and_not_of_the_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a computer that others use too, what is drawn may wait for its turn."""
    monkeypatch.setattr(workers, "SLOW", 1000)

    async def serving() -> None:
        async with working() as worker:
            first = await worker.ask(os.getpid, limit=30)
            await worker.ask(time.sleep, 0.6, limit=0.3)
            assert await worker.ask(os.getpid, limit=30) == first
            with pytest.raises(TooLong):
                await worker.ask(sum, range(10**12), limit=0.3)

    run(serving)


def test_what_breaks_is_told_and_the_process_stays() -> None:
    async def serving() -> None:
        async with working() as worker:
            first = await worker.ask(os.getpid, limit=30)
            with pytest.raises(Broken, match="a fault of the program"):
                await worker.ask(int, "x", limit=30)
            with pytest.raises(Broken, match="more memory"):
                await worker.ask(bytearray, 10**12, limit=30)
            assert await worker.ask(os.getpid, limit=30) == first

    run(serving)


def test_the_urgent_comes_first_and_what_nobody_waits_for_not_at_all() -> None:
    order: list[str] = []

    async def asked(worker: Worker, name: str, urgency: int) -> None:
        await worker.ask(time.sleep, 0.01, limit=30, urgency=urgency)
        order.append(name)

    async def serving() -> None:
        async with working() as worker:
            await worker.ask(len, "", limit=30)
            tasks = [asyncio.create_task(asked(worker, "first", 2))]
            await asyncio.sleep(0)
            await asyncio.sleep(0)
            tasks += [
                asyncio.create_task(asked(worker, name, urgency))
                for name, urgency in (("idle", 2), ("usual", 1), ("given up", 0), ("urgent", 0))
            ]
            await asyncio.sleep(0)
            tasks[3].cancel()
            await asyncio.gather(*tasks, return_exceptions=True)

    run(serving)
    assert order == ["first", "urgent", "usual", "idle"]


@pytest.mark.slow
def test_what_takes_long_is_begun_again_when_nobody_waits(monkeypatch: pytest.MonkeyPatch) -> None:
    """A giant of 2 s, two others while it runs, one more in its second turn: it comes last, and whole."""
    monkeypatch.setattr(workers, "PATIENCE", 0.2)
    order: list[str] = []

    async def asked(worker: Worker, name: str, seconds: float, urgency: int) -> None:
        await worker.ask(time.sleep, seconds, limit=30, urgency=urgency)
        order.append(name)

    async def serving() -> None:
        async with working() as worker:
            await worker.ask(len, "", limit=30)
            giant = asyncio.create_task(asked(worker, "giant", 2.0, 1))
            await asyncio.sleep(0.1)
            small = [asyncio.create_task(asked(worker, name, 0.0, 1)) for name in ("one", "other")]
            await asyncio.gather(*small)
            await asyncio.sleep(0.5)
            await asked(worker, "third", 0.0, 2)
            await giant

    run(serving)
    assert order == ["one", "other", "third", "giant"]


def test_what_is_less_urgent_breaks_nothing_off(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "PATIENCE", 0.1)

    async def serving() -> None:
        async with working() as worker:
            first = await worker.ask(os.getpid, limit=30)
            urgent = asyncio.create_task(worker.ask(time.sleep, 0.6, limit=30, urgency=0))
            await asyncio.sleep(0.05)
            assert await worker.ask(os.getpid, limit=30, urgency=1) == first
            await urgent

    run(serving)


def test_nobody_waits_in_a_queue_without_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "WAITING", 3)

    async def serving() -> None:
        async with working() as worker:
            tasks = [asyncio.create_task(worker.ask(len, "", limit=30)) for _ in range(10)]
            found = await asyncio.gather(*tasks, return_exceptions=True)
            assert sum(isinstance(one, Gone) for one in found) >= 5
            assert 0 in found

    run(serving)


@pytest.mark.skipif(os.name != "posix", reason="a terminal tells Ctrl-C otherwise here")
def test_ctrl_c_of_the_terminal_passes_it_by() -> None:
    async def serving() -> None:
        async with working() as worker:
            process = await worker.ask(os.getpid, limit=30)
            os.kill(process, signal.SIGINT)
            assert await worker.ask(os.getpid, limit=30) == process

    run(serving)
