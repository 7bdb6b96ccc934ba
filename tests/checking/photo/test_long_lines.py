"""Long lines of pictures drawn here: where they are, what is no line, the lens that bows them."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image, ImageDraw
from support.photographs import Camera

from graphic_tmm.checking.photo.long_lines import long_lines, smaller

pytest.importorskip("cv2")
SIZE = 1600, 1200


def picture(lines: list[list[complex]], colour: tuple[int, int, int] = (90, 90, 90)) -> np.ndarray:
    made = Image.new("RGB", SIZE, (240, 238, 230))
    draw = ImageDraw.Draw(made)
    for line in lines:
        draw.line([(z.real, z.imag) for z in line], fill=colour, width=3)
    return np.asarray(made)


def test_lines_are_found_where_they_are() -> None:
    drawn = [(100 + 80j, 1500 + 160j), (1480 + 150j, 1400 + 1100j), (200 + 900j, 1300 + 700j)]
    found = long_lines(smaller(picture([list(line) for line in drawn])), 3.0)
    assert len(found.feet) == 3
    for a, b in drawn:
        way = (b - a) / abs(b - a)
        off = abs(((np.stack([found.feet, found.heads]) - a) / way).imag).max(axis=0)
        k = int(np.argmin(off))
        assert off[k] < 2.5  # a line of 3 dots has its edges 1.5 aside
        assert found.seen[k] > 0.9 * abs(b - a)
    assert abs(found.lens.share) < 0.011  # three lines tell little of a lens


def test_blue_squares_are_not_dark() -> None:
    lines = [[complex(x, 0), complex(x, 1199)] for x in range(30, 1600, 40)]
    blue = picture(lines, (150, 180, 225))
    assert smaller(blue).dark.max() < 8
    grey = picture(lines, (180, 180, 180))
    assert smaller(grey).dark.max() > 40


@pytest.mark.parametrize("share", [-0.01, 0.0, 0.02])
def test_the_lens_is_told_by_what_it_bows(share: float) -> None:
    camera = Camera(columns=SIZE[0], rows=SIZE[1], lens=share)
    share_of = np.linspace(0, 1, 80)
    straight = [(complex(x, 100), complex(x + 60, 1100)) for x in (120, 500, 900, 1300, 1440)] + [
        (complex(150, y), complex(1450, y - 40)) for y in (120, 600, 1090)
    ]
    bowed = []
    for a, b in straight:
        ideal = a + (b - a) * share_of
        seen = ideal
        for _ in range(60):
            seen = seen - (camera.ideal(seen) - ideal)
        bowed.append(list(seen))
    found = long_lines(smaller(picture(bowed)), 4.0)
    assert found.lens.share == pytest.approx(share, abs=0.0051)
    assert len(found.feet) >= len(straight)


@pytest.mark.parametrize("shape", [(1, 1), (1, 5000), (3000, 2), (2000, 3), (4001, 1)])
def test_a_photograph_narrower_than_its_reduction_shows_no_lines(shape: tuple[int, int]) -> None:
    grain = np.random.default_rng(5).integers(0, 256, (*shape, 3), dtype=np.uint8)
    small = smaller(grain)
    assert min(small.dark.shape) >= 1
    assert not long_lines(small, 3.0).seen.size


@pytest.mark.parametrize("seed", range(3))
def test_a_lens_that_shows_no_ray_of_a_line_is_no_fault(seed: int) -> None:
    """Half the width of a narrow photograph is a small part of its height: a lens folds its ends over."""
    grain = np.random.default_rng(seed).integers(0, 256, (2000, 40, 3), dtype=np.uint8)
    grain[:, 12:14] //= 4
    long_lines(smaller(grain), 3.0)
