"""What follows from a cam: its least radius and the one taken, the pressure angles against those allowed."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.table import cam_marks
from graphic_tmm.drawn import Drawn, results_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import asked, filled, result_number
from graphic_tmm.note.document import Run, Runs

RADIUS = said("The least radius of the cam is {least}; taken is {taken}.")
PRESSURE = said(
    "The pressure angle reaches {rise} on the rise and {back} on the return; allowed are {allowed} and "
    "{behind}."
)


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield what the limits of the cam come to; those that are passed are warnings."""
    made, _ = CAM_PLAN.of(drawn), speaking(language)
    if made is None:
        return
    results = results_of(drawn, cam_marks(made))

    def told(name: str) -> Run:
        return result_number(drawn, results, name, language)

    yield filled(_(RADIUS), {"least": told("r0_min"), "taken": told("r0")})
    if "pressure_rise" in results:
        back = "pressure" if made.order.pressure_return is None else "pressure_return"
        limits = {
            "allowed": asked(drawn, "cam", "pressure", "°", language),
            "behind": asked(drawn, "cam", back, "°", language),
        }
        both = {"rise": told("pressure_rise"), "back": told("pressure_return")}
        yield filled(_(PRESSURE), {**both, **limits})
