"""A curl: the camera's foot and the places that a curled sheet hides, by a camera of known place."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from support import photographs
from support.each import each
from support.photographs import CORNERS, FRAME, HEIGHT, WIDTH, Camera

from graphic_tmm.checking.photo.camera import (
    MOST_BOWED,
    Curl,
    Lens,
    Shot,
    foot_of,
    straightening,
    unbending,
)
from graphic_tmm.checking.photo.perspective import homography
from graphic_tmm.paper.ruled import Box

MIDDLE, RADIUS = 1999.5 + 1499.5j, 2000.0
PLACES = np.array([0, 3999, 3999 + 2999j, 1999.5 + 1499.5j, 2500 + 10j, 17 + 2000j])


def by_roots(share: float, straight: complex) -> complex:
    """The smallest positive root of the cubic of the radius, 40 digits."""
    with mpmath.workdps(40):
        off = mpmath.mpc(straight) - mpmath.mpc(MIDDLE)
        far = abs(off) / RADIUS
        if far == 0:
            return MIDDLE
        roots = mpmath.polyroots([-far, 1, 0, share], asc=True, maxsteps=200, extraprec=200)
        real = [mpmath.re(one) for one in roots if abs(mpmath.im(one)) < 1e-20]
        return complex(MIDDLE + off * min(one for one in real if one > 0) / far)


@pytest.mark.parametrize("share", [0.002, -0.002, 0.05, MOST_BOWED, -0.05])
def test_a_ray_is_seen_where_the_cubic_says(share: float) -> None:
    lens = Lens(MIDDLE, RADIUS, share)
    seen = lens.seen(PLACES)
    assert max(abs(a - by_roots(share, b)) for a, b in zip(seen, PLACES, strict=True)) < 1e-6
    assert abs(lens.straight(seen) - PLACES).max() < 1e-6


def test_beyond_what_a_lens_can_show_nothing_is_seen() -> None:
    assert np.isnan(Lens(MIDDLE, RADIUS, -MOST_BOWED).seen(np.array([1e5 + 0j, -9e4j]))).all()
    assert (Lens(MIDDLE, RADIUS).seen(PLACES) == PLACES).all()


def bowed(share: float, foot: complex, head: complex) -> tuple[np.ndarray, np.ndarray]:
    line = foot + (head - foot) * np.linspace(0, 1, 50)
    return Lens(MIDDLE, RADIUS, share).seen(line), np.ones(50)


@pytest.mark.parametrize("share", [0.0, 0.002, -0.03])
def test_straight_lines_tell_the_lens(share: float) -> None:
    lines = [bowed(share, 300 + 200j, 3700 + 350j), bowed(share, 400 + 300j, 250 + 2700j)]
    found = straightening(Lens(MIDDLE, RADIUS, 0.01), lines)
    # a chord of the bowed line is turned against the straight one's by a share of the share
    assert abs(found.share - share) < 1e-9 + share**2
    assert straightening(found, [bowed(found.share, *ends) for ends in ENDS]).share == (
        pytest.approx(found.share, abs=1e-9 + share**2)
    )


ENDS = ((300 + 200j, 3700 + 350j), (400 + 300j, 250 + 2700j))


def test_what_is_not_believed_does_not_count() -> None:
    (one, weights), other = bowed(0.01, *ENDS[0]), bowed(0.01, *ENDS[1])
    spoilt = one.copy()
    spoilt[20:30] += 40j
    believed = weights.copy()
    believed[20:30] = 0
    lens = Lens(MIDDLE, RADIUS)
    assert straightening(lens, [(spoilt, believed), other]).share == pytest.approx(0.01, abs=1e-4)
    assert abs(straightening(lens, [(spoilt, weights), other]).share - 0.01) > 1e-3


def test_one_line_tells_no_lens() -> None:
    lens = Lens(MIDDLE, RADIUS, 0.004)
    assert straightening(lens, [bowed(0.02, *ENDS[0])]) == lens
    assert straightening(lens, []) == lens


def test_a_reduced_photograph_has_the_same_lens() -> None:
    lens = Lens(MIDDLE, RADIUS, 0.02)
    reduced = lens.reduced(4)
    assert (
        abs(4 * reduced.seen(PLACES / 4) + 1.5 + 1.5j - lens.seen(PLACES + 1.5 + 1.5j)).max() < 1e-9
    )


BOX = Box(*FRAME)
TILTS = [
    (8.0, -8.0, 1.0),
    (-12.0, 11.0, 90.0),
    (0.0, 11.0, -6.0),
    (4.0, 0.5, -5.0),
    (0.0, 0.0, 3.0),
]
GRID = np.array([x + 1j * y for x in np.linspace(20, 836, 9) for y in np.linspace(5, 589, 7)])
NOTHING = np.zeros((1500, 2000, 3), dtype=np.uint8)


def middle_of(camera: Camera) -> complex:
    return complex((camera.columns - 1) / 2, (camera.rows - 1) / 2)


def lens_of(camera: Camera) -> Lens:
    return Lens(middle_of(camera), camera.columns / 2, camera.lens)


def foot(camera: Camera) -> complex:
    x, y, _ = -camera.turn.T @ camera.place
    return complex(x, y)


@each("tilt", TILTS)
@each("focal", [1500.0, 2150.0])
def test_the_camera_s_foot_is_told_by_its_projection(
    tilt: tuple[float, float, float], focal: float
) -> None:
    camera = Camera(tilt, 1150 * focal / 2150, focal)
    found = foot_of(camera.matrix, lens_of(camera))
    # a sheet seen almost straight from above tells little of the camera, and its foot is near the middle
    aside = abs(foot(camera) - complex(WIDTH / 2, HEIGHT / 2))
    assert abs(found - foot(camera)) < 1 + (0.06 if aside > 100 else 0.6) * aside


def test_points_of_a_curled_sheet_come_back() -> None:
    for upright in (True, False):
        curl = Curl(BOX, 700 - 100j, upright, (1.5, -0.7))
        assert abs(curl.flat(curl.seen(GRID)) - GRID).max() < 1e-9
        assert abs(curl.seen(CORNERS) - CORNERS).max() < 1e-9
        assert abs(curl.seen(GRID) - GRID).max() > 0.5
    assert (Curl(BOX).flat(GRID) == GRID).all()


def edges(camera: Camera, *, turned: bool = False) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return the frame's edges as they are seen, px; ``turned``: the sheet curled about its level line."""
    lines = []
    for start, end in zip(CORNERS, np.roll(CORNERS, -1), strict=True):
        line = start + (end - start) * np.linspace(0.01, 0.99, 100)
        lines.append((seen(camera, line, turned=turned), np.ones(line.size)))
    return lines


