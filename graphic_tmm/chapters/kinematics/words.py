"""What people call plans, tables and views of kinematics; why plans are drawn as they are."""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.task import BY_DRIVE, EXTREMES, PLANS, SPECIAL_POINTS
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "chapter kinematics": said("Kinematics of the mechanism"),
    "positions": said("Plan of positions"),
    "extremes": said("Extreme positions"),
    "special points": said("Special points"),
    "velocities": said("Velocity plan"),
    "accelerations": said("Acceleration plan"),
    "table positions": said("Positions from the plans"),
    "table velocities": said("Velocities from the plans"),
    "table accelerations": said("Accelerations from the plans"),
    "velocities by drive": said("Velocities added up"),
    "velocities at rest": said("Plan of possible velocities"),
    "table velocities at rest": said("Possible velocities from the plans"),
    "positions in a turn": said("Positions"),
}

SYMBOLS = (
    ("l_{AB}", said("length of a link"), "m"),
    ("n_1", said("turns a minute of the crank"), "rpm"),
    ("φ", said("angle of the crank"), "°"),
    ("ω", said("angular velocity"), "1/s"),
    ("ε", said("angular acceleration"), "1/s²"),
    ("v", said("velocity of a point"), "m/s"),
    ("v_r", said("given speed of the drive"), "m/s"),
    ("a_B", said("acceleration of a point"), "m/s²"),
    ("μ_l", said("scale factor of lengths"), "m/mm"),
    ("μ_v", said("scale factor of velocities"), "(m/s)/mm"),
    ("μ_a", said("scale factor of accelerations"), "(m/s²)/mm"),
)
"""Its letters in a note: what they stand for, their units."""
ALONE, EACH_ALONE = (
    said("Velocity plan, link {link} alone driving"),
    said("Velocity plans, link {link} alone driving"),
)
"""What the plan of velocities of one drive is called, and more of them."""


def called(view: str, speech: Speech) -> str:
    """Return what the plan of velocities of one drive is called; "" for other views."""
    name, _, link = view.rpartition(" ")
    return speech(ALONE, link=link) if name == BY_DRIVE else ""


WORDS = Named(
    captions=CAPTIONS,
    called=called,
    plans=(EXTREMES, SPECIAL_POINTS, *PLANS),
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)


