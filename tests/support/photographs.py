"""Photographs made by a camera of known place: a sheet drawn on dots, seen dot by dot through a pinhole.

Nothing is shared with the package: the camera is K [r1 r2 t], a dot of the photograph the mean of four
rays, each a dot of the sheet; then shade, noise of the sensor and JPEG.
"""

from __future__ import annotations

import functools
import io
from typing import NamedTuple

import numpy as np
from PIL import Image

DOTS = 8
"""Dots of the drawn sheet to the mm."""
WIDTH, HEIGHT = 841.0, 594.0
FRAME = (20.0, 5.0, 836.0, 589.0)
CORNERS = np.array([20 + 5j, 836 + 5j, 836 + 589j, 20 + 589j])
TARGETS = np.array(
    [x + 1j * y for x in (60, 180, 300, 420, 540, 640, 780) for y in (90, 180, 300, 420, 540)]
)
RADIUS = 1.5
PAPER, INK, TABLE = 235.0, 40.0, 70.0


class Camera(NamedTuple):
    """``tilt``: about the photograph's x, y and z axes, degrees; ``far``: distance, mm; ``focal``, px.

    ``lens``: radial distortion at the half width of the photograph, as a share; ``sag``: how far the sheet
    lies off its table where it is farthest, mm: curled about its upright middle line, or a ``dome``;
    ``middle``: the point of the sheet that the camera looks at, mm; ``size``: of the sheet, mm.
    """

    tilt: tuple[float, float, float] = (0.0, 0.0, 0.0)
    far: float = 1000.0
    focal: float = 2000.0
    columns: int = 2000
    rows: int = 1500
    lens: float = 0.0
    sag: float = 0.0
    dome: bool = False
    middle: tuple[float, float] = (WIDTH / 2, HEIGHT / 2)
    size: tuple[float, float] = (WIDTH, HEIGHT)

    @property
    def turn(self) -> np.ndarray:
        """From the sheet's axes to the camera's."""
        a, b, c = np.radians(self.tilt)
        about_x = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
        about_y = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
        about_z = np.array([[np.cos(c), -np.sin(c), 0], [np.sin(c), np.cos(c), 0], [0, 0, 1]])
        return about_z @ about_y @ about_x @ np.diag([1.0, -1.0, -1.0])

    @property
    def place(self) -> np.ndarray:
        """Where the sheet's origin is, by the camera's axes, mm."""
        return np.array([0, 0, self.far]) - self.turn @ np.array([*self.middle, 0])

    @property
    def matrix(self) -> np.ndarray:
        """From the sheet (mm, y upward) to the ideal photograph (px, y downward)."""
        inner = np.array(
            [
                [self.focal, 0, (self.columns - 1) / 2],
                [0, self.focal, (self.rows - 1) / 2],
                [0, 0, 1],
            ]
        )
        return inner @ np.column_stack([self.turn[:, 0], self.turn[:, 1], self.place])

    def _lifted(self, points: np.ndarray) -> np.ndarray:
        """From points of the sheet to those of the table that they hide, mm."""
        across, up = 2 * points.real / self.size[0] - 1, 2 * points.imag / self.size[1] - 1
        high = self.sag * (1 - across**2) * ((1 - up**2) if self.dome else 1)
        x, y, above = -self.turn.T @ self.place
        return (points - complex(x, y)) * high / (above - high)

    def table(self, seen: np.ndarray) -> np.ndarray:
        """Which points of the sheet are seen at places of the photograph."""
        plane = project(np.linalg.inv(self.matrix), self.ideal(seen))
        found = plane
        for _ in range(4 if self.sag else 0):
            found = plane - self._lifted(found)
        return found

    def _middle(self) -> complex:
        return complex((self.columns - 1) / 2, (self.rows - 1) / 2)

    def ideal(self, seen: np.ndarray) -> np.ndarray:
        """Where the ray of a dot would be seen without the lens."""
        off = seen - self._middle()
        return self._middle() + off * (1 + self.lens * abs(off / (self.columns / 2)) ** 2)

    def seen(self, points: np.ndarray) -> np.ndarray:
        """Where points of the sheet (complex mm) are seen in the photograph (complex px)."""
        sharp = project(self.matrix, points + self._lifted(points))
        found = sharp
        for _ in range(60):
            found = found - (self.ideal(found) - sharp)
        return found


def project(matrix: np.ndarray, points: np.ndarray) -> np.ndarray:
    x, y, w = matrix @ np.stack([points.real, points.imag, np.ones_like(points.real)]).reshape(
        3, -1
    )
    return ((x + 1j * y) / w).reshape(points.shape)


def rule(sheet: np.ndarray, left: float, bottom: float, right: float, top: float) -> None:
    """Ink a rectangle (mm): a dot covered in part takes a part of the ink."""

    def covered(low: float, high: float, count: int) -> np.ndarray:
        at = np.arange(count) / DOTS
        return np.clip(np.minimum(high, at + 1 / DOTS) - np.maximum(low, at), 0, None) * DOTS

    rows = slice(max(int(bottom * DOTS) - 1, 0), int(top * DOTS) + 2)
    columns = slice(max(int(left * DOTS) - 1, 0), int(right * DOTS) + 2)
    part = (
        covered(bottom, top, sheet.shape[0])[rows, None]
        * covered(left, right, sheet.shape[1])[columns]
    )
    sheet[rows, columns] += (INK - sheet[rows, columns]) * part


