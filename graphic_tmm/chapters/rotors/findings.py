"""What is told of a rotor: what is balanced already, what a counterweight at rest leaves, what is too small."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.rotors.plan import MOMENTS, ROTOR_PLAN, Rotor
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.readers.findings import Warned


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    rotor = ROTOR_PLAN.of(drawn)
    if rotor is None:
        return
    _ = speaking(language)
    idle = [one.name for one in rotor.weights if one.size is None]
    if len(idle) == len(rotor.weights):
        yield _("rotor: its masses balance one another: no counterweight is wanted")
    elif idle:
        yield _("rotor: plane {name} wants no counterweight", name=idle[0])
    if _apart(rotor):
        yield _(
            "rotor: its masses stand in several planes: one counterweight leaves a couple; give two planes"
        )
    for one in rotor.weights:
        if one.size is not None and not drawn.value(one.size) > 0.0:
            yield _(
                "rotor: the ruler reads no side that is missing in plane {name}: what is left is less than it "
                "shows",
                name=one.name,
            )
    if MOMENTS not in rotor.polygons and rotor.order.dynamic:
        yield _("rotor: all masses stand in plane I: no moment is left about it")


def _apart(rotor: Rotor) -> bool:
    """Whether balance at rest is asked for of masses that are known to stand in several planes."""
    places = [one.at for one in rotor.order.unbalances if one.at is not None]
    places += rotor.order.planes
    return not rotor.order.dynamic and len(set(places)) > 1


WARNINGS = Warned(_warnings)
