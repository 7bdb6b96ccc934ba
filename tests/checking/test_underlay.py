"""A photograph under its exact sheet: it is seen, the ink fits it, and any sheet can be chosen."""

from __future__ import annotations

import functools
import io
import re
from pathlib import Path

import numpy as np
import pytest
from click.testing import Result
from support import photographs
from support.command import invoke
from support.photographs import DOTS, Camera

from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheets

image = pytest.importorskip("PIL.Image")
resvg = pytest.importorskip("resvg_py")

SCENE = """title = "Four-bar"
language = "en"
[frame]
O = [0, 0]
C = ["0.35 m", "0.05 m"]
[[link]]
number = 1
points = { O = [0, 0], A = ["0.11 m", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["0.31 m", 0] }
[[link]]
number = 3
points = { C = [0, 0], B = ["0.2 m", 0] }
side = "left of AC"
[drive]
link = 1
speed = "12 1/s"
positions = 6
[[sheet]]
format = "A4"
place = ["structure"]
[[sheet]]
format = "A2"
place = ["positions", "velocities"]
"""
CAMERA = Camera((11, -7, 3), 813, 1296, 1200, 920, middle=(297, 210), size=(594, 420))
CORNERS = np.array([20 + 10j, 584 + 10j, 584 + 410j, 20 + 410j])
"""Of the frame of an A2, mm: 20 to the left, 10 elsewhere (ISO 5457)."""
INK = (208, 0, 111)
MM = 5
"""Dots of the rendered overlay to the mm, as many as the flattened picture has."""


def rendered(text: str, folder: Path, dots: float) -> np.ndarray:
    """Paint an SVG with a renderer that the package does not use for it; ``dots`` to the mm."""
    file = folder / "painted.svg"
    file.write_text(text, encoding="utf-8")
    options = {"dpi": 25.4 * dots, "skip_system_fonts": True, "resources_dir": str(folder)}
    painted = bytes(resvg.svg_to_bytes(svg_path=str(file), **options))
    image.MAX_IMAGE_PIXELS = None
    return np.asarray(image.open(io.BytesIO(painted)).convert("RGB"))


@functools.cache
def hand_in() -> bytes:
    """A photograph of the second sheet, printed as it is drawn: by a camera of known place, on tinted paper."""
    from tempfile import TemporaryDirectory

    with TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.toml"
        scene.write_text(SCENE, encoding="utf-8")
        printed = rendered(svg(sheets(read(scene))[1][1]), Path(folder), DOTS)
    drawn = printed.mean(axis=2)[::-1].astype(np.float32) * (photographs.PAPER / 255)
    return photographs.jpeg(photographs.photograph(CAMERA, drawn, shade=1.0, noise=2.0), 95)


@pytest.fixture
def given(tmp_path: Path) -> tuple[Path, Path]:
    scene, photo = tmp_path / "scene.toml", tmp_path / "photo.jpg"
    scene.write_text(SCENE, encoding="utf-8")
    photo.write_bytes(hand_in())
    return scene, photo


def corners() -> str:
    return " ".join(f"{z.real:.2f},{z.imag:.2f}" for z in CAMERA.seen(CORNERS))


def check(*arguments: object) -> Result:
    return invoke("check", *map(str, arguments))


