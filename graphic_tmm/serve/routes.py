"""What a browser may ask of the studio, below its token; events for one that follows scenes.

    /                       the scenes of the folder; the only scene's studio where there is one
    /events                 how they stand, as they change: event "state" of each, with its name
    /s/NAME/                the studio of a scene
    /s/NAME/events          how it stands, as it changes: event "state"
    /s/NAME/sheet/HASH.svg  a sheet, /s/NAME/page/HASH.html its page, while they are the ones of some state kept
    /s/NAME/again           draws it once more that was not drawn to its end
    /s/NAME/form            its values as a form; to be set by sending it back
    /s/NAME/scheme          its mechanism as it is drawn, after what was done to it; written where it is whole
    /draw                   a paper on which a mechanism is drawn that no scene has yet
    /scheme                 that mechanism after what was done to it
    /new                    takes its scene under a title; tells the name that it has in the folder
    /s/NAME/download/FORM   its files of a format
    /s/NAME/plans           its plans that may be clicked in a photograph
    /s/NAME/photo           takes a photograph, in the address what was clicked; tells what its check says
    /s/NAME/proposals       takes a photograph; tells which plans it seems to show
    /s/NAME/report/HASH.html  the report of a check, while it is kept
    /web/NAME               scripts and styles of the studio

A name finds a scene that was found in the folder before; it is never made a path.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager, suppress
from typing import Any, NamedTuple
from urllib.parse import quote

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, RedirectResponse, Response
from starlette.routing import Route
from starlette.types import ASGIApp, Receive, Scope, Send

from graphic_tmm.paper.formats import PAPERS
from graphic_tmm.serve.answers import Answers, forms, photographs
from graphic_tmm.serve.desk import IDLE, Desk, Scene, watch
from graphic_tmm.serve.guard import Guard
from graphic_tmm.serve.jobs import Refused, Task
from graphic_tmm.serve.kept import Kept
from graphic_tmm.serve.limits import (
    BEAT,
    CLICKED,
    PHOTO,
    PHOTO_TIME,
    STREAMS,
)
from graphic_tmm.serve.photos import Clicked
from graphic_tmm.serve.scheme.routes import scheme_routes
from graphic_tmm.serve.sent import body_of, json_of, nothing, refused
from graphic_tmm.serve.shell import asset, gallery, studio


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


FRAMED = {"content-security-policy": "frame-ancestors 'self'", "x-frame-options": "SAMEORIGIN"}
"""Of what the studio shows within its own page; the page of a scene says itself what it may do."""
DRAWN = {
    "content-security-policy": "default-src 'none'; style-src 'unsafe-inline'; frame-ancestors 'self'",
    "x-frame-options": "SAMEORIGIN",
}
"""Of a sheet, or a report: a picture that does nothing."""


def application(desk: Desk, token: str, *, open: bool = False) -> ASGIApp:
    """Return the application that serves a desk to who knows a token; ``open``: to other computers, too."""
    asked = AnswerRoutes(desk)

    @asynccontextmanager
    async def life(_: Starlette) -> AsyncIterator[None]:
        desk.open()
        watching = asyncio.create_task(watch(desk))
        try:
            yield
        finally:
            watching.cancel()
            desk.close()

    routes = [
        Route("/", asked.gallery),
        Route("/events", asked.all_events),
        Route("/web/{name}", asked.asset),
        Route("/s/{name}/", asked.studio),
        Route("/s/{name}/events", asked.events),
        Route("/s/{name}/sheet/{hash}.svg", asked.sheet),
        Route("/s/{name}/page/{hash}.html", asked.page),
        Route("/s/{name}/again", asked.again, methods=["POST"]),
        Route("/s/{name}/form", asked.form),
        Route("/s/{name}/form", asked.change, methods=["POST"]),
        *scheme_routes(asked.answers),
        Route("/s/{name}/download/{form}", asked.download),
        Route("/s/{name}/plans", asked.plans),
        Route("/s/{name}/photo", asked.photo, methods=["POST"]),
        Route("/s/{name}/proposals", asked.proposals, methods=["POST"]),
        Route("/s/{name}/report/{hash}.html", asked.report),
    ]
    app = Starlette(routes=routes, lifespan=life)
    app.router.redirect_slashes = False  # the way would be one without the token
    return Guard(app, token, open=open)


class Change(NamedTuple):
    """What a form sends: the version that it was made of, the values to be set, by key."""

    version: str
    changes: dict[str, str]


class AnswerRoutes:
    """The answers, one a route."""

    def __init__(self, desk: Desk) -> None:
        self.desk, self.answers = desk, Answers(desk)

    def _scene(self, request: Request) -> Scene | None:
        return self.desk.wanted(request.path_params["name"])

    async def gallery(self, request: Request) -> Response:
        """The scenes of the folder; the way to the only one where it is served alone."""
        if self.desk.folder.only is not None:
            (name,) = self.desk.folder.scenes()
            return RedirectResponse(f"s/{quote(name, safe='')}/")
        titles = await self.answers.titles()
        if not titles and not self.desk.folder.fixed:
            return RedirectResponse("draw")
        language = self.desk.speech(None).language
        fixed = self.desk.folder.fixed
        return HTMLResponse(gallery(titles, self.desk.folder.root.name, language, fixed=fixed))

    async def studio(self, request: Request) -> Response:
        """The studio of a scene."""
        scene = self._scene(request)
        if scene is None:
            return nothing()
        self.desk.draw_again(scene)  # who loads it anew wants it
        task = Task(scene.data or b"", str(scene.file))
        (title,) = await self.answers.titles_of([task])
        shown = studio(
            scene.kept.name,
            title,
            self.desk.speech(task).language,
            formats=forms(),
            several=self.desk.folder.only is None,
            fixed=self.desk.folder.fixed,
            photographed=photographs(),
        )
        return HTMLResponse(shown)

    async def asset(self, request: Request) -> Response:
        """A script or a style of the studio."""
        found = asset(request.path_params["name"])
        return nothing() if found is None else Response(found[0], media_type=found[1])

    async def events(self, request: Request) -> Response:
        """How a scene stands, now and whenever that changes."""
        scene = self._scene(request)
        return nothing() if scene is None else Stream(followed(scene.kept))

    async def all_events(self, request: Request) -> Response:
        """How all scenes stand; what was not drawn yet is drawn for it, one after the other."""
        there = [self.desk.wanted(name, IDLE) for name in self.desk.folder.scenes()]
        return Stream(followed_all([one.kept for one in there if one is not None]))

    async def sheet(self, request: Request) -> Response:
        """A sheet of some state that is kept."""
        return self._kept(request, "image/svg+xml", DRAWN)

    async def page(self, request: Request) -> Response:
        """The page of some state that is kept."""
        return self._kept(request, "text/html", FRAMED)

    async def again(self, request: Request) -> Response:
        """A scene drawn once more that was not drawn to its end."""
        scene = self._scene(request)
        if scene is None:
            return nothing()
        self.desk.draw_again(scene)
        return Response(status_code=204)

    async def form(self, request: Request) -> Response:
        """The values of a scene's file."""
        scene = self._scene(request)
        if scene is None:
            return nothing()
        found = await self.answers.form(scene)
        return refused(found) if isinstance(found, Refused) else JSONResponse(found._asdict())

    async def change(self, request: Request) -> Response:
        """Values set in a scene's file, 200; 409 if it has changed meanwhile, 422 if they are refused."""
        scene = self._scene(request)
        if scene is None:
            return nothing()
        if self.desk.folder.fixed:
            return Response(status_code=403)
        sent = await _sent(request)
        if sent is None:
            return Response(status_code=400)
        found = await self.answers.change(scene, sent.version, sent.changes)
        if isinstance(found, Refused):
            return refused(found)
        return JSONResponse({"version": found.version}, 200 if found.done else 409)

    async def download(self, request: Request) -> Response:
        """A scene's file of a format; of several a ZIP."""
        scene, form = self._scene(request), request.path_params["form"]
        if scene is None or form not in forms():
            return nothing()
        found = await self.answers.download(scene, form)
        if isinstance(found, Refused):
            return refused(found)
        name = quote(found.name, safe="")
        headers = {"content-disposition": f"attachment; filename*=UTF-8''{name}"}
        return Response(found.data, media_type="application/octet-stream", headers=headers)

    async def plans(self, request: Request) -> Response:
        """The plans of a scene that may be clicked in a photograph."""
        scene = self._scene(request)
        if scene is None:
            return nothing()
        found = await self.answers.plans(scene)
        return refused(found) if isinstance(found, Refused) else JSONResponse(found)

    async def photo(self, request: Request) -> Response:
        """What the check of a photograph says, and where its report is; 422 with what it is refused for."""
        scene, clicked = self._scene(request), await _clicked(request)
        if scene is None or clicked is None:
            return Response(status_code=404 if scene is None else 400)
        found = await self.answers.check(scene, clicked)
        if isinstance(found, Refused):
            return refused(found)
        return JSONResponse(found._asdict() | {"page": scene.kept.keep(found.page)})

    async def proposals(self, request: Request) -> Response:
        """The plans that a photograph seems to show, to be confirmed; 422 with what it is refused for."""
        scene, clicked = self._scene(request), await _clicked(request)
        if scene is None or clicked is None:
            return Response(status_code=404 if scene is None else 400)
        found = await self.answers.propose(scene, clicked)
        return refused(found) if isinstance(found, Refused) else JSONResponse({"plans": found})

    async def report(self, request: Request) -> Response:
        """The report of a check that is kept: a page that does nothing."""
        return self._kept(request, "text/html", DRAWN)

    def _kept(self, request: Request, kind: str, headers: dict[str, str]) -> Response:
        scene = self.desk.wanted(request.path_params["name"], IDLE)
        data = scene.kept.contents.get(request.path_params["hash"]) if scene else None
        if data is None:
            return nothing()
        return Response(data, media_type=kind, headers=headers)


async def _sent(request: Request) -> Change | None:
    """Return what is to be set, None if that cannot be told: too large, too slow, no such JSON."""
    return _change(await json_of(request))


async def _clicked(request: Request) -> Clicked | None:
    """Return a photograph that is sent, and what was clicked in it; None if that cannot be told."""
    told, plans = request.query_params, request.query_params.getlist("plan")
    sheet, paper = told.get("sheet", "1"), told.get("paper", "")
    plain = sheet.isascii() and sheet.isdecimal() and len(sheet) < 4 and int(sheet) > 0
    if not plain or paper not in ("", *PAPERS) or len(str(told)) > CLICKED:
        return None
    data = await body_of(request, PHOTO, PHOTO_TIME)
    if not data:
        return None
    name = told.get("name", "photo")
    return Clicked(name, data, tuple(plans), told.get("corners", ""), paper, int(sheet))


def _change(told: dict[str, Any]) -> Change | None:
    version, changes = told.get("version"), told.get("changes")
    if not isinstance(version, str) or not isinstance(changes, dict):
        return None
    plain = all(isinstance(value, str) for value in changes.values())
    return Change(version, changes) if plain else None
