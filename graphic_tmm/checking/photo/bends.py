"""What bends the frame's lines: the lens all four alike, a curl of the sheet two of them; found together."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.curl import Curl, foot_of
from graphic_tmm.checking.photo.lens import MOST, Lens, bow_of, left_of_line, straightening
from graphic_tmm.checking.photo.perspective import through
from graphic_tmm.checking.photo.shot import Shot

STIFF = 1e-4
"""What a millimetre of curl costs, as a share of what it costs that all places seen are a millimetre off:
keeps small what the frame does not tell, and takes less than 1 % of the rest."""

CLEARER = 0.97
"""A curl is believed if it leaves less than this share of the squares that the lens alone leaves. In
1.5 megapixels flat sheets, in ink or pencil, leave 0.995 and more, those that curl by 0.6 mm 0.92, by 2 mm
0.4 to 0.6."""


Line = tuple[Complexes, Reals]
"""Places seen along a line, px, and their weights."""


class Bends(NamedTuple):
    """A lens and a curl, and the squares that they leave of the lines' distance from straight, px²."""

    lens: Lens
    curl: Curl
    left: float


def unbending(shot: Shot, lines: list[Line]) -> tuple[Lens, Curl]:
    """Return the lens and the curl that make the frame's lines straight, seen near where ``shot`` has them.

    The curl only where all four lines were found: of fewer it could not be told from the lens. A flat sheet
    has none.
    """
    lens = straightening(shot.lens, lines)
    flat = Curl(shot.curl.box)
    if len(lines) < 4:
        return lens, flat
    alone = Bends(lens, flat, CLEARER * _left(lens, lines))
    best = min(
        alone, _curled(shot, lines, True), _curled(shot, lines, False), key=lambda one: one.left
    )
    return best.lens, best.curl


def _left(lens: Lens, lines: list[Line]) -> float:
    """Return the squares that a lens leaves."""
    bows = [bow_of(lens, *line) for line in lines]
    return sum(float((weights * (off + lens.share * by) ** 2).sum()) for weights, off, by in bows)


def _curled(shot: Shot, lines: list[Line], upright: bool) -> Bends:
    """Return lens and curl by least squares, the curl about one of the sheet's two directions."""
    tried = Curl(shot.curl.box, foot_of(shot.matrix, shot.lens), upright)
    normal, due, whole, dots = np.zeros((3, 3)), np.zeros(3), 0.0, 0.0
    for seen, given in lines:
        weights, off, by = bow_of(shot.lens, seen, given)
        columns = np.stack([by, *_shifts(shot, tried, seen, weights)])
        normal += columns * weights @ columns.T
        due -= columns * weights @ off
        whole += float((weights * off**2).sum())
        first, last = shot.sheet(seen[[0, -1]])
        dots += float(weights.sum()) * (abs(seen[-1] - seen[0]) / abs(last - first)) ** 2
    normal[1:, 1:] += STIFF * dots * np.eye(2)
    share, middle, more = np.linalg.solve(normal, due).tolist()
    lens = shot.lens._replace(share=float(np.clip(share, -MOST, MOST)))
    curl = tried._replace(parts=(middle, more))
    return Bends(lens, curl, whole - float(due @ [share, middle, more]))


def _shifts(shot: Shot, curl: Curl, seen: Complexes, weights: Reals) -> Reals:
    """Return what a millimetre of each part of a curl, taken out, moves a line across, px, beside straight."""
    way = (seen[-1] - seen[0]) / abs(seen[-1] - seen[0])
    along = ((seen - seen[0]) / way).real
    flat = shot.sheet(seen)
    here = through(shot.matrix, flat)
    moved = (through(shot.matrix, flat + curl.shapes(flat)) - here) / way
    return np.stack([-left_of_line(along, one.imag, weights) for one in moved])