@pytest.mark.turns(1, "photograph")
@pytest.mark.slow
def test_the_photograph_is_seen_and_the_ink_fits_it(
    given: tuple[Path, Path], tmp_path: Path
) -> None:
    scene, photo = given
    out = tmp_path / "under 'it' \"1\" & план.svg"
    options = ("--photo", photo, "--corners", corners(), "--sheet", 2, "--overlay", out)
    done = check(scene, *options)
    flat = tmp_path / "under 'it' \"1\" & план-flat.png"
    # not every point of its plans is seen
    assert (done.exit_code, done.stderr) == (3, f"{out}\n{flat}\n"), done.output
    assert "wrong 0" in done.stdout
    text = out.read_text(encoding="utf-8")
    seen = rendered(text, tmp_path, MM).astype(np.int16)
    picture = np.asarray(image.open(flat).convert("RGB")).astype(np.int16)
    assert seen.shape == picture.shape == (420 * MM, 594 * MM, 3)
    pure = abs(seen - INK).max(axis=2) < 60
    # a dot of ink is a dot of the picture, but for the edges; nothing else covers any of it
    same = abs(seen - picture).max(axis=2) < 12
    assert 0.002 < pure.mean() < 0.1
    assert (same | near(pure, 2)).mean() > 0.99  # the rest: lettering thinner than a dot
    # every line of the exact sheet lies on a printed line: lines of the paper are dark under it
    grey = picture.mean(axis=2)
    dark = grey < 0.93 * np.median(grey)  # a thin line is a fifth of a dot of the photograph
    assert near(dark, round(0.25 * MM))[pure].mean() > 0.97
    away = np.roll(pure, 2 * MM, axis=(0, 1))
    assert near(dark, round(0.25 * MM))[away].mean() < 0.5  # 2 mm off it would be told


def near(mask: np.ndarray, reach: int) -> np.ndarray:
    """Where a dot of the mask lies within a few dots across and along."""
    found = mask.copy()
    for axis in (0, 1):
        line = found.copy()
        for by in range(1, reach + 1):
            found |= np.roll(line, by, axis=axis) | np.roll(line, -by, axis=axis)
    return found


@pytest.mark.turns(1, "photograph")
@pytest.mark.slow
def test_the_first_sheet_is_taken_if_none_is_named(tmp_path: Path) -> None:
    scene, photo = tmp_path / "scene.toml", tmp_path / "photo.png"
    scene.write_text(SCENE, encoding="utf-8")
    image.new("RGB", (210, 297), "white").save(photo)
    ends = "20,292 205,292 205,5 20,5"
    done = check(scene, "--photo", photo, "--corners", ends, "--overlay", tmp_path / "o.svg")
    assert done.exit_code == 0, done.output
    text = (tmp_path / "o.svg").read_text(encoding="utf-8")
    assert re.search('height="297mm".* width="210mm"', text)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--sheet", 3), "--sheet: there is no sheet 3; the scene has 2"),
        (("--sheet", 0), "'--sheet'"),
        (("--overlay", "drawing.png"), "drawing.png: the drawing is an SVG file; name it .svg"),
        (("--corners", "1,2"), "--corners: write the four corners"),
        (("none.jpg",), "none.jpg: there is no such file; name a photograph"),
    ],
)
def test_what_cannot_be_laid_under_is_told(
    options: tuple[object, ...], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("scene.toml").write_text(SCENE, encoding="utf-8")
    image.new("RGB", (210, 297), "white").save("photo.png")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    ends = "20,292 205,292 205,5 20,5"
    photo, *rest = options if len(options) == 1 else ("photo.png", *options)
    done = invoke("photo", "scene.toml", photo, "--corners", ends, *rest)
    assert (done.exit_code, done.stdout) == (2, "")
    assert said in done.stderr
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


@pytest.mark.parametrize(
    "option",
    [
        ("--sheet", "1"),
        ("--corners", "1,2 3,4 5,6 7,8"),
        ("--pole", "velocities:1=2,3"),
        ("--readings-out", "seen.csv"),
    ],
)
def test_what_goes_with_a_photograph_is_not_passed_over_without_one(
    option: tuple[str, str],
) -> None:
    done = check("crank-rocker", "readings.csv", *option)
    assert done.exit_code == 2
    assert "it is an option of photo" in done.stderr


@pytest.mark.turns(1, "photograph")
@pytest.mark.slow
def test_a_report_has_the_output_to_itself(given: tuple[Path, Path], tmp_path: Path) -> None:
    scene, photo = given
    csv = tmp_path / "readings.csv"
    csv.write_text(check(scene, "--template").stdout, encoding="utf-8")
    options = ("--photo", photo, "--corners", corners(), "--sheet", 2)
    done = check(scene, csv, *options, "--overlay", tmp_path / "o.svg", "-f", "md", "--trials", 20)
    assert done.exit_code == 0, done.output
    assert "o-flat.png" in done.stderr
    assert "o-flat.png" not in done.stdout
