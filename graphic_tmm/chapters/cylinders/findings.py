"""What is told of an engine's inertia: what balances itself, what counterweights on the shaft can balance."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cylinders.plan import CYLINDERS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.readers.findings import Warned
from graphic_tmm.scene.captions import captions


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made = CYLINDERS_PLAN.of(drawn)
    if made is None:
        return
    _, words = speaking(language), captions(language)
    rests = made.rests
    if made.order.apart:
        listed = ", ".join(f"{one}–{other} ({turn:.4g}°)" for one, other, turn in made.order.apart)
        yield _(
            "cylinders: in this order of firing cylinders that face each other have cranks apart, {listed}: no "
            "pin bears both rods; where one is to, change firing, or angle",
            listed=listed,
        )
    if all(rest.size is None for rest in rests.values()):
        yield _("cylinders: forces and moments of both orders balance one another")
    for kind, rest in rests.items():
        if rest.turns and kind[1] == "1":
            yield _(
                "cylinders: {what}: they keep their size and turn with the shaft; counterweights can balance "
                "them",
                what=words[f"cylinders-{kind}"],
            )


WARNINGS = Warned(_warnings)