def box(
    sheet: np.ndarray, left: float, bottom: float, right: float, top: float, wide: float
) -> None:
    half = wide / 2
    rule(sheet, left - half, bottom - half, right + half, bottom + half)
    rule(sheet, left - half, top - half, right + half, top + half)
    rule(sheet, left - half, bottom + half, left + half, top - half)
    rule(sheet, right - half, bottom + half, right + half, top - half)


@functools.cache
def sheet(frame_width: float = 0.8, ink: bool = True) -> np.ndarray:
    """An A1 sheet on dots, the lowest row first: frame, title block, margin boxes, discs at TARGETS."""
    made = np.full((int(HEIGHT * DOTS), int(WIDTH * DOTS)), PAPER, dtype=np.float32)
    if not ink:
        return made
    box(made, 0.15, 0.15, WIDTH - 0.15, HEIGHT - 0.15, 0.27)
    box(made, *FRAME, frame_width)
    for k in range(1, 12):  # the title block, form 1, its rows 5 mm apart
        wide = 0.8 if k in (1, 6, 8, 11) else 0.27
        rule(made, 651, 5 + 5 * k - wide / 2, 716 if k < 11 else 836, 5 + 5 * k + wide / 2)
    for x in (651, 658, 668, 691, 706, 716, 786):
        rule(made, x - 0.4, 5, x + 0.4, 60)
    for y in (30, 65, 90, 115, 150, 250, 310):  # the boxes of the binding margin
        rule(made, 8, y - 0.4, 20, y + 0.4)
    rule(made, 90 - 0.4, 575, 90 + 0.4, 589)  # column 26
    rule(made, 20, 575 - 0.4, 90, 575 + 0.4)
    for z in TARGETS:
        x, y = int((z.real - 3) * DOTS), int((z.imag - 3) * DOTS)
        side = np.arange(6 * DOTS + 1)
        far = abs(
            (x + side + 0.5) / DOTS - z.real + 1j * ((y + side[:, None] + 0.5) / DOTS - z.imag)
        )
        part = np.clip((RADIUS - far) * DOTS + 0.5, 0, 1)
        patch = made[y : y + side.size, x : x + side.size]
        patch += (INK - patch) * part
    return made


def photograph(
    camera: Camera, drawn: np.ndarray, *, shade: float = 0.5, noise: float = 4.0, seed: int = 1
) -> np.ndarray:
    """The photograph (rows, columns, 3): a lamp falls off to ``shade`` across it, noise of the sensor."""
    random = np.random.default_rng(seed)
    made = np.empty((camera.rows, camera.columns), dtype=np.float32)
    x = np.arange(camera.columns)
    for first in range(0, camera.rows, 100):
        y = np.arange(first, min(first + 100, camera.rows))[:, None]
        whole = np.zeros((y.size, x.size), dtype=np.float32)
        for dx, dy in ((-0.25, -0.25), (0.25, -0.25), (-0.25, 0.25), (0.25, 0.25)):
            # anywhere in its quarter: at fixed places the dots of sheet and photograph would beat
            aside = random.random((2, y.size, x.size), dtype=np.float32) / 2 - 0.25
            at = camera.table(x + dx + aside[0] + 1j * (y + dy + aside[1]))
            column, row = np.floor(at.real * DOTS), np.floor(at.imag * DOTS)
            on = (column >= 0) & (column < drawn.shape[1]) & (row >= 0) & (row < drawn.shape[0])
            j, i = np.where(on, column, 0).astype(int), np.where(on, row, 0).astype(int)
            whole += np.where(on, drawn[i, j], TABLE)
        made[first : first + y.size] = whole / 4
    across = (
        np.linspace(1, shade, camera.columns)
        * np.linspace(1, (1 + shade) / 2, camera.rows)[:, None]
    )
    colour = np.array([1.0, 0.97, 0.9])
    lit = (made * across)[..., None] * colour + random.normal(0, noise, (*made.shape, 3))
    return np.clip(np.rint(lit), 0, 255).astype(np.uint8)


def jpeg(image: np.ndarray, quality: int = 80) -> bytes:
    made = io.BytesIO()
    Image.fromarray(image).save(made, "JPEG", quality=quality)
    return made.getvalue()


def pairs(points: np.ndarray) -> np.ndarray:
    return np.stack([points.real, points.imag], axis=-1)


def found_discs(image: np.ndarray, dots: float, top: float = HEIGHT) -> np.ndarray:
    """Where the discs stand in a flattened sheet whose upper left corner is at (0, top): complex mm."""
    grey = image.mean(axis=2)
    found = []
    for z in TARGETS:
        column, row = int(z.real * dots), int((top - z.imag) * dots)
        half = int(4 * dots)
        patch = grey[row - half : row + half + 1, column - half : column + half + 1]
        dark = np.clip(np.median(patch) * 0.75 - patch, 0, None)
        i, j = np.indices(patch.shape)
        x, y = (dark * j).sum() / dark.sum(), (dark * i).sum() / dark.sum()
        found.append(complex((column - half + x + 0.5) / dots, top - (row - half + y + 0.5) / dots))
    return np.array(found)
