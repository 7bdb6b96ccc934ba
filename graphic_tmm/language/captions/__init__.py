"""The words of sheets, tables and protocols by the names that code has for them; what links are called."""

from __future__ import annotations

from graphic_tmm.language.captions.english import ENGLISH
from graphic_tmm.language.said import said
from graphic_tmm.language.tables import Tongues

CAPTIONS = Tongues(ENGLISH)
LINK_NAMES = Tongues(
    {
        "crank": said("crank"),
        "rocker": said("rocker"),
        "slotted rocker": said("slotted rocker"),
        "coupler": said("connecting rod"),
        "slider": said("slider"),
        "stone": said("sliding block"),
        "frame": said("frame"),
        "link": said("link"),
    }
)
HANDS = Tongues(
    {
        "exact": said("exact"),
        "cad": said("CAD"),
        "careful": said("careful"),
        "student": said("student"),
    }
)
