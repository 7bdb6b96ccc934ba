"""A Geneva wheel: a pin on a crank enters a slot, turns the wheel by a pitch, leaves it; a disc holds it then.

While the pin is in a slot crank, pin and wheel are a mechanism with a slotted link, and its plans are those of
the chapter of kinematics, drawn over the angle of engagement alone. The pin enters without a shock where it
moves along the slot: there the crank is square to it, so a wheel with z slots and its centre at the distance L
wants the crank R = L·sin(180°/z). The drawing says the same: from the crank's centre the square is dropped on
the line that stands at half a pitch to the line of centres; its foot is the entry, and with the protractor the
angle 2φ of engagement is read, which leaves 180° − 360°/z. Over a turn of the crank the wheel moves for the
share τ = k·2φ/360° of k pins, and on the line of centres it turns fastest, ω_w/ω_1 = R/(L − R).

The wheel's rim goes through the entry; a slot ends where the pin comes nearest to the wheel's centre. The disc
locks as long as its convex part stands in a hollow of the rim, all but 2φ of its turn; the rest is cut out by
the rim's circle as it stands in the middle of the motion, made smaller about the crank's centre as the disc is
smaller than the crank: it goes through both ends of the convex part, square to it there.

Draws: place ``geneva``: the wheel at the entry, its results. Builds on the plan of positions.

Sources: Артоболевский И. И., Теория механизмов и машин (мальтийский механизм); Norton R. L., Design of
Machinery (Geneva mechanism).
"""

from __future__ import annotations

from graphic_tmm.chapters.geneva.task import GENEVA, SECTIONS
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import Chapter, Place

_ASKS = (
    said(
        "The Geneva wheel is drawn at the entry of the pin, with its slots and the disc that locks it."
    ),
    said("The angle of engagement is measured; times of motion and of rest are found."),
)

CHAPTER = Chapter(
    name=GENEVA,
    number=14,
    builds_on=("kinematics",),
    places=(Place(GENEVA, 23, asks=_ASKS),),
    sections=SECTIONS,
)
