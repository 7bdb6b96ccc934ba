"""Who may ask: the address names a token, the host is this one, no other page asks in a person's name.

All else is answered as if nothing were here. Every answer says that it is kept nowhere, and what it may do.
"""

from __future__ import annotations

import ipaddress
import re
import secrets
from collections.abc import MutableMapping
from typing import Any
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from graphic_tmm.serve.limits import LOOPBACK

SHELL = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; "
    "frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; "
    "require-trusted-types-for 'script'; trusted-types 'none'"
)
"""What the pages of the studio may do: their own files, and no text made into elements."""
HEADERS = {
    "cache-control": "no-store",
    "content-security-policy": SHELL,
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "permissions-policy": "camera=(), geolocation=(), microphone=()",
    "referrer-policy": "no-referrer",
    "x-content-type-options": "nosniff",
    "x-frame-options": "DENY",
}
"""Of every answer, where it does not say otherwise itself."""

_HOST = re.compile(r"(?:\[([0-9a-f:.]+)\]|([a-z0-9.-]+))(?::[0-9]{1,5})?")
SAFE = ("GET", "HEAD")
SENT = ("application/json", "application/octet-stream")
"""What is sent: values, a photograph; a page of another server may send neither without being asked first."""


class Guard:
    """An application that is asked only by who knows its token, under the name of its host.

    ``open``: it is served to other computers, under any address in figures, but under no name that somebody
    may have given to it elsewhere.
    """

    def __init__(self, app: ASGIApp, token: str, *, open: bool = False) -> None:
        self.app, self.token, self.open = app, token.encode(), open

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer what may be asked; hide from all else that something is here."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        if scope["type"] != "http":
            await send({"type": "websocket.close", "code": 1000})
            return

        async def sealed(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    headers.setdefault(name, value)
            await send(message)

        inner = self._inner(scope)
        if inner is None:
            await PlainTextResponse("", 404)(scope, receive, sealed)
        else:
            await self.app(inner, receive, sealed)

    def _inner(self, scope: Scope) -> MutableMapping[str, Any] | None:
        """Return what is asked, its path without the token; None if it may not be asked."""
        headers = Headers(scope=scope)
        token, slash, rest = scope["path"].removeprefix("/").partition("/")
        known = secrets.compare_digest(token.encode("utf-8", "surrogatepass"), self.token)
        if not (known and slash and self._hosted(headers)):
            return None
        if scope["method"] not in SAFE and not _own(headers):
            return None
        return {**scope, "path": f"/{rest}", "raw_path": f"/{rest}".encode("utf-8", "replace")}

    def _hosted(self, headers: Headers) -> bool:
        """Whether this host is asked by a name of its own."""
        if len(headers.getlist("host")) != 1:
            return False
        found = _HOST.fullmatch(headers["host"].lower())
        host = (found[1] or found[2]) if found is not None else ""
        return host in LOOPBACK or (self.open and _in_figures(host))


def _in_figures(host: str) -> bool:
    try:
        ipaddress.ip_address(host)
    except ValueError:
        return False
    return True


def _own(headers: Headers) -> bool:
    """Whether a page of this server asks, or no page; no form of HTML sends what is sent."""
    origin, kind = headers.get("origin"), headers.get("content-type", "")
    if origin is not None and _place(origin) != headers["host"]:
        return False
    if headers.get("sec-fetch-site", "same-origin") not in ("same-origin", "none"):
        return False
    return kind.partition(";")[0].strip().lower() in SENT


def _place(origin: str) -> str:
    """Return the host and the port of an origin; "" if it has none."""
    try:
        return urlsplit(origin).netloc
    except ValueError:
        return ""
