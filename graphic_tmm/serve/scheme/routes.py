"""What a browser may ask of schemes: a paper, a mechanism after an act, a scene put into the folder."""

from __future__ import annotations

from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route

from graphic_tmm.serve.answers import Answers, Sent
from graphic_tmm.serve.jobs import Refused
from graphic_tmm.serve.scheme.act import drawing_of
from graphic_tmm.serve.sent import json_of, nothing, refused
from graphic_tmm.serve.shell import drawing_paper


def scheme_routes(answers: Answers) -> list[Route]:
    """Return the routes of schemes."""
    asked = SchemeRoutes(answers)
    return [
        Route("/draw", asked.draw),
        Route("/scheme", asked.scheme, methods=["POST"]),
        Route("/new", asked.new, methods=["POST"]),
        Route("/s/{name}/scheme", asked.scheme, methods=["POST"]),
    ]


class SchemeRoutes:
    """The answers, one a route."""

    def __init__(self, answers: Answers) -> None:
        self.desk, self.answers = answers.desk, answers

    async def draw(self, request: Request) -> Response:
        """A paper on which a mechanism is drawn that no scene has yet."""
        if self.desk.folder.fixed or self.desk.folder.only is not None:
            return nothing()
        several = bool(self.desk.folder.scenes())
        return HTMLResponse(drawing_paper(self.desk.speech(None).language, several=several))

    async def scheme(self, request: Request) -> Response:
        """A mechanism after an act, 200; 409 if its file has changed meanwhile, 422 if it cannot be."""
        named = "name" in request.path_params
        scene = self.desk.wanted(request.path_params["name"]) if named else None
        if named and scene is None:
            return nothing()
        told = await json_of(request)
        asked = drawing_of(told)
        if asked is None:
            return Response(status_code=400)
        sent = Sent(str(told.get("text") or ""), str(told.get("version") or ""))
        found = await self.answers.scheme(scene, asked, sent)
        if isinstance(found, Refused):
            return refused(found)
        return JSONResponse({"version": found.version, **found.scheme}, 200 if found.done else 409)

    async def new(self, request: Request) -> Response:
        """A scene put into the folder, 201 with its name; 422 if it is none."""
        if self.desk.folder.fixed or self.desk.folder.only is not None:
            return Response(status_code=403)
        told = await json_of(request)
        text, title = told.get("text"), told.get("title")
        if not isinstance(text, str) or not isinstance(title, str):
            return Response(status_code=400)
        found = await self.answers.create(text, title)
        return refused(found) if isinstance(found, Refused) else JSONResponse({"name": found}, 201)
