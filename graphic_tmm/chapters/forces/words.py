"""What people call the force analysis, its table and its columns."""

from __future__ import annotations

from graphic_tmm.chapters.forces.names import FORCES
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.names import plain
from graphic_tmm.language.said import said
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
    "bal_difference": said("Δ"),
    "bal_open": said("Δ_{friction}"),
}


def called(view: str, speech: Speech) -> str:
    """Return what the figure, the polygon or the equations of a group or a link are called, and its pass.

    So is the friction of a pass, "friction 1"; "" for other views.
    """
    kind, _, name = view.partition(" ")
    if kind == "load" and name:
        return speech(LOAD, letter=plain(name))
    if kind == "friction" and name.isdigit():
        return speech(_FRICTION, number=name, before=int(name) - 1)
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
