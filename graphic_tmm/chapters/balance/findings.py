"""What is warned of a balance: links that are balanced already, and need no counterweight."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.balance.plan import BALANCE_PLAN
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned

_ALREADY = said(
    "balance: link {link} is balanced already: it needs no counterweight; take its [[counterweight]] out, if "
    "there is one"
)

_NO_MASS = said(
    "balance: link {link} has a mass centre and J, but no mass: no force of its inertia is counted; write mass"
)
_NO_J = said(
    "balance: link {link} has a mass, but no J: its moment of inertia is not counted; write J"
)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made = BALANCE_PLAN.of(drawn)
    if made is not None:
        yield from _halves(drawn, language)
    for one in made.unbalances if made is not None else ():
        if one.held is None:
            yield speaking(language)(_ALREADY, link=one.link)


def _halves(drawn: Drawn, language: str) -> Iterator[str]:
    """Yield which links have a part of what shakes: a centre without a mass, a mass that turns without J."""
    _, plans = speaking(language), KINEMATICS_PLAN.on(drawn)
    rates = plans.accelerations.rates if plans.accelerations is not None else {}
    for link in plans.mechanism.links:
        if (
            not link.mass
            and link.inertia
            and link.centre not in (None, *plans.mechanism.frame.points)
        ):
            yield _(_NO_MASS, link=link.number)
        elif link.mass and not link.inertia and link.number in rates:
            yield _(_NO_J, link=link.number)


WARNINGS = Warned(_warnings)
