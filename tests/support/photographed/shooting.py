"""The camera in a hand: twelve megapixels of a sheet on a table, with shade, blur, grain and JPEG.

Dot by dot: the mean of four rays, each a dot of the sheet (`support.photographs.Camera`, K [r1 r2 t], a lens
of one number, a sheet that sags). What is on the paper beside pencil is seen here too: squares, stains.
"""

from __future__ import annotations

import io
from typing import NamedTuple

import numpy as np
from PIL import Image, ImageFilter

from support.photographed.pencil import DOTS
from support.photographs import Camera

RAYS = 4
BLOCK = 100
COARSE = 10
"""Rays are followed for every tenth dot: between them the sheet is seen straight to 0.001 mm."""
SQUARES = 5.0


class Light(NamedTuple):
    """How a photograph is lit and taken.

    ``fall``: how bright the darkest corner is, of the brightest; ``shadow``: how bright where a hand's shadow
    lies (1: none); ``warm``: of red to blue; ``noise``: of 255; ``blur``: dots; ``quality``: of the JPEG;
    ``table``: its grey; ``lead``: how dark graphite is at the most (0 … 1).
    """

    fall: float = 0.7
    shadow: float = 1.0
    warm: float = 1.05
    noise: float = 4.0
    blur: float = 0.8
    quality: int = 80
    table: float = 90.0
    lead: float = 0.8


class Marks(NamedTuple):
    """What is on the paper beside pencil: its squares (0: none; how dark), how many stains and smears."""

    squares: float = 0.0
    stains: int = 0
    smears: int = 0


class Sheets(NamedTuple):
    """A sheet on dots, the lowest row first: how far graphite and dirt cover it, 0 … 255."""

    lead: np.ndarray
    dirt: np.ndarray
    size: tuple[float, float]
    squares: float
    offset: complex


def soiled(lead: np.ndarray, size: tuple[float, float], marks: Marks, seed: int) -> Sheets:
    """Return a drawn sheet with what use leaves on it: pencil smeared by an eraser, rings, thumbs."""
    random = np.random.default_rng([seed, 77])
    lead = lead.copy()
    dirt = np.zeros(lead.shape, np.uint8)
    for _ in range(marks.smears):
        place, patch = _patch(lead, size, random, 14.0)
        y, x = place
        way = random.uniform(0, np.pi)
        u, v = x * np.cos(way) + y * np.sin(way), y * np.cos(way) - x * np.sin(way)
        soft = np.clip(1.6 - np.hypot(u / 12, v / 5) * 1.6, 0, 1)
        lead[patch] = (lead[patch] * (1 - random.uniform(0.2, 0.5) * soft)).astype(np.uint8)
        dirt[patch] = np.maximum(dirt[patch], (random.uniform(15, 40) * soft).astype(np.uint8))
    for _ in range(marks.stains):
        (y, x), patch = _patch(lead, size, random, 45.0)
        far = np.hypot(x, y * random.uniform(0.8, 1.2))
        if random.random() < 0.5:  # the ring of a cup
            most = random.uniform(25, 38)
            soft = np.exp(-(((far - most) / random.uniform(0.5, 2)) ** 2)) + 0.15 * (far < most)
        else:
            soft = np.clip(1.5 - far / random.uniform(4, 20), 0, 1)
        much = random.uniform(15, 60)
        dirt[patch] = np.maximum(dirt[patch], np.clip(much * soft, 0, 255).astype(np.uint8))
    return Sheets(lead, dirt, size, marks.squares, complex(*random.uniform(0, SQUARES, 2)))


def _patch(
    lead: np.ndarray, size: tuple[float, float], random: np.random.Generator, reach: float
) -> tuple[tuple[np.ndarray, np.ndarray], tuple[slice, slice]]:
    """Return places (y, x; mm from a random middle) and where on the sheet they are."""
    x, y = random.uniform(0, size[0]), random.uniform(0, size[1])
    rows = slice(max(int((y - reach) * DOTS), 0), min(int((y + reach) * DOTS), lead.shape[0]))
    columns = slice(max(int((x - reach) * DOTS), 0), min(int((x + reach) * DOTS), lead.shape[1]))
    up = (np.arange(rows.start, rows.stop) + 0.5)[:, None] / DOTS - y
    across = (np.arange(columns.start, columns.stop) + 0.5)[None, :] / DOTS - x
    return (up, across), (rows, columns)


def shot(camera: Camera, sheet: Sheets, light: Light, seed: int) -> np.ndarray:
    """Return the photograph (rows, columns, 3) as the sensor gives it, before JPEG."""
    random = np.random.default_rng([seed, 99])
    nodes = _nodes(camera)
    made = np.empty((camera.rows, camera.columns, 3), np.uint8)
    lamp = _lamp(camera, light, random)
    wood = _wood(camera, light, random)
    for first in range(0, camera.rows, BLOCK):
        rows = np.arange(first, min(first + BLOCK, camera.rows))
        seen = _seen(
            sheet, light, nodes, rows, camera.columns, wood[rows[0] : rows[-1] + 1], random
        )
        seen *= lamp(rows)[..., None]
        made[rows] = np.clip(seen, 0, 255).astype(np.uint8)
    blurred = np.asarray(Image.fromarray(made).filter(ImageFilter.GaussianBlur(light.blur)))
    grain = random.normal(0, 1, 1 << 22).astype(np.float32)
    whole = blurred.astype(np.float32)
    starts = random.integers(0, 1 << 21, camera.rows)
    for row, start in enumerate(starts):  # more where it is bright, as counted photons are
        part = grain[start : start + 3 * camera.columns].reshape(-1, 3)
        whole[row] += part * light.noise * np.sqrt(0.3 + whole[row] / 255)
    return np.clip(np.rint(whole), 0, 255).astype(np.uint8)


