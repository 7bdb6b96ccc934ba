"""For one test: a scene of a file is read once, and what was found of it is kept for every command."""

from __future__ import annotations

from functools import cache

import pytest

from graphic_tmm.scene import read as reading
from graphic_tmm.scene.records import Scene
from support.once import ANEW


@pytest.fixture
def found_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever reads a file gets the same record, in each language one; the file has to stay as it is."""
    read, translated = cache(ANEW), Scene.spoken_in
    told: dict[tuple[int, str], Scene] = {}

    def spoken_in(scene: Scene, language: str) -> Scene:
        key = id(scene), language
        return told[key] if key in told else told.setdefault(key, translated(scene, language))

    monkeypatch.setattr(reading, "read", lambda path, **_: read(path))
    monkeypatch.setattr(Scene, "spoken_in", spoken_in)
