"""What is warned of a balance: links that are balanced already, and need no counterweight."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.balance.plan import BALANCE_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned

_ALREADY = said(
    "balance: link {link} is balanced already: it needs no counterweight; take its [[counterweight]] out, if "
    "there is one"
)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made = BALANCE_PLAN.of(drawn)
    for one in made.unbalances if made is not None else ():
        if one.held is None:
            yield speaking(language)(_ALREADY, link=one.link)


WARNINGS = Warned(_warnings)
