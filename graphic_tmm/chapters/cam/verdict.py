"""That a cam keeps all its limits, in words; which it passes its findings tell."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cam.findings import cam_findings
from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.table import results
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, result_number
from graphic_tmm.note.document import Runs

ROLLER = said(
    "All conditions of the cam hold: below the allowed pressure angle {rise} are left on the rise and {back} "
    "on the return, below the largest radius of the roller {radius} by r0 and {profile} by the profile."
)
FLAT = said(
    "The condition of the cam holds: the profile is convex, its least radius of curvature {rest} above the "
    "allowed one."
)
NAMES = {
    "rise": "left_rise",
    "back": "left_return",
    "radius": "left_roller_r0",
    "profile": "left_roller_profile",
}


def verdict(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield one sentence where no limit is passed."""
    made = CAM_PLAN.on(drawn)
    if cam_findings(drawn.reading, made):
        return
    flat, found = made.roller is None, results(drawn)
    names = {"rest": "left_curvature"} if flat else NAMES
    put = {key: result_number(drawn, found, name, language) for key, name in names.items()}
    yield filled(speaking(language)(FLAT if flat else ROLLER), put)
