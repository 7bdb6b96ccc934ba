"""What a student may choose, as Assur's special point of other legs: where it stands then, nothing is amiss.

What hangs on the choice is not judged then; what does not, the points that come out of it, is.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.checking.cells import points
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.columns import Choice, Readings
from graphic_tmm.scene.captions import captions

NEAR, SHARE = 3.0, 0.12
"""A point so near to where another choice puts it, mm, and a share of how far it is from the pole, is that."""
FARTHER = 3.0
"""It is at least so many times as far from where it is due."""


def chosen_otherwise(
    made: DrawnScene, rows: Sequence[Taken]
) -> tuple[tuple[Taken, ...], tuple[str, ...]]:
    """Return readings without those that another choice puts elsewhere, and notes of these choices."""
    gone = dict(_chosen(made, rows))
    if not gone:
        return tuple(rows), ()
    language, places = made.scene.language, dict[tuple[str, str], list[str]]()
    for (plan, place), choice in gone.items():
        places.setdefault((plan, choice.point), []).append(place)
    notes = [
        speaking(language)(
            _CHOSEN, plan=captions(language)[plan], point=point, listed=", ".join(listed)
        )
        for (plan, point), listed in places.items()
    ]
    kept = tuple(
        one
        for one in rows
        if (of := gone.get((one.plan, one.position))) is None or one.segment not in of.hanging
    )
    return kept, tuple(notes)


def _chosen(made: DrawnScene, rows: Sequence[Taken]) -> Iterator[tuple[tuple[str, str], Choice]]:
    work = made.mechanism
    if work is None:
        return
    choices = {
        (one.plan, one.point): one
        for chapter in work.project.chapters
        for one in Readings.of(chapter).choices(work)
    }
    due = points(made) if choices else {}
    for row in rows:
        for one in row.parts():
            choice = choices.get((one.plan, one.segment))
            if choice is None or not one.pointed or one.key not in due:
                continue
            others = choice.others[:, work.names.index(one.position)]
            off = float(np.nanmin([*abs(others - one.spot), np.inf]))
            near = NEAR + SHARE * abs(one.spot)
            if off <= near and abs(one.spot - due[one.key]) > FARTHER * off:
                yield (one.plan, one.position), choice


_CHOSEN = said(
    "{plan}, positions {listed}: {point} is where another pair of legs puts it, which is as right; what is "
    "drawn from it is not judged, the points that come out of it are"
)
