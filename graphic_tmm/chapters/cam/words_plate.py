"""Why a cam that slides is drawn as it is; what its views are called."""

from __future__ import annotations

from graphic_tmm.language.said import said

CAPTIONS: dict[str, str] = {
    "cam plate": said("Least length of the cam"),
    "cam sliding profile": said("Profile of the translating cam"),
    "cam slope": said("Diagram of dS/ds_{c}"),
    "cam bend": said("Diagram of d²S/ds_{c}²"),
    "symbol cam slope": said("S′"),
    "symbol cam bend": said("S″"),
    "length_min": "L_{min}",
    "length": said("L of the cam"),
}

RADIUS = said("The least length of the cam is {length_min}; its length is {length}.")
CURVATURE = said(
    "The curvature follows from how the tangent turns along the travel, whose whole length stands for 1:"
)
BASE = said(
    "Along the base the travel of the cam is laid off; each phase is divided into equal parts. Ordinates are "
    "taken to scale from the stroke:"
)
READ = said(
    "At s = {angle} (position {position}) the ordinates are S = {S}, S′ = {dS}, S″ = {ddS}, that is {travel}, "
    "{speed} and {rate}."
)
EXTREMES = said(
    "The pressure angles of all positions are laid off over the travel; the largest are read with the places "
    "of the cam at which they stand:"
)
KEPT = said("All conditions of the cam hold.")
RADIANS = said(
    "Derivatives are taken by the travel of the cam, S′ = dS/ds and S″ = d²S/ds²: what is told of dS/dφ holds "
    "for them."
)
FINDINGS = {
    "plate pressure": said(
        "the pressure angle reaches {value:.4g}° at s = {angle:.4g} mm, {limit:g}° are allowed: the cam of "
        "{r0:.4g} mm is too short, take {least:.4g} mm at least, all its phases longer in proportion"
    ),
    "plate roller by curvature": said(
        "the roller's radius {value:.4g} mm is larger than {limit:.4g} mm, the allowed share of the least "
        "radius of curvature of its path, at s = {angle:.4g} mm"
    ),
    "plate undercut": said(
        "the roller of {value:.4g} mm cuts the profile away at s = {angle:.4g} mm, where the radius of "
        "curvature of its path is {limit:.4g} mm: take a smaller roller or a longer cam"
    ),
    "plate sharp": said(
        "the radius of curvature falls to {value:.4g} mm at s = {angle:.4g} mm, {limit:.4g} mm are the least: "
        "take a longer cam than {r0:.4g} mm"
    ),
}
"""By kind of finding."""

STATED = {
    False: said("The cam is a plate that slides to and fro; its profile lifts a roller."),
    True: said("The cam is a plate that slides to and fro; its profile lifts a knife edge."),
}
"""By whether the follower has an edge."""
DIAGRAMS = said(
    "Diagrams of the follower's displacement and of its two derivatives by the travel of the cam are drawn."
)
ASKS = (
    said("The least length of the cam is found by the largest pressure angle allowed."),
    said("The profile of the cam is drawn."),
)

RATE_AT = said("So much the follower would rise over the whole travel if it went on as here.")
POLE = said("The pole stands before the axis at the length of the cam.")
RAY = said(
    "Over the length of the cam the follower would rise by what stands on the axis: this ray is parallel to "
    "the tangent of its path."
)
ANGLE = said(
    "The rod moves square to the travel, the force along the normal of the path: between them is the angle of "
    "the tangent with the travel."
)
TURNING = said(
    "The normal turns as the tangent does, whose slope is dS/ds: its derivative by the share of the travel, "
    "taken positive where the profile is convex."
)
BASE_LINE = said("The cam slides along this line.")
FOOT = said("When the cam has gone so far this place of it is under the follower.")
PATH_POINT = said("Over this place of the cam the follower's point stands at its displacement.")
