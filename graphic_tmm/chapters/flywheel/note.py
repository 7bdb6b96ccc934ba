"""What follows from the flywheel: its moment of inertia by both methods."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.flywheel.table import flywheel_results
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, result_number
from graphic_tmm.note.document import Run, Runs

BOTH = said(
    "The moment of inertia of the flywheel is {energy} by the change of kinetic energy and {energy_mass} by "
    "the energy–mass diagram, which does not take the speed for even."
)
ONE = said("The moment of inertia of the flywheel is {energy}.")


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield what the flywheel has to be."""
    _, results = speaking(language), flywheel_results(drawn)
    if "J_fly" not in results:
        return
    put: dict[str, Run] = {"energy": result_number(drawn, results, "J_fly", language)}
    if "J_fly_energy_mass" not in results:
        yield filled(_(ONE), put)
        return
    put["energy_mass"] = result_number(drawn, results, "J_fly_energy_mass", language)
    yield filled(_(BOTH), put)
