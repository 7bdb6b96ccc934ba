"""What people call the constructions and their columns; why their steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.task import ACCELERATIONS
from graphic_tmm.chapters.klein.task import KLEIN, RITTERHAUS, TABLE
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

DIFFERENCE = "klein_difference"
SEVERAL = {
    KLEIN: said("Klein's construction by positions"),
    RITTERHAUS: said("Ritterhaus's construction by positions"),
}
CAPTIONS: dict[str, str] = {
    "chapter klein": said("Constructions of Klein and Ritterhaus"),
    KLEIN: said("Klein's construction"),
    RITTERHAUS: said("Ritterhaus's construction"),
    TABLE: said("Velocities and accelerations by Klein's figure"),
    DIFFERENCE: said("off the plan"),
    "klein results": said("Ways to the slider's acceleration"),
    f"klein_work_{KLEIN}": said("operations in a position, Klein"),
    f"klein_scatter_{KLEIN}": said("scatter by a student's hand, Klein"),
    f"klein_work_{RITTERHAUS}": said("operations in a position, Ritterhaus"),
    f"klein_scatter_{RITTERHAUS}": said("scatter by a student's hand, Ritterhaus"),
    f"klein_work_{ACCELERATIONS}": said("operations in a position, plans"),
    f"klein_scatter_{ACCELERATIONS}": said("scatter by a student's hand, plans"),
    f"table {KLEIN}": said("Velocities and accelerations by Klein's construction"),
    f"table {RITTERHAUS}": said("Velocities and accelerations by Ritterhaus's construction"),
}

CRANK = said("The crank stands as on the plan of positions.")
ROD = said("The rod stands as on the plan of positions.")
ALONG = said("The acceleration of the slider lies along its guide: this line bears it.")
ACROSS = said(
    "Turned by 90° the velocity of the slider is square to its guide: this line bears it."
)
TURNED = said(
    "Turned by 90° the velocity of the slider about the crank pin lies along the rod; {it} closes the triangle."
)
VELOCITY = said("A side of the triangle of velocities: it is a velocity divided by ω.")
OPENING = said("The compass takes the side of the triangle that lies along the rod.")
MIDDLE = said("The centre of the circle that has the rod as its diameter.")
ON_ROD = said("Every point of it sees the rod under a right angle.")
SHARED = said("A point of both circles: the right angle over the rod stands there.")
CHORD = said(
    "The common chord of two circles is square to the line of their centres, here the rod."
)
NORMAL = said(
    "In the right-angled triangle over the rod the opening is the mean proportional of the rod and of what "
    "{it} cuts off: this stands for the normal acceleration."
)
SIDE = said("The line from the slider to the crank's pivot closes the triangle of the mechanism.")
SIMILAR = said(
    "It cuts off a triangle similar to the mechanism's: the crank is divided as M divides the rod."
)
AGAIN = said("It divides once more in the same ratio.")
NORMAL_BY_RATIO = said(
    "Divided twice in one ratio, the rod is to the side along it as that side is to what {it} cuts off: this "
    "stands for the normal acceleration."
)
PIN_TANGENTIAL = said(
    "The tangential acceleration of the crank pin is square to the crank; the figure is turned by 180°, so "
    "it is laid off against its sense."
)
AGAIN_NORMAL = said(
    "The normal acceleration about the crank pin is laid off behind the whole acceleration of the pin."
)
TANGENTIAL = said("The tangential acceleration is square to the rod.")
WHOLE = said("The figure is closed: its last side stands for the acceleration of the slider.")
ACCELERATION = said("A side of the figure of accelerations.")
ROD_POINT = said("The point stands on the rod of this figure as on that of the plan.")
IMAGE_V = said("The point lies on the side of the velocities as it lies on the rod.")
IMAGE_A = said("The point lies on the side of the accelerations as it lies on the rod.")

WORDS = Named(captions=CAPTIONS, plans=(KLEIN, RITTERHAUS), sources=("artobolevsky",))
