"""A photograph of a hand-made sheet, its perspective removed, at true millimetres.

A drawing frame is a rectangle of known size: its four corners fix the projection of the sheet into the
photograph. The corners are clicked, or found by what is ruled on the sheet, and refined to the frame's lines;
how the lens bows these is taken out, and how straight they then are tells whether the sheet was flat. Needs
Pillow, and OpenCV where nobody clicks (extra ``photo``).
"""

from __future__ import annotations

import io
import math
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.camera import Curl, Lens, Shot, pinhole
from graphic_tmm.checking.photo.frame_lines import REACH, Lines, refine
from graphic_tmm.checking.photo.frame_search import frame_found
from graphic_tmm.checking.photo.perspective import (
    Corners,
    colours_at,
    cross,
    homography,
    ordered,
    through,
    vertices,
)
from graphic_tmm.checking.photo.picture import MOST, Sent, pillow, read_photo
from graphic_tmm.checking.photo.quadrilaterals import Ruled
from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import joined, said
from graphic_tmm.paper.ruled import Box

BENT = 0.5
"""A frame farther than this from straight is bent, mm: two such lines put their corner 0.7 mm off."""

BOWED = 2.0
"""A lens that bows the frame farther is told of, mm: of such a lens one number tells too little."""

BLOCK = 1 << 15
"""So many pixels are sampled at a time: what is reckoned of them stays near the processor."""

PRESSED = 3
"""How far a PNG is compressed, of 9: grain yields little. It is 5 % larger than by the usual 6, three times as
soon."""

PAPER = 255
"""The grey of what the photograph does not show."""


class Photo(NamedTuple):
    """A sheet seen straight from above.

    ``image`` (rows, columns, 3): colours 0 ... 255, the uppermost row first; ``area``: the rectangle of
    the sheet that it fills, mm; ``corners`` (4,): the frame's corners in the photograph, px, lower left,
    lower right, upper right, upper left; ``homography`` (3, 3): from the sheet, mm, y upward, into the
    photograph of a pinhole, px, y downward; ``lens``: from there into this one; ``curl``: what the sheet
    is beside the plane of its corners; ``residual``: how far the frame's lines are from straight without
    the lens, mm, NaN if no line was found; ``warnings``: what makes the picture doubtful.
    """

    image: NDArray[np.uint8]
    area: Box
    corners: Complexes
    homography: Reals
    lens: Lens
    curl: Curl
    residual: float
    warnings: tuple[str, ...]


def flatten(
    photo: str | Path | Sent | NDArray[np.uint8],
    corners: Corners | Ruled,
    frame: tuple[float, float, float, float],
    *,
    dots_per_mm: float = 4.0,
    area: tuple[float, float, float, float] | None = None,
    refined: bool = True,
) -> Photo:
    """Return the photograph in a file, one that was sent or that was read, without its perspective.

    ``corners`` (4, 2): where the frame's corners are seen, x and y in pixels from the centre of the
    first, y downward, in any order, the photograph upright as a viewer shows it; or what is ruled on the sheet:
    then the frame is found, the sheet either way up. ``frame``: left, bottom,
    right and top of the frame on the sheet, mm (from the paper's lower left corner, y upward).
    ``area``: what of the sheet is wanted, mm; if left out the whole paper, whose right and upper margins
    are as wide as the lower one. ``refined=False`` leaves the corners where they were given.

    Raises
    ------
    SheetError
        If Pillow is missing, the file is no photograph of at most 100 megapixels or is damaged, the
        corners are not four corners of a convex quadrilateral within it, no frame is found or it is not
        sure which it is, the rectangles are empty, or the picture wanted has no dots or more than 100 million.
    """
    box = _rectangle("frame", frame)
    wanted = _rectangle("area", area) if area is not None else _paper(box)
    whole, rows, columns = _raster(wanted, dots_per_mm)
    known = isinstance(corners, Ruled)
    clicked = vertices(box) if isinstance(corners, Ruled) else ordered(corners)
    image = photo if isinstance(photo, np.ndarray) else read_photo(photo)
    found: Lines | None = None
    if isinstance(corners, Ruled):
        found = frame_found(image, corners).lines
    else:
        _within(clicked, image)
        found = refine(image, box, clicked) if refined else None
    marks = clicked if found is None else found.corners
    lens = pinhole(image) if found is None else found.lens
    curl = Curl(box) if found is None else found.curl
    matrix = homography(box, lens.straight(marks))
    notes = [] if known else [_turned(box, marks)]
    if found is not None:
        notes += [_missing(found.missing), _bowed(found.bowed), _bent(found.residual)]
    return Photo(
        _unbent(_coarser(Shot(image, matrix, lens, curl), dots_per_mm), whole, rows, columns),
        whole,
        marks,
        matrix,
        lens,
        curl,
        math.nan if found is None else found.residual,
        tuple(note for note in notes if note),
    )


def png(photo: Photo) -> bytes:
    """Return a flattened photograph as PNG whose dots are as many to the metre as they are on the sheet."""
    images = pillow()[0]
    dots = photo.image.shape[1] / (photo.area.right - photo.area.left)
    made = io.BytesIO()
    images.fromarray(photo.image).save(
        made, "PNG", dpi=(25.4 * dots, 25.4 * dots), compress_level=PRESSED
    )
    return made.getvalue()


