"""What a quantity should be: by an exact hand without a ruler, on the same log where that is independent.

Where it is not, another drawing tells it: of a row so fine that it has converged, or by another road; which one
is said by the quantity.
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.accuracy.drawing import Pinned, draw, on_board
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.quantity import Quantity, Reference
from graphic_tmm.board.execute import execute
from graphic_tmm.board.values import Reals
from graphic_tmm.errors import TmmError
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import at_count
from graphic_tmm.scene.records import Scene

TURN = 192
"""Positions among which the largest value of a turn is looked for."""


class References:
    """What the quantities of a scene should be; each is found once."""

    def __init__(self, scene: Scene, scales: Pinned) -> None:
        self.scene, self.scales = scene, scales
        self._known: dict[tuple[str, int], Reals | None] = {}
        self._largest: dict[tuple[str, str], float] = {}

    def of(self, quantity: Quantity, drawing: Project) -> Reals | None:
        """Return the quantity as it should be, (1, value); None if nothing independent tells it."""
        if quantity.due:
            reading = execute(drawing.construction, drawing.given, quantity.due_marks)
            return quantity.read(reading, 1, due=True)
        key = quantity.name, quantity.row
        if key not in self._known:
            told = quantity.reference
            found = self._find(quantity, told, drawing.board) if told is not None else None
            self._known[key] = found
        return self._known[key]

    def largest(self, quantity: Quantity, drawing: Project) -> float:
        """Return the largest value that the quantity has in the turn; NaN if nothing tells it."""
        key = drawing.board, quantity.name
        if key not in self._largest:
            fine = self._row(quantity, drawing) if quantity.row else None
            due = self.of(quantity, drawing) if fine is None else fine
            size = np.abs(due) if due is not None else np.array([np.nan])
            self._largest[key] = float(np.max(size, initial=0.0, where=np.isfinite(size)))
        return self._largest[key]

    def _row(self, quantity: Quantity, drawing: Project) -> Reals | None:
        """Return what a quantity should be at the positions of a fine row."""
        scene = at_count(self.scene, TURN)
        if scene is None:
            return None
        for one in draw(scene, self.scales):
            if one.board == drawing.board:
                for found in quantities(one):
                    if found.name == quantity.name:
                        return self.of(found, one)
        return None

    def _find(self, quantity: Quantity, told: Reference, board: str) -> Reals | None:
        row = at_count(self.scene, told.count or quantity.row or self.scene.row.count)
        scene = told.scene(row) if row is not None else None
        if scene is None:
            return None
        try:
            drawn = on_board(scene, board, self.scales, told.places)
        except TmmError:
            return None
        name = told.name or quantity.name
        found = next((one for one in quantities(drawn) if one.name == name), None)
        if found is None:
            return None
        reading = execute(drawn.construction, drawn.given, found.marks)
        return found.read(reading, 1) * told.by
