"""What people call forces by instantaneous centres; why steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.advantage.task import ADVANTAGE
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    f"chapter {ADVANTAGE}": said("Forces by the centres"),
    ADVANTAGE: said("Forces by the centres"),
    "centre balance": said("Balance by the centres"),
    "load": said("load"),
    "load size": said("magnitude"),
    "arm h": said("arm h"),
    "ratio u": said("ratio u"),
    "at the drive": said("at the drive"),
    "sum at the drive": said("sum"),
    "balancing by centres": said("balancing, by centres"),
    "unknown by centres": said("unknown force, by centres"),
    "by force plans": said("by force plans"),
    "by lever": said("by lever"),
    "off force plans": said("difference from force plans"),
    "off lever": said("difference from lever"),
    "loads at drive": said("Loads at the drive"),
    "mechanical advantage": said("mechanical advantage i"),
}
SYMBOLS = (("i_{F5}", said("mechanical advantage of a load"), ""),)
WORDS = Named(captions=CAPTIONS, plans=(ADVANTAGE,), sources=("artobolevsky",), symbols=SYMBOLS)

ACTION = said("The force acts along this line; its arm is measured from the centre of its link.")
CARRIED = said(
    "The link does not turn, all of its points move as this one does: the force has the same power here, on "
    "the other link."
)
ARM = said(
    "About its centre the link turns at this moment: the arm of the force, positive where it turns the link "
    "counter-clockwise."
)
SUM = said("The powers of all loads add up.")
BALANCE = said("What drives has the power of all loads, reversed.")
RADIUS = said("What drives acts at the crank pin, square to the crank.")
