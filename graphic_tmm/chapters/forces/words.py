"""What people call the force analysis and its columns; why groups and lever are drawn as they are."""

from __future__ import annotations

from graphic_tmm.chapters.forces.task import FORCES
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "forces": said("Force analysis"),
    "loads": said("Loads"),
    "friction": said("Friction"),
    "lever": said("Zhukovsky's lever"),
    "table forces": said("Forces, reactions, balancing"),
    "P_bal_forces": said("P_{b}"),
    "P_bal_lever": said("P_{b}^{Zh}"),
    "M_bal_forces": said("M_{b}"),
    "M_bal_lever": said("M_{b}^{Zh}"),
    "P_bal_left": said("P_{b}"),
    "M_bal_left": said("M_{b}"),
    "bal_difference": said("Δ"),
    "bal_open": said("Δ_{friction}"),
}


def called(view: str, speech: Speech) -> str:
    """Return what the figure, the polygon or the equations of a group or a link are called, and its pass.

    So is the friction of a pass, "friction 1", and one lever of several, "lever 3"; "" for other views.
    """
    kind, _, name = view.partition(" ")
    if kind == "load" and name:
        return speech(LOAD, letter=plain(name))
    if kind == "spring" and name:
        return speech(SPRING, letter=plain(name))
    if kind == "friction" and name.isdigit():
        return speech(_FRICTION, number=name, before=int(name) - 1)
    if kind == "lever" and name:
        return speech(_LEVER, link=name)
    if kind not in _TITLES or not name:
        return ""
    name, _, tried = name.partition(" ")
    group, link = _TITLES[kind]
    title = speech(group if "-" in name else link, name=name)
    return title + (speech(_PASS, number=tried) if tried else "")


_TITLES = {
    "group": (said("Group {name}"), said("Link {name}")),
    "forces": (said("Force polygon of group {name}"), said("Force polygon of link {name}")),
    "equations": (said("Equations of group {name}"), said("Equations of link {name}")),
}
"""The figure, the polygon and the equations of a group, and those of a link."""
LOAD = said("Diagram of the load {letter}")
"""What the diagram of a load that varies is called."""
SPRING = said("Diagram of the spring force {letter}")
"""What the diagram of a spring is called."""
_LEVER = said("Zhukovsky's lever, link {link} driving")
_PASS = said(", pass {number}")
_FRICTION = said("Pass {number}: friction by the reactions of pass {before}")

SYMBOLS = (
    ("m", said("mass"), "kg"),
    ("J", said("moment of inertia"), "kg·m²"),
    ("G", said("weight"), "N"),
    ("P_{i1}", said("inertia force"), "N"),
    ("M_{i1}", said("couple of inertia"), "N·m"),
    ("F", said("force on a link"), "N"),
    ("R_{12}", said("force of link 1 on link 2"), "N"),
    ("P_b", said("balancing force"), "N"),
    ("M_b", said("balancing moment"), "N·m"),
    ("i_P", said("mechanical advantage"), ""),
    ("h", said("arm"), "mm"),
    ("μ_F", said("scale factor of forces"), "N/mm"),
    ("Δ", said("difference of the two methods"), "%"),
)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    called=called,
    plans=(FORCES,),
    rank=23,
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)


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
SPRING_LINE = said(
    "A spring pulls its ends together, or pushes them apart, along the line of both."
)
SPRING_LENGTH = said(
    "The length of the spring is how far its ends are apart on the plan of positions."
)
SPRING_AND_DAMPER = said("The spring and the damper act side by side: both forces are added.")
RATE_LINE = said(
    "The plan of velocities is turned by 90°, and so is the direction of the damper on it."
)
RATE_OF_LENGTH = said(
    "The part of the relative velocity of both ends along their line is the rate of its length."
)
OPPOSITE_LINE = said("Action and reaction act along one line, on two links.")
TURNING_LINE = said(
    "The direction of the load turns with the mechanism: it is taken from the plan of positions."
)
AGAINST_VELOCITY = said("A useful resistance acts along the velocity of its point, against it.")
BOTTOM_LINE = said(
    "The gas pushes the bottom of the cylinder as much as the piston, the other way."
)
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
ALONG_GUIDE = said("The balancing force of what slides lies along its guide.")
ROD_FORCE = said(
    "Along the rod only the cylinder's oil or gas holds it: its force is the part along the rod of all else "
    "that acts on the rod, reversed; it pushes the rod out where it is positive."
)
ROD_HELD = said(
    "Square to the rod the cylinder holds it: what it does there and the force along the rod are together the "
    "reverse of all else that acts on the rod."
)
LEVER_ARM_OF_SLIDE = said(
    "The balancing force lies along the velocity that is given, so on the turned lever its arm is the segment "
    "of that velocity."
)
LEVER_ARM_OF_CRANK = said(
    "The balancing force is square to the crank, so its arm on the lever is the image of the crank."
)
SUM_ON_LEVER = said(
    "The lever is in equilibrium about its pole: the moments of all forces on it are added with their "
    "signs."
)
POWER = said("What balances a drive times the rate at which it goes is its power.")
FRICTION_READ = said("The friction of the guide is the part of the reaction along it.")
SPECIAL_POINT_OF_FORCES = said(
    "The lines of what holds two of the legs cross in Assur's special point: about it neither has a moment."
)
POINT_OF_PLATES = said(
    "What the links bear that join both plates acts along their lines but for the known parts: where the lines "
    "cross it has no moment."
)
TO_SPECIAL_POINT = said(
    "About the special point a plate is balanced as a link is about its inner pin: its outer reaction has a "
    "part along this line and one square to it."
)
COUPLE_ON_THE_PLATE = said("As the plate holds what turns the leg, the leg turns the plate.")
ON_THE_PLATE = said(
    "What the plate does to the link across it, the link does to the plate, reversed."
)
PLATE_CLOSES = said(
    "All that acts on the first plate closes a polygon too: what it does to both links begins and ends in "
    "vertices that are there, so their normal components meet."
)
TANGENTIAL_LINE = said("The tangential component acts at the outer pin, square to the link.")
GUIDE_HOLDS = said(
    "What turns the slider about its pin is held by the guide: its reaction stands off the pin, as a force at "
    "the pin with this couple."
)
