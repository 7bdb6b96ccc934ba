"""Specimens: the lettering of ГОСТ 2.304, and the symbols of links and pairs (ГОСТ 2.770), to be placed on any sheet."""

from __future__ import annotations

from graphic_tmm.chapter import Chapter, Place
from graphic_tmm.chapters.lettering.specimen import specimen
from graphic_tmm.chapters.lettering.specimen_symbols import specimen_symbols

CHAPTER = Chapter(
    name="lettering",
    number=11,
    board="",
    places=(
        Place("lettering", 0, plain=lambda scene: specimen(scene.language)),
        Place("symbols", 0, plain=lambda scene: specimen_symbols(scene.language)),
    ),
)
