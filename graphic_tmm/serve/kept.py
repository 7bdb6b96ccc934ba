"""What is known of a scene that is served: its state, and by their hashes the sheets and pages drawn of it."""

from __future__ import annotations

import asyncio
import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from graphic_tmm.errors import printable
from graphic_tmm.serve.limits import KEPT, KEPT_BYTES, LINE


class SceneFault(NamedTuple):
    """A fault of a scene: its line (0: unknown), its key, what is said of it, what stands on that line.

    ``place``: the key in words, "" where it has none. ``pictures``: ways out, each a small picture with what is
    written by keys then: lines as x, y by turns, downward, in a square of side 1.
    """

    line: int
    key: str
    text: str
    source: str = ""
    place: str = ""
    pictures: tuple[dict[str, Any], ...] = ()


class KeptSheet(NamedTuple):
    """A sheet that is shown: its name, the hash of its SVG, its size in mm."""

    name: str
    hash: str
    width: float
    height: float


@dataclass
class Kept:
    """A scene that is served.

    ``text_version``: of the text that is drawn, or being drawn. ``errors``: of that text; ``failed``: why it
    was not drawn to its end though nothing in it may be wrong. The sheets are then those of the last text that
    could be drawn, unless they are ``fresh``: of this one.
    """

    name: str
    version: int = 0
    text_version: str = ""
    ok: bool = True
    busy: bool = False
    fresh: bool = False
    errors: tuple[SceneFault, ...] = ()
    failed: str = ""
    warnings: tuple[str, ...] = ()
    sheets: tuple[KeptSheet, ...] = ()
    page: str | None = None
    contents: dict[str, bytes] = field(default_factory=dict)
    _news: asyncio.Event = field(default_factory=asyncio.Event)

    def tell(self, **changes: Any) -> None:
        """Change the state and tell those who follow it; what stays as it was is not told."""
        if all(getattr(self, name) == value for name, value in changes.items()):
            return
        for name, value in changes.items():
            setattr(self, name, value)
        self.version += 1
        self._news.set()
        self._news = asyncio.Event()

    async def after(self, version: int) -> None:
        """Wait for a state that is later than one."""
        while self.version <= version:
            await self._news.wait()

    def state(self) -> dict[str, Any]:
        """Return the state as JSON takes it."""
        return {
            "version": self.version,
            "text_version": self.text_version,
            "ok": self.ok,
            "busy": self.busy,
            "fresh": self.fresh,
            "errors": [one._asdict() for one in self.errors],
            "failed": self.failed,
            "warnings": list(self.warnings),
            "sheets": [one._asdict() for one in self.sheets],
            "page": self.page,
        }

    def keep(self, data: bytes) -> str:
        """Keep what a browser may ask for; return its hash. What is oldest goes when there is too much."""
        name = hashed(data)
        self.contents.pop(name, None)
        self.contents[name] = data
        shown = {name, self.page, *(one.hash for one in self.sheets)}
        old = [one for one in self.contents if one not in shown]
        size = sum(map(len, self.contents.values()))
        while old and (len(self.contents) > KEPT or size > KEPT_BYTES):
            size -= len(self.contents.pop(old.pop(0)))
        return name


def with_lines(faults: Sequence[SceneFault], data: bytes) -> tuple[SceneFault, ...]:
    """Return the faults of a text with what stands on their lines; of a long line its beginning."""
    lines = data.decode("utf-8", "replace").split("\n")
    return tuple(
        one._replace(source=printable(lines[one.line - 1].strip()[:LINE]))
        if 0 < one.line <= len(lines)
        else one
        for one in faults
    )


def hashed(data: bytes) -> str:
    """Return a name for bytes: other bytes have another."""
    return hashlib.sha256(data).hexdigest()[:32]


def as_sheets(kept: Kept, drawn: Sequence[tuple[str, float, float, str]]) -> tuple[KeptSheet, ...]:
    """Keep sheets (name, width, height, SVG), and return them as they are shown."""
    return tuple(
        KeptSheet(name, kept.keep(svg.encode()), width, height)
        for name, width, height, svg in drawn
    )
