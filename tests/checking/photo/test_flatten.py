"""Synthetic photographs flattened: where the discs of the drawn sheet come back, mm."""

from __future__ import annotations

import functools
import io
import math
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from support import photographs
from support.each import each
from support.photographs import CORNERS, FRAME, TARGETS, Camera

from graphic_tmm.checking.photo.flatten import BENT, flatten, png
from graphic_tmm.checking.photo.perspective import through
from graphic_tmm.errors import SheetError
from graphic_tmm.paper.sheet_frame import drawing_area

CAMERAS = {
    "tilted": Camera((18, -12, 6), 1150, 2311.7),
    "steep": Camera((-25, 8, -10), 1200, 2311.7),
    "lens": Camera((3, -2, 1), 1000, 1987.6, 2000, 1500, lens=0.01),
    "wide": Camera((3, -2, 1), 1000, 1391.3, 1400, 1050, lens=0.03),
    "curled": Camera((18, -12, 6), 1150, 1618.1, 1400, 1050, sag=3.0),
}
EXACT, CLICKED = 0.1, 0.7
"""What a point may be off, mm: corners given exactly; corners clicked ±2 px."""
DOTS = 2.0
"""Of the flat picture to the mm: enough for a disc to be found again."""


@functools.cache
def taken(name: str) -> bytes:
    return photographs.jpeg(photographs.photograph(CAMERAS[name], photographs.sheet()))


@pytest.fixture
def file(tmp_path: Path, request: pytest.FixtureRequest) -> Path:
    path = tmp_path / "photo.jpg"
    path.write_bytes(taken(getattr(request, "param", "tilted")))
    return path


def corners(name: str) -> np.ndarray:
    return photographs.pairs(CAMERAS[name].seen(CORNERS))


@pytest.mark.turns(4, "cameras")
@pytest.mark.slow
@pytest.mark.parametrize("refined", [True, False])
@pytest.mark.parametrize(
    ("file", "name"), [("tilted", "tilted"), ("steep", "steep")], indirect=["file"]
)
def test_exact_corners_bring_every_point_back(file: Path, name: str, refined: bool) -> None:
    photo = flatten(file, corners(name), FRAME, dots_per_mm=DOTS, refined=refined)
    assert photo.image.shape == (594 * DOTS, 841 * DOTS, 3)
    assert abs(photographs.found_discs(photo.image, DOTS) - TARGETS).max() < EXACT
    assert abs(photo.lens.seen(through(photo.homography, CORNERS)) - photo.corners).max() < 1e-9
    assert photo.warnings == ()
    assert photo.residual < EXACT if refined else math.isnan(photo.residual)


@pytest.mark.turns(4, "cameras")
@pytest.mark.slow
@pytest.mark.parametrize(
    ("file", "name"), [("tilted", "tilted"), ("steep", "steep")], indirect=["file"]
)
def test_clicked_corners_bring_every_point_back(file: Path, name: str) -> None:
    random = np.random.default_rng(1)
    clicked = random.permutation(corners(name) + random.uniform(-2, 2, (4, 2)))
    photo = flatten(file, clicked, FRAME, dots_per_mm=DOTS)
    assert abs(photographs.found_discs(photo.image, DOTS) - TARGETS).max() < CLICKED
    assert abs(photo.corners - CAMERAS[name].seen(CORNERS)).max() < 0.1
    assert photo.warnings == ()


@pytest.mark.turns(4, "cameras")
@pytest.mark.slow
@pytest.mark.parametrize("file", ["lens"], indirect=True)
def test_the_lens_is_taken_out_of_the_picture(file: Path) -> None:
    photo = flatten(file, corners("lens"), FRAME, dots_per_mm=DOTS)
    assert abs(photographs.found_discs(photo.image, DOTS) - TARGETS).max() < EXACT
    assert photo.warnings == ()


@pytest.mark.turns(4, "cameras")
@pytest.mark.slow
@pytest.mark.parametrize("file", ["wide"], indirect=True)
def test_a_lens_that_bows_much_is_told(file: Path) -> None:
    photo = flatten(file, corners("wide"), FRAME, dots_per_mm=1.0)
    assert photo.residual < EXACT
    assert len(photo.warnings) == 1
    assert "the lens bows the frame by 3." in photo.warnings[0]


