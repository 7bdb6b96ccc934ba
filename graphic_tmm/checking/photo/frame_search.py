"""The frame of a sheet found in a photograph, either way up; what is not sure is said, not guessed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.camera import Curl, Lens, Shot, pinhole
from graphic_tmm.checking.photo.frame_lines import Lines, refine
from graphic_tmm.checking.photo.long_lines import ALIKE, COLOURED, long_lines, smaller
from graphic_tmm.checking.photo.perspective import bilinear, homography, through, vertices
from graphic_tmm.checking.photo.quadrilaterals import Guess, Ruled, guesses
from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import said
from graphic_tmm.paper.ruled import Box

REACH = 1.5
"""mm: a side of a frame is as straight in the picture without its lens: a sheet that sags by 2 mm bends it by
so much, the lens's steps by half of it."""

FILLS = 0.7
"""Of the photograph's longer side an ordinary photograph shows so much of the sheet's: only to tell what a
millimetre is in dots before anything is found."""

TRIED = 4
"""So many different guesses are refined and compared."""

DIFFERENT = 2.0
"""mm: guesses whose corners are nearer are the same: refining brings them together."""

PIECE = 8.0
"""mm of a ruled line that are seen or not: long enough to average grain, short enough to leave out what a hand
or a stain covers."""

ASIDE = np.array([-1.9, -1.6, -1.3, -0.4, -0.2, 0.0, 0.2, 0.4, 1.3, 1.6, 1.9])
"""Across a ruled line, mm: the paper beside it, the line and what it is off; the next line is at 5 mm, in some
title blocks at 4."""

ALONG = np.linspace(0.0, 1.0, 17)
"""Where along a piece its dots are read."""

PALE = 0.04
"""A piece is seen if it is darker than the paper on both sides by this share; grain averaged over a piece comes
to 0.01."""

ENOUGH = 0.65
"""Of whose ruling so much is seen, that is the frame: no others are tried, but its other ways up."""

SURE, CLEARER = 0.5, 0.2
"""So much of what is ruled is seen of the frame that is taken, and so much more than of any other."""


class FoundFrame(NamedTuple):
    """The frame: its lines, in the order of `vertices`, and how much of what is ruled is seen, 0 … 1.

    ``second``: the same of the best of the others.
    """

    lines: Lines
    seen: float
    second: float


def frame_found(image: NDArray[np.uint8], ruled: Ruled) -> FoundFrame:
    """Return the frame of a sheet in ``image`` (rows, columns, 3).

    Raises
    ------
    SheetError
        If OpenCV is missing, no frame is seen, or it is not sure which it is or which way up it stands.
    """
    best = tried(image, ruled)
    if best is None or best.seen < SURE:
        raise SheetError(
            said(
                "no frame of this sheet is seen in the photograph: photograph the whole frame with its "
                "title block, or give its corners with --corners"
            )
        )
    if best.seen - best.second < CLEARER:
        raise SheetError(
            said(
                "it is not sure where the frame is in the photograph, or which way up it stands: give its "
                "corners with --corners"
            )
        )
    return best


def tried(image: NDArray[np.uint8], ruled: Ruled) -> FoundFrame | None:
    """Return the frame of which most is seen, and how much of any other; None if nothing is like a frame."""
    small = smaller(image)
    reach = REACH * FILLS * max(small.dark.shape) / max(ruled.paper.right, ruled.paper.top)
    lines = long_lines(small, reach)
    half = complex(0.5, 0.5)
    lens = pinhole(image)._replace(share=lines.lens.share)
    several: list[tuple[float, Lines]] = []
    for guess in _different(guesses(small, lines, ruled, reach), reach * DIFFERENT / REACH):
        corners = (guess.corners + half) * small.factor - half
        several.append(_refined(image, ruled, corners, lens))
        if several[-1][0] > ENOUGH:
            break
    if not several:
        return None
    seen, best = max(several, key=lambda one: one[0])
    near = DIFFERENT / REACH * reach * small.factor
    others = [one for one, other in several if abs(other.corners - best.corners).max() > near]
    return FoundFrame(best, seen, max([*others, *_other_ways_up(image, ruled, best)]))


