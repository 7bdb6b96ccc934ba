"""What people call the construction of a synthesis and its results; why its steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.linkage_synthesis.task import SYNTHESIS
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "given synthesis": said("Given for the synthesis"),
    "synthesis lengths": said("Lengths found"),
    "synthesis by drawing": said("by the drawing"),
    "chapter linkage_synthesis": said("Synthesis by drawing"),
    "synthesis-calculation": said("Synthesis, calculated"),
    "synthesis_transmission_1": said("angle of transmission, crank towards C"),
    "synthesis_transmission_2": said("angle of transmission, crank away from C"),
    "synthesis by calculation": said("calculated"),
    "synthesis_departure_calculated": said("how far the path leaves the arc"),
}

STROKE_LAID = said("The stroke is laid off on the slider's guide.")
OF_COUPLER = said("The point keeps its place in the coupler.")
ARC = said("The centre of an arc stands on the bisector of any of its chords.")
EXTREME = said("In its extreme places the rocker stands at half its swing from the axis.")
SEEN = said(
    "A point from which a chord is seen under θ lies on a circle; the radii to both ends of the chord are at "
    "90° − θ to it."
)
OFFSET = said("The crank's pivot stands at the distance e from the guide.")
PIVOT_ON_LOCUS = said(
    "The crank's pivot stands on the circle from which the chord is seen under θ."
)
ABOUT = said(
    "Where θ is half of ψ, the circle is about C: the angle of transmission alone chooses a place on it."
)
TWICE_CRANK = said(
    "In the dead centres B is l + r and l − r from O: the difference of both distances is twice the crank."
)
IN_LINE = said("In a dead centre crank and coupler lie in one line.")
WITH_FRAME = said("The transmission is worst where crank and frame lie in one line.")
DEAD_CENTRE = said(
    "In a dead centre B is the rod's length and the crank's, or less the crank's, from O."
)
POINTER = said("The coupler stands at its given angle.")
MIDDLE = said("A bisector goes through the middle of its chord.")
HALF_STROKE = said("The stroke is twice the crank: the diameter of its pin's circle.")
BISECTOR = said(
    "A pin keeps its distance from the centre about which it turns, so that stands on the bisector of any "
    "chord between its places."
)
CRANK_AT = said("The crank stands at its given angle.")
BACK = said(
    "The rocker is held in its first position, so the frame with the crank turns back about C by the angle "
    "through which the rocker has turned."
)
FORTH = said("The rocker has turned about C by its given angle.")
TOUCHING = said("In an extreme position the rocker touches the circle of the crank pin.")
CYLINDER = said("In an extreme position the cylinder's axis touches the circle of the crank pin.")
SWUNG = said(
    "In its extreme positions the cylinder stands at half its swing from the line of the pivots."
)
ASLANT = said("The rod is most aslant where the crank is square to the guide.")


def _result(name: str, speech: Speech) -> str:
    """Return what the length of some letters is called: as measured, as calculated."""
    _, _, rest = name.partition("synthesis_")
    letters, _, calculated = rest.partition("_")
    if not letters or name == rest:
        return ""
    if calculated:
        return speech(said("{letters} of the task, calculated"), letters=letters)
    return speech(said("{letters} of the task, by the drawing"), letters=letters)


WORDS = Named(
    captions=CAPTIONS,
    plans=(SYNTHESIS,),
    rank=5,
    result=_result,
    sources=("artobolevsky", "popov"),
)
