"""A signal that comes while the server hands a task on: nothing is waited for inside of it."""

from __future__ import annotations

import asyncio
import signal

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
    assert asyncio.run(ended(Closing())) == (0, True, 1)
