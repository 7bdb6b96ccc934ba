"""What a quantity should be: by an exact hand without a ruler, on the same log where that is independent.

Diagrams are judged by the plans at the same positions. A flywheel and a cam's least radius are taken from a row
so fine that they have converged; friction from many passes; the moment of a crank mechanism whose rod was
replaced by two masses from the kinetostatics of the rod itself; the contact ratio from its formula.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from graphic_tmm.accuracy.drawing import Drawing, Pinned, draw
from graphic_tmm.accuracy.quantities import CONVERGED, Quantity, quantities
from graphic_tmm.accuracy.settings import ALL, at_count
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.forces.task import ForcesOrder
from graphic_tmm.errors import TmmError
from graphic_tmm.scene.records import Scene, SheetOrder

FINE = 12_288
"""Positions of a row that has converged."""
DIVISIONS = 192
"""Parts of a cam's moving phase that has converged."""
TURN = 192
"""Positions among which the largest value of a turn is looked for."""
PASSES = 12
"""Passes of friction after which nothing changes any more."""


class References:
    """What the quantities of a scene should be; each is found once."""

    def __init__(self, scene: Scene, scales: Pinned) -> None:
        self.scene, self.scales = scene, scales
        self._known: dict[tuple[str, int], Reals | None] = {}
        self._largest: dict[tuple[str, str], float] = {}

    def of(self, quantity: Quantity, drawing: Drawing) -> Reals | None:
        """Return the quantity as it should be, (1, value); None if nothing independent tells it."""
        if quantity.due:
            reading = execute(drawing.log, drawing.given, _due_marks(quantity))
            return quantity.read(reading, 1, due=True)
        key = quantity.name, quantity.row
        if key not in self._known:
            self._known[key] = self._find(quantity, drawing)
        return self._known[key]

    def largest(self, quantity: Quantity, drawing: Drawing) -> float:
        """Return the largest value that the quantity has in the turn; NaN if nothing tells it."""
        key = drawing.board, quantity.name
        if key not in self._largest:
            fine = self._row(quantity, drawing) if quantity.row else None
            due = self.of(quantity, drawing) if fine is None else fine
            size = np.abs(due) if due is not None else np.array([np.nan])
            self._largest[key] = float(np.max(size, initial=0.0, where=np.isfinite(size)))
        return self._largest[key]

    def _row(self, quantity: Quantity, drawing: Drawing) -> Reals | None:
        """Return what a quantity should be at the positions of a fine row."""
        scene = at_count(self.scene, TURN)
        if scene is None:
            return None
        for one in draw(scene, self.scales):
            for found in quantities(one):
                if (one.board, found.name) == (drawing.board, quantity.name):
                    return self.of(found, one)
        return None

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
    if quantity.name == "r0_min" and scene.tasks.get("cam") is not None:
        return scene.asking(cam=replace(scene.tasks["cam"], divisions=DIVISIONS, per_turn=None))
    if quantity.name in CONVERGED and scene.tasks.get("flywheel") is not None:
        fine = at_count(scene, FINE)
        order = replace(scene.tasks["flywheel"], integration="areas")
        if order.tangents is not None:
            order = replace(order, tangents="curve")
        if fine is None or fine.tasks.get("flywheel") is None:
            return None
        return fine.asking(flywheel=replace(order, indicator=fine.tasks["flywheel"].indicator))
    same = at_count(scene, quantity.row)
    if same is None:
        return None
    if quantity.name == "M_engine" and same.tasks.get("engine") is not None:
        forces = ForcesOrder(
            ALL, inertia=True, gas=same.tasks["engine"].indicator, balance="moment"
        )
        sheet = SheetOrder("A1", ("positions", "forces"))
        return replace(same.asking(forces=forces, engine=None, flywheel=None), sheets=(sheet,))
    if same.tasks.get("forces") is not None and same.tasks["forces"].friction is not None:
        many = replace(same.tasks["forces"].friction, passes=PASSES)
        return same.asking(forces=replace(same.tasks["forces"], friction=many))
    return None
