"""The command that serves, as a process, and who asks it over the network."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from http.client import HTTPConnection
from pathlib import Path
from typing import NamedTuple
from urllib.parse import urlsplit


class Server(NamedTuple):
    """A server that runs: its process, where it is asked."""

    process: subprocess.Popen[str]
    host: str
    port: int
    base: str

    def ask(
        self, path: str, method: str = "GET", body: bytes | None = None, **headers: str
    ) -> tuple[int, bytes]:
        """Return the status and the body of an answer."""
        line = HTTPConnection(self.host, self.port, timeout=60)
        try:
            line.request(method, self.base + path, body, headers)
            answer = line.getresponse()
            return answer.status, answer.read()
        finally:
            line.close()

    def interrupted(self, wait: float = 10.0) -> tuple[int, str]:
        """Return the status and the errors of a server that is told Ctrl-C, as a terminal tells it."""
        os.killpg(self.process.pid, signal.SIGINT)
        _, errors = self.process.communicate(timeout=wait)
        return self.process.returncode, errors


@contextmanager
def begun(*arguments: object, **environment: str) -> Iterator[subprocess.Popen[str]]:
    """Begin the command in a group of its own, as a shell does; nothing of it is left."""
    process = subprocess.Popen(
        [sys.executable, "-m", "graphic_tmm", "serve", *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, **environment},
        start_new_session=True,
    )
    try:
        yield process
    finally:
        if process.poll() is None:
            process.kill()
            process.communicate()


@contextmanager
def serving(place: Path, **environment: str) -> Iterator[Server]:
    """Serve a folder until the end."""
    with begun(place, **environment) as process:
        assert process.stdout is not None
        address = urlsplit(process.stdout.readline().strip())
        assert address.hostname, process.communicate()[1]
        yield Server(process, address.hostname, address.port or 0, address.path.rstrip("/"))