@pytest.mark.turns(4, "cameras")
@pytest.mark.slow
@pytest.mark.parametrize("file", ["curled"], indirect=True)
def test_a_bent_frame_is_warned_of(file: Path) -> None:
    photo = flatten(file, corners("curled"), FRAME, dots_per_mm=1.0)
    assert photo.residual > BENT
    assert len(photo.warnings) == 1
    assert f"bent by {photo.residual:.1f} mm" in photo.warnings[0]


@pytest.mark.turns(4, "cameras")
@pytest.mark.slow
@pytest.mark.parametrize("file", ["curled"], indirect=True)
def test_the_curl_is_taken_out_of_the_picture(file: Path) -> None:
    photo = flatten(file, corners("curled"), FRAME, dots_per_mm=DOTS)
    # a disc of 1.4 dots to the mm is found again to 0.1 mm; with the curl points are up to 0.9 mm off
    assert abs(photographs.found_discs(photo.image, DOTS) - TARGETS).max() < 2 * EXACT


def test_a_frame_that_is_not_there_is_warned_of(tmp_path: Path) -> None:
    Image.new("RGB", (900, 700), "white").save(tmp_path / "white.png")
    given = [(50, 50), (850, 60), (860, 650), (40, 640)]
    photo = flatten(tmp_path / "white.png", given, FRAME, dots_per_mm=1.0)
    assert math.isnan(photo.residual)
    assert len(photo.warnings) == 1
    assert "lower, right, upper, left" in photo.warnings[0]
    assert abs(photographs.pairs(photo.corners)[::-1] - np.array(given)).max() < 1e-9


def test_a_sheet_lying_on_its_side_is_warned_of(tmp_path: Path) -> None:
    Image.new("RGB", (700, 900), "white").save(tmp_path / "white.png")
    given = [(50, 50), (650, 50), (650, 850), (50, 850)]
    photo = flatten(tmp_path / "white.png", given, FRAME, dots_per_mm=1.0, refined=False)
    assert len(photo.warnings) == 1
    assert "quarter" in photo.warnings[0]


@pytest.mark.turns(4, "cameras")
@pytest.mark.slow
def test_the_png_lies_at_true_millimetres(file: Path) -> None:
    photo = flatten(file, corners("tilted"), FRAME, dots_per_mm=1.0, refined=False)
    assert photo.area == (0.0, 0.0, 841.0, 594.0)
    made = Image.open(io.BytesIO(png(photo)))
    assert made.format == "PNG"
    assert (np.asarray(made) == photo.image).all()
    assert made.info["dpi"] == pytest.approx((25.4, 25.4), abs=1e-9)
    assert png(photo) == png(photo)


@pytest.mark.turns(4, "cameras")
@pytest.mark.slow
def test_a_part_of_the_sheet_on_whole_dots(file: Path) -> None:
    photo = flatten(file, corners("tilted"), FRAME, dots_per_mm=3.0, area=(50, 80, 70.1, 100.1))
    assert photo.image.shape == (61, 61, 3)
    assert photo.area == pytest.approx((50, 100.1 - 61 / 3, 50 + 61 / 3, 100.1), abs=1e-12)
    whole = flatten(file, corners("tilted"), FRAME, dots_per_mm=10.0, area=(56, 86, 64, 94))
    dark = np.clip(120.0 - whole.image.mean(axis=2), 0, None)
    i, j = np.indices(dark.shape)
    x, y = (dark * (j + 0.5)).sum() / dark.sum() / 10, (dark * (i + 0.5)).sum() / dark.sum() / 10
    assert abs(complex(56 + x, 94 - y) - TARGETS[0]) < EXACT


def test_what_the_photograph_does_not_show_is_white(tmp_path: Path) -> None:
    Image.new("RGB", (400, 300), "black").save(tmp_path / "black.png")
    given = [(0, 0), (399, 0), (399, 299), (0, 299)]
    frame, area = (0, 0, 399, 299), (-10, -10, 409, 309)
    photo = flatten(tmp_path / "black.png", given, frame, dots_per_mm=1.0, area=area)
    assert (photo.image[11:-11, 11:-11] == 0).all()
    rim = np.ones(photo.image.shape[:2], dtype=bool)
    rim[10:-10, 10:-10] = False
    assert (photo.image[rim] == 255).all()


