"""Scenes of the package, read once in a process: what is found of a scene is kept beside it."""

from __future__ import annotations

from functools import cache, wraps
from pathlib import Path
from typing import Any

from graphic_tmm.scene import read as reading
from graphic_tmm.scene.packaged import packaged
from graphic_tmm.scene.records import Scene

ANEW = reading.read
"""The reader itself."""
PACKAGED = {path.resolve() for path in packaged()}


@cache
def _kept(path: str) -> Scene:
    return ANEW(path)


@wraps(ANEW)
def read_once(path: Path | str, **options: Any) -> Scene:
    """Read a scene; one of the package, which nobody changes while tests run, is the same record each time."""
    known = "\0" not in str(path) and Path(path).resolve() in PACKAGED
    return _kept(str(path)) if known else ANEW(path, **options)


def install() -> None:
    """Let all readers of scenes read so; to be called before any test is imported."""
    reading.read = read_once
