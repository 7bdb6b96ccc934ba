"""What people call the indicator diagram; why it is divided and read as it is."""

from __future__ import annotations

from graphic_tmm.chapters.indicator.task import VIEW
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "indicator": said("Indicator diagram"),
    "strokes of the cycle": said("Strokes of the cycle"),
    "indicator-calculation": said("Scale of the stroke"),
}


_OF_CYLINDER = said("Indicator diagram of cylinder {point}")
_OF_CYLINDERS = said("Indicator diagram of cylinders {points}")


def called(view: str, speech: Speech) -> str:
    """Return what the diagram of one of several cylinders is called; "" for other views."""
    kind, _, points = view.partition(" ")
    if kind != VIEW or not points:
        return ""
    if " " in points:
        return speech(_OF_CYLINDERS, points=points.replace(" ", ", "))
    return speech(_OF_CYLINDER, point=points)


WORDS = Named(
    captions=CAPTIONS,
    called=called,
    sources=("artobolevsky",),
)


AUXILIARY = said(
    "On a ray at any angle the travel may be laid off as it is, whatever the length of the base."
)
TRAVEL_ON_RAY = said(
    "The travel of the piston in this position, as it was read off the plan of positions."
)
STROKE = said("The stroke lies between both dead centres of the piston.")
STROKE_ON_RAY = said("The stroke of the piston, as it was read between its dead centres.")
SHORTEST = said("The cylinder is shortest where the crank lies towards its pin.")
LONGEST = said("The cylinder is longest where the crank lies away from its pin.")
LENGTHENED = said(
    "From the bottom of the cylinder the piston has gone as far as the length has grown."
)
LENGTH_STROKE = said("The stroke is the change of the length between both of these places.")
CLOSING = said("The end of the stroke on the ray belongs to the end of the base.")
ALIKE = said("Parallels cut both lines in the same ratio: the base is divided as the stroke is.")
PRESSURE = said("Over the place of the piston stands the pressure of this position, to scale.")
PRESSURE_READ = said("The ordinate over the place of the piston is the pressure there.")
