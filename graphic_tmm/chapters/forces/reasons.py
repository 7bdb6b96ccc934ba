"""Why forces, groups and the lever are drawn as they are: the arguments of the book."""

from __future__ import annotations

from graphic_tmm.language.said import said

WEIGHT = said("A weight acts at the mass centre, straight down.")
INERTIA_LINE = said(
    "The inertia force acts at the mass centre against its acceleration: parallel to that vector of the "
    "plan, the other way."
)
SINGLE_ACROSS = said(
    "The single force stands off the mass centre, square to its line, by this arm."
)
SINGLE_AT = said(
    "At this distance the force alone has the moment of the couple: both are replaced by it."
)
SINGLE_LINE = said(
    "The single force has the size and direction of the inertia force; only its line is shifted."
)
GIVEN_LINE = said("The load acts at its point in the direction that the task gives.")
AGAINST_VELOCITY = said("A useful resistance acts along the velocity of its point, against it.")
GAS_LINE = said(
    "The gas presses on the piston along the cylinder, from the cover towards the crank."
)
TRAVEL = said(
    "The force hangs on how far the point has travelled from the beginning of its stroke."
)
STROKE = said(
    "The whole way between both ends of the stroke: shares of it tell where the load changes."
)
CARRIED_LINE = said(
    "The group is cut free with every force in its own direction, drawn to the scale of this figure."
)
REACTION_LINE = said(
    "What the group does to its neighbour is the reverse of what the neighbour does to it, on the same "
    "line."
)
ARM_OF_TANGENTIAL = said(
    "The tangential component acts square to the link, so its arm about the inner pin is the length of the "
    "link."
)
SUM_OF_MOMENTS = said(
    "The moments of all known forces and couples about this point are added with their signs, "
    "counter-clockwise positive; the reactions that pass through the point have none."
)
KNOWN_SIDE = said(
    "The forces of a group in equilibrium close a polygon: what is known is laid off first, side by side, "
    "each parallel to its line of action."
)
KNOWN_TANGENTIAL = said(
    "The tangential component is known now: it is a side of the polygon, square to its link."
)
NORMAL_UNKNOWN = said(
    "What is left of the reaction, its normal component, acts along the link; its amount is not known."
)
GUIDE_UNKNOWN = said(
    "Without friction a guide can only press: its reaction is square to it, the amount is not known."
)
POLYGON_CLOSES = said(
    "The polygon closes: both unknown sides end in one vertex, which is where their lines meet."
)
REACTION_READ = said(
    "The whole reaction is the side that joins both its components; its length is read off."
)
NORMAL_PART = said(
    "Friction goes by the normal pressure: the part of the reaction square to the guide."
)
BALANCING_LINE = said(
    "The balancing force acts at the crank pin, square to the crank, where its arm is longest."
)
CRANK_SIDES = said(
    "The crank is in equilibrium too: its forces close a polygon, and the last side is the reaction of the "
    "frame."
)
CRANK_REACTION = said(
    "What closes the polygon of the crank is the reaction of the frame on its pivot."
)
BALANCING_MOMENT = said(
    "The balancing moment is the reverse of the sum of all other moments about the pivot."
)
FORCE_ON_LEVER = said(
    "The force is carried to the image of its point in its own direction: on the plan turned by 90° it "
    "then has the right arm."
)
PAIR_ACROSS = said(
    "A couple is two equal forces square to the link at its ends, which are carried to the lever as others "
    "are."
)
PAIR_FORCE = said(
    "The couple is shared between the ends of the link: each force is the couple divided by the length."
)
LEVER_ARM_OF_CRANK = said(
    "The balancing force is square to the crank, so its arm on the lever is the image of the crank."
)
SUM_ON_LEVER = said(
    "The lever is in equilibrium about its pole: the moments of all forces on it are added with their "
    "signs."
)
FRICTION_READ = said("The friction of the guide is the part of the reaction along it.")
