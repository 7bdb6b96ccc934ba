"""Which four long lines may be the frame of a sheet: tried on what is ruled on it."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.camera import Lens
from graphic_tmm.checking.photo.long_lines import Lines, Small, opencv
from graphic_tmm.checking.photo.perspective import cross, homography, vertices
from graphic_tmm.paper.drawing import Drawing, Sheet, Stroke
from graphic_tmm.paper.ruled import Box
from graphic_tmm.paper.sheet_frame import NAME, drawing_area

SHORTEST = 4.0
"""mm: shorter lines of a title block tell nothing."""
EDGE = 1.0
"""mm: what is ruled nearer to the edge of the paper is where it is cut."""


class Ruled(NamedTuple):
    """What is ruled on an empty sheet, mm: its ``frame``, the ``paper``, lines (n, 2) beside the frame's."""

    frame: Box
    paper: Box
    lines: Complexes


def ruled(sheet: Sheet, first: bool) -> Ruled:
    """Return what is ruled on a sheet, the ``first`` of its scene or a further one."""
    frame = drawing_area(sheet.format, sheet.language, first).inner
    paper = Box(0.0, 0.0, sheet.width, sheet.height)
    found = [
        line
        for drawing in sheet.drawings
        if drawing.name == NAME
        for line in _lines(drawing)
        if abs(line[1] - line[0]) >= SHORTEST
        and not _cut(line, paper)
        and not any(_upon(line, *side) for side in _sides(frame))
    ]
    return Ruled(frame, paper, np.array(found, np.complex128).reshape(-1, 2))


def _lines(drawing: Drawing) -> Iterator[tuple[complex, complex]]:
    for stroke in drawing.strokes:
        if isinstance(stroke, Stroke):
            points = [complex(x, y) for x, y, _ in stroke.path]
            yield from pairwise([*points, points[0]] if stroke.closed else points)


def _sides(box: Box) -> Iterator[tuple[complex, complex]]:
    corners = [complex(x, y) for x in (box.left, box.right) for y in (box.bottom, box.top)]
    for one, two in ((0, 1), (0, 2), (1, 3), (2, 3)):
        yield corners[one], corners[two]


def _cut(line: tuple[complex, complex], paper: Box) -> bool:
    """Whether a line is where the paper is cut, or without it."""
    return any(
        z.real < paper.left + EDGE
        or z.real > paper.right - EDGE
        or z.imag < paper.bottom + EDGE
        or z.imag > paper.top - EDGE
        for z in line
    )


def _upon(line: tuple[complex, complex], foot: complex, head: complex) -> bool:
    """Whether a line lies upon another."""
    way = (head - foot) / abs(head - foot)
    return all(abs(((z - foot) / way).imag) < 1e-6 for z in line)


SIDES = 16
"""So many of the longest lines that lie, and of those that stand, are combined."""

LEAST = 0.15
"""A frame covers this share of the photograph at least."""

OUTSIDE = 0.03
"""How far a corner may be beyond the photograph's edge, as a share of its side: of the paper, not the frame."""

SQUARE = 0.35
"""Sides of a rectangle seen by a usual camera are square, and as long as they should be, within this (as a
cosine, and as the logarithm of a quotient): cameras are other than the usual by a half."""

USUAL = 1.5
"""Of a camera: from its lens to its image, half lengths of this (a telephone's, 27 mm of 36)."""

KEPT = 400
"""So many guesses are looked at for such as differ."""

BLOCK = 512
"""So many quadrilaterals are tried at a time."""

STEP = 3.0
"""mm from one place that is tried to the next along what is ruled."""

FINE = 16
"""Dots between two places for which the lens is asked; between them it is linear to a hundredth of a dot."""

CLEAR = 30.0
"""Of 255: what is darker than its surroundings by so much is a line for sure; a paler one counts as less."""


class Guess(NamedTuple):
    """Where the frame's corners may be: (4,), px, as `vertices` go; how well what is ruled is seen, 0 … 1."""

    corners: Complexes
    score: float


