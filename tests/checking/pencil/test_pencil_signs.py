"""A head in the middle of a longer line tells where its point is: by its inside, and the paper behind it."""

from __future__ import annotations

import numpy as np
import pytest
from support.photographed.rubbed import DOTS, HEIGHT, flat, paper, rubbed

from graphic_tmm.checking.pencil.expected import _chords
from graphic_tmm.checking.pencil.points import MOVED, Sign
from graphic_tmm.paper.drawing import line

LONG, WIDE = 4.5, 1.1
HEAD = line("main", 0j, -LONG + WIDE * 1j, -LONG - WIDE * 1j, closed=True, filled=True)
AXIS = (-40 + 0j, 30 + 0j)
NOBODY = np.empty((0, 2), dtype=np.complex128)


def headed(at: complex) -> np.ndarray:
    """Return paper with a level line on it, and a filled head that ends at a place."""
    grey = rubbed(paper(), at + AXIS[0], at + AXIS[1])
    x = (np.arange(grey.shape[1]) + 0.5) / DOTS
    y = HEIGHT - (np.arange(grey.shape[0])[:, None] + 0.5) / DOTS
    own = x + 1j * y - at
    inside = (own.real < 0) & (own.real > -LONG) & (abs(own.imag) < -own.real * WIDE / LONG)
    return np.where(inside, grey * 0.4, grey)


@pytest.mark.parametrize("off", [-1.3, 0.0, 0.8])
def test_a_head_upon_a_longer_line_is_found_along_it(off: float) -> None:
    due = 80 + 60j
    pieces = np.array([AXIS, *_chords(HEAD)], dtype=np.complex128)
    telling = Sign.of_pieces(pieces, NOBODY).along(1.0, MOVED)
    assert telling is not None
    along = np.arange(-3.0, 3.01, 0.1)
    like = telling.like(flat(headed(due + off)), due + along.astype(np.complex128))
    assert abs(along[int(np.argmax(like))] - off) < 0.6
    assert like.max() > 0.4


def test_a_line_alone_tells_no_place_along_it() -> None:
    assert Sign.of_pieces(np.array([AXIS], dtype=np.complex128), NOBODY).along(1.0, MOVED) is None


def test_a_filled_head_is_more_than_its_edge() -> None:
    assert len(_chords(HEAD)) == 4 * len(_chords(HEAD._replace(filled=False)))


def test_a_sign_is_told_from_what_is_near_it_only() -> None:
    pieces = np.array([AXIS, *_chords(HEAD)], dtype=np.complex128)
    far = pieces + 30j
    one, other = Sign.of_pieces(pieces, NOBODY), Sign.of_pieces(np.concatenate([pieces, far]), far)
    np.testing.assert_array_equal(one.ink, other.ink)
    np.testing.assert_array_equal(one.paper, other.paper)