FRAME_AXIS = said("The points of the fixed link are laid off from {start} along this axis.")
FROM_FIRST = said("The angles of the positions are counted from that of the first.")
CRANK = said("The crank turns about {start}: in each position it stands at its own angle.")
FROM_ITS_LINE = said("It is laid off from where the line of the guide is drawn from.")
DRIVEN_PIN = said("How far it has come along its guide is given in each position.")
ROD_AXIS = said("The rod runs out of its cylinder along the line that joins both pins.")
ROD_OUT = said(
    "The rod runs out of the cylinder at the speed that is given: the pin goes along {to} at that speed, seen "
    "from the cylinder."
)
ROD_OUT_TURNED = said(
    "The rod runs out of the cylinder along {to} at the speed that is given; on a plan turned by 90° it is "
    "square to it."
)
ROD_TURNS = said(
    "The rod turns together with its cylinder: the other part of the velocity of one pin about the other is "
    "square to {to}, its amount is not known yet."
)
ROD_TURNS_TURNED = said(
    "The rod turns together with its cylinder: the other part of the velocity of one pin about the other is "
    "square to {to}; on a plan turned by 90° it is drawn along {to}."
)
ROD_CORIOLIS = said(
    "The cylinder turns while its rod runs out: to the relative velocity belongs the Coriolis acceleration, "
    "square to {to}; the signs of ω and of the relative velocity decide to which side."
)
ROD_GAIN = said("The rod gains speed along {to} at the rate that is given.")
CRANK_PIN = said(
    "The crank is rigid: {it} keeps its distance {length} from the pivot and goes round in a circle."
)
POINT = said("{it} is fixed on its link: where it stands along the link's axis does not change.")
UPRIGHT = said(
    "A point of the link stands beside its axis here: to the left where its distance is positive."
)
PIN_ARC = said(
    "The link is rigid and turns about {centre}: its other pin can only be on this arc, the radius of "
    "which is the length of the link."
)
TWO_ARCS = said(
    "The pin belongs to both links, so it is where both arcs meet; of the two places it is the one on the "
    "side on which the mechanism was assembled, for it cannot pass from the one to the other."
)
TRACING = said(
    "The plate is rigid, and each of its three pins keeps to what its leg leaves it: on tracing paper it is "
    "moved until all three are there at once. Of the places where they are, up to six, it is the one that "
    "goes on from the position before."
)
TRACING_PAST = said(
    "The plate is rigid, its pins keep to what their legs leave them, and its guide passes the pivot of the "
    "leg that slides along it: on tracing paper it is moved until all three are so at once. Of the places "
    "where they are, it is the one that goes on from the position before."
)
PRICKED = said("The first pin of the plate is pricked through with the line.")
PRICKED_WITH_LINK = said(
    "The pin is pricked through with the line of the link, which begins there."
)
SPECIAL_POINT = said(
    "As a point of the plate, the point where the lines of two legs cross moves square to both of them: only "
    "there is the direction of its relative velocity the same about both ends of a leg (Assur's special point)."
)
EQUALLY_FAST = said(
    "Where the lines of both links cross both plates are equally fast: a link whose pins had these velocities "
    "would neither grow nor shrink. So the point turns about the pivots of both plates, and its image lies on "
    "both lines."
)
ALONG_THE_LINK = said(
    "Along the link the accelerations of the special point as a point of both plates differ by this."
)
REST_ACROSS = said("What they differ by besides is square to that.")
BOTH_PARTS = said(
    "The difference is known along both links, so it ends where the squares to both parts meet."
)
SAME_TANGENTIAL = said(
    "The first plate has the same tangential part as was read, from the end of its own normal one."
)
GUIDE_NORMAL = said(
    "What slides along a guide turns about no point of it; the special point lies on the normal to the guide."
)
OF_THE_PLATE = said("Both are points of the plate.")
SPECIAL_VELOCITY = said(
    "The special point moves about the pivot of each of both legs square to that leg: its image lies on both "
    "lines."
)
SPECIAL_ACCELERATION = said(
    "Square to each of both legs nothing but the tangential components is unknown: the image of the special "
    "point lies on both lines."
)
ARC_AND_GUIDE = said(
    "The pin belongs to the rod and to the slider, so it is where the arc of the rod cuts the slider's "
    "path; of the two places it is the one on the side on which the mechanism was assembled."
)
TWO_GUIDES = said("The pin belongs to both sliders, so it is where their paths cross.")
LINK_AXIS = said("The axis of a link goes through its two pins.")
ARM = said(
    "Both arms are one link: the angle between them stays, so the second is drawn by it from the first."
)
PASSIVE_AXIS = said(
    "This link is passive: it doubles what others hold already, so it lies where both of its points stand."
)
SLIDER_PATH = said(
    "A link that slides does not turn on its guide: each of its points moves on a parallel to it."
)
SLIDER_AXIS = said(
    "A link that slides does not turn on its guide, so its axis keeps the direction of the guide."
)
ROCKER_LENGTH = said(
    "The stone slides along the rocker, so this length changes with the position: it is read off the "
    "drawing each time."
)
CYLINDER_LENGTH = said(
    "The piston slides in the cylinder, so this length changes with the position: it is read off the "
    "drawing each time."
)
SPEED_OF_PIN = said(
    "The crank turns about a fixed pivot: the speed of its pin is the angular velocity times the radius."
)
POSSIBLE_SPEED = said(
    "The crank stands: a possible plan is drawn at 1 rad/s, for only the ratios of possible velocities count."
)
VELOCITY_OF_PIN = said(
    "A velocity is tangent to the path, here a circle: it is square to the crank, in the sense in which "
    "the crank turns."
)
VELOCITY_OF_PIN_TURNED = said(
    "The velocity of the pin is square to the crank; on a plan turned by 90° it lies along it."
)
ABOUT_FIXED = said(
    "The pivot stands still and the link is rigid: its point keeps its distance from the pivot, so the "
    "velocity has no part along {to}, it is square to it."
)
ABOUT_MOVING = said(
    "Two points of a rigid link keep their distance, so the velocity of one about the other has no part "
    "along {to}: it is square to {to}, its amount is not known yet."
)
ABOUT_FIXED_TURNED = said(
    "The velocity about the fixed pivot is square to {to}, for a point of a rigid link keeps its distance "
    "from it; on a plan turned by 90° it is drawn along {to}."
)
ABOUT_MOVING_TURNED = said(
    "The velocity of one point of a rigid link about another is square to {to}, for their distance does "
    "not change; on a plan turned by 90° it is drawn along {to}."
)
ON_FIXED_GUIDE = said("The guide is fixed, so the velocity has its direction.")
ON_MOVING_GUIDE = said(
    "A slider can move along its guide only: its velocity relative to the point of the guide below it has "
    "the direction of {to}, its amount is not known yet."
)
ON_FIXED_GUIDE_TURNED = said(
    "The guide is fixed, so the velocity has its direction; on a plan turned by 90° it is square to it."
)
ON_MOVING_GUIDE_TURNED = said(
    "The relative velocity of a slider has the direction of its guide {to}; on a plan turned by 90° it is "
    "square to it."
)
BOTH_EQUATIONS = said(
    "The end of the vector sought lies on both lines: from the ends of what is known the unknown parts "
    "are drawn in their directions, and only where these meet all that is known of it holds."
)
RELATIVE_VELOCITY = said(
    "This segment, times the scale factor, is the relative velocity; its sign tells in which sense the "
    "link turns, or the slider slides."
)
OMEGA = said(
    "About the other end of the link the point goes round in a circle: its relative velocity is ω times "
    "the length of the link."
)
ABSOLUTE_VELOCITY = said(
    "A vector from the pole is the velocity of the point itself: its length times the scale factor."
)
GAIN_OF_PIN = said(
    "The pin goes round in a circle at even speed: it has only the normal acceleration ω²·l."
)
NORMAL_OF_PIN = said(
    "The pin goes round in a circle: ω²·l is the normal part of its acceleration, ε·l will be the "
    "tangential one."
)
TO_THE_PIVOT = said(
    "A normal acceleration points to the centre of the circle: along the crank, from the pin to the pivot."
)
TANGENTIAL_OF_PIN = said("The crank gains speed: a tangential acceleration ε·l is added.")
ACROSS_THE_CRANK = said("A tangential acceleration is square to the radius, in the sense of ε.")
TO_THE_OTHER_POINT = said(
    "A normal acceleration points to the point about which the link turns, back along {to}."
)
TANGENTIAL = said(
    "The tangential part is ε times the length and square to {to}; ε is not known yet, so only its "
    "direction is."
)
CORIOLIS_ACROSS = said(
    "The Coriolis acceleration has the direction of the relative velocity turned by 90° in the sense of "
    "the guide's ω: square to {to}; the signs of ω and of the relative velocity decide to which side."
)
RELATIVE_ALONG = said(
    "Along a straight guide the relative path is straight: the relative acceleration has the direction of "
    "{to}, its amount is not known yet."
)
ACCELERATION_ALONG = said("The guide is fixed and straight, so the acceleration has its direction.")
STANDING_WHEEL = said(
    "The other wheel stands, and on it this one rolls without slipping: its pitch point has no velocity."
)
EQUAL_RIMS = said(
    "The belt or chain neither stretches nor slips: both ends of its run, and the rims there, are equally fast "
    "along it."
)
RIM_APART = said(
    "The ends of a run have the same acceleration along it; they differ only across it, along the "
    "radius {to}."
)
ROLLING_APART = said(
    "Where the wheels roll on each other their points have the same acceleration along the common tangent; "
    "they differ only along the line of centres, {to}."
)
TANGENTIAL_READ = said(
    "This segment, times the scale factor, is the tangential acceleration; its sign tells the sense of ε."
)
EPSILON = said(
    "The tangential acceleration about the other end of the link is ε times the length of the link."
)
RELATIVE_READ = said(
    "This segment, times the scale factor, is the relative acceleration along the guide."
)
ABSOLUTE_ACCELERATION = said(
    "A vector from the pole is the acceleration of the point itself: its length times the scale factor."
)
STRETCHED = said(
    "In this extreme position crank and rod are stretched in one line: the pin is as far from the crank's "
    "pivot as both together."
)
FOLDED = said(
    "In this extreme position crank and rod lie over each other in one line: the pin is as far from the "
    "crank's pivot as they differ."
)
EXTREME_PIN = said(
    "At that distance from the pivot the pin is on this arc, and on its own path as in every position."
)
IN_LINE = said(
    "Crank and rod are in one line, so the line from the crank's pivot to the pin tells the angle of the "
    "crank."
)
CRANK_CIRCLE = said("The pin of the crank goes round on this circle.")
ROCKER_TOUCHES = said(
    "The rocker swings out farthest where its line touches the circle of the pin: there crank and rocker "
    "are square to one another, and it turns back."
)
CYLINDER_TOUCHES = said(
    "The cylinder swings out farthest where its axis touches the circle of the pin: there crank and axis "
    "are square to one another, and it turns back."
)
CRANK_AT_EXTREME = said("The line from the pivot to the pin tells the angle of the crank.")
STANDS_STILL = said(
    "In an extreme position the point turns back: its velocity in the asked direction is 0, so it is "
    "looked for between two angles at which that velocity has opposite senses."
)
ANGLE_OF_LINK = said("The angle of a link is that of a line fixed in it, from the x axis.")
ALONG_THE_GUIDE = said(
    "The point slides along its guide: where it is, is read along it, with a sign for either way."
)
WHOLE_RELATIVE = said(
    "The vector from one image to another is the whole acceleration of one point relative to the other, its "
    "normal and tangential parts together."
)
PATH_WAY = said("The velocity of a point lies along the tangent of its path.")
PATH_ALONG = said(
    "Along the path means along the velocity: its direction is that of the plan of velocities."
)
PATH_ACROSS = said("The normal of the path is square to the velocity.")
PATH_TANGENTIAL = said(
    "The part of the acceleration along the path changes the size of the velocity; it is positive where the "
    "point goes faster."
)
PATH_NORMAL = said(
    "The part of the acceleration square to the path turns the velocity towards the centre of curvature; it "
    "is positive where that lies on the left of the way."
)
VECTOR = said("This vector is known in length and direction: it is laid off to scale.")