def _rectangle(name: str, given: tuple[float, float, float, float]) -> Box:
    """Return a rectangle of finite numbers that is not empty."""
    try:
        box = Box(*(float(side) for side in given))
    except (TypeError, ValueError):
        box = Box(0.0, 0.0, 0.0, 0.0)
    if not (all(map(math.isfinite, box)) and box.left < box.right and box.bottom < box.top):
        raise SheetError(
            said(
                "{name}: left, bottom, right and top in mm make no rectangle: {given}",
                name=name,
                given=given,
            )
        )
    return box


def _paper(frame: Box) -> Box:
    """Return the paper about a frame: the binding margin is on the left, the others are alike."""
    return Box(0.0, 0.0, frame.right + frame.bottom, frame.top + frame.bottom)


def _raster(area: Box, dots: float) -> tuple[Box, int, int]:
    """Return the area grown to whole dots to the right and downward, its rows and columns."""
    if not (math.isfinite(dots) and dots > 0):
        raise SheetError(said("dots per mm: {dots} is no positive number", dots=dots))
    width, height = (area.right - area.left) * dots, (area.top - area.bottom) * dots
    if width * height > MOST:
        raise SheetError(
            said("dots per mm: {dots:g} gives more than 100 million dots: choose fewer", dots=dots)
        )
    columns, rows = max(math.ceil(width - 1e-6), 1), max(math.ceil(height - 1e-6), 1)
    grown = area._replace(right=area.left + columns / dots, bottom=area.top - rows / dots)
    return grown, rows, columns


def _within(corners: Complexes, image: NDArray[np.uint8]) -> None:
    rows, columns = image.shape[:2]
    x, y = corners.real, corners.imag
    if not ((x > -0.5) & (x < columns - 0.5) & (y > -0.5) & (y < rows - 0.5)).all():
        raise SheetError(
            said(
                "corners: one lies outside the photograph of {columns} × {rows} pixels",
                columns=columns,
                rows=rows,
            )
        )


def _turned(frame: Box, corners: Complexes) -> str:
    """Return a warning if the quadrilateral is rather the frame turned by a quarter."""
    sides = abs(np.roll(corners, -1) - corners)
    seen = math.log((sides[0] + sides[2]) / (sides[1] + sides[3]))
    drawn = math.log((frame.right - frame.left) / (frame.top - frame.bottom))
    if abs(seen - drawn) <= abs(seen + drawn):
        return ""
    return said(
        "the frame looks turned by a quarter in the photograph: turn the photograph upright"
    )


def _missing(edges: tuple[str, ...]) -> str:
    if not edges:
        return ""
    return said(
        "no line of the frame within {reach:g} mm of the corners given at its {edges} "
        "edge: there they are used as given, click them with care",
        reach=REACH,
        edges=joined(", ", edges),
    )


def _bowed(bowed: float) -> str:
    if not bowed > BOWED:
        return ""
    return said(
        "the lens bows the frame by {bowed:.1f} mm (more than {most:g} mm): that is taken out, but take the "
        "photograph from farther away, without wide angle",
        bowed=bowed,
        most=BOWED,
    )


def _bent(residual: float) -> str:
    if not residual > BENT:
        return ""
    return said(
        "the frame is bent by {residual:.1f} mm (more than {most:g} mm) even without the lens: the sheet is "
        "not flat: take the photograph anew, the sheet pressed flat",
        residual=residual,
        most=BENT,
    )


def _coarser(shot: Shot, dots: float) -> Shot:
    """Return a photograph with several dots to one of the picture as their means, its projection, its lens."""
    frame = shot.curl.box
    corners = through(shot.matrix, vertices(frame))
    seen = abs(cross(corners[2] - corners[0], corners[3] - corners[1])) / 2
    drawn = (frame.right - frame.left) * (frame.top - frame.bottom)
    factor = int(math.sqrt(seen / drawn) / dots)
    if factor < 2:
        return shot
    reduced = np.asarray(pillow()[0].fromarray(shot.image).reduce(factor), dtype=np.uint8)
    half = 0.5 / factor - 0.5
    moved = np.array([[1 / factor, 0, half], [0, 1 / factor, half], [0, 0, 1.0]])
    return Shot(reduced, moved @ shot.matrix, shot.lens.reduced(factor), shot.curl)


def _unbent(shot: Shot, area: Box, rows: int, columns: int) -> NDArray[np.uint8]:
    """Return the ``area`` (mm) of the sheet on ``rows`` × ``columns`` dots, sampled in blocks."""
    side = (area.right - area.left) / columns
    across = area.left + side * (np.arange(columns) + 0.5)
    down = area.top - side * (np.arange(rows) + 0.5)
    made = np.empty((rows, columns, 3), dtype=np.uint8)
    block = max(BLOCK // columns, 1)
    for first in range(0, rows, block):
        points = across + 1j * down[first : first + block, None]
        for k, seen in enumerate(colours_at(shot.image, shot.to_picture(points))):
            made[first : first + block, :, k] = np.where(np.isnan(seen), PAPER, np.rint(seen))
    return made
