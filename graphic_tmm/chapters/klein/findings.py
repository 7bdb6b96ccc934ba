"""Where a construction has no figures, and why: dead centres, a rod square to the guide, circles apart."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.chapters.klein.record import KLEIN_PLAN
from graphic_tmm.chapters.klein.task import KLEIN, VIEWS
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned

_NO_M = said(
    "klein: in positions {places} the rod is square to the guide: no point of it meets the normal in a finite "
    "place, the slider is locked there"
)
_NO_R = said(
    "klein: in positions {places} crank and rod lie in one line, in which the lines of Ritterhaus fall too: "
    "they do not meet; take Klein's construction there"
)
_NO_CHORD = said(
    "klein: in positions {places} the side of velocities along the rod is longer than the rod: Klein's circles "
    "do not meet; take Ritterhaus's construction there"
)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made = KLEIN_PLAN.of(drawn)
    for view, figure in made.figures.items() if made is not None else ():
        reading = drawn.of(view)
        if reading is None:
            continue
        count = len(drawn.row(view))
        m, q = (
            ~np.isfinite(np.broadcast_to(reading[z][0], (count,))) for z in (figure.M, figure.Q)
        )
        undrawn = np.isin(drawn.row(view), drawn.undrawn)
        for says, where in ((_NO_M, m), (_NO_CHORD if view == KLEIN else _NO_R, q & ~m)):
            places = [drawn.names[drawn.row(view)[k]] for k in np.flatnonzero(where & ~undrawn)]
            if places:
                yield speaking(language)(says, places=", ".join(places))


WARNINGS = Warned(_warnings, covers=lambda drawn: VIEWS)