def guesses(small: Small, lines: Lines, ruled: Ruled, reach: float) -> list[Guess]:
    """Return where the frame may be, the likeliest first, in the picture of darkness as its lens shows it."""
    plain = _plain(small.dark, lines.lens, reach)
    quads = _quadrilaterals(lines, small.dark.shape)
    turned = np.concatenate([np.roll(quads, turn, axis=1) for turn in range(4)])
    matrices = homography(ruled.frame, turned.T)
    likely = _rectangular(matrices, lines.lens)
    turned, matrices = turned[likely], matrices[likely]
    places = _places(ruled)
    scores = np.concatenate(
        [np.zeros(0)]
        + [
            _level(plain, _through(matrices[k : k + BLOCK], places)).mean(axis=1)
            for k in range(0, len(matrices), BLOCK)
        ]
    )
    best = np.argsort(-scores, kind="stable")[:KEPT]
    return [Guess(lines.lens.seen(turned[k]), float(scores[k])) for k in best]


def _through(matrices: Reals, points: Complexes) -> Complexes:
    """Return where points (m,) are seen by projections (n, 3, 3): (n, m); far outside where they are not."""
    x, y = points.real.astype(np.float32), points.imag.astype(np.float32)
    rows = [
        part[:, :1] * x + part[:, 1:2] * y + part[:, 2:]
        for part in np.moveaxis(matrices.astype(np.float32), 1, 0)
    ]
    deep = np.where(rows[2] > 0, rows[2], np.float32(np.inf))
    found: Complexes = (rows[0] + 1j * rows[1]) / deep
    return found


def _plain(dark: NDArray[np.uint8], lens: Lens, reach: float) -> Reals:
    """Return how dark it is within ``reach`` of every dot, 0 … 1, without the lens."""
    cv2 = opencv()
    wide = 2 * max(round(reach), 1) + 1
    grown = cv2.dilate(
        cv2.GaussianBlur(dark, (0, 0), 0.7),
        cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (wide, wide)),
    )
    if lens.share:
        grown = cv2.remap(grown, *_unbent(cv2, dark.shape, lens), cv2.INTER_LINEAR)
    usual = float(np.median(grown))
    found: Reals = np.clip((grown.astype(np.float32) - usual) / CLEAR, 0.0, 1.0)
    return found


def _unbent(cv2: Any, shape: tuple[int, ...], lens: Lens) -> tuple[Any, Any]:
    """Return where every dot of a picture without its lens is seen: x and y, rows × columns."""
    rows, columns = shape[:2]
    x = np.linspace(0, columns - 1, columns // FINE + 2)
    y = np.linspace(0, rows - 1, rows // FINE + 2)
    seen = lens.seen(x + 1j * y[:, None])
    seen = np.where(np.isfinite(seen), seen, -1)
    # cv2.resize sees dots as squares: the outermost nodes would be half a node too far out
    across = np.interp(np.arange(columns), x, np.arange(x.size)).astype(np.float32)
    down = np.interp(np.arange(rows), y, np.arange(y.size)).astype(np.float32)
    nodes = (
        np.broadcast_to(across, (rows, columns)),
        np.broadcast_to(down[:, None], (rows, columns)),
    )
    found = [
        cv2.remap(part.astype(np.float32), *map(np.ascontiguousarray, nodes), cv2.INTER_LINEAR)
        for part in (seen.real, seen.imag)
    ]
    return found[0], found[1]


def _quadrilaterals(lines: Lines, shape: tuple[int, ...]) -> Complexes:
    """Return quadrilaterals (n, 4) of two lines and two across them, round about as `vertices` go."""
    if not len(lines.seen):
        return np.zeros((0, 4), np.complex128)
    way = lines.heads - lines.feet
    turn = np.angle((way / way[int(np.argmax(lines.seen))]) ** 2) / 2
    order = np.argsort(-lines.seen, kind="stable")
    lying = [k for k in order if abs(turn[k]) < np.pi / 4][:SIDES]
    standing = [k for k in order if abs(turn[k]) >= np.pi / 4][:SIDES]
    one = np.array(list(itertools.combinations(lying, 2)), np.intp).reshape(-1, 2)
    two = np.array(list(itertools.combinations(standing, 2)), np.intp).reshape(-1, 2)
    a, b = np.repeat(one, len(two), axis=0), np.tile(two, (len(one), 1))
    met = [_met(lines, a[:, i], b[:, j]) for i, j in ((0, 0), (0, 1), (1, 1), (1, 0))]
    quads = np.stack(met, axis=1)
    rows, columns = shape[:2]
    x, y = quads.real, quads.imag
    within = (abs(x / columns - 0.5) < 0.5 + OUTSIDE) & (abs(y / rows - 0.5) < 0.5 + OUTSIDE)
    quads = quads[within.all(axis=1)]
    around = np.roll(quads, -1, axis=1) - quads
    corner = cross(around, np.roll(around, -1, axis=1))
    area = cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1]) / 2
    # y is downward: as `vertices` go round, areas are negative in these numbers
    quads = np.where((area > 0)[:, None], quads[:, ::-1], quads)
    convex = (corner > 0).all(axis=1) | (corner < 0).all(axis=1)
    found: Complexes = quads[convex & (abs(area) > LEAST * rows * columns)]
    return found


