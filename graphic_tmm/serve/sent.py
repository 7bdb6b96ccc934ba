"""What a browser sends, read within bounds; how it is answered where there is nothing, or a refusal."""

from __future__ import annotations

import asyncio
import json
from typing import Any

from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response

from graphic_tmm.serve.jobs import Refused
from graphic_tmm.serve.limits import BODY, BODY_TIME


async def json_of(request: Request) -> dict[str, Any]:
    """Return the table that is sent; an empty one if that cannot be told."""
    body = await body_of(request, BODY, BODY_TIME)
    try:
        told = json.loads(body or b"")
    except (ValueError, RecursionError):
        return {}
    return told if isinstance(told, dict) else {}


async def body_of(request: Request, most: int, seconds: float) -> bytes | None:
    """Return what is sent; None if it is too large, or too slow."""
    body = bytearray()
    try:
        async with asyncio.timeout(seconds):
            async for part in request.stream():
                body += part
                if len(body) > most:
                    return None
    except (TimeoutError, ClientDisconnect):
        return None
    return bytes(body)


def refused(found: Refused) -> Response:
    """Return the answer that tells what something is refused for."""
    return JSONResponse({"errors": [one._asdict() for one in found.faults]}, 422)


def nothing() -> Response:
    """Return the answer where there is nothing."""
    return Response(status_code=404)