def jpeg(image: np.ndarray, quality: int) -> bytes:
    made = io.BytesIO()
    Image.fromarray(image).save(made, "JPEG", quality=quality)
    return made.getvalue()


def _nodes(camera: Camera) -> np.ndarray:
    """Return what is seen at every tenth dot, mm on the sheet (complex64)."""
    x = np.arange(-COARSE, camera.columns + 2 * COARSE, COARSE)
    y = np.arange(-COARSE, camera.rows + 2 * COARSE, COARSE)
    return camera.table(x + 1j * y[:, None]).astype(np.complex128)


def _between(nodes: np.ndarray, rows: np.ndarray, columns: int) -> np.ndarray:
    """Return what is seen at the dots of some rows."""
    at = rows / COARSE + 1
    k = at.astype(int)
    share = (at - k)[:, None]
    lines = nodes[k] * (1 - share) + nodes[k + 1] * share
    at = np.arange(columns) / COARSE + 1
    k = at.astype(int)
    share = at - k
    return (lines[:, k] * (1 - share) + lines[:, k + 1] * share).astype(np.complex64)


def _seen(
    sheet: Sheets,
    light: Light,
    nodes: np.ndarray,
    rows: np.ndarray,
    columns: int,
    wood: np.ndarray,
    random: np.random.Generator,
) -> np.ndarray:
    """Return the colours of some rows under an even light."""
    wide = np.concatenate([rows[:1] - 1, rows, rows[-1:] + 1])
    places = _between(nodes, wide, columns)
    down = (places[2:] - places[:-2]) / 2
    places = places[1:-1]
    along = np.gradient(places, axis=1)
    lead = np.zeros(places.shape, np.float32)
    dirt, lines, on = lead.copy(), lead.copy(), lead.copy()
    near = lead.copy()
    width, height = sheet.size
    for ray in range(RAYS):
        dx, dy = (ray % 2 - 0.5) / 2, (ray // 2 - 0.5) / 2
        aside = random.random((2, *places.shape), np.float32) / 2 - 0.25
        at = places + along * (dx + aside[0]) + down * (dy + aside[1])
        x, y = at.real, at.imag
        inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        column = np.where(inside, x * DOTS, 0).astype(np.int32)
        row = np.where(inside, y * DOTS, 0).astype(np.int32)
        column = np.minimum(column, sheet.lead.shape[1] - 1)
        row = np.minimum(row, sheet.lead.shape[0] - 1)
        flat = row * sheet.lead.shape[1] + column
        on += inside
        lead += inside * sheet.lead.ravel()[flat]
        dirt += inside * sheet.dirt.ravel()[flat]
        near += ~inside & (x > -1.5) & (x < width + 1.5) & (y > -2.5) & (y < height + 1.5)
        if sheet.squares:
            a = np.abs((x - sheet.offset.real) % SQUARES - SQUARES / 2)
            b = np.abs((y - sheet.offset.imag) % SQUARES - SQUARES / 2)
            lines += inside & (np.maximum(a, b) > SQUARES / 2 - 0.1)
    on, lead, dirt, lines = on / RAYS, lead / RAYS / 255, dirt / RAYS / 255, lines / RAYS
    paper = np.array([240.0, 238.0, 231.0], np.float32)
    ruled = 1 - sheet.squares * lines[..., None] * np.array([0.5, 0.35, 0.15], np.float32)
    brown = 1 - dirt[..., None] * np.array([0.5, 0.6, 0.8], np.float32)
    graphite = (1 - light.lead * lead)[..., None]
    beside = (wood * (1 - 0.35 * near / RAYS))[..., None] * np.array([1.0, 0.93, 0.82], np.float32)
    return on[..., None] * paper * ruled * brown * graphite + (1 - on)[..., None] * beside


def _lamp(camera: Camera, light: Light, random: np.random.Generator):
    """Return how bright the dots of some rows are lit: a lamp that falls off, a shadow with soft edges."""
    way = np.exp(1j * random.uniform(0, 2 * np.pi))
    middle = complex(*random.uniform(0.2, 0.8, 2))
    edge = np.exp(1j * random.uniform(0, 2 * np.pi))
    soft = random.uniform(0.01, 0.1)
    size = random.uniform(0.15, 0.4)
    colour = light.warm

    def lit(rows: np.ndarray) -> np.ndarray:
        x = np.arange(camera.columns, dtype=np.float32) / camera.columns
        y = (rows / camera.columns).astype(np.float32)[:, None]
        along = ((x - 0.5) * way.real + (y - 0.4) * way.imag + 0.7) / 1.4
        lamp = light.fall + (1 - light.fall) * np.clip(along, 0, 1)
        u = (x - middle.real) * edge.real + (y - middle.imag) * edge.imag
        v = (y - middle.imag) * edge.real - (x - middle.real) * edge.imag
        deep = 1 / (1 + np.exp(np.clip(np.maximum(abs(v) - size, -u) / soft, -30, 30)))
        return (lamp * (1 - (1 - light.shadow) * deep) * colour).astype(np.float32)

    return lit


def _wood(camera: Camera, light: Light, random: np.random.Generator) -> np.ndarray:
    """Return the grey of the table: boards with their grain."""
    x = np.arange(camera.columns, dtype=np.float32)
    y = np.arange(camera.rows, dtype=np.float32)[:, None]
    slope = random.uniform(-0.2, 0.2)
    at = ((y + slope * x) / 6).astype(np.int32)
    grain = random.normal(0, 1, int(at.max() - at.min()) + 2).astype(np.float32)
    grain = np.convolve(grain, np.ones(5, np.float32) / 5, "same")
    return light.table * (1 + 0.12 * grain[at - at.min()])
