"""What is warned of a Geneva wheel: a shock at the entry, pins in each other's way, parts without room."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.geneva.plan import GENEVA_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import unit
from graphic_tmm.readers.findings import Warned

SHOCK = 1e-3
"""A crank off by this share enters across the slot by 2.6° (arccos 0.999): its length to three digits."""


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    wheel = GENEVA_PLAN.of(drawn)
    if wheel is None:
        return
    _ = speaking(language)

    has = drawn.value
    due, given, mm = 1e3 * has(wheel.due), 1e3 * has(wheel.given), unit("mm", language)
    if abs(given - due) > SHOCK * due:
        yield _(
            "geneva: the pin enters with a shock: the crank is {given} {mm}, L·sin(180°/z) = {due} {mm}",
            given=number(given, language), due=number(due, language), mm=mm,
        )  # fmt: skip
    if (share := has(wheel.share)) >= 1.0:
        yield _(
            "geneva: with {k} pins one would enter before another has left: τ = {share}; take fewer pins",
            k=wheel.order.pins, share=number(share, language),
        )  # fmt: skip
    if not has(wheel.bottom) > 0.0:
        yield _(
            "geneva: the slots would go through the wheel's centre: take a smaller pin or more distance"
        )
    if not 0.0 < has(wheel.lock) < has(wheel.crank) - has(wheel.pin):
        yield _(
            "geneva: the disc that locks the wheel has to be smaller than the pin's way: change lock"
        )


WARNINGS = Warned(_warnings)
