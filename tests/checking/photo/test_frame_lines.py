"""The frame found again in photographs made by a camera of known place (`photographs`)."""

from __future__ import annotations

import functools
import io
from collections.abc import Callable

import numpy as np
import pytest
from PIL import Image
from support import photographs
from support.gallery import SHEETS
from support.photographs import CORNERS, FRAME, PAPER, Camera

from graphic_tmm.checking.photo.camera import Curl, Shot
from graphic_tmm.checking.photo.frame_lines import EDGES, refine
from graphic_tmm.checking.photo.perspective import homography, vertices
from graphic_tmm.paper.ruled import Box

BOX = Box(*FRAME)
TILTED = Camera((18, -12, 6), 1150, 1618.1, 1400, 1050)
STEEP = Camera((-32, 8, -10), 1300, 1618.1, 1400, 1050)
SMALL = Camera((10, -8, 5), 1100, 1618.1, 1400, 1050)
UPRIGHT = Camera((3, -2, 1), 1000, 1391.3, 1400, 1050)
GRID = np.array([x + 1j * y for x in np.linspace(0, 841, 9) for y in np.linspace(0, 594, 7)])

EXACT, CLICKED = 0.1, 0.7
"""What may be off anywhere on the sheet, mm: corners given exactly; corners clicked ±2 px."""


@functools.cache
def seen(camera: Camera, ink: float = 1.0, width: float = 0.8, noise: float = 4.0) -> np.ndarray:
    """A photograph after JPEG; ``ink``: how dark the lines are, as a share."""
    drawn = PAPER - (PAPER - photographs.sheet(width)) * ink
    return through_jpeg(photographs.photograph(camera, drawn, noise=noise))


def through_jpeg(image: np.ndarray) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(photographs.jpeg(image))))


def off(camera: Camera, corners: np.ndarray) -> float:
    """How far any point of the sheet comes back from its place, mm."""
    back = np.linalg.inv(homography(BOX, corners))
    return float(abs(photographs.project(back, camera.seen(GRID)) - GRID).max())


def clicks(camera: Camera, seed: int, by: float = 2.0) -> np.ndarray:
    random = np.random.default_rng(seed)
    corners = camera.seen(CORNERS)
    return corners + random.uniform(-by, by, 4) + 1j * random.uniform(-by, by, 4)


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
@pytest.mark.parametrize("camera", [TILTED, STEEP, UPRIGHT], ids=["tilted", "steep", "upright"])
def test_clicked_corners_come_back_to_the_lines(
    camera: Camera, many: Callable[[int, int], int]
) -> None:
    image, worst = seen(camera), []
    for seed in range(many(4, 2)):
        clicked = clicks(camera, seed)
        found = refine(image, BOX, clicked)
        assert found.missing == ()
        assert found.residual < EXACT
        assert off(camera, found.corners) < EXACT
        worst.append(off(camera, clicked))
    assert max(worst) > CLICKED  # without the lines the clicks would not do


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
def test_an_edge_clicked_far_beside_its_line_is_found(many: Callable[[int, int], int]) -> None:
    """Both of its corners to one side: by more than the reach that is enough for the others.

    To the side where something else is ruled, with ``--measured`` to the other too: the title block lies within
    the lower and the right edge, a box within the upper one, the boxes of the margin outside the left one.
    """
    ruled = [(0, 6.0), (1, 6.0), (2, 6.0), (3, -6.0)]
    for edge, aside in ruled + [(edge, -aside) for edge, aside in ruled][: many(4, 0)]:
        ends = [edge, (edge + 1) % 4]
        way = CORNERS[ends[1]] - CORNERS[ends[0]]
        clicked = CORNERS.astype(np.complex128)
        clicked[ends] += aside * 1j * way / abs(way)
        found = refine(seen(TILTED), BOX, TILTED.seen(clicked))
        assert found.missing == (), EDGES[edge]
        assert off(TILTED, found.corners) < EXACT, EDGES[edge]


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
@pytest.mark.parametrize(
    ("ink", "width", "noise", "by"),
    [(0.35, 0.5, 4.0, 2.0), (1.0, 0.3, 12.0, 5.0)],
    ids=["pencil", "thin lines, grain, clicks of 5 px"],
)
def test_faint_and_thin_lines_are_found(ink: float, width: float, noise: float, by: float) -> None:
    found = refine(seen(SMALL, ink, width, noise), BOX, clicks(SMALL, 3, by))
    assert found.missing == ()
    assert off(SMALL, found.corners) < EXACT
    assert found.curl == Curl(BOX)  # the sheet is flat


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
def test_fingers_on_the_frame_do_not_draw_it_away() -> None:
    image = seen(TILTED).copy()
    image[420:532, 70:182] = (150, 110, 90)
    image[805:980, 630:805] = (150, 110, 90)
    found = refine(image, BOX, clicks(TILTED, 4))
    assert found.missing == ()
    assert found.residual < EXACT
    assert off(TILTED, found.corners) < EXACT


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
def test_an_edge_without_a_line_is_named_and_stays_as_clicked() -> None:
    """The left one; the lower one is wiped in `test_own_frame.py`."""
    wiped = photographs.sheet().copy()
    wiped[:, 18 * photographs.DOTS : 22 * photographs.DOTS] = PAPER
    image = through_jpeg(photographs.photograph(SMALL, wiped))
    exact = refine(image, BOX, SMALL.seen(CORNERS))
    assert exact.missing == ("left",)
    assert off(SMALL, exact.corners) < EXACT
    # two pixels stay two pixels along the lines that were found, 1.4 px a mm at the worst
    clicked = refine(image, BOX, clicks(SMALL, 5))
    assert clicked.missing == ("left",)
    assert abs(clicked.corners - SMALL.seen(CORNERS)).max() < 2 * 2**0.5 * 1.2


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
def test_an_empty_sheet_keeps_its_clicks() -> None:
    image = through_jpeg(photographs.photograph(SMALL, photographs.sheet(0.8, False)))
    clicked = clicks(SMALL, 6)
    found = refine(image, BOX, clicked)
    assert found.missing == EDGES
    assert np.isnan(found.residual)
    assert abs(found.corners - clicked).max() < 1e-9


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
@pytest.mark.parametrize("lenses", [(0.002, -0.002), (-0.01, 0.02)])
def test_what_the_lens_bows_is_taken_out(
    lenses: tuple[float, ...], many: Callable[[int, int], int]
) -> None:
    for lens in lenses[: many(2, 1)]:
        taken_out(UPRIGHT._replace(lens=lens), lens)


