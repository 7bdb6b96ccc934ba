"""What a browser may ask of the studio, below its token.

    /                       the scenes of the folder; the only scene's studio where there is one
    /events                 how they stand, as they change: event "state" of each, with its name
    /s/NAME/                the studio of a scene
    /s/NAME/events          how it stands, as it changes: event "state"
    /s/NAME/sheet/HASH.svg  a sheet, /s/NAME/page/HASH.html its page, while they are the ones of some state kept
    /s/NAME/form            its values as a form; to be set by sending it back
    /s/NAME/download/FORM   its files of a format
    /web/NAME               scripts and styles of the studio

A name finds a scene that was found in the folder before; it is never made a path.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route
from starlette.types import ASGIApp

from graphic_tmm.serve.desk import Desk, Scene
from graphic_tmm.serve.guard import Guard
from graphic_tmm.serve.stream import Stream, followed, followed_all
from graphic_tmm.serve.watch import watch

FRAMED = {"content-security-policy": "frame-ancestors 'self'", "x-frame-options": "SAMEORIGIN"}
"""Of what the studio shows within its own page; the page of a scene says itself what it may do."""
DRAWN = {
    "content-security-policy": "default-src 'none'; style-src 'unsafe-inline'; frame-ancestors 'self'",
    "x-frame-options": "SAMEORIGIN",
}
"""Of a sheet: a picture that does nothing."""


def application(desk: Desk, token: str, *, open: bool = False) -> ASGIApp:
    """Return the application that serves a desk to who knows a token; ``open``: to other computers, too."""
    asked = Asked(desk)

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
        Route("/s/{name}/events", asked.events),
        Route("/s/{name}/sheet/{hash}.svg", asked.sheet),
        Route("/s/{name}/page/{hash}.html", asked.page),
    ]
    return Guard(Starlette(routes=routes, lifespan=life), token, open=open)


class Asked:
    """The answers, one a route."""

    def __init__(self, desk: Desk) -> None:
        self.desk = desk

    def _scene(self, request: Request) -> Scene | None:
        return self.desk.wanted(request.path_params["name"])

    async def gallery(self, request: Request) -> Response:
        """The scenes by name."""
        return JSONResponse({"scenes": list(self.desk.folder.scenes())})

    async def events(self, request: Request) -> Response:
        """How a scene stands, now and whenever that changes."""
        scene = self._scene(request)
        return _nothing() if scene is None else Stream(followed(scene.kept))

    async def all_events(self, request: Request) -> Response:
        """How all scenes stand; what was not drawn yet is drawn for it, one after the other."""
        there = [self.desk.wanted(name) for name in self.desk.folder.scenes()]
        return Stream(followed_all([one.kept for one in there if one is not None]))

    async def sheet(self, request: Request) -> Response:
        """A sheet of some state that is kept."""
        return self._kept(request, "image/svg+xml", DRAWN)

    async def page(self, request: Request) -> Response:
        """The page of some state that is kept."""
        return self._kept(request, "text/html", FRAMED)

    def _kept(self, request: Request, kind: str, headers: dict[str, str]) -> Response:
        scene = self._scene(request)
        data = scene.kept.contents.get(request.path_params["hash"]) if scene else None
        if data is None:
            return _nothing()
        return Response(data, media_type=kind, headers=headers)


def _nothing() -> Response:
    return Response(status_code=404)
