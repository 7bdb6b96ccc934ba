"""What people call instantaneous centres and what is found by them; why steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "chapter centres": said("Instantaneous centres"),
    "centres": said("Instantaneous centres"),
    "centres polygon": said("Polygon of links"),
    "centres found": said("Where the centres are found"),
    "centres rates": said("Velocities by the centres"),
    "centre": said("centre"),
    "centre of lines": said("lines"),
    "distances": said("distances"),
    "by centres": said("by centres"),
    "by plan": said("by plan"),
}
SYMBOLS = (
    ("P_{12}", said("instantaneous centre of links 1 and 2"), ""),
    ("u_{21}", said("ratio of angular velocities, ω_2/ω_1"), ""),
)
WORDS = Named(captions=CAPTIONS, plans=(CENTRES,), sources=("artobolevsky",), symbols=SYMBOLS)

AT_INFINITY = said("The centre of links that slide lies at infinity, square to their guide.")
KENNEDY_LINE = said("The centres of three links lie on one straight line (Aronhold and Kennedy).")
TO_INFINITY = said("A line to a centre at infinity is drawn parallel to the direction of that.")
TWO_LINES = said(
    "By the theorem of Aronhold and Kennedy {it} lies on both lines: each goes through two known centres of "
    "three links."
)
VELOCITY = said("The velocity of the point, from the plan of velocities.")
NORMAL = said("The centre lies on the normal to the velocity of each point of the link.")
TWO_NORMALS = said("The link turns about the point in which the normals to two velocities meet.")
IMAGE = said("The point of the link that stands has its image in the pole.")
DIVIDED = said("The common centre lies on the line of both centres.")
RADIUS = said("The distance from the centre, about which the link turns at this moment.")
ALONG_VELOCITY = said("The point moves along its velocity, square to the radius from the centre.")
TO_COMMON = said("A distance from the common centre, with its side.")

WAYS = {
    "pin": said("pin"),
    "guide": said("guide, at infinity"),
    "wheel": said("pitch point"),
    "normals": said("normals to velocities"),
    "image": said("plan of velocities"),
    "rates": said("ω by the plan"),
}
"""How a centre was found that no two lines tell."""
