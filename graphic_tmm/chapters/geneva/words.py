"""What people call the view and the results of a Geneva wheel; why its steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.geneva.task import GENEVA
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "geneva": said("Geneva wheel at the entry of the pin"),
    "geneva results": said("Geneva wheel"),
    "geneva_crank_due": said("crank due, R = L·sin(180°/z)"),
    "geneva_engaged": said("angle of engagement 2φ"),
    "geneva_share": said("share of motion in a turn, τ"),
    "geneva_share_by_slots": said("the same by the number of slots"),
    "geneva_motion": said("time of a motion"),
    "geneva_dwell": said("time of a dwell"),
    "geneva_fastest": said("greatest ω_w/ω_1"),
}

CENTRES = said("The wheel's centre stands on the frame, at its distance from the crank's.")
SLOT_AT_ENTRY = said("At the entry a slot stands at half a pitch from the line of centres.")
SLOT_AT_EXIT = said("At the exit the same slot stands at half a pitch on the other side.")
ENTRY = said("The pin moves along the slot where the crank is square to it: there it enters.")
EXIT = said("On the other side the crank is square to the slot again: there the pin leaves.")

WORDS = Named(captions=CAPTIONS, plans=(GENEVA,), sources=("artobolevsky",))
