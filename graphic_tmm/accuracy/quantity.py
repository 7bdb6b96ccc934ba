"""A quantity whose error can be told: the marks that give it, and what tells how large it should be."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals

if TYPE_CHECKING:
    from graphic_tmm.scene.records import Scene


class Value(NamedTuple):
    """A mark, and what it is multiplied by to be the quantity: a scale factor's mark, or a number."""

    mark: Mark
    by: Mark | float = 1.0

    @property
    def marks(self) -> tuple[Mark, ...]:
        """The marks to be read."""
        return (self.mark, self.by) if isinstance(self.by, Mark) else (self.mark,)


@dataclass(frozen=True)
class Reference:
    """Another drawing, by an exact hand, that tells a quantity as it should be.

    ``scene``: what is drawn instead of a scene, None if nothing can be; ``places``: what is recorded of it
    (places of sheets), None for all that it calls for. ``count``: the positions of its row, 0 for as many as
    the quantity has. ``name``: what the quantity is called there if otherwise, ``by``: what it is multiplied
    by to be the same.
    """

    scene: Callable[[Scene], Scene | None]
    count: int = 0
    places: frozenset[str] | None = None
    name: str = ""
    by: float = 1.0


class Quantity(NamedTuple):
    """What is drawn, and what is due.

    ``values``: read position by position, ``row`` of them from the first; a single number if it is 0.
    ``due``: what the values should be, drawn on the same log by an exact hand; empty where another drawing
    has to tell: the ``reference``. ``places``: those of sheets of which one has to call for it, none if it is
    always asked for.
    """

    name: str
    unit: str
    values: tuple[Value, ...]
    row: int = 0
    due: tuple[Value, ...] = ()
    reference: Reference | None = None
    places: tuple[str, ...] = ()

    @property
    def marks(self) -> tuple[Mark, ...]:
        """The marks to be read of a drawing."""
        return tuple(mark for value in self.values for mark in value.marks)

    @property
    def due_marks(self) -> tuple[Mark, ...]:
        """The marks that tell what is due."""
        return tuple(mark for value in self.due for mark in value.marks)

    def read(self, reading: Reading, trials: int, *, due: bool = False) -> Reals:
        """Return the quantity, (trial, value); ``due``: what it should be."""
        found = []
        for mark, by in self.due if due else self.values:
            value = reading[mark] * (reading[by] if isinstance(by, Mark) else by)
            wide = self.row or 1
            value = value[:, :wide] if value.shape[1] > 1 else value
            found.append(np.broadcast_to(value, (trials, wide)))
        return np.concatenate(found, axis=1)