def taken_out(camera: Camera, lens: float) -> None:
    found = refine(seen(camera), BOX, clicks(camera, 7))
    assert found.missing == ()
    assert found.residual < EXACT
    straight = found.lens.straight(found.corners)
    back = np.linalg.inv(homography(BOX, straight))
    came = photographs.project(back, found.lens.straight(camera.seen(GRID)))
    assert abs(came - GRID).max() < EXACT
    # of a frame as the pinhole shows it, larger or smaller by what the lens does at its edges
    assert abs(found.bowed - bend(camera)) < 0.02 + 0.05 * bend(camera)
    if abs(lens) > 0.005:  # as if there were no lens, points would be far off
        assert off(camera, found.corners) > 5 * EXACT


def bend(camera: Camera) -> float:
    """How far the edges are from their straight lines of least squares, mm, by the lens alone."""
    back = np.linalg.inv(homography(BOX, camera.seen(CORNERS)))
    worst = []
    for foot, head in zip(CORNERS, np.roll(CORNERS, -1), strict=True):
        share = np.linspace(0, 1, 200)
        edge = photographs.project(back, camera.seen(foot + (head - foot) * share))
        aside = ((edge - foot) / (head - foot) * abs(head - foot)).imag
        line = np.polyval(np.polyfit(share, aside, 1), share)
        worst.append(abs(aside - line).max())
    return max(worst)


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
def test_a_sheet_that_curls_leaves_a_residual() -> None:
    camera = TILTED._replace(sag=-3.0)
    found = refine(seen(camera), BOX, clicks(camera, 7))
    assert found.missing == ()
    # two edges bow alike, by the sag's parallax: what a lens cannot do; least squares leave it between the two
    assert bend(camera) - EXACT - found.bowed < found.residual < bend(camera) + EXACT
    assert found.residual > 0.4


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
@pytest.mark.parametrize(
    ("tilt", "lens", "sag", "ink"),
    [
        ((-12, -5, -3), 0.0, 1.4, 1.0),
        ((3, -12, 1), -0.002, -2.0, 0.35),
        ((12, 12, 90), 0.0, -1.5, 1.0),
    ],
    ids=["one edge near the foot", "pencil and a lens", "on its side"],
)
def test_what_a_curled_sheet_hides_is_found(
    tilt: tuple[float, float, float], lens: float, sag: float, ink: float
) -> None:
    camera = SMALL._replace(tilt=tilt, lens=lens, sag=sag)
    if tilt[2] == 90:
        camera = camera._replace(columns=1050, rows=1400)
    image = seen(camera, ink)
    found = refine(image, BOX, clicks(camera, 9))
    shot = Shot(image, homography(BOX, found.lens.straight(found.corners)), found.lens, found.curl)
    inner = GRID[(GRID.real > 20) & (GRID.real < 836) & (GRID.imag > 5) & (GRID.imag < 589)]
    assert abs(shot.sheet(camera.seen(inner)) - inner).max() < EXACT
    without = shot._replace(curl=Curl(BOX))
    assert abs(without.sheet(camera.seen(inner)) - inner).max() > 3 * EXACT


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
def test_any_quadrilateral_on_any_picture_gives_numbers(many: Callable[[int, int], int]) -> None:
    random = np.random.default_rng(8)
    image = random.integers(0, 255, (300, 400, 3), dtype=np.uint8)
    square = np.array([0 + 1j, 1 + 1j, 1, 0])
    for case in range(many(12, 4)):
        side = random.uniform(30, 260)
        corners = 20 + 20j + side * (square + 0.2 * random.uniform(0, 1, 4))
        found = refine(image if case % 2 else image * 0, BOX, corners)
        assert np.isfinite(found.corners).all()


@pytest.mark.turns(4, "conditions")
@pytest.mark.slow
def test_the_frame_of_a_sheet_drawn_by_the_package() -> None:
    """An A4 by ISO 5457."""
    resvg = pytest.importorskip("resvg_py")
    text = (SHEETS / "crank-rocker/crank-rocker-2.svg").read_text("utf-8")
    made = resvg.svg_to_bytes(svg_string=text, dpi=25.4 * photographs.DOTS, skip_system_fonts=True)
    painted = Image.open(io.BytesIO(bytes(made))).convert("RGBA")
    white = Image.new("RGBA", painted.size, "white")
    drawn = np.asarray(Image.alpha_composite(white, painted).convert("L"), np.float32)[::-1]
    camera = Camera((6, -5, 3), 560, 1475, 750, 1000, middle=(105.0, 148.5))
    box = Box(20.0, 10.0, 200.0, 287.0)
    corners = camera.seen(vertices(box))
    found = refine(through_jpeg(photographs.photograph(camera, drawn)), box, corners + 1.5 - 1j)
    assert found.missing == ()
    back = np.linalg.inv(homography(box, found.corners))
    assert abs(photographs.project(back, corners) - vertices(box)).max() < EXACT
