"""Whether mechanisms assemble: what the package finds, what it tells, and the law of cosines."""

from __future__ import annotations

import math

import pytest

from graphic_tmm.chapters.kinematics.assembly import Assembly, check_assembly
from graphic_tmm.chapters.kinematics.survey import survey
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import dissect


def assembly(mechanism: Mechanism) -> Assembly:
    """Return over which crank angles the groups of a mechanism assemble."""
    return check_assembly(survey(mechanism, dissect(mechanism)))


def message(mechanism: Mechanism) -> str:
    """Return what is told of one that does not."""
    with pytest.raises(StructureError) as caught:
        assembly(mechanism)
    return str(caught.value)


def ranges(r: float, rod: float, s: float, d: float) -> list[tuple[float, float]]:
    """Return the ranges of a four-bar's crank by law of cosines: cos φ between two bounds."""
    far = (r * r + d * d - (rod + s) ** 2) / (2 * r * d)
    near = (r * r + d * d - (rod - s) ** 2) / (2 * r * d)
    low = 0.0 if near >= 1 else math.degrees(math.acos(near))
    high = 180.0 if far <= -1 else math.degrees(math.acos(far))
    if low == 0.0:
        return [(360 - high, 360 + high)]
    if high == 180.0:
        return [(low, 360 - low)]
    return [(low, high), (360 - high, 360 - low)]
