"""What people call the views; why the steps of the construction are done."""

from __future__ import annotations

from graphic_tmm.chapters.curvature.task import BALL, BRESSE, CURVATURE
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "curvature": said("Centres of curvature"),
    "bresse": said("Circles of Bresse"),
    "ball": said("Ball's point"),
    "table curvature": said("Curvature of paths"),
    "chapter curvature": said("Curvature of paths"),
}

OFF = "curvature_off_"
"""What the names of results begin with that tell how far radii by both ways are apart."""
_APART = said("ρ by Bobillier off the plans, path of {point}")


def _result(name: str, speech: Speech) -> str:
    return speech(_APART, point=name.removeprefix(OFF)) if name.startswith(OFF) else ""


NORMAL = said("The centre of curvature lies on the normal to the path.")
GUIDED = said(
    "The path is straight: its centre of curvature is infinitely far, on the normal to the guide."
)
LAID = said("The radius of curvature is laid off the way that the normal acceleration points.")
POLE = said(
    "Velocities are square to these normals: where they meet is the instantaneous centre of the link."
)
CENTRES = said("By Bobillier the line of two centres of curvature meets the line of their points.")
ENDLESS = said("One centre is infinitely far: the line to it is parallel to its normal.")
AXIS = said("By Bobillier this is the axis of the two rays.")
AXIS_ENDLESS = said(
    "Both centres are infinitely far, so Q is too: the axis is parallel to the line of both points."
)
EQUAL_ANGLE = said(
    "By Bobillier the tangent of the centrodes is turned from the second ray as the first ray is from the axis."
)
TURN = said(
    "By Bobillier an axis is to the first ray as the other ray is to the tangent of the centrodes: so the axis "
    "is turned by the angle between the other rays."
)
NEXT_AXIS = said("This is the axis of the first ray and of the ray to the new point.")
RAY = said("The normal to the path goes through the instantaneous centre.")
FAR_END = said(
    "The inflection circle goes through the instantaneous centre: by Thales squares on two rays meet at the "
    "other end of its diameter."
)
MIDDLE = said("The centre of the circle halves its diameter.")
INFLECTION = said(
    "Points of the inflection circle have no normal acceleration: their paths are straight there."
)
TANGENT = said(
    "The common tangent of the centrodes is square to the diameter of the inflection circle."
)
NO_ACCELERATION = said(
    "The triangle on the link is similar to that of the plan with its pole: there the acceleration is zero."
)
SECOND = said("Points of the second circle have no tangential acceleration.")
SECOND_END = said(
    "The second circle has its centre on the tangent and goes through both poles: by Thales its diameter ends "
    "here."
)
CHECKED = said(
    "The circles of Bresse meet in the pole of accelerations: it is as far from the centre as the radius."
)
CORNER = said(
    "The square on the ray cuts the tangent and the normal of the centrodes; the corner of the rectangle over "
    "both stands for the point."
)
CUBIC = said(
    "The curvature of circles about fixed pivots does not change; corners of all points whose curvature does "
    "not change lie on one line."
)
BALL_POINT = said(
    "Of the points of the inflection circle, whose squares go through the end of its diameter, this has a "
    "corner on that line."
)

WORDS = Named(
    captions=CAPTIONS, result=_result, plans=(CURVATURE, BRESSE, BALL), sources=("artobolevsky",)
)