def test_a_fine_photograph_keeps_its_thin_lines(tmp_path: Path) -> None:
    """24 dots to the mm: lines of 0.2 mm, 5 dots, must not fall between the dots of the picture."""
    image = np.full((24 * 50, 24 * 60), 255, dtype=np.uint8)
    places = [5 + 7.3 * k for k in range(7)]
    for x in places:
        image[:, round(24 * x) - 2 : round(24 * x) + 3] = 0
    Image.fromarray(image).save(tmp_path / "fine.png")
    given = [(0, 0), (1439, 0), (1439, 1199), (0, 1199)]
    frame = (0.5 / 24, 0.5 / 24, 60 - 0.5 / 24, 50 - 0.5 / 24)
    area = (0, 0, 60, 50)
    photo = flatten(tmp_path / "fine.png", given, frame, area=area, refined=False)
    ink = 255.0 - photo.image[100, :, 0]
    for x in places:
        near = slice(int(4 * x) - 3, int(4 * x) + 4)
        at = (np.arange(240)[near] + 0.5) / 4
        due = (round(24 * x) + 0.5) / 24
        assert abs((ink[near] * at).sum() / ink[near].sum() - due) < 0.05
        assert ink[near].sum() / 255 / 4 == pytest.approx(5 / 24, rel=0.2)


@pytest.mark.turns(4, "cameras")
@pytest.mark.slow
def test_a_camera_held_upright_tells_so(tmp_path: Path, file: Path) -> None:
    upright = Image.open(file)
    said = Image.Exif()
    said[0x0112] = 6
    upright.transpose(Image.Transpose.ROTATE_90).save(tmp_path / "turned.png", exif=said)
    one = flatten(file, corners("tilted"), FRAME, dots_per_mm=1.0)
    other = flatten(tmp_path / "turned.png", corners("tilted"), FRAME, dots_per_mm=1.0)
    assert (one.image == other.image).all()


@each(
    "given, frame, words, said",
    [
        (
            [(0, 0), (399, 0), (399, 299), (0, 300)],
            FRAME,
            {},
            "outside the photograph of 400 × 300",
        ),
        ([(-1, 0), (399, 0), (399, 299), (0, 299)], FRAME, {}, "outside the photograph"),
        ([(0, 0), (399, 0), (399, 299)], FRAME, {}, "four corners"),
        (None, (20, 5, 20, 589), {}, "frame: .* no rectangle"),
        (None, (20, 5, math.nan, 589), {}, "frame: .* no rectangle"),
        (None, (20, 5, 836), {}, "frame: .* no rectangle"),
        (None, FRAME, {"area": (0, 0, -1, 5)}, "area: .* no rectangle"),
        (None, FRAME, {"dots_per_mm": 0.0}, "dots per mm"),
        (None, FRAME, {"dots_per_mm": math.nan}, "dots per mm"),
        (None, FRAME, {"dots_per_mm": math.inf}, "dots per mm"),
        (None, FRAME, {"dots_per_mm": 15.0}, "100 million"),
    ],
)
def test_what_cannot_be_flattened_is_told(
    tmp_path: Path, given: object, frame: object, words: dict[str, object], said: str
) -> None:
    path = tmp_path / "black.png"
    Image.new("RGB", (400, 300), "black").save(path)
    whole = [(0, 0), (399, 0), (399, 299), (0, 299)]
    with pytest.raises(SheetError, match=said):
        flatten(path, given or whole, frame, **words)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("format", "language", "size"),
    [
        ("A1", "ru", (841, 594)),
        ("A1", "en", (841, 594)),
        ("A1 portrait", "ru", (594, 841)),
        ("A4", "en", (210, 297)),
    ],
)
def test_the_paper_is_known_from_the_frame(
    tmp_path: Path, format: str, language: str, size: tuple[float, float]
) -> None:
    Image.new("RGB", (400, 300), "white").save(tmp_path / "white.png")
    given = [(0, 0), (399, 0), (399, 299), (0, 299)]
    frame = drawing_area(format, language, True).inner
    photo = flatten(tmp_path / "white.png", given, frame, dots_per_mm=1.0, refined=False)
    assert photo.area == (0.0, 0.0, *size)
