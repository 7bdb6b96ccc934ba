"""The page's program finds frames as the check does: on photographs of known cameras, run by node."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from support import photographs
from support.photographs import CORNERS, FRAME, PAPER, Camera
from support.scripts import run

from graphic_tmm.checking.photo.camera import Curl, Lens, Shot
from graphic_tmm.checking.photo.frame_lines import EDGES, refine
from graphic_tmm.checking.photo.perspective import bilinear, homography, ordered
from graphic_tmm.errors import SheetError
from graphic_tmm.page.practice.own import seeking
from graphic_tmm.paper.ruled import Box

BOX = Box(*FRAME)
SAME = 1e-6
"""Both find the same line, px: sums in another order, fed back twelve times."""
CASES: dict[str, tuple[Camera, float, float]] = {
    "lens": (Camera((3, -2, 1), 1000, 1391.3, 1400, 1050, lens=-0.01), 1.0, 0.8),
    "curled": (Camera((9, 7, -4), 1100, 1480, 1400, 1050, lens=0.002, sag=2.0), 1.0, 0.8),
    "tilted": (Camera((18, -12, 6), 1150, 1618.1, 1400, 1050), 1.0, 0.8),
    "pencil": (Camera((10, -8, 5), 1100, 1618.1, 1400, 1050), 0.35, 0.5),
}
FOUND = """
import { refinedFrame } from "./own/frame.js";
const told = asked.cases.map(({ width, height, corners }, k) => {
  const bytes = readFileSync(files[k]);
  const data = new Uint8ClampedArray(bytes.buffer, bytes.byteOffset, bytes.length);
  const found = refinedFrame({ width, height, data }, asked.box, corners, asked.seeking);
  const { shot, residual, bowed, missing } = found;
  const grid = asked.grid.map(([x, y]) => shot.onSheet(...shot.seen(x, y)));
  const curl = [...shot.curl.parts, ...shot.curl.foot];
  const curled = asked.grid.map(([x, y]) => shot.onSheet(x, y));
  return { corners: shot.corners, share: shot.lens.share, curl, residual, bowed, missing, grid, curled };
});
tell(told);
"""


def rgba(image: np.ndarray) -> bytes:
    return np.dstack([image, np.full(image.shape[:2], 255, np.uint8)]).tobytes()


def found_by_page(images: list[np.ndarray], corners: list[np.ndarray], folder: Path) -> list[Any]:
    files = []
    for k, image in enumerate(images):
        files.append(folder / f"{k}.raw")
        files[-1].write_bytes(rgba(image))
    cases = [
        {"width": one.shape[1], "height": one.shape[0], "corners": photographs.pairs(at).tolist()}
        for one, at in zip(images, corners, strict=True)
    ]
    grid = photographs.pairs(CORNERS).tolist()
    asked = {"cases": cases, "box": FRAME, "seeking": seeking(), "grid": grid}
    return list(run(FOUND, asked, *files))


@pytest.mark.slow
def test_frames_are_found_as_the_check_finds_them(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    """Through a lens, of a sheet that curls, without an edge, without any; with ``--measured`` plainly too."""
    random = np.random.default_rng(5)
    images, clicked = [], []
    cases = dict(list(CASES.items())[: many(len(CASES), 2)])
    for camera, ink, width in cases.values():
        drawn = PAPER - (PAPER - photographs.sheet(width)) * ink
        taken = photographs.jpeg(photographs.photograph(camera, drawn))
        images.append(np.asarray(Image.open(io.BytesIO(taken))))
        by = random.uniform(-3, 3, 4) + 1j * random.uniform(-3, 3, 4)
        clicked.append(camera.seen(CORNERS) + by)
    wiped = PAPER - (PAPER - photographs.sheet(0.5)) * 0.35
    wiped[3 * photographs.DOTS : 7 * photographs.DOTS] = PAPER  # no lower edge
    images += [photographs.photograph(CASES["pencil"][0], wiped), images[0] * 0 + 200]
    clicked += [CASES["pencil"][0].seen(CORNERS), clicked[0]]
    answers = found_by_page(images, clicked, tmp_path)
    for image, at, told in zip(images, clicked, answers, strict=True):
        due = refine(image, BOX, at)
        corners = np.array([complex(*one) for one in told["corners"]])
        assert abs(corners - due.corners).max() < SAME
        assert abs(told["share"] - due.lens.share) < SAME / 100
        assert abs(told["bowed"] - due.bowed) < SAME
        foot = due.curl.foot
        assert np.allclose(told["curl"], [*due.curl.parts, foot.real, foot.imag], atol=1e-6)
        shot = Shot(image, homography(BOX, due.lens.straight(due.corners)), due.lens, due.curl)
        assert np.allclose(told["curled"], photographs.pairs(shot.sheet(CORNERS)), atol=1e-6)
        assert [EDGES[k] for k in told["missing"]] == list(due.missing)
        none = told["residual"] is None
        assert none == bool(np.isnan(due.residual))
        assert none or abs(told["residual"] - due.residual) < SAME
        assert np.allclose(told["grid"], photographs.pairs(CORNERS), rtol=0, atol=1e-6)
    curled = [any(one["curl"]) for one in answers]
    assert curled == [name == "curled" for name in cases] + [False, False]
    assert [one["missing"] for one in answers[-2:]] == [[0], [0, 1, 2, 3]]


PLANE = """
import { orderedCorners, homographyOf, inverseOf, projected } from "./own/projection.js";
import { straightSpot, seenSpot } from "./own/lens.js";
import { Shot } from "./own/shot.js";
tell({
  ordered: asked.rings.map((ring) => orderedCorners(ring)),
  matrix: homographyOf(asked.box, asked.corners),
  straight: asked.points.map(([x, y]) => straightSpot(asked.lens, x, y)),
  seen: asked.points.map(([x, y]) => new Shot(asked.box, asked.corners, asked.lens).seen(x, y)),
  back: asked.points.map(([x, y]) => {
    const shot = new Shot(asked.box, asked.corners, asked.lens);
    return shot.onSheet(...shot.seen(x, y));
  }),
});
"""


def test_the_plane_and_the_lens_are_those_of_the_check() -> None:
    random = np.random.default_rng(2)
    square = np.array([200 + 900j, 1200 + 930j, 1100 + 150j, 260 + 120j])
    rings = [random.permutation(photographs.pairs(square)) for _ in range(6)]
    rings += [photographs.pairs(square * np.exp(1j * turn)) for turn in (0.6, -0.6, 1.0)]
    rings += [random.uniform(0, 200, (4, 2)) for _ in range(12)]
    lens = Lens(699.5 + 524.5j, 700.0, -0.02)
    points = random.uniform(0, 800, (30, 2))
    told = run(
        PLANE,
        {
            "rings": [one.tolist() for one in rings],
            "box": FRAME,
            "corners": photographs.pairs(square).tolist(),
            "points": points.tolist(),
            "lens": {"x": 699.5, "y": 524.5, "radius": 700.0, "share": lens.share},
        },
    )
    for ring, found in zip(rings, told["ordered"], strict=True):
        try:
            due = photographs.pairs(ordered(ring)).tolist()
        except SheetError:
            due = None
        assert found == due
    assert sum(one is None for one in told["ordered"]) > 2
    matrix = homography(BOX, lens.straight(square))
    at = points[:, 0] + 1j * points[:, 1]
    seen = Shot(np.zeros((1, 1, 3), np.uint8), matrix, lens, Curl(BOX)).to_picture(at)
    assert np.allclose(told["matrix"], homography(BOX, square).ravel(), rtol=1e-12, atol=1e-12)
    assert np.allclose(told["straight"], photographs.pairs(lens.straight(at)), atol=1e-9)
    assert np.allclose(told["seen"], photographs.pairs(seen), atol=1e-7)
    assert np.allclose(told["back"], points, atol=1e-5)


FLAT = """
import { Flattening } from "./own/flatten.js";
import { Shot } from "./own/shot.js";
const bytes = readFileSync(files[0]);
const data = new Uint8ClampedArray(bytes.buffer, bytes.byteOffset, bytes.length);
const shot = new Shot(asked.box, asked.corners, asked.lens);
const flat = new Flattening({ ...asked.size, data }, shot, asked.area, asked.dots);
while (!flat.done) flat.step();
const grey = [...flat.data.filter((_, k) => k % 4 === 1)];
tell({ width: flat.width, height: flat.height, share: flat.share, grey });
"""


def test_the_flat_picture_is_the_check_s(tmp_path: Path) -> None:
    random = np.random.default_rng(3)
    rough = random.integers(60, 250, (30, 40), dtype=np.uint8)
    image = np.asarray(Image.fromarray(rough).resize((400, 300), Image.Resampling.BICUBIC))
    colours = np.dstack([image, 255 - image, image // 2])
    corners = np.array([40 + 280j, 370 + 250j, 330 + 40j, 70 + 20j])
    lens, box, area = Lens(199.5 + 149.5j, 200.0, 0.03), (0, 0, 90, 60), (-10, -10, 101, 71)
    Image.fromarray(colours).save(tmp_path / "photo.png")
    file = tmp_path / "photo.raw"
    file.write_bytes(rgba(colours))
    told = run(
        FLAT,
        {
            "box": box,
            "corners": photographs.pairs(corners).tolist(),
            "lens": {"x": 199.5, "y": 149.5, "radius": 200.0, "share": 0.03},
            "size": {"width": 400, "height": 300},
            "area": area,
            "dots": 2.0,
        },
        file,
    )
    shot = Shot(colours, homography(Box(*box), lens.straight(corners)), lens, Curl(Box(*box)))
    x = area[0] + (np.arange(told["width"]) + 0.5) / 2
    y = area[3] - (np.arange(told["height"]) + 0.5) / 2
    due = bilinear(colours, shot.to_picture(x + 1j * y[:, None]))[..., 1]
    found = np.array(told["grey"], dtype=np.float64).reshape(due.shape)
    inner = np.isfinite(due)
    # places between those of the grid, 16 dots apart, lie on a line: here, of 90 mm on 220 dots, 0.1 px off
    off = abs(found - due)[inner & (found < 255)]
    assert off.mean() < 2.0
    assert np.quantile(off, 0.99) < 8.0
    assert (found[~inner] == 255).mean() > 0.97
    assert (inner & (found < 255)).mean() > 0.5
    assert ((found < 255) | ~inner).mean() > 0.97
    assert told["share"] == 1
