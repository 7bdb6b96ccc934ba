"""The frame among all quadrilaterals of a sheet: tried together on what is ruled."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image, ImageDraw

from graphic_tmm.checking.photo.long_lines import Small, long_lines, smaller
from graphic_tmm.checking.photo.perspective import homography, through, vertices
from graphic_tmm.checking.photo.quadrilaterals import Ruled, guesses
from graphic_tmm.paper.ruled import Box

pytest.importorskip("cv2")
FRAME, PAPER = Box(20.0, 5.0, 292.0, 205.0), Box(0.0, 0.0, 297.0, 210.0)
BLOCK = np.array(
    [[150 + 5j, 150 + 45j], [150 + 45j, 292 + 45j], [150 + 20j, 292 + 20j], [220 + 5j, 220 + 45j]]
)
TABLE = [[60 + 80j, 200 + 80j], [60 + 150j, 200 + 150j], [60 + 80j, 60 + 150j]]


def test_many_projections_at_once_are_the_single_ones() -> None:
    random = np.random.default_rng(3)
    corners = np.array([300 + 900j, 1300 + 950j, 1250 + 200j, 350 + 150j])
    several = corners + random.normal(0, 30, (6, 4)) + 1j * random.normal(0, 30, (6, 4))
    together = homography(FRAME, several.T)
    for one, whole in zip(several, together, strict=True):
        assert np.allclose(homography(FRAME, one), whole, rtol=0, atol=1e-12)
        assert abs(through(whole, vertices(FRAME)) - one).max() < 1e-9


@pytest.mark.parametrize("turn", [0, 1, 2, 3])
def test_the_frame_is_the_best_guess_whichever_way_up(turn: int) -> None:
    upright = np.array([180 + 1050j, 1450 + 1000j, 1380 + 130j, 260 + 90j])
    size = (1600, 1200)
    if turn % 2:  # a frame that stands
        upright, size = np.array([150 + 1400j, 1060 + 1450j, 1020 + 180j, 200 + 150j]), (1200, 1600)
        upright = np.roll(upright, 1)
    corners = np.roll(upright, 2 * (turn // 2))
    small = photographed(size, corners)
    found = guesses(small, long_lines(small, 5.0), Ruled(FRAME, PAPER, BLOCK), 5.0)
    assert abs(found[0].corners - corners).max() < 4
    assert found[0].score > 0.9


def photographed(size: tuple[int, int], corners: np.ndarray) -> Small:
    """Return a photograph, made small, of what is ruled on a sheet whose frame's corners are seen there."""
    matrix = homography(FRAME, corners)
    made = Image.new("RGB", size, (240, 240, 240))
    draw = ImageDraw.Draw(made)
    feet = vertices(FRAME)
    frame = np.stack([feet, np.roll(feet, -1)], axis=1)
    for line in (*frame, *BLOCK, *np.array(TABLE)):
        draw.line([(z.real, z.imag) for z in through(matrix, line)], fill=(70, 70, 70), width=4)
    return smaller(np.asarray(made))


def test_no_lines_make_no_guess() -> None:
    small = smaller(np.full((600, 800, 3), 230, np.uint8))
    assert guesses(small, long_lines(small, 3.0), Ruled(FRAME, PAPER, BLOCK), 3.0) == []


@pytest.mark.parametrize("paler", range(4))
def test_the_frame_is_the_best_guess_whichever_side_is_seen_the_worst(paler: int) -> None:
    """Sides are combined in the order in which they are seen: the frame goes round either way then."""
    corners = np.array([180 + 1050j, 1450 + 1000j, 1380 + 130j, 260 + 90j])
    small = photographed((1600, 1200), corners)
    lines = long_lines(small, 5.0)
    start, end = corners[paler], corners[(paler + 1) % 4]
    off = [abs(((z - start) / (end - start)).imag) for z in (lines.feet, lines.heads)]
    side = np.maximum(*off) * abs(end - start) < 5.0
    assert side.any()
    seen = np.where(side, 1.0, lines.seen)
    found = guesses(small, lines._replace(seen=seen), Ruled(FRAME, PAPER, BLOCK), 5.0)
    assert abs(found[0].corners - corners).max() < 4
