"""The hand that works at the board: so far its ruler; pencil and compass are without error."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Reals


class Hand(NamedTuple):
    """How finely the ruler is read: ``ruler`` in mm, None for readings without rounding."""

    ruler: float | None = None

    def read(self, length: Reals) -> Reals:
        """Return a length as read off the ruler; ties go up and do not depend on the last bit."""
        if self.ruler is None:
            return length
        divisions = np.floor(np.abs(length) / self.ruler + (0.5 + 1e-9))
        return np.asarray(np.copysign(divisions * self.ruler, length) + 0.0)


EXACT = Hand()
