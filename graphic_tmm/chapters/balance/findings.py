"""What is warned of a balance: links that are balanced already, and bear a counterweight without mass."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.balance.plan import BALANCE_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned

LEFT = 1e-6
"""Static moments whose sum is no larger than this share of them balance each other: nobody files off less."""


_ALREADY = said(
    "balance: link {link} is balanced already: its counterweight comes to nothing; take its "
    "[[counterweight]] out"
)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made = BALANCE_PLAN.of(drawn)
    for one in made.unbalances if made is not None else ():
        spots = [complex(drawn.reading[head][0, 0]) for _, _, head in one.sides]
        if drawn.value(one.closing) <= LEFT * max(map(abs, spots)):
            yield speaking(language)(_ALREADY, link=one.link)


WARNINGS = Warned(_warnings)