def _met(lines: Lines, one: NDArray[np.intp], two: NDArray[np.intp]) -> Complexes:
    """Return where lines meet; NaN where they do not."""
    start, way = lines.feet[one], lines.heads[one] - lines.feet[one]
    other = lines.heads[two] - lines.feet[two]
    whole = cross(way, other)
    along = cross(lines.feet[two] - start, other) / np.where(whole == 0, np.nan, whole)
    return np.asarray(start + way * along, np.complex128)


def _between(quads: Complexes, count: int) -> Complexes:
    """Return places along the four sides of quadrilaterals, (n, 4 × count)."""
    share = (np.arange(count) + 0.5) / count
    sides = quads[..., None] + (np.roll(quads, -1, axis=1) - quads)[..., None] * share
    found: Complexes = sides.reshape(len(quads), -1)
    return found


def _level(plain: Reals, seen: Complexes) -> Reals:
    """Return the darkness at places, 0 outside."""
    rows, columns = plain.shape
    seen = np.where(np.isfinite(seen), seen, -9)
    x, y = np.rint(seen.real).astype(int), np.rint(seen.imag).astype(int)
    on = (x >= 0) & (x < columns) & (y >= 0) & (y < rows)
    found: Reals = np.where(on, plain[np.where(on, y, 0), np.where(on, x, 0)], 0.0)
    return found


def _places(ruled: Ruled) -> Complexes:
    """Return places along what is ruled on a sheet, mm: the frame as often as all the rest."""
    feet = vertices(ruled.frame)
    count = 0
    found = []
    for foot, head in ruled.lines:
        steps = max(int(abs(head - foot) / STEP), 1)
        found.append(foot + (head - foot) * (np.arange(steps) + 0.5) / steps)
        count += steps
    sides = _between(feet[None], max(count // 4, 40))[0]
    return np.concatenate([sides, *found])


def _rectangular(matrices: Reals, lens: Lens) -> NDArray[np.bool_]:
    """Whether projections show mm of both directions square and alike, by a usual camera."""
    half = max(abs(lens.middle.real), abs(lens.middle.imag)) * USUAL
    deep = matrices[:, 2]
    x = (matrices[:, 0] - lens.middle.real * deep) / half
    y = (matrices[:, 1] - lens.middle.imag * deep) / half
    one, two = np.moveaxis(np.stack([x, y, deep], axis=1)[:, :, :2], 2, 0)
    long, high = np.linalg.norm(one, axis=1), np.linalg.norm(two, axis=1)
    skew = abs((one * two).sum(axis=1)) / (long * high)
    alike: NDArray[np.bool_] = (skew < SQUARE) & (abs(np.log(long / high)) < SQUARE)
    return alike
