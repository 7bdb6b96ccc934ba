"""What is warned of a Geneva wheel: a shock at the entry, pins in each other's way, parts without room."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.chapters.geneva.plan import GENEVA_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import small, unit
from graphic_tmm.readers.findings import Warned

SHOCK = 1e-3
"""A crank off by this share of its length is warned of: it is given to three digits."""


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    wheel = GENEVA_PLAN.of(drawn)
    if wheel is None:
        return
    _ = speaking(language)

    has = drawn.value
    pin = has(wheel.pin)
    (due, of), (given, of) = (small(has(one), language) for one in (wheel.due, wheel.given))
    if abs(given - due) > SHOCK * due:
        yield _(
            "geneva: the pin enters with a shock: the crank is {given} {mm}, L·sin(180°/z) = {due} {mm}",
            given=number(given, language), due=number(due, language), mm=unit(of, language),
        )  # fmt: skip
    if wheel.order.spare < 0:
        yield _(
            "geneva: with {k} pins one would enter before another has left: take fewer pins",
            k=wheel.order.pins,
        )
    elif wheel.order.spare == 0:
        yield _(
            "geneva: with {k} pins the wheel never stands: one enters as another leaves",
            k=wheel.order.pins,
        )
    if not has(wheel.bottom) > 0.0:
        yield _(
            "geneva: the slots would go through the wheel's centre: take a smaller pin or more distance"
        )
    elif not (has(wheel.bottom) + pin) * math.sin(math.pi / wheel.order.slots) > pin:
        yield _("geneva: the slots run into each other: take a smaller pin or more distance")
    lock, crank = has(wheel.lock), has(wheel.crank)
    if not lock > 0.0:
        yield _("geneva: no disc is left inside the pin's way: take a smaller pin, or give lock")
    elif not lock < crank - pin:
        yield _(
            "geneva: the disc that locks the wheel has to be smaller than the pin's way: change lock"
        )
    elif not lock > has(wheel.apart) - has(wheel.rim):
        yield _("geneva: the disc does not reach the wheel and cannot lock it: take a larger lock")


WARNINGS = Warned(_warnings)
