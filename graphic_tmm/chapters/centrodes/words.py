"""What people call centrodes, their points and results; why their steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.centrodes.task import CENTRODES
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "chapter centrodes": said("Centrodes"),
    CENTRODES: said("Fixed and moving centrode"),
    "table centrodes": said("Centrodes: instantaneous centres and arcs"),
}

_CALLED = said("Centrodes of link {number}")
_AGAINST = said("Centrodes of link {number} on link {on}")


def called(view: str, speech: Speech) -> str:
    """Return what the centrodes of a link are called; "" for other views."""
    kind, _, named = view.partition(" ")
    number, _, on = named.partition("/")
    if kind != CENTRODES or not number:
        return ""
    return speech(_AGAINST, number=number, on=on) if on else speech(_CALLED, number=number)


_OFF = said("angle of the tangents, link {number}")


def _result(name: str, speech: Speech) -> str:
    kind, _, number = name.rpartition("_")
    return speech(_OFF, number=number) if kind == "centrodes_off" else ""


SYMBOLS = (
    ("P", said("instantaneous centre of a link"), ""),
    ("x_P", said("coordinate of the instantaneous centre in the axes of the frame"), "m"),
    ("ξ_P", said("coordinate of the instantaneous centre in the axes of the link"), "m"),
    ("s", said("arc of the fixed centrode from a position to the next"), "m"),
    ("s′", said("arc of the moving centrode from a position to the next"), "m"),
    ("δ", said("angle between the tangents of both centrodes where they touch"), "°"),
)
"""Its letters in a note: what they stand for, their units."""

WORDS = Named(
    captions=CAPTIONS,
    called=called,
    result=_result,
    plans=(CENTRODES,),
    sources=("artobolevsky",),
    symbols=SYMBOLS,
)

NORMAL_OF_PIN = said(
    "A pin that turns about a pivot moves square to the line that joins both: this is its normal."
)
NORMAL_OF_GUIDE = said("A point of a slider moves along its guide: its normal is square to that.")
WAY = said("The velocity of the point, seen from what the link rolls on, lies along this line.")
NORMAL = said("A point moves square to the line that joins it with the instantaneous centre.")
TURNED = said(
    "The plan of velocities is turned by 90°: its vector lies along the line that joins the point with the "
    "instantaneous centre."
)
CENTRE = said("The instantaneous centre lies on the normals to the velocities of both points.")
DISTANCE = said(
    "The pin goes evenly: the farther it is from the centre the slower the link turns, and past infinity the "
    "other way."
)
OWN_AXIS = said("In the link's own axes this line stands still: it is the first of them.")
FRAME_AXIS = said("The coordinates on the frame are read along this axis and square to it.")
UPRIGHT = said("The other coordinate is read along the square to it.")
TOUCH = said("Here both centrodes have a common point, which stands still for a moment.")
