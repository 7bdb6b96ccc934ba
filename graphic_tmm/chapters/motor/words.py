"""What people call the views of a motor; why its steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.motor.task import MOTOR
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

STEP_PLACE = said(
    "One interval is worked: what is known at its beginning is taken from the graphs."
)
SHARES = {
    False: said(
        "What the machine has, what the loads do over the interval, and half of the motor's work, by its "
        "moment at the beginning: the other half hangs on the speed sought."
    ),
    True: said(
        "From rest ω grows as the root of the angle, so the moment at the end counts two thirds, that at the "
        "beginning one third."
    ),
}
"""What is known of an interval's energy, by whether it begins at rest."""

WORDS = Named(
    captions={
        "chapter motor": said("Motor"),
        "motor": said("Characteristic of the motor on the crank"),
        "motor-speeds": said("Speeds of the motor"),
        "motion-step": said("Crossing of one interval"),
    },
    plans=(MOTOR,),
    sources=("artobolevsky",),
)
