"""Few positions in which each of some marks has a value."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Curve, undefined

MOST = 0.8
"""Positions with so large a share of the values that the best one has are as good. Chosen by eye."""


def covering(reading: Reading, marks: Sequence[Mark], first: Sequence[int]) -> list[int]:
    """Return positions (indices) so that each mark has a value in one of them: ``first``, then few more.

    A position is taken in the middle of the longest stretch on which the same has a value, and most of it.
    """
    rows = [undefined(reading[mark])[0] for mark in marks if mark.kind is not Curve]
    there = np.array([~row for row in rows if row.size == reading.positions])
    places, left = list(first), np.ones(len(there), dtype=bool)
    while True:
        for place in places:
            left &= ~there[:, place] if there.size else left
        counts = there[left].sum(axis=0) if there.size else np.zeros(1)
        if not counts.any():
            return places or [0]
        changes = np.flatnonzero((there[left][:, 1:] != there[left][:, :-1]).any(axis=0)) + 1
        stretches = np.split(np.arange(counts.size), changes)
        whole = [s for s in stretches if counts[s[0]] >= MOST * counts.max()]
        longest = max(whole, key=len)
        places.append(int(longest[longest.size // 2]))
