"""What people call the balance of a mechanism, its views and columns; why its steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.balance.task import (
    BALANCE,
    COUNTERWEIGHTS,
    FORCE,
    INERTIA,
    MASSES,
    MOMENT,
    UNBALANCE,
)
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    BALANCE: said("Balance of the mechanism"),
    INERTIA: said("Inertia forces"),
    MASSES: said("Replacing masses"),
    COUNTERWEIGHTS: said("Counterweights"),
    FORCE: said("Polar diagram of the shaking force"),
    MOMENT: said("Moment of the shaking force about {point}"),
    f"view {MOMENT}": said("Moment of the shaking force"),
    f"table {BALANCE}": said("Shaking force and its moment"),
    "without": said("without counterweights"),
    "with": said("with counterweights"),
    "shaking_max": said("largest shaking force"),
    "shaking_max_balanced": said("the same with counterweights"),
    "shaking_removed": said("taken away by the counterweights"),
    "shaking_moment": said("largest moment of it"),
    "shaking_moment_balanced": said("largest moment with counterweights"),
}

WEIGHT = "counterweight_"
"""How names of results of counterweights begin: counterweight_mass_1."""


def called(view: str, speech: Speech) -> str:
    """Return what the static moments of a link are called; "" for other views."""
    kind, _, link = view.rpartition(" ")
    return speech(_UNBALANCE, link=link) if kind == UNBALANCE else ""


def result(name: str, speech: Speech) -> str:
    """Return what a result of a counterweight is called; "" for other results."""
    of, _, link = name.removeprefix(WEIGHT).partition("_")
    return speech(_SIZES[of], link=link) if name.startswith(WEIGHT) and of in _SIZES else ""


_UNBALANCE = said("Static moments of link {link}")
_SIZES = {
    "mass": said("mass of the counterweight on link {link}"),
    "radius": said("radius of the counterweight on link {link}"),
}

SYMBOLS = (
    ("Φ", said("shaking force"), "N"),
    ("M_Φ", said("moment of the shaking force"), "N·m"),
    ("m_{c1}", said("mass of the counterweight on link 1"), "kg"),
    ("r_{c1}", said("radius of the counterweight on link 1"), "m"),
    ("m_{2A}", said("mass that replaces link 2 at A"), "kg"),
    ("D_{2A}", said("static moment"), "kg·m"),
    ("μ_D", said("scale factor of static moments"), "(kg·m)/mm"),
    ("μ_Φ", said("scale factor of shaking forces"), "N/mm"),
)
"""Its letters in a note: what they stand for, their units."""

WORDS = Named(
    captions=CAPTIONS,
    called=called,
    result=result,
    plans=(BALANCE,),
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)

SHAKING = said(
    "The frame bears the inertia forces of all links: their vector sum, from the pole to the end of the "
    "polygon, is the shaking force in this position."
)
HODOGRAPH = said(
    "The ends of the shaking force in all positions, from one pole, lie on a smooth curve: its polar diagram."
)
LARGEST = said("The frame is shaken most where the curve is farthest from the pole.")
LEVELLED = said(
    "The ordinate is carried to the axis: there the ordinates of all positions are compared."
)
ARM_ABOUT = said("The moment of an inertia force about the point is the force times this arm.")
MOMENTS_SUM = said(
    "The moments of all inertia forces about the point and the couples of inertia are added with their signs, "
    "counter-clockwise positive."
)
BOTH_SUMS = said("The moments of the counterweights are added to those of the links.")
COUNTERWEIGHT_LINE = said(
    "The counterweight is fixed in its link: its line stands at one angle to the link in all positions."
)
COUNTERWEIGHT_AT = said("On this line, at its radius, stands the mass centre of the counterweight.")
COUNTERWEIGHT_GAINS = said(
    "The acceleration of the counterweight's mass centre is measured: its inertia force follows from it."
)
