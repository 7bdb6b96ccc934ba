"""Which pistons share an indicator diagram: those that go through the same positions with the same pressures.

A piston that has the pressures of another stands, in each position, where that one stood some positions before:
so it is with cylinders on one crank whose axes or crank pins are turned by whole intervals. Then the curves
through the pressures of the first are those of the second, too. Any other piston has a diagram of its own.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.chapters.indicator.diagram import Piston
from graphic_tmm.chapters.indicator.stretches import SLACK


def by_diagram(draft: Draft, pistons: Sequence[Piston]) -> list[list[tuple[Piston, int]]]:
    """Return pistons of the same pressures diagram by diagram, with how many positions each is behind."""
    if len(pistons) == 1:
        return [[(pistons[0], 0)]]
    marks = [one.travel for one in pistons]
    given = {**draft.given, draft.mu_l: 1.0}
    reading = execute(draft.board.construction(), given, marks)
    groups: list[list[tuple[Piston, int]]] = []
    for piston in pistons:
        for group in groups:
            behind = _behind(group[0][0], piston, reading)
            if behind is not None:
                group.append((piston, behind))
                break
        else:
            groups.append([(piston, 0)])
    return groups


def _behind(first: Piston, piston: Piston, reading: Reading) -> int | None:
    """Return by how many positions a piston follows; None if it stands elsewhere, or has sizes of its own."""
    sizes = [(one.order.base, one.order.height, one.order.mu) for one in (first, piston)]
    if sizes[0] != sizes[1]:
        return None
    count = piston.row.size
    states = [np.array([one.row.turns, one.row.out])[:, :count] for one in (first, piston)]
    ways = [reading[one.travel][0, :count] for one in (first, piston)]
    for behind in range(count):
        near = np.abs(np.roll(ways[0], behind) - ways[1]) <= SLACK * np.max(ways[0])
        if near.all() and (np.roll(states[0], behind, axis=1) == states[1]).all():
            return behind
    return None
