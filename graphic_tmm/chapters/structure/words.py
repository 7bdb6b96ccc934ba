"""What the structure of a mechanism is called, and its letters."""

from __future__ import annotations

from graphic_tmm.chapters.structure import STRUCTURE
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS = {
    STRUCTURE: said("Structure"),
    "chapter structure": said("Structure of the mechanism"),
}
SYMBOLS = (("W", said("mobility"), ""),)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    plans=(STRUCTURE,),
    sources=("assur", "artobolevsky"),
    symbols=SYMBOLS,
)
