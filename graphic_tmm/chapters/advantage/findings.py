"""What is told of forces that the centres do not balance."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.advantage.plan import ADVANTAGE_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned

_SEVERAL = said(
    "centres: several drives share the power of the loads: what balances each is told by its lever alone"
)
_APART = said(
    "centres: no position has both centres and forces: name one in both [centres] and [forces], and what "
    "balances the drive is found by centres too"
)
_LACKS = said(
    "centres: no centre tells how link {links} moves by the drive: forces are not balanced by centres"
)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made, _ = ADVANTAGE_PLAN.of(drawn), speaking(language)
    if made is None:
        return
    if made.several:
        yield _(_SEVERAL)
    elif not made.places:
        yield _(_APART)
    elif made.lacks:
        yield _(_LACKS, links=", ".join(map(str, dict.fromkeys(made.lacks))))


WARNINGS = Warned(_warnings)
