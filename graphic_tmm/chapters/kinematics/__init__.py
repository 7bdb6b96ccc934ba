"""Kinematics: the plans of positions, velocities and accelerations of a mechanism, group by group.

Every dyad closes the same way: each of its two legs hands the plan something known, a point with an offset, and a
direction; the plan closes where the two lines meet. A leg is a turning pair (the relative velocity stands square to
it), or a sliding pair (it lies along the guide, and Coriolis' acceleration is added). Images of further points
follow by similarity.

Sources: Артоболевский И. И., Теория механизмов и машин, гл. 4, 5 (планы положений, скоростей, ускорений).
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.chapter import Chapter, Place
from graphic_tmm.chapters.kinematics import views
from graphic_tmm.chapters.kinematics.accuracy import ACCURACY
from graphic_tmm.chapters.kinematics.captions import CAPTIONS
from graphic_tmm.chapters.kinematics.extremes import VIEW as EXTREMES
from graphic_tmm.chapters.kinematics.plan import (
    ACCELERATIONS,
    KINEMATICS,
    PLANS,
    POSITIONS,
    VELOCITIES,
    record,
)
from graphic_tmm.chapters.kinematics.scales import (
    SCALE_KEYS,
    SIZES,
    extents,
    plan_scales,
    sizes_of,
)
from graphic_tmm.chapters.kinematics.table import kinematic_columns, rate_marks, speed_marks
from graphic_tmm.project import Project


def _undrawn(project: Project, reading: Reading) -> tuple[int, ...]:
    """Return the positions in which a mark of the plan of positions is not there."""
    bad = np.zeros((1, len(project.names)), dtype=bool)
    for mark in project.marks(POSITIONS):
        if mark.kind is not Curve:
            bad = bad | undefined(reading[mark]).any(axis=0, keepdims=True)
    return tuple(int(i) for i in np.flatnonzero(bad[0]))


def _ranges(project: Project) -> str:
    """Return, as the end of a sentence, over which ranges of the crank the mechanism assembles."""
    said = KINEMATICS.on(project).assembly.said
    return f": {said}" if said else ""


_BOTH = (VELOCITIES, ACCELERATIONS)

CHAPTER = Chapter(
    name=KINEMATICS.chapter,
    number=2,
    captions=CAPTIONS,
    places=(
        Place(POSITIONS, 20, views.position_views, follows=(POSITIONS,), sizes=sizes_of),
        Place(
            VELOCITIES,
            21,
            views.velocity_views,
            follows=(POSITIONS, VELOCITIES),
            sizes=sizes_of,
        ),
        Place(
            ACCELERATIONS,
            22,
            views.acceleration_views,
            follows=(POSITIONS, ACCELERATIONS),
            sizes=sizes_of,
        ),
        Place("equations", 23, views.equation_views, shows=_BOTH, follows=(POSITIONS,)),
        Place(
            "velocity table",
            0,
            views.velocity_table,
            shows=(VELOCITIES,),
            follows=(POSITIONS, VELOCITIES),
        ),
        Place(
            "acceleration table",
            0,
            views.acceleration_table,
            shows=(ACCELERATIONS,),
            follows=(POSITIONS, ACCELERATIONS),
        ),
        Place(
            "results",
            99,
            views.both_tables,
            shows=_BOTH,
            together=("velocity table", "acceleration table"),
        ),
    ),
    sizes=SIZES,
    asked=lambda scene: scene.mechanism is not None,
    always=True,
    record=record,
    reach=extents,
    plan_scales=plan_scales,
    scale_key=lambda view: SCALE_KEYS.get(view, ""),
    undrawn=_undrawn,
    ranges=_ranges,
    plans=(EXTREMES, *PLANS),
    columns=kinematic_columns,
    pointed=PLANS,
    plan_at=views.plan_at,
    named_marks=rate_marks,
    speeds=speed_marks,
    views=lambda project: {plan: (plan,) for plan in (EXTREMES, *PLANS)},
    accuracy=ACCURACY,
)
