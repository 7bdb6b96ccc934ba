"""Why the diagrams of a follower's spring are drawn as they are; what people call them."""

from __future__ import annotations

from graphic_tmm.language.said import said

CAPTIONS: dict[str, str] = {
    "cam spring": said("Line of the spring over the inertia force"),
    "cam inertia": said("Inertia force of the follower"),
    "cam contact force": said("Force of contact"),
    "cam moment": said("Moment on the camshaft"),
    "rocker cam inertia": said("Moment of the lever's inertia"),
    "symbol cam inertia": "P",
    "symbol rocker cam inertia": "P",
    "symbol cam contact force": "N",
    "symbol cam moment": "M",
    "symbol cam P": "P",
    "symbol cam N": "N",
    "symbol cam M": "M",
    "spring_preload": said("F_{0} of the spring"),
    "spring_rate": said("rate c of the spring"),
    "contact_least": said("least N"),
    "contact_most": said("largest N"),
    "moment_most": said("largest M on the shaft"),
    "moment_least": said("least M on the shaft"),
}

WANTED = said("Over the displacement of this position stands the force that the spring is to hold.")
POLE = said(
    "In the lowest place the spring is compressed by this much already: so long before it had no force."
)
SPRING_LINE = said(
    "The steepest ray from the pole has no wanted force above it, and touches the curve: no weaker spring of "
    "this compression would do."
)
ARM = said("The moment on the shaft comes from the normal's distance from the cam's centre.")

SPRING = said("Spring, force of contact, moment on the camshaft")
INERTIA = said(
    "The inertia of the follower is laid off over the turn; in position {position}, and where it lifts the "
    "follower the spring has to hold it:"
)
SOUGHT = said(
    "Over the displacement stands the force that the spring is to hold, with its reserve. From the pole K, as "
    "far before the lowest place as the spring is compressed there, the steepest ray is drawn that touches the "
    "curves; it is the line of the spring:"
)
GIVEN = said(
    "The line of the spring that is given is laid off over the displacement; where it stands above the curves "
    "it has its reserve."
)
CONTACT = said(
    "What the spring and the load have over the inertia closes the pair; the force of contact is along the "
    "normal, its arm about the cam's centre gives the moment on the shaft. Without friction the works of the "
    "rise and of the return are equal. The extremes, with the angles of the cam:"
)
