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

A plate on three legs (class III, `plates`) is laid with tracing paper: its three pins are moved until each is
on what its leg leaves it. It can lie in up to six places; the one that is meant is followed through the drive
(`branches`). Where the lines of two legs cross is Assur's special point of the plate (`special_point`): its
velocity against the pivots of both legs is square to them, so its image is where two lines meet; with the third
leg the plate then makes a dyad. The line of a leg that slides is square to its guide. A leg that slides along
the plate about a pivot lays the guide past that; its line is square to the guide, through the pivot, and with
the plate's point over the pivot it is as any other. Where no leg turns the plate is turned until all three
guides fit: each direction leaves it one place on two of them. Where the lines of all three are parallel, or
meet in one point, however the plate lies, nothing holds it: that is refused by the names of its guides.

Two plates about pivots, joined by two links (class IV, `squares`), are laid with a tracing each: both are
turned until the links fit. Where the lines of the links cross both plates are equally fast
(`special_square`), so with that point they make a dyad. Its accelerations as a point of either plate differ by
a vector that is known along both links.

Extreme positions are found before the plans: crank and rod in one line, or crank square to the rocker;
elsewhere by refining (`extremes`). Whether the mechanism assembles over the turn is told by the gaps of all
steps with two roots (`assembly`).

Draws: places ``given`` (the table of what the scene gives, of all chapters), ``positions``, ``special points``
(of plates), ``velocities``, ``velocities by drive`` (of several drives: what each alone causes, added up),
``accelerations``, ``equations`` (``velocity equations`` and ``acceleration equations``, each with its plans),
``velocity table``, ``acceleration table``, ``results`` (both tables). Builds on no chapter; the dissection is
the kernel's (`graphic_tmm.mechanism.structure`).

Sources: Артоболевский И. И., Теория механизмов и машин (кинематический анализ: планы положений, скоростей,
ускорений); Попов С. А., Тимофеев Г. А., Курсовое проектирование по теории механизмов и механике машин.
"""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.task import (
    ACCELERATIONS,
    BY_DRIVE,
    GIVEN,
    KINEMATICS,
    POSITIONS,
    SECTIONS,
    SPECIAL_POINTS,
    VELOCITIES,
)
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import Chapter, Place

_BOTH = (VELOCITIES, ACCELERATIONS)
_AT = (POSITIONS,)
_EQUATIONS = said("The vector equations of velocities are written down.")
_POSITION_TABLE = said("Lengths and angles are put into a table.")
_TABLE = said("Velocities of points and angular velocities of links are set in a table.")

CHAPTER = Chapter(
    name=KINEMATICS,
    number=2,
    places=(
        Place(GIVEN, 20, attends=POSITIONS),
        Place(POSITIONS, 19),
        Place(SPECIAL_POINTS, 20, shows=(VELOCITIES,)),
        Place(VELOCITIES, 21),
        Place(ACCELERATIONS, 22),
        Place(BY_DRIVE, shows=(VELOCITIES,)),
        Place(
            "equations",
            23,
            shows=_BOTH,
            together=("velocity equations", "acceleration equations"),
        ),
        Place(
            "velocity equations",
            shows=(VELOCITIES,),
            tells=VELOCITIES,
            asks=(_EQUATIONS,),
        ),
        Place("acceleration equations", shows=(ACCELERATIONS,), tells=ACCELERATIONS),
        Place("position table", shows=_AT, asks=(_POSITION_TABLE,)),
        Place(
            "velocity table",
            shows=(VELOCITIES,),
            asks=(_TABLE,),
        ),
        Place("acceleration table", shows=(ACCELERATIONS,)),
        Place("results", 99, shows=_BOTH, together=("velocity table", "acceleration table")),
    ),
    sections=SECTIONS,
    always=True,
)
