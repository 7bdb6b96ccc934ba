"""A signal that comes while the server hands a task on: nothing is waited for inside of it."""

from __future__ import annotations

import asyncio
import signal
from concurrent.futures import ThreadPoolExecutor

import uvicorn

from graphic_tmm.serve.server import _Server


class Closing:
    """A desk that notes when it is closed."""

    def __init__(self) -> None:
        self.closed = 0

    def close(self) -> None:
        self.closed += 1


async def ended(desk: Closing) -> tuple[int, bool, int]:
    server = _Server(uvicorn.Config("none"), desk, lambda: None)  # type: ignore[arg-type]
    server.handle_exit(signal.SIGINT, None)
    within = desk.closed
    await asyncio.sleep(0)
    return within, server.should_exit, desk.closed


def test_a_desk_is_closed_behind_what_the_signal_interrupts() -> None:
    # Where a browser is driven, this thread has its own loop already.
    with ThreadPoolExecutor(1) as apart:
        assert apart.submit(asyncio.run, ended(Closing())).result() == (0, True, 1)
