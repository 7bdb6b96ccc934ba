"""What people call the flywheel's graphs, table and results; why its inertia is found as it is."""

from __future__ import annotations

from graphic_tmm.chapters.flywheel.task import FLYWHEEL
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "flywheel": said("Flywheel"),
    "moment": said("Reduced moment of the driving forces"),
    "work": said("Works of the driving and the resisting forces"),
    "energy": said("Change of kinetic energy"),
    "energy-mass": said("Energy–mass diagram"),
    "flywheel-calculation": said("Mean moment, power and the two methods"),
    "table flywheel": said("Flywheel, by positions"),
    "cd": said("cd"),
    "J_fly": said("J_{F}"),
    "delta": "δ",
    "J_fly_energy_mass": said("J_{F} (energy–mass)"),
    "J_apart": said("difference of J_{F}"),
    "M_mean": said("M_{mean}"),
    "power": said("N, mean power"),
    "A_excess": said("largest excess work"),
    "J_made": said("J of the rim as it is made"),
    "delta_made": said("δ of the rim as it is made"),
    "D_mean": said("D_{mean}"),
    "rim_mass": said("m_{F}"),
    "p_mean_cover": said("p_{mean}, cover"),
    "p_mean_shaft": said("p_{mean}, shaft"),
    "D_max": "D_{max}",
    "D_e": "D_{e}",
    "D_i": "D_{i}",
    "rim_width": "b",
}

_MEAN = {
    "p_mean_cover": said("p_{{mean}}, cover, cylinder {point}"),
    "p_mean_shaft": said("p_{{mean}}, shaft, cylinder {point}"),
}


def result(name: str, speech: Speech) -> str:
    """Return what the mean pressure of one of several cylinders is called; "" for other results."""
    mean, _, point = name.rpartition("_")
    return speech(_MEAN[mean], point=point) if mean in _MEAN else ""


_RESISTING = said("Reduced moment of the resisting forces")
_GIVEN = {
    "resisting": said("Driving moment over the cycle"),
    "driving": said("Resisting moment over the cycle"),
}
"""What the moment is called that varies where it is given, by which is constant."""


def graph_title(view: str, constant: str, speech: Speech, *, given: bool = False) -> str:
    """Return what a graph is called; that of the moment by which of the two moments varies.

    ``given``: it is given as it is, no force was reduced.
    """
    if view == "moment" and given:
        return speech(_GIVEN[constant])
    if view == "moment" and constant == "driving":
        return speech(_RESISTING)
    return speech(CAPTIONS[view])


SYMBOLS = (
    ("M_r", said("reduced moment"), "N·m"),
    ("A", said("work"), "J"),
    ("A_{ex}", said("largest excess work"), "J"),
    ("p_{max}", said("highest pressure of the diagram"), "Pa"),
    ("T", said("kinetic energy"), "J"),
    ("J_F", said("moment of inertia of the flywheel"), "kg·m²"),
    ("δ", said("coefficient of irregularity"), ""),
    ("μ_M", said("scale factor of moments"), "(N·m)/mm"),
    ("μ_A", said("scale factor of works"), "J/mm"),
)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    result=result,
    plans=(FLYWHEEL,),
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)


STRAIGHT = said(
    "In steady motion the driving and the resisting forces do the same work in a turn, and the work of a "
    "constant moment grows evenly: a straight line between the ends of the other work."
)
STRAIGHT_AT = said(
    "The ordinate of the straight line in the same position is the work of the constant moment."
)
SURPLUS = said(
    "By how much the driving work is ahead of the resisting one is what the kinetic energy of the machine "
    "has gained: ΔT."
)
CONSTANT_RAY = said(
    "A ray with the slope of the straight line cuts off, on the axis of moments, the constant moment."
)
CONSTANT = said("The constant moment is read on the axis of moments, to the same scale.")
LEVEL = said(
    "From a pole on the level of the constant moment that moment has a level ray, so the rays to the other "
    "one have the slopes of ΔT."
)
OF_FLYWHEEL = said(
    "The gain ΔT is shared by links and flywheel: what the links do not have the flywheel has."
)
EXTREME_LEVEL = said("The level of this extreme is carried to the axis of ordinates.")
CD = said(
    "Between its least and its greatest the energy of the flywheel changes by cd: this is what it has to "
    "store."
)
LINKS_ENERGY = said("The kinetic energy of the links is the sum of the energies of all of them.")
CYLINDERS_SUM = said("The powers of all cylinders add up, so their reduced moments do.")
MOMENTS_SUM = said("The powers of all loads add up, so their moments on the lever do.")
CLOCKWISE = {
    True: said(
        "The moment on the lever is a power, to scale; divided by the pin's velocity it is a force on the "
        "pin, times the crank's length a moment on the shaft. The crank turns clockwise, so what drives it "
        "has a negative moment there: it counts with the opposite sign."
    ),
    False: said(
        "The moment on the lever is a power, to scale; divided by the pin's velocity it is a force on the "
        "pin, times the crank's length a moment on the shaft. The crank turns clockwise, so what resists "
        "has a positive moment there: it counts as it is."
    ),
}
"""Why the sum of the moments is taken with its sign, by whether those of the driving forces are wanted."""
JT_POINT = said(
    "The point of a position has its reduced moment of inertia as abscissa and its ΔT as ordinate."
)
JT_CUT = said("Both tangents cut off on the axis of ΔT the segment by which the flywheel follows.")
