"""Scenes of mechanisms that are none of the package's: cases that were found from outside, by their names."""

from __future__ import annotations

from functools import cache

from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from support.boards import in_usual_size
from support.gallery import CASES

FILES = {
    file.stem: file
    for file in sorted(CASES.rglob("*.toml"))
    if "[[link]]" in file.read_text("utf-8")
}


@cache
def stranger(name: str) -> Scene:
    """Return a scene by the name of its file."""
    return read(FILES[name])


@cache
def mechanism_of(name: str) -> Drawn:
    """Return its mechanism in its usual size, by the exact hand."""
    found = in_usual_size(stranger(name), exact=True).mechanism
    assert found is not None
    return found
