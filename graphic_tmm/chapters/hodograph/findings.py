"""What is warned of hodographs: tangents that are off the plans of accelerations by more than is explained."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.chapters.hodograph.record import HODOGRAPH_PLAN
from graphic_tmm.chapters.hodograph.table import angles, limits
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned

_OFF = said(
    "hodograph: at the ends of {point} in positions {places} its tangent is turned from πk by up to {angle}°, "
    "more than {count} positions explain: take more of them, or look at the plans there"
)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made = HODOGRAPH_PLAN.of(drawn)
    for one in made.curves if made is not None else ():
        found, most = np.abs(angles(drawn, one)[0]), limits(drawn, one)[0]
        over = [
            int(k) for k in np.flatnonzero(np.nan_to_num(found) > np.nan_to_num(most, nan=np.inf))
        ]
        if made is not None and over:
            yield speaking(language)(
                _OFF,
                point=one.point,
                places=", ".join(drawn.names[k] for k in over),
                angle=number(float(found[over].max()), language, 2),
                count=made.count,
            )


WARNINGS = Warned(_warnings)
