"""Drawings judged, and no mistake looked for in them: what a test of verdicts asks for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.records import WRONG, Judged, Taken, Whole
from graphic_tmm.scene.records import Scene


class Verdicts(NamedTuple):
    """The verdicts on the readings of a drawing; how far off it is as a whole, if it is."""

    readings: tuple[Judged, ...]
    whole: Whole | None = None

    @property
    def wrong(self) -> bool:
        """Whether a reading is."""
        return any(one.verdict == WRONG for one in self.readings)


class _Same:
    """A scene as the key of a table: the very same one, not another like it."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and other.scene is self.scene

    def __hash__(self) -> int:
        return id(self.scene)


@lru_cache(16)
def _checker(same: _Same, **how: Any) -> Checker:
    """Return what checks drawings of a scene: what the hand drew for some is there for the next."""
    return Checker(same.scene, **how)


def verdicts(
    scene: Scene, drawings: Iterable[tuple[str, Sequence[Taken]]], **how: Any
) -> Iterator[Verdicts]:
    """Yield the verdicts of reports on many drawings of a scene: see `graphic_tmm.checking.check.checks`."""
    checker = _checker(_Same(scene), **how)
    for source, readings in drawings:
        yield Verdicts(*checker.verdicts(readings, source))
