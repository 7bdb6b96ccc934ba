"""An application asked as a browser does, but with any path, header and body; a small scene to be served."""

from __future__ import annotations

import asyncio
import json
import shutil
from asyncio import AbstractEventLoop
from collections.abc import AsyncIterator, Callable, Coroutine
from contextlib import asynccontextmanager
from functools import cache
from pathlib import Path
from threading import Thread
from typing import Any, NamedTuple

from graphic_tmm.serve import jobs
from graphic_tmm.serve.desk import Desk
from graphic_tmm.serve.folder import Folder, folder_of
from graphic_tmm.serve.routes import application
from graphic_tmm.serve.worker import Worker
from support.gallery import SHEETS

TOKEN = "a-token-that-nobody-guesses"
PATIENCE = 120.0
HOST = "127.0.0.1:8000"
SMALL = """title = "Small"
language = "en"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = ["0.1 m", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["0.3 m", 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = "10 1/s"
turns = "counterclockwise"
positions = 2
[[sheet]]
format = "A4"
place = ["positions"]
"""
"""A slider-crank that is drawn in a moment."""


class Answer(NamedTuple):
    status: int
    headers: dict[str, str]
    body: bytes

    def json(self) -> Any:
        return json.loads(self.body)


class Browser:
    """Who asks an application; every header can be said otherwise, None leaves it out."""

    def __init__(self, app: Any, token: str = TOKEN) -> None:
        self.app, self.token = app, token

    async def ask(
        self, path: str, method: str = "GET", body: bytes | list[bytes] = b"", **headers: str | None
    ) -> Answer:
        """Ask below the token; a path that begins with // is taken without it."""
        sent: list[dict[str, Any]] = []
        parts = list(body) if isinstance(body, list) else [body]

        async def receive() -> dict[str, Any]:
            if parts:
                part = parts.pop(0)
                return {"type": "http.request", "body": part, "more_body": bool(parts)}
            await asyncio.sleep(3600)
            return {"type": "http.disconnect"}

        async def send(message: dict[str, Any]) -> None:
            sent.append(message)

        await self.app(self.scope(path, method, headers), receive, send)
        start = sent[0]
        told = {k.decode(): v.decode("latin-1") for k, v in start["headers"]}
        return Answer(start["status"], told, b"".join(one.get("body", b"") for one in sent[1:]))

    def scope(self, path: str, method: str, headers: dict[str, str | None]) -> dict[str, Any]:
        own: dict[str, str | None] = {"host": HOST}
        if method == "POST":
            own["content-type"] = "application/json"
        own |= {name.replace("_", "-"): value for name, value in headers.items()}
        path, _, query = path.partition("?")
        whole = path[1:] if path.startswith("//") else f"/{self.token}{path}"
        return {
            "type": "http",
            "asgi": {"version": "3.0", "spec_version": "2.3"},
            "http_version": "1.1",
            "method": method,
            "scheme": "http",
            "path": whole,
            "raw_path": whole.encode("utf-8", "surrogatepass"),
            "query_string": query.encode(),
            "root_path": "",
            "headers": [
                (name.encode(), value.encode("latin-1"))
                for name, value in own.items()
                if value is not None
            ],
            "client": ("127.0.0.1", 5),
            "server": ("127.0.0.1", 8000),
        }

    async def states(self, path: str) -> AsyncIterator[dict[str, Any]]:
        """Yield the states that a browser is told that follows a scene."""
        told: asyncio.Queue[bytes] = asyncio.Queue()
        gone = asyncio.Event()

        async def receive() -> dict[str, Any]:
            await gone.wait()
            return {"type": "http.disconnect"}

        async def send(message: dict[str, Any]) -> None:
            told.put_nowait(message.get("body", b""))

        task = asyncio.create_task(self.app(self.scope(path, "GET", {}), receive, send))
        try:
            while True:
                text = (await asyncio.wait_for(told.get(), PATIENCE)).decode()
                if text.startswith("event: state\ndata: "):
                    yield json.loads(text.partition("data: ")[2])
        finally:
            gone.set()
            await task

    async def settled(
        self, name: str, wanted: Callable[[dict[str, Any]], bool] = lambda state: True
    ) -> dict[str, Any]:
        """Return the first state of a scene that is not busy, and as it is wanted."""
        found = self.states(f"/s/{name}/events")
        state: dict[str, Any] = {}
        try:
            async with asyncio.timeout(PATIENCE):
                async for state in found:
                    if not state["busy"] and state["version"] and wanted(state):
                        return state
        except TimeoutError:
            raise AssertionError(state) from None
        finally:
            await found.aclose()  # type: ignore[attr-defined]
        raise AssertionError


class Kept(Worker):
    """A worker that draws for many desks, one after another: its process takes a second to begin."""

    def close(self) -> None:
        """Forget what this desk has asked for and is not begun."""
        vars(self).pop("ask", None)  # what a test put in its place
        for asked in self._queued.values():
            asked.answer.cancel()


@cache
def _shared() -> tuple[AbstractEventLoop, tuple[Kept, ...]]:
    """The loop that tests serve in, in a thread of its own, and those who draw for them."""
    loop = asyncio.new_event_loop()
    Thread(target=loop.run_forever, daemon=True).start()
    return loop, tuple(Kept(jobs.warmed, patient=patient) for patient in (False, True, True))


@asynccontextmanager
async def opened(
    folder: Path | Folder, *, drawing: bool = True, anew: bool = False
) -> AsyncIterator[tuple[Browser, Desk]]:
    """Serve a folder without a server; without ``drawing`` nothing is begun that draws before it must.

    ``anew``: by processes of its own.
    """
    desk = Desk(folder if isinstance(folder, Folder) else folder_of(str(folder)))
    if not anew and asyncio.get_running_loop() is _shared()[0]:
        desk.front, desk.behind, desk.aside = _shared()[1]
    app = application(desk, TOKEN)
    begun, end = asyncio.Event(), asyncio.Event()

    async def receive() -> dict[str, str]:
        if begun.is_set():
            await end.wait()
            return {"type": "lifespan.shutdown"}
        return {"type": "lifespan.startup"}

    async def send(message: dict[str, Any]) -> None:
        begun.set()

    life = (
        asyncio.create_task(app({"type": "lifespan", "state": {}}, receive, send))
        if drawing
        else None
    )
    if life is not None:
        await begun.wait()
    try:
        yield Browser(app), desk
    finally:
        if life is None:
            desk.close()
        else:
            end.set()
            await life


def run(serving: Callable[[], Coroutine[Any, Any, None]]) -> None:
    """Run what asks and answers, in a thread of its own: a browser may have a loop in this one."""
    asyncio.run_coroutine_threadsafe(serving(), _shared()[0]).result()


def small(folder: Path, name: str = "small") -> Path:
    """Write the small scene into a folder of its own; return its file."""
    home = folder / name
    home.mkdir(parents=True)
    file = home / "scene.toml"
    file.write_text(SMALL, encoding="utf-8")
    return file


def copied(name: str, folder: Path) -> Path:
    """Copy a scene that comes with the package; return its file."""
    home = folder / name
    home.mkdir()
    shutil.copy(SHEETS / name / "scene.toml", home)
    return home / "scene.toml"
