"""That a gear pair passes all checks of its meshing, in words."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.gears.checks import verdicts
from graphic_tmm.chapters.gears.names import GEARS
from graphic_tmm.chapters.gears.results import gear_results
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, result_number
from graphic_tmm.note.document import Runs

ALL = said(
    "All conditions of the meshing hold: no tooth is pointed ({first} and {second} at the tips) or undercut, "
    "the flanks do not interfere, the clearance is kept, and the contact ratio {ratio} is above 1."
)
NAMES = {"first": "s_a1", "second": "s_a2", "ratio": "contact_ratio"}


def verdict(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield one sentence where every check holds; those that fail stand in the table of checks."""
    if not all(one.holds for one in verdicts(GEARS.on(drawn).checks, drawn.reading)):
        return
    found = gear_results(drawn)
    put = {key: result_number(drawn, found, name, language) for key, name in NAMES.items()}
    yield filled(speaking(language)(ALL), put)
