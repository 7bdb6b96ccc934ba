"""The logs of the scenes that come with the package, and how many positions their values have."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache

from gallery import SHEETS

from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Curve, arrays
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

Log = tuple[Construction, Mapping[Mark, object]]


@cache
def logs(name: str) -> tuple[Log, ...]:
    made = make(read(SHEETS / name), exact=True)
    found = [(part.construction, part.given) for part in made.parts]
    if made.work is not None:
        found.append((made.work.project.construction, made.work.given))
    return tuple(found)


def sizes(log: Construction, given: Mapping[Mark, object]) -> Iterator[tuple[Mark, int]]:
    """Yield the marks of the steps that leave no curve with how many positions their values have."""
    reading = execute(log, given)
    for step in log.steps:
        if step.op.leaves is not Curve and not step.op.across:
            yield step.it, max(part.shape[1] for part in arrays(reading[step.it]))
