"""What is told of centres that no lines lead to."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.centres.network import letter_of
from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.symbols import plain
from graphic_tmm.readers.findings import Warned


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made = CENTRES_PLAN.of(drawn)
    if made is not None and made.lost:
        _ = speaking(language)
        yield _(
            "centres: no two lines and no velocities lead to {names}: these links do not move to one another, "
            "or both have one centre on the frame",
            names=", ".join(plain(letter_of(links)) for links in made.lost),
        )


WARNINGS = Warned(_warnings)
