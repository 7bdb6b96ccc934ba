"""Where an error comes from, by switching sources off: draw often, by another seed, and compare mean squares.

No code of `accuracy/sources.py` and no random number of it is used.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.drawing import References, draw, pinned
from graphic_tmm.accuracy.quantities import Quantity, quantities
from graphic_tmm.accuracy.sources import Sources, sources
from graphic_tmm.accuracy.ways import wanted
from graphic_tmm.board.execute import prepare
from graphic_tmm.board.hand import HANDS, Hand, slip_of
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

FRESH = 90_000
"""No scene has this seed."""
OFF = {
    "swing": {"swing": 0.0},
    "prick": {"prick": 0.0},
    "compass": {"compass": 0.0},
    "reading": {"reading": 0.0},
    "ruler": {"ruler": None},
    "digits": {"digits": None},
}


class Task(NamedTuple):
    """A board of a scene, what its sheets show, their true values."""

    drawing: Project
    asked: list[Quantity]
    references: References


def tasks(scene: Scene, enlarged: float = 1.0) -> Iterator[Task]:
    full, scales = at_all_positions(scene), pinned(make(scene, exact=True))
    references = References(full, scales)
    for drawing in draw(full, scales, enlarged):
        if asked := [q for q in quantities(drawing) if wanted(scene, q)]:
            yield Task(drawing, asked, references)


def sources_of(task: Task, hand: str) -> dict[str, Sources]:
    """The shares as the package tells them."""
    return sources(task.drawing, task.asked, task.references, HANDS[hand])


def by_kind(found: Sources) -> dict[str, float]:
    """The shares of steps summed by their sort of slip; the ruler rounds what is read."""
    sums = dict.fromkeys(("swing", "prick", "compass", "reading"), 0.0)
    for step, share in found.steps:
        slip = slip_of(step.op, *step.it.key)
        assert slip is not None
        sums[slip.kind] += share
    return sums


def told_by_kind(found: Sources) -> dict[str, float]:
    """The shares of sources that steps have, by the same names."""
    told = {k: found.parts.get(k, 0.0) for k in ("swing", "prick", "compass", "reading")}
    return {**told, "reading": told["reading"] + found.parts.get("ruler", 0.0)}


def brute(task: Task, hand: str, trials: int) -> dict[str, dict[str, float]]:
    """By quantity and source the share of the mean square that goes when it is switched off."""
    who = HANDS[hand]._replace(trials=trials, seed=FRESH)
    whole = deviations(task, who)
    found = {name: {"method": 1.0 - own / square} for name, (square, own) in whole.items()}
    for source, off in OFF.items():
        if any(getattr(who, name) != value for name, value in off.items()):
            mended = deviations(task, who._replace(**off))
            for name in found:
                found[name][source] = 1.0 - mended[name][0] / whole[name][0]
    return found


def deviations(task: Task, who: Hand) -> dict[str, tuple[float, float]]:
    """By quantity the mean square of how far it is off what is due, and off what an exact hand draws."""
    log, given = task.drawing.construction, task.drawing.given
    program = prepare(log, [mark for q in task.asked for mark in q.marks])
    exact, drawn = program.run(given), program.run(given, hand=who)
    found = {}
    for q in task.asked:
        due = task.references.of(q, task.drawing)
        if due is None:
            continue
        values = q.read(drawn, who.trials)
        found[q.name] = tuple(
            float(np.nanmean((values - right) ** 2)) for right in (due, q.read(exact, 1))
        )
    return {name: both for name, both in found.items() if both[0] > 0.0}
