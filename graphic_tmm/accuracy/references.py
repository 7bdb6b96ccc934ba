"""What a quantity should be: by an exact hand without a ruler, on the same log where that is independent.

Diagrams are judged by the plans at the same positions. A flywheel and a cam's least radius are taken from a row
so fine that they have converged; friction from many passes; the moment of a crank mechanism whose rod was
replaced by two masses from the kinetostatics of the rod itself; the contact ratio from its formula.
"""

from __future__ import annotations

from dataclasses import replace

from graphic_tmm.accuracy.drawing import Drawing, Pinned, draw
from graphic_tmm.accuracy.quantities import CONVERGED, Quantity, quantities
from graphic_tmm.accuracy.settings import ALL, at_count
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.errors import TmmError
from graphic_tmm.mechanism.loads import ForcesOrder
from graphic_tmm.scene.records import Scene, SheetOrder

FINE = 12_288
"""Positions of a row that has converged."""
DIVISIONS = 192
"""Parts of a cam's moving phase that has converged."""
PASSES = 12
"""Passes of friction after which nothing changes any more."""


class References:
    """What the quantities of a scene should be; each is found once."""

    def __init__(self, scene: Scene, scales: Pinned) -> None:
        self.scene, self.scales = scene, scales
        self._known: dict[tuple[str, int], Reals | None] = {}

    def of(self, quantity: Quantity, drawing: Drawing) -> Reals | None:
        """Return the quantity as it should be, (1, value); None if nothing independent tells it."""
        if quantity.due:
            reading = execute(drawing.log, drawing.given, _due_marks(quantity))
            return quantity.read(reading, 1, due=True)
        key = quantity.name, quantity.row
        if key not in self._known:
            self._known[key] = self._find(quantity, drawing)
        return self._known[key]

    def _find(self, quantity: Quantity, drawing: Drawing) -> Reals | None:
        scene = _finer(self.scene, quantity)
        if scene is None:
            return None
        name = "M_bal" if quantity.name == "M_engine" else quantity.name
        try:
            drawn = draw(scene, self.scales)
        except TmmError:
            return None
        for one in drawn:
            for found in quantities(one):
                if found.name == name and one.board == drawing.board:
                    value = found.read(execute(one.log, one.given, found.marks), 1)
                    return -value if quantity.name == "M_engine" else value
        return None


def _due_marks(quantity: Quantity) -> list[Mark]:
    return [mark for value in quantity.due for mark in value.marks]


def _finer(scene: Scene, quantity: Quantity) -> Scene | None:
    """Return the scene that tells a quantity as it should be."""
    if quantity.name == "r0_min" and scene.cam is not None:
        return replace(scene, cam=replace(scene.cam, divisions=DIVISIONS, per_turn=None))
    if quantity.name in CONVERGED and scene.flywheel is not None:
        fine = at_count(scene, FINE)
        order = replace(scene.flywheel, integration="middles")
        if order.tangents is not None:
            order = replace(order, tangents="curve")
        if fine is None or fine.flywheel is None:
            return None
        return replace(fine, flywheel=replace(order, indicator=fine.flywheel.indicator))
    same = at_count(scene, quantity.row)
    if same is None:
        return None
    if quantity.name == "M_engine" and same.engine is not None:
        forces = ForcesOrder(ALL, inertia=True, gas=same.engine.indicator, balance="moment")
        sheet = SheetOrder("A1", ("positions", "forces"))
        return replace(same, forces=forces, engine=None, flywheel=None, sheets=(sheet,))
    if same.forces is not None and same.forces.friction is not None:
        many = replace(same.forces.friction, passes=PASSES)
        return replace(same, forces=replace(same.forces, friction=many))
    return None