def _other_ways_up(image: NDArray[np.uint8], ruled: Ruled, lines: Lines) -> Iterator[float]:
    """Yield how much is seen of a frame turned by quarters."""
    for turn in (1, 2, 3):
        turned = lines._replace(corners=np.roll(lines.corners, turn), curl=Curl(ruled.frame))
        yield _least_seen(shares_seen(image, ruled, turned))


def _refined(
    image: NDArray[np.uint8], ruled: Ruled, corners: Complexes, lens: Lens
) -> tuple[float, Lines]:
    """Return a guess refined, and how much of what is ruled is seen of it.

    A side that is no line may be the edge of the paper: then the frame is where it is on this paper.
    """
    lines = refine(image, ruled.frame, corners, lens)
    seen = shares_seen(image, ruled, lines)
    if seen[1].min() > SURE:
        return _least_seen(seen), lines
    lower, right, upper, left = seen[1] < SURE
    frame, paper = ruled.frame, ruled.paper
    box = Box(
        paper.left if left else frame.left,
        paper.bottom if lower else frame.bottom,
        paper.right if right else frame.right,
        paper.top if upper else frame.top,
    )
    matrix = homography(box, lines.lens.straight(lines.corners))
    moved = lines.lens.seen(through(matrix, vertices(frame)))
    if not np.isfinite(moved).all():
        return _least_seen(seen), lines
    lines = refine(image, ruled.frame, moved, lens)
    return _least_seen(shares_seen(image, ruled, lines)), lines


def _least_seen(shares: tuple[float, Reals]) -> float:
    return min(shares[0], float(shares[1].min()))


def _different(several: list[Guess], apart: float) -> Iterator[Guess]:
    """Yield the best guesses of which no two are the same."""
    taken: list[Guess] = []
    for guess in several:
        if all(abs(guess.corners - one.corners).max() > apart for one in taken):
            taken.append(guess)
            yield guess
        if len(taken) == TRIED:
            return


def shares_seen(image: NDArray[np.uint8], ruled: Ruled, lines: Lines) -> tuple[float, Reals]:
    """Return how much of what is ruled is seen where the frame says, 0 … 1: without its sides, and of each."""
    matrix = homography(ruled.frame, lines.lens.straight(lines.corners))
    shot = Shot(image, matrix, lines.lens, lines.curl)
    feet = vertices(ruled.frame)
    sides = np.stack([feet, np.roll(feet, -1)], axis=1)
    return _share(shot, ruled.lines), np.array([_share(shot, side[None], ALIKE) for side in sides])


def _share(shot: Shot, lines: Complexes, alike: float = 0.0) -> float:
    """Return how much of lines (n, 2), mm, is seen: darker than what is beside them.

    ``alike``: the least quotient of both sides; letters in a title block stand on one side of its lines.
    """
    feet, ways = _pieces(lines)
    places = feet[:, None] + ways[:, None] * ALONG
    across = 1j * ways / abs(ways)
    seen = shot.to_picture(places[:, None, :] + across[:, None, None] * ASIDE[:, None])
    seen = np.where(np.isfinite(seen), seen, complex(-9, -9))
    level: Reals = bilinear(shot.image, seen).mean(axis=2)  # (pieces, across, colours)
    one, two = level[:, :3].mean(axis=1), level[:, -3:].mean(axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        paper = (np.minimum(one, two) > alike * np.maximum(one, two)).all(axis=1)
        shares = level[:, 3:-3] / np.minimum(one, two)[:, None]
        least, most = shares.min(axis=-1), shares.max(axis=-1)
        dark = (1 - most - COLOURED * (most - least)).max(axis=1)
        return float(((dark > PALE) & paper).mean())


def _pieces(lines: Complexes) -> tuple[Complexes, Complexes]:
    """Return the feet of the pieces of lines (n, 2), and their ways, mm."""
    feet, ways = [], []
    for foot, head in lines:
        count = max(round(abs(head - foot) / PIECE), 1)
        feet.append(foot + (head - foot) * np.arange(count) / count)
        ways.append(np.full(count, (head - foot) / count))
    return np.concatenate(feet), np.concatenate(ways)
