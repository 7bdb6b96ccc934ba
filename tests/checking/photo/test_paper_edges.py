"""The corners of a sheet of paper by its edges."""

from __future__ import annotations

import numpy as np
import pytest
from support.own_sheets import Paper
from support.photographed.pencil import DOTS
from support.photographed.shooting import Light, Sheets, shot
from support.photographed.taking import Conditions, aimed

from graphic_tmm.checking.photo.paper_edges import paper_found
from graphic_tmm.errors import SheetError

pytest.importorskip("cv2")
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
def test_corners_are_where_the_edges_of_the_paper_meet(
    tilt: tuple[float, float], light: Light, squares: float
) -> None:
    image, due = photograph(tilt, light, squares)
    assert abs(paper_found(image) - due).max() < 1.5


def test_clicked_corners_are_drawn_to_the_edges() -> None:
    image, due = photograph((12.0, 40.0), Light(), 0.0)
    clicked = [(z.real + 5, z.imag - 4) for z in due[[2, 0, 3, 1]]]
    assert abs(paper_found(image, clicked) - due).max() < 1.5


def test_where_no_paper_is_that_is_said() -> None:
    dull = np.full((400, 600, 3), 120, np.uint8)
    with pytest.raises(SheetError, match="the four edges of the paper"):
        paper_found(dull)
