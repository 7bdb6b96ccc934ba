"""What mutations make of a scene's figures: its tables and points read off rows instead of trials."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.execute import Reading, cut
from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.cells import Key, figures, spots
from graphic_tmm.checking.mutations.execution import Beside, taken
from graphic_tmm.drawn import Drawn, DrawnScene, Numbers


class _Rows(Mapping[int, Any]):
    """The values of some rows, put together when they are asked for; a position that is not drawn is NaN."""

    def __init__(
        self, beside: Beside, base: Mapping[int, Any], rows: NDArray[np.intp], places: Sequence[int]
    ) -> None:
        self.beside, self.base, self.rows, self.places = beside, base, rows, places

    def __getitem__(self, slot: int) -> Any:
        if slot not in self.beside.base:
            return self.base[slot]
        found = taken(self.beside.base[slot], self.beside.rows.get(slot), self.rows)
        return cut(found, self.places) if self.places else found

    def __iter__(self) -> Iterator[int]:
        return iter(self.base)

    def __len__(self) -> int:
        return len(self.base)


def as_drawn(made: DrawnScene, board: Drawn, beside: Beside, rows: NDArray[np.intp]) -> DrawnScene:
    """Return a scene as some rows of a board draw it: one trial a row."""
    numbers = board.numbers
    whole = _Rows(beside, numbers.whole.values, rows, ())
    own = {
        view: Reading(_Rows(beside, one.values, rows, board.row(view)), one.positions)
        for view, one in numbers.own.items()
    }
    drawn = Reading(_Rows(beside, numbers.drawn.values, rows, ()), numbers.drawn.positions)
    other = Numbers(Reading(whole, numbers.whole.positions), own, drawn)
    boards = (replace(one, numbers=other) if one is board else one for one in made.boards)
    return DrawnScene(made.scene, tuple(boards))


def figures_of(
    made: DrawnScene,
    board: Drawn,
    beside: Beside,
    rows: NDArray[np.intp],
    wanted: Sequence[tuple[Key, bool]],
) -> dict[tuple[Key, bool], Reals | Complexes]:
    """Return figures of some rows, by key and whether in mm; (row,), of a point where it stands."""
    scene = as_drawn(made, board, beside, rows)
    found: dict[tuple[Key, bool], Any] = {}
    with np.errstate(all="ignore"):
        told = {mm: figures(scene, in_mm=mm) for mm in {mm for _, mm in wanted}}
        where = spots(scene) if board.board == made.boards[0].board else {}
    for key, mm in wanted:
        row = told[mm].get(key, where.get(key))
        if row is not None:
            found[key, mm] = np.broadcast_to(row, rows.shape)
    return found
