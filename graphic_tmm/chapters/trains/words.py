"""What people call a planetary train's views and results; why it is drawn as it is."""

from __future__ import annotations

from graphic_tmm.chapters.trains.task import PLANETARY_TRAIN
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "given planetary": said("Given data: train"),
    "planetary": said("Planetary train"),
    "planetary-velocities": said("Picture of linear velocities"),
    "planetary-rates": said("Plan of angular velocities"),
    "planetary-conditions": said("Conditions on the tooth numbers"),
    "planetary-trains": said("Trains, the smallest first"),
    "train size": said("size"),
    "planetary-calculation": said("Calculation of the train"),
    "planetary-behind": said("Speed behind the train"),
    "planetary_satellites": said("number of satellites k"),
    "planetary_ratio": said("U"),
    "planetary_ratio_drawn": said("U as drawn"),
    "planetary_difference": said("Δ_{U}"),
    "planetary_omega_difference": "Δ_{ω}",
    "planetary_omega": said("ω by Willis"),
    "planetary_omega_drawn": said("ω as drawn"),
    "planetary_n_2H": "n_{2H}",
    **{f"planetary_M_{member}": f"M_{member}" for member in "01345H"},
    **{f"planetary_N_{member}": f"N_{member}" for member in "0134H"},
    "planetary_efficiency": "η",
    "planetary_circulating": "ν",
    "planetary-torques": said("Torques on the shafts"),
    "planetary_mesh_1": said("U^{H} of the first mesh"),
    "planetary_mesh_2": said("U^{H} of the second mesh"),
    "planetary_mesh_3": said("U^{H} of the third mesh"),
    "planetary_v_rack": "v",
    "planetary_most": "k_{max}",
    "overall_ratio": "U_{0}",
}

SYMBOLS = (
    ("U", said("transmission ratio"), ""),
    ("z", said("number of teeth"), ""),
)
"""Its letters in a note: what they stand for, their units."""


def _turns(name: str, speech: Speech) -> str:
    """Return what the turns a minute of a body are called, of however many wheels."""
    body = name.removeprefix("planetary_n_")
    return "" if body == name else f"n_{{{body}}}"


WORDS = Named(
    captions=CAPTIONS,
    result=_turns,
    plans=(PLANETARY_TRAIN,),
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)


AXIS = said("The axis of the train; radii are laid off square to it.")
MESH = said(
    "Pitch circles touch in the mesh: its distance from the axis is the radius of the central wheel."
)
AXIS_OF_BEVEL = said(
    "The carrier holds the satellites about an axis that crosses the main one in O, where all cones have their "
    "tips."
)
MEAN_DIAMETER = said(
    "The mean diameter of the satellite is square to its axis; it touches the central wheel at its end."
)
BETWEEN_CONTACTS = said(
    "A, B and C are points of the satellite in one line: their velocities grow evenly along it."
)
CONES_TOUCH = said(
    "In this line the cones touch: seen from the wheel the satellite turns about it."
)
ZERO_OF_BEVEL = said(
    "Velocities are square to the drawing; they are laid off square to the line of A, B, C, from one parallel "
    "to it."
)
POLE_OF_VECTORS = said(
    "Angular velocities are vectors along the axes; those about the main axis lie in one line."
)
ALONG_AXIS = said("The angular velocity is laid off along the main axis, to scale, with its sign.")
RELATIVE_ALONG_AXIS = said(
    "Seen from the carrier the satellite turns about its own axis: ω_2 = ω_H + ω_2H."
)
ABOUT_CONTACT = said(
    "Seen from the central wheel the satellite turns about the line in which their cones touch: the vector is "
    "parallel to it."
)
SATELLITES = said(
    "The carrier holds the satellites evenly about the axis, so that their forces balance."
)
CIRCLE = said("The pitch circle of the wheel.")
LEVEL = said("The level of this point is carried over to the other views.")
DISC = said(
    "Seen from the side a wheel is a line of the length of its radius to either side of its axis."
)
ZERO = said("On this line velocities begin: a point that stands still is on it.")
KNOWN_VELOCITY = said(
    "The velocity of the driving point is known: it is square to the radius, to scale."
)
TRIAL = said(
    "A velocity of any size is laid off, and beside it that which the closing wheels give the other member "
    "then: the line of the satellites goes through both ends."
)
SATELLITE_LINE = said(
    "The satellite touches the wheel that stands still in C, where it has no velocity, so its velocities "
    "grow from there in proportion to the distance."
)
SATELLITE_OF_TWO = said(
    "Two points of the satellite have known velocities: those of all others end on the line through them."
)
SOUGHT_VELOCITY = said(
    "The point belongs to the satellite too: its velocity ends on the satellite's line."
)
BODY_LINE = said(
    "The body turns about the axis of the train: its velocities grow in proportion to the radius."
)
VELOCITY_READ = said("The segment, times the scale factor, is the velocity.")
RATES_LINE = said("On this line the segments will be the angular velocities of all bodies.")
RATES_POLE = said("The pole distance gives the scale of angular velocities.")
RATE_RAY = said(
    "The slope of a body's line is its angular velocity: a ray of the same slope cuts it off, whatever the "
    "radius."
)
FIRST_STANDS = said(
    "By Willis as with the last wheel held, the wheels counted from the other end: wheel 1 stands."
)
COMPARED = said("What the drawing gives is compared with what the numbers of teeth give.")
RATE_READ = said(
    "The segment from the body that stands still is the angular velocity, with its sense."
)
