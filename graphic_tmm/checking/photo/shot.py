"""How a photograph shows a sheet: the curl, a pinhole's projection, then the lens."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.curl import Curl
from graphic_tmm.checking.photo.lens import Lens
from graphic_tmm.checking.photo.perspective import through


class Shot(NamedTuple):
    """A photograph, and how it shows the sheet: its curl, the projection into a pinhole's, then the lens."""

    image: NDArray[np.uint8]
    matrix: Reals
    lens: Lens
    curl: Curl

    def shown(self, points: Any) -> Complexes:
        """Return where points of the sheet, mm, are seen, px."""
        return self.lens.seen(through(self.matrix, self.curl.seen(points)))

    def sheet(self, seen: Any) -> Complexes:
        """Return which points of the sheet, mm, are seen at places, px."""
        back: Reals = np.linalg.inv(self.matrix).astype(np.float64)
        return self.curl.flat(through(back, self.lens.straight(seen)))


def bowed(shot: Shot, feet: Complexes) -> float:
    """Return how far the lens alone bows the frame's edges from their chords' means, mm."""
    shot = shot._replace(curl=Curl(shot.curl.box))
    back: Reals = np.linalg.inv(shot.matrix).astype(np.float64)
    worst = 0.0
    for foot, head in zip(feet, np.roll(feet, -1), strict=True):
        share = np.linspace(0.0, 1.0, 33, dtype=np.float64)
        edge = through(back, shot.shown(foot + (head - foot) * share))
        aside = ((edge - foot) / (head - foot) * abs(head - foot)).imag
        line = np.polyval(np.polyfit(share, aside, 1), share)
        worst = max(worst, float(abs(aside - line).max()))
    return worst
