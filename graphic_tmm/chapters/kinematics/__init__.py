"""Kinematics: the plans of positions, velocities and accelerations of a mechanism, group by group.

Every dyad closes the same way, whatever its kind: each of its two legs hands the plan something known, an
image with an offset, and a direction; the image of the closing point lies where the two lines meet. There
are two kinds of legs (`bodies`), so five kinds of groups need no five rules:

- A leg that turns (`PinLeg`): Q turns about a pivot of known motion. v_Q = v_A + v_QA with v_QA ⊥ QA; a_Q =
  a_A + n + t, where n = v_QA²/l points from Q to the pivot and is known from the plan before, t ⊥ QA.
- A leg that slides (`GuideLeg`): Q moves over a point of the guide. Its velocity against that point lies
  along the guide; its acceleration has, besides a part along the guide, the Coriolis acceleration
  2·ω·v_rel, square to the guide: once because the guide turns under what slides along it, and once because
  what slides comes to a place that moves otherwise. Where the guide does not turn there is none
  (`accelerations._relative_line`).

So the plan of accelerations of an RPR group (kind 3, a stone on a rocker) is drawn: from the image of the
stone's point the Coriolis segment square to the rocker, through its end a line along the rocker; from the
image of the rocker's pivot the normal segment along it, through its end a line square to it; where both
lines meet is the image of the rocker's point under the stone. ω and ε follow from segments: ω =
(segment·μ_v)/(link·μ_l), the same with μ_a.

Similarity: the velocities of a rigid link are linear in place, so the images of its points are a figure
similar to the link, turned by 90° in the plan of velocities, by another angle in that of accelerations.
Images of further points are found by that and not by equations (`images`). Turning the whole velocity plan
by 90° makes every line parallel to its link instead of square to it: the turned plan, which is Zhukovsky's
lever later.

Extreme positions are found before the plans: crank and rod in one line, or crank square to the rocker;
elsewhere by refining (`extremes`). Whether the mechanism assembles over the turn is told by the gaps of all
steps with two roots (`assembly`).

Draws: places ``given`` (the table of what the scene gives, of all chapters), ``positions``, ``velocities``,
``accelerations``, ``equations`` (``velocity equations`` and ``acceleration equations``, each with its plans),
``velocity table``, ``acceleration table``, ``results`` (both tables). Builds on no chapter; the dissection is
the kernel's (`graphic_tmm.mechanism.structure`).

Sources: Артоболевский И. И., Теория механизмов и машин (кинематический анализ: планы положений, скоростей,
ускорений); Попов С. А., Тимофеев Г. А., Курсовое проектирование по теории механизмов и механике машин.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from graphic_tmm.board.values import Curve
from graphic_tmm.chapter import Chapter, Place
from graphic_tmm.chapters.kinematics.captions import CAPTIONS, SYMBOLS
from graphic_tmm.chapters.kinematics.names import (
    ACCELERATIONS,
    EXTREMES,
    GIVEN,
    KINEMATICS,
    PLANS,
    POSITIONS,
    VELOCITIES,
)
from graphic_tmm.chapters.kinematics.scales import SIZES
from graphic_tmm.chapters.kinematics.task import ASKED, SECTIONS
from graphic_tmm.late import late

if TYPE_CHECKING:
    from graphic_tmm.board.execute import Reading
    from graphic_tmm.project import Project
    from graphic_tmm.scene.records import Scene

with late(__name__):
    from graphic_tmm.board.values import undefined
    from graphic_tmm.chapters.kinematics import asks, views
    from graphic_tmm.chapters.kinematics.accuracy import ACCURACY
    from graphic_tmm.chapters.kinematics.any_angle import free, told
    from graphic_tmm.chapters.kinematics.choice import choose
    from graphic_tmm.chapters.kinematics.given import given, stated
    from graphic_tmm.chapters.kinematics.note import note
    from graphic_tmm.chapters.kinematics.plan import record
    from graphic_tmm.chapters.kinematics.scales import (
        SCALE_KEYS,
        extents,
        plan_scales,
        sizes_of,
    )
    from graphic_tmm.chapters.kinematics.scheme import scheme
    from graphic_tmm.chapters.kinematics.table import (
        kinematic_columns,
        measured_vectors,
        rate_marks,
        speed_marks,
    )
    from graphic_tmm.chapters.kinematics.transmission import passed
    from graphic_tmm.chapters.kinematics.turning import between, moving
    from graphic_tmm.language.said import joined, said


def _undrawn(project: Project, reading: Reading) -> tuple[int, ...]:
    """Return the positions in which a mark of the plan of positions is not there."""
    bad = np.zeros((1, len(project.names)), dtype=bool)
    for mark in project.marks(POSITIONS):
        if mark.kind is not Curve:
            bad = bad | undefined(reading[mark]).any(axis=0, keepdims=True)
    return tuple(int(i) for i in np.flatnonzero(bad[0]))


def _ranges(project: Project) -> tuple[str, str]:
    """Return, as the end of a sentence, where the mechanism assembles; and how to draw it there."""
    assembly = KINEMATICS.on(project).assembly
    if not assembly.said:
        return "", ""
    inside = (
        f'"{(a + (b - a) * share) % 360:.4g} deg"' for a, b in assembly.ranges for share in SHARES
    )
    remedy = said("write positions that lie there: extra = [{listed}]", listed=", ".join(inside))
    return joined("", (": ", assembly.said)), remedy


SHARES = (0.25, 0.5, 0.75)
"""Where in a range of crank angles a position is proposed."""


def _needs(scene: Scene) -> dict[str, object]:
    """Return the plans that further rows are read off."""
    rows = ASKED.of(scene)
    if rows is None:
        return {}
    gained = bool(rows.relative or rows.paths)
    return dict.fromkeys(
        [*[VELOCITIES] * bool(rows.pins or gained), *[ACCELERATIONS] * gained], True
    )


_BOTH = (VELOCITIES, ACCELERATIONS)

CHAPTER = Chapter(
    name=KINEMATICS.chapter,
    number=2,
    captions=CAPTIONS,
    places=(
        Place(GIVEN, 20, views.given_views, attends=POSITIONS),
        Place(
            POSITIONS,
            19,
            views.position_views,
            follows=(POSITIONS,),
            sizes=sizes_of,
            asks=asks.positions,
        ),
        Place(
            VELOCITIES,
            21,
            views.velocity_views,
            asks=asks.velocities,
            follows=(POSITIONS, VELOCITIES),
            sizes=sizes_of,
        ),
        Place(
            ACCELERATIONS,
            22,
            views.acceleration_views,
            asks=asks.accelerations,
            follows=(POSITIONS, ACCELERATIONS),
            sizes=sizes_of,
        ),
        Place(
            "equations",
            23,
            views.equation_views,
            asks=asks.equations,
            shows=_BOTH,
            follows=(POSITIONS,),
            together=("velocity equations", "acceleration equations"),
        ),
        Place(
            "velocity equations",
            0,
            views.velocity_equations,
            asks=asks.velocity_equations,
            shows=(VELOCITIES,),
            follows=(POSITIONS,),
            tells=VELOCITIES,
        ),
        Place(
            "acceleration equations",
            0,
            views.acceleration_equations,
            asks=asks.acceleration_equations,
            shows=(ACCELERATIONS,),
            follows=(POSITIONS,),
            tells=ACCELERATIONS,
        ),
        Place(
            "position table",
            0,
            views.position_table,
            asks=asks.position_table,
            shows=(POSITIONS,),
            follows=(POSITIONS,),
        ),
        Place(
            "velocity table",
            0,
            views.velocity_table,
            asks=asks.velocity_table,
            shows=(VELOCITIES,),
            follows=(POSITIONS, VELOCITIES),
        ),
        Place(
            "acceleration table",
            0,
            views.acceleration_table,
            asks=asks.acceleration_table,
            shows=(ACCELERATIONS,),
            follows=(POSITIONS, ACCELERATIONS),
        ),
        Place(
            "results",
            99,
            views.both_tables,
            asks=asks.both_tables,
            shows=_BOTH,
            together=("velocity table", "acceleration table"),
        ),
    ),
    sizes=SIZES,
    sections=SECTIONS,
    asked=lambda scene: scene.mechanism is not None,
    needs=_needs,
    always=True,
    given=given,
    stated=stated,
    scheme=scheme,
    record=record,
    reach=extents,
    plan_scales=plan_scales,
    choice=choose,
    warnings=views.warned,
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
    between=between,
    moving=moving,
    passed=passed,
    vectors=measured_vectors,
    told=told,
    free=free,
    note=note,
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)
