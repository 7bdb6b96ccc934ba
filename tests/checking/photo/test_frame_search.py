"""The frame found by itself in photographs of a student's sheet; told where it is not there or not sure."""

from __future__ import annotations

import functools
import io
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from support.command import invoke
from support.photographed.student import exact
from support.photographed.taking import SHEETS, Conditions, Taken, conditions, taken, turned

from graphic_tmm.checking.photo.flatten import flatten
from graphic_tmm.checking.photo.frame_search import frame_found, tried
from graphic_tmm.checking.photo.quadrilaterals import Ruled, ruled
from graphic_tmm.errors import SheetError

cv2 = pytest.importorskip("cv2")

EASY = Conditions(wide=1200)


@functools.cache
def ruling(name: str, number: int) -> Ruled:
    return ruled(exact(name)[1][number - 1], number == 1)


def pixels(shown: Taken) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(shown.jpeg)))


def mm_off(shown: Taken, corners: np.ndarray) -> float:
    """How far corners are from where they are, mm where the sheet is seen largest."""
    left, _, right, _ = shown.paper.frame
    dots = abs(np.diff(shown.corners)).max() / max(right - left, 1)
    return float(abs(corners - shown.corners).max() / dots)


@pytest.mark.turns(2, "photographs")
@pytest.mark.slow
@pytest.mark.parametrize("quarters", [0, 3])
def test_a_frame_is_found_whichever_way_up_it_stands(quarters: int) -> None:
    shown = taken(4, EASY)
    whole = pixels(shown)
    found = frame_found(np.ascontiguousarray(np.rot90(whole, quarters)), ruling(*SHEETS[4]))
    back = turned(found.lines.corners, -quarters, *np.rot90(whole, quarters).shape[1::-1])
    assert mm_off(shown, back) < 0.2
    assert found.seen - found.second > 0.3


@pytest.mark.turns(2, "photographs")
@pytest.mark.slow
def test_a_hard_photograph_comes_back_in_true_millimetres(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    """With ``--measured`` of as many dots as a telephone takes."""
    shown = taken(31, conditions(31)._replace(wide=many(4000, 2000)))
    file = tmp_path / "photo.jpg"
    file.write_bytes(shown.jpeg)
    lines = ruling(shown.name, shown.number)
    flat = flatten(file, lines, lines.frame, dots_per_mm=1.0)
    assert mm_off(shown, flat.corners) < 0.6
    assert flat.image.shape[1] == round(lines.paper.right)


@pytest.mark.slow
def test_a_photograph_without_a_frame_is_told() -> None:
    random = np.random.default_rng(1)
    grain = random.normal(128, 20, (900, 1200, 3)).clip(0, 255).astype(np.uint8)
    for image in (grain, np.full((900, 1200, 3), 255, np.uint8), np.zeros((20, 9, 3), np.uint8)):
        with pytest.raises(SheetError, match="no frame of this sheet"):
            frame_found(image, ruling(*SHEETS[4]))


@pytest.mark.turns(2, "photographs")
@pytest.mark.slow
def test_the_frame_of_another_format_is_not_taken_for_this_one() -> None:
    shown = taken(4, EASY)
    with pytest.raises(SheetError, match="--corners"):
        frame_found(pixels(shown), ruling("slider-diagrams", 1))  # the same paper by ГОСТ


@pytest.mark.turns(2, "photographs")
@pytest.mark.slow
def test_a_frame_that_is_cut_off_is_told() -> None:
    shown = taken(4, EASY)
    whole = pixels(shown)
    inside = int(shown.corners.real.min()) + 45
    with pytest.raises(SheetError, match="--corners"):
        frame_found(np.ascontiguousarray(whole[:, inside:]), ruling(*SHEETS[4]))


@pytest.mark.turns(2, "photographs")
@pytest.mark.slow
def test_a_frame_without_anything_ruled_does_not_tell_which_way_up_it_is() -> None:
    """A bare rectangle: where its corners are is seen, but not which of them is which."""
    lines = ruling(*SHEETS[4])
    image = np.full((600, 450, 3), 240, np.uint8)
    left, bottom, right, top = (round(2 * side) for side in lines.frame)
    cv2.rectangle(image, (left, 594 - top), (right, 594 - bottom), (60, 60, 60), 2)
    with pytest.raises(SheetError, match="--corners"):
        frame_found(image, lines)
    best = tried(image, lines)
    assert best is not None
    assert best.seen < 0.3


@pytest.mark.turns(2, "photographs")
@pytest.mark.slow
def test_a_photograph_is_laid_under_its_sheet_without_corners(tmp_path: Path) -> None:
    shown = taken(4, EASY._replace(quarters=2))
    photo, out = tmp_path / "photo.jpg", tmp_path / "under.svg"
    photo.write_bytes(shown.jpeg)
    scene = Path("sheets") / shown.name
    done = invoke("check", str(scene), "--photo", str(photo), "--sheet", "2", "--overlay", str(out))
    assert done.exit_code in (0, 1), done.output
    assert "warning" not in done.stderr
    with Image.open(tmp_path / "under-flat.png") as picture:
        flat = np.asarray(picture.convert("L"))
    dots = flat.shape[1] / shown.paper.size[0]
    drawn = [one.sheet for one in shown.points.values() if one.drawn and abs(one.spot) > 5]
    places = [(round(dots * (297 - z.imag)), round(dots * z.real)) for z in drawn]
    dark = [flat[r - 3 : r + 4, c - 3 : c + 4].min() for r, c in places]
    assert len(dark) > 20
    assert np.mean(np.array(dark) < 0.85 * np.median(flat)) > 0.9
