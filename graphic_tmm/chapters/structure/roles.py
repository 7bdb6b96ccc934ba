"""What a link is by its pairs, and what pairs are called."""

from __future__ import annotations

from graphic_tmm.language.said import said
from graphic_tmm.language.tables import Tongues
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.mechanism.structure import Pair, Structure

LINK_NAMES = Tongues(
    {
        "crank": said("crank"),
        "rocker": said("rocker"),
        "slotted rocker": said("slotted rocker"),
        "coupler": said("connecting rod"),
        "cylinder": said("cylinder"),
        "piston": said("piston with rod"),
        "slider": said("slider"),
        "stone": said("sliding block"),
        "frame": said("frame"),
        "link": said("link"),
    }
)
"""What a link is called by its role."""


def link_role(mechanism: Mechanism, structure: Structure, link: Link) -> str:
    """Return what a link is by its pairs: crank, rocker, coupler, slider, piston ... (a key of LINK_NAMES)."""
    frame = mechanism.frame.number
    if link.number == frame:
        return "frame"
    pairs = [pair for pair in structure.pairs if link.number in pair.links]
    for pair in (one for one in pairs if one.slide is not None and one.slide.cylinder):
        return "piston" if pair.links[0] == link.number else "cylinder"
    if link.number == structure.driver:
        return "crank"
    slides_on = [
        pair.links[1] for pair in pairs if pair.kind == "P" and pair.links[0] == link.number
    ]
    if slides_on:
        return "slider" if frame in slides_on else "stone"
    owns = any(pair.kind == "P" and pair.links[1] == link.number for pair in pairs)
    turns_on_frame = any(pair.kind == "R" and frame in pair.links for pair in pairs)
    if owns:
        return "slotted rocker" if turns_on_frame else "link"
    return "rocker" if turns_on_frame else "coupler"


def link_name(mechanism: Mechanism, structure: Structure, link: Link, language: str) -> str:
    """Return the name the scene gives to a link, or that of its role."""
    return link.name or LINK_NAMES[language][link_role(mechanism, structure, link)]


def pair_name(pair: Pair, mechanism: Mechanism) -> str:
    """Return a pair's letter; a guide of the frame is named y-y, one on a moving link by the stone's letter."""
    if pair.kind == "R":
        return pair.name
    if pair.links[1] == mechanism.frame.number:
        return f"{pair.name}-{pair.name}"
    letters = mechanism.by_number[pair.links[0]].points
    return next(iter(letters), pair.name)
