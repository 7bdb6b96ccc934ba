"""What the drawings of a hand have of the figures that were read: they are drawn once, block by block.

Nothing else of a drawing is kept, so that many of them need little memory.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Mapping
from typing import Any, NamedTuple, TypeVar

import numpy as np

from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.cells import Key, figures, spots
from graphic_tmm.checking.judging.own_errors import exact
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.studio import blocks

T = TypeVar("T")


class Sample(NamedTuple):
    """What drawings have: figures (by key, and whether in mm) and points, (trial,), of those that have them.

    ``marks``: the numbers of marks, (trial, position).
    """

    figures: Mapping[tuple[Key, bool], Reals]
    spots: Mapping[Key, Complexes]
    marks: Mapping[Mark, Any]


def sample(
    made: DrawnScene,
    hand: Hand,
    wanted: Mapping[Key, Collection[bool]],
    marks: Collection[Mark] = (),
) -> Sample:
    """Return what the drawings of a hand, so many as its trials, have of what was read.

    Parameters
    ----------
    made
        The scene as the exact hand draws it.
    wanted
        By figure, whether it was read in mm (or as a point), as a quantity, or both.
    marks
        Marks of the mechanism.
    """
    rows: defaultdict[tuple[Key, bool], list[Any]] = defaultdict(list)
    stand: defaultdict[Key, list[Any]] = defaultdict(list)
    drawn: defaultdict[Mark, list[Any]] = defaultdict(list)
    for block in blocks(made, hand):
        where, told = spots(block), {mm: figures(block, in_mm=mm) for mm in (True, False)}
        for key, kinds in wanted.items():
            if key in where:
                stand[key].append(_known(where[key], block.trials))
            for in_mm in kinds:
                if key in told[in_mm]:
                    rows[key, in_mm].append(_known(told[in_mm][key], block.trials))
        for mark in marks:
            assert block.mechanism is not None
            row = exact(block.mechanism, mark)
            drawn[mark].append(np.broadcast_to(row, (block.trials, row.shape[1])))
    return Sample(_whole(rows), _whole(stand), _whole(drawn))


def joined(one: Sample, other: Sample) -> Sample:
    """Return what two samples of the same drawings have."""
    return Sample(
        {**one.figures, **other.figures},
        {**one.spots, **other.spots},
        {**one.marks, **other.marks},
    )


def _whole(blocks: Mapping[T, list[Any]]) -> dict[T, Any]:
    return {name: np.concatenate(rows) for name, rows in blocks.items()}


def _known(row: Any, trials: int) -> Any:
    """Return what is known of a figure in so many trials; of a single number, that all of them are alike."""
    whole = np.broadcast_to(row, trials)
    return whole[np.isfinite(whole)]
