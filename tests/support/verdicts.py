"""Drawings judged, and no mistake looked for in them: what a test of verdicts asks for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.records import WRONG, Judged, Taken
from graphic_tmm.scene.records import Scene


class Verdicts(NamedTuple):
    """The verdicts on the readings of a drawing."""

    readings: tuple[Judged, ...]

    @property
    def wrong(self) -> bool:
        """Whether a reading is."""
        return any(one.verdict == WRONG for one in self.readings)


def verdicts(
    scene: Scene, drawings: Iterable[tuple[str, Sequence[Taken]]], **how: Any
) -> Iterator[Verdicts]:
    """Yield the verdicts of reports on many drawings of a scene: see `graphic_tmm.checking.check.checks`."""
    checker = Checker(scene, **how)
    for source, readings in drawings:
        yield Verdicts(checker.verdicts(readings, source))
