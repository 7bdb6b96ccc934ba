"""Bodies of turning pictures laid where their moves bring them, by shapely: no code of the page moves them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import shapely
from shapely import affinity

from graphic_tmm.page.turning import RigidBody, Rotation, TurningPicture, turning_pictures
from graphic_tmm.paper.drawing import Bezier, Ink, Stroke
from graphic_tmm.scene.read import read
from support.boards import in_usual_size
from support.scenes import written

JOINED = 1e-3
"""Lines that end so near to one another go on, mm."""
FINE = np.linspace(0.0, 1.0, 65)[:, None]
"""Shares of an arc at which its points are taken; of a cubic one, which is short, of every eighth."""


def picture(folder: Path, text: str) -> TurningPicture:
    """Return the one picture of a scene that turns; of a file, or as its text says."""
    path = Path(text) if "\n" not in text else written(folder, text)
    (found,) = turning_pictures(in_usual_size(read(path), exact=True))
    return found


def points(stroke: Ink) -> np.ndarray:
    """Return points of a stroke, (n, 2)."""
    if isinstance(stroke, Bezier):
        z = np.array(stroke.controls)
        a, b, c, d = z[:-1:3], z[1::3], z[2::3], z[3::3]
        t, s = FINE[::8], 1.0 - FINE[::8]
        found = (s**3 * a + 3 * s * s * t * b + 3 * s * t * t * c + t**3 * d).T.ravel()
        return np.column_stack([found.real, found.imag])
    assert isinstance(stroke, Stroke)
    spots = [complex(x, y) for x, y, _ in stroke.path]
    bulges = [bulge for _, _, bulge in stroke.path]
    if stroke.closed:
        spots.append(spots[0])
    found = [spots[:1]]
    for start, end, bulge in zip(spots, spots[1:], bulges, strict=False):
        if not bulge:
            found.append([end])
            continue
        half = 2.0 * np.arctan(bulge)
        centre = (start + end) / 2 + (end - start) * 0.5j / np.tan(half)
        found.append(centre + (start - centre) * np.exp(2j * half * FINE[1:, 0]))
    all_ = np.concatenate(found)
    return np.column_stack([all_.real, all_.imag])


def laid(
    body: RigidBody, turn: float, *pens: str, part: str | None = None
) -> shapely.MultiLineString:
    """Return the strokes of a body (of some pens, of a part) with its copies, moved as it says."""
    own = shapely.MultiLineString(
        [
            points(stroke)
            for stroke in body.strokes
            if (not pens or stroke.pen in pens) and part in (None, stroke.part)
        ]
    )
    at = (body.centre.real, body.centre.imag)
    copies = [affinity.rotate(own, 360.0 * k / body.copies, origin=at) for k in range(body.copies)]
    return moved(
        shapely.MultiLineString([line for one in copies for line in one.geoms]), body, turn
    )


def moved(shape: shapely.Geometry, body: RigidBody, turn: float) -> shapely.Geometry:
    """Return a shape of a body moved as that says."""
    for move in body.moves:
        far = move[1]
        if isinstance(far, tuple):
            far = np.interp(turn % 360.0, np.arange(361), np.append(far, far[0]))
        else:
            far = far * turn
        if isinstance(move, Rotation):
            shape = affinity.rotate(shape, far, origin=(move.centre.real, move.centre.imag))
        else:
            way = move.direction * far
            shape = affinity.translate(shape, way.real, way.imag)
    return shape


def inside(lines: shapely.MultiLineString) -> shapely.Polygon:
    """Return what lines go once round: each goes on where the one before it ends."""
    left = [np.array(line.coords) for line in lines.geoms]
    chain = [left.pop()]
    while left:
        ends = np.array([[line[0], line[-1]] for line in left])
        gaps = np.linalg.norm(ends - chain[-1][-1], axis=2)
        k, end = np.unravel_index(gaps.argmin(), gaps.shape)
        assert gaps[k, end] < JOINED
        line = left.pop(int(k))
        chain.append(line[::-1] if end else line)
    assert np.linalg.norm(chain[-1][-1] - chain[0][0]) < JOINED
    found = shapely.Polygon(np.concatenate([line[:-1] for line in chain]))
    assert found.is_valid
    return found
