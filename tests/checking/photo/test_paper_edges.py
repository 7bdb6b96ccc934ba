"""The corners of a sheet of paper by its edges."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from support.command import invoke
from support.own_sheets import Paper
from support.photographed.pencil import DOTS
from support.photographed.shooting import Light, Sheets, shot
from support.photographed.taking import Conditions, aimed

from graphic_tmm.checking import pictures
from graphic_tmm.checking.photo.paper_edges import paper_found
from graphic_tmm.checking.pictures import laid
from graphic_tmm.errors import SheetError
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

pytest.importorskip("cv2")
SHEETS = Path(__file__).parents[3] / "sheets"
SIZE = (210.0, 297.0)


def photograph(
    tilt: tuple[float, float], light: Light, squares: float
) -> tuple[np.ndarray, np.ndarray]:
    """A blank sheet on a table, and where its corners are seen."""
    lead = np.zeros((round(SIZE[1] * DOTS), round(SIZE[0] * DOTS)), np.uint8)
    paper = Paper(SIZE, (-4.0, -4.0, SIZE[0] + 4, SIZE[1] + 4))
    camera = aimed(paper, Conditions(tilt=tilt, light=light, wide=1600))
    image = shot(camera, Sheets(lead, lead, SIZE, squares, 1 + 2j), light, 5)
    corners = np.array([0, SIZE[0], complex(*SIZE), 1j * SIZE[1]])
    return image, camera.seen(corners)


@pytest.mark.parametrize(
    ("tilt", "light", "squares"),
    [
        ((3.0, 0.0), Light(), 0.0),
        ((25.0, 130.0), Light(shadow=0.6, fall=0.6), 0.0),
        ((15.0, 250.0), Light(table=150.0), 0.8),
    ],
)
@pytest.mark.slow
def test_corners_are_where_the_edges_of_the_paper_meet(
    tilt: tuple[float, float], light: Light, squares: float
) -> None:
    image, due = photograph(tilt, light, squares)
    assert abs(paper_found(image) - due).max() < 1.5


@pytest.mark.slow
def test_clicked_corners_are_drawn_to_the_edges() -> None:
    image, due = photograph((12.0, 40.0), Light(), 0.0)
    clicked = [(z.real + 5, z.imag - 4) for z in due[[2, 0, 3, 1]]]
    assert abs(paper_found(image, clicked) - due).max() < 1.5


@pytest.mark.slow
def test_where_no_frame_is_seen_the_papers_edges_are_taken_and_that_is_said(tmp_path: Path) -> None:
    image, due = photograph((8.0, 40.0), Light(), 0.0)
    Image.fromarray(image).save(tmp_path / "p.png")
    shown = laid(read(SHEETS / "crank-rocker" / "scene.toml"), str(tmp_path / "p.png"), "", 2)
    taken = [told for told in shown.flat.warnings if "the edges of the paper were taken" in told]
    assert "as of an upright A4; of another format by --paper" in taken[0]
    assert abs(shown.flat.corners - due).max() < 1.5
    own = laid(
        read(SHEETS / "crank-rocker" / "scene.toml"), str(tmp_path / "p.png"), "", paper="A4"
    )
    assert (own.own_paper, own.sheet.width, own.sheet.height) == (True, 210.0, 297.0)


@pytest.mark.parametrize("asked", ["en", "ru"])
def test_the_form_that_is_looked_for_is_the_scenes(
    asked: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    languages = []

    def stopped(scene: Scene, *_: object) -> None:
        languages.append(scene.language)
        raise SheetError("enough")

    monkeypatch.setattr(pictures, "laid", stopped)
    monkeypatch.chdir(tmp_path)
    invoke("photo", "windrower", "photo.png", "-l", asked)
    assert languages == [read(SHEETS / "windrower" / "scene.toml").language]


def test_where_no_paper_is_that_is_said() -> None:
    dull = np.full((400, 600, 3), 120, np.uint8)
    with pytest.raises(SheetError, match="the four edges of the paper"):
        paper_found(dull)
