"""Events for a browser that follows scenes: states as they come, and a beat where nothing changes."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Sequence
from contextlib import suppress
from typing import Any

from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from graphic_tmm.serve.kept import Kept
from graphic_tmm.serve.limits import BEAT, STREAMS


async def followed(kept: Kept) -> AsyncIterator[str]:
    """Yield the state of a scene, now and whenever it has changed."""
    told = -1
    while True:
        if kept.version > told:
            told = kept.version
            yield _event(kept.state())
        with suppress(TimeoutError):
            async with asyncio.timeout(BEAT):
                await kept.after(told)
                continue
        yield _BEAT


async def followed_all(several: Sequence[Kept]) -> AsyncIterator[str]:
    """Yield the states of scenes, each with its name, now and whenever one has changed."""
    told = [-1] * len(several)
    while True:
        for k, kept in enumerate(several):
            if kept.version > told[k]:
                told[k] = kept.version
                yield _event({"name": kept.name, **kept.state()})
        waiting = [
            asyncio.create_task(kept.after(version))
            for kept, version in zip(several, told, strict=True)
        ]
        try:
            done: set[Any] = set()
            if waiting:
                done, _ = await asyncio.wait(
                    waiting, timeout=BEAT, return_when=asyncio.FIRST_COMPLETED
                )
            else:
                await asyncio.sleep(BEAT)
            if not done:
                yield _BEAT
        finally:
            for task in waiting:
                task.cancel()


_BEAT = ": here\n\n"


def _event(state: dict[str, Any]) -> str:
    return f"event: state\ndata: {json.dumps(state, ensure_ascii=False)}\n\n"


class Stream(Response):
    """Events sent until the browser has gone; only so many at once."""

    media_type = "text/event-stream"
    open = 0

    def __init__(self, events: AsyncIterator[str]) -> None:
        self.events = events
        self.status_code = 200
        self.background = None
        self.init_headers(None)
        del self.headers["content-length"]

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send events as they come."""
        if Stream.open >= STREAMS:
            await Response(status_code=503)(scope, receive, send)
            return
        Stream.open += 1
        sending = asyncio.create_task(self._sent(send))
        gone = asyncio.create_task(_gone(receive))
        try:
            await asyncio.wait((sending, gone), return_when=asyncio.FIRST_COMPLETED)
        finally:
            Stream.open -= 1
            for task in (sending, gone):
                task.cancel()
            await asyncio.gather(sending, gone, return_exceptions=True)

    async def _sent(self, send: Send) -> None:
        await send({"type": "http.response.start", "status": 200, "headers": self.raw_headers})
        async for event in self.events:
            await send({"type": "http.response.body", "body": event.encode(), "more_body": True})


async def _gone(receive: Receive) -> None:
    while (await receive())["type"] != "http.disconnect":
        pass
