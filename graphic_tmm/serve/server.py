"""The server of the studio: on a port of its own, told where it is, ended at once by Ctrl-C."""

from __future__ import annotations

import asyncio
import secrets
import socket
from collections.abc import Callable
from types import FrameType

import uvicorn
from uvicorn.protocols.http.h11_impl import H11Protocol

from graphic_tmm.errors import SheetError, reason_of
from graphic_tmm.language.said import said
from graphic_tmm.serve.desk import Desk
from graphic_tmm.serve.folder import Folder
from graphic_tmm.serve.limits import CONNECTIONS, LOOPBACK
from graphic_tmm.serve.routes import application

TOKEN = 24
"""Of so many random bytes the token is made."""


def serve(
    folder: Folder,
    *,
    host: str = LOOPBACK[0],
    port: int = 0,
    language: str = "",
    tell: Callable[[str], None],
) -> None:
    """Serve a folder until Ctrl-C; tell its address when it can be asked.

    Raises
    ------
    SheetError
        If the host or the port cannot be had.
    """
    listening = _listening(host, port)
    token = secrets.token_urlsafe(TOKEN)
    desk = Desk(folder, language)
    config = uvicorn.Config(
        application(desk, token, open=host not in LOOPBACK),
        http=Connection,
        loop="asyncio",
        ws="none",
        lifespan="on",
        log_config=None,
        log_level="critical",
        access_log=False,
        server_header=False,
        date_header=False,
        proxy_headers=False,
        limit_concurrency=CONNECTIONS,
        timeout_graceful_shutdown=0,
    )
    address = listening.getsockname()
    shown = f"[{address[0]}]" if listening.family == socket.AF_INET6 else address[0]
    server = _Server(config, desk, lambda: tell(f"http://{shown}:{address[1]}/{token}/"))
    with listening:
        asyncio.run(server.serve([listening]))


def _listening(host: str, port: int) -> socket.socket:
    try:
        family, kind, protocol, _, place = socket.getaddrinfo(
            host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
        )[0]
        made = socket.socket(family, kind, protocol)
        try:
            made.bind(place)
        except OSError:
            made.close()
            raise
    except (OSError, UnicodeError, OverflowError) as error:
        reason = reason_of(error) if isinstance(error, OSError) else str(error).lower()
        says = said(
            "cannot listen at {host}, port {port}: {reason}; choose others with --host, --port",
            host=host,
            port=port,
            reason=reason,
        )
        raise SheetError(says) from error
    return made


class Connection(H11Protocol):
    """A connection; where many stand, the one that has asked nothing for longest makes room for it.

    Connections that know no token, or say nothing, would else keep out those that do: beyond its limit the
    server refuses whoever asks.
    """

    last: float

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Take the connection, in the place of another if there is no room."""
        idle = [line for line in self.connections if isinstance(line, Connection) and line.is_idle]
        if idle and len(self.connections) >= CONNECTIONS // 2:
            oldest = min(idle, key=lambda line: line.last)
            self.connections.discard(oldest)
            oldest.transport.abort()
        self.last = self.loop.time()
        super().connection_made(transport)

    def on_response_complete(self) -> None:
        """Note when it was answered last."""
        self.last = self.loop.time()
        super().on_response_complete()

    @property
    def is_idle(self) -> bool:
        """Whether nothing is being answered."""
        return self.cycle is None or self.cycle.response_complete


class _Server(uvicorn.Server):
    """A server that tells where it is, and on Ctrl-C waits neither for a drawing nor for who follows one."""

    def __init__(self, config: uvicorn.Config, desk: Desk, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._desk, self._ready = desk, ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._ready()

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        self._captured_signals.append(sig)
        self.should_exit = self.force_exit = True
        # a signal may come while a task is handed to a thread, whose lock ending it would wait for
        asyncio.get_running_loop().call_soon_threadsafe(self._desk.close)