def seen(camera: Camera, points: np.ndarray, *, turned: bool = False) -> np.ndarray:
    if not turned:
        return camera.seen(points)
    high = camera.sag * (1 - (2 * points.imag / HEIGHT - 1) ** 2)
    x, y, above = -camera.turn.T @ camera.place
    lifted = points + (points - complex(x, y)) * high / (above - high)
    return camera._replace(sag=0.0).seen(lifted)


def straightened(camera: Camera, *, turned: bool = False) -> tuple[Shot, np.ndarray]:
    """Return how the photograph is understood after some rounds, and how far points are off, mm."""
    corners = seen(camera, CORNERS, turned=turned)
    lens, curl = lens_of(camera)._replace(share=0.0), Curl(BOX)
    for _ in range(4):
        shot = Shot(NOTHING, homography(BOX, lens.straight(corners)), lens, curl)
        lens, curl = unbending(shot, edges(camera, turned=turned))
    shot = Shot(NOTHING, homography(BOX, lens.straight(corners)), lens, curl)
    return shot, abs(shot.sheet(seen(camera, GRID, turned=turned)) - GRID)


@pytest.mark.turns(6)
@pytest.mark.parametrize("turned", [False, True], ids=["upright", "level"])
@pytest.mark.parametrize("tilt", TILTS)
@pytest.mark.parametrize(("lens", "sag"), [(0.002, 2.0), (-0.002, -2.0), (0.0, 1.0), (0.01, 2.0)])
def test_lens_and_curl_are_told_apart(
    tilt: tuple[float, float, float], lens: float, sag: float, turned: bool
) -> None:
    camera = Camera(tilt, 1150, 2150, lens=lens, sag=sag)
    shot, off = straightened(camera, turned=turned)
    assert off.max() < 0.05
    if abs(foot(camera) - complex(WIDTH / 2, HEIGHT / 2)) > 1:
        assert shot.curl.upright is not turned
        assert abs(shot.lens.share - lens) < 2e-4 + 0.01 * abs(lens)
    # seen straight from above a curl is the lens and the other curl together: then one is as good as the other
    back = photographs.project(np.linalg.inv(shot.matrix), shot.lens.straight(camera.seen(GRID)))
    assert abs(back - GRID).max() > 0.15 * abs(sag)  # without the curl


def test_fewer_lines_than_four_tell_no_curl() -> None:
    camera = Camera((8, -8, 1), 1150, 2150, sag=2.0)
    lens = lens_of(camera)
    shot = Shot(NOTHING, homography(BOX, camera.seen(CORNERS)), lens, Curl(BOX))
    assert unbending(shot, edges(camera))[1] != Curl(BOX)
    assert unbending(shot, edges(camera)[:3])[1] == Curl(BOX)
    assert unbending(shot, [])[1] == Curl(BOX)


@pytest.mark.parametrize("seed", range(6))
def test_grain_makes_no_curl(seed: int) -> None:
    random = np.random.default_rng(seed)
    camera = Camera((8, -8, 1), 1150, 2150, lens=0.002)
    lines = [
        (line + random.normal(0, 0.2, line.size) * 1j + random.normal(0, 0.2, line.size), weights)
        for line, weights in edges(camera)
    ]
    lens = lens_of(camera)
    corners = lens.straight(camera.seen(CORNERS))
    shot = Shot(NOTHING, homography(BOX, corners), lens, Curl(BOX))
    assert unbending(shot, lines)[1] == Curl(BOX)
