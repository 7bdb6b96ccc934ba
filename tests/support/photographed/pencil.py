"""A pencil: lines as grains of graphite strewn along them, as wide and as dark as it is pressed.

A dot of the sheet is covered as the grains that fall on it cover it. Lines are drawn along a ruler: as a
whole a little aside, a little bowed; now wider and darker, now less; a little too long. Letters are
written: each word turned, stretched and bent as a hand bends it.
"""

from __future__ import annotations

import itertools
from typing import NamedTuple

import numpy as np

from support.photographed.ink import Inked

DOTS = 8
"""Dots of a drawn sheet to the mm."""
STEP = 0.08
"""Along a line from one cross-section to the next, mm."""
GRAINS = 4.0 * DOTS**2
"""Grains to the mm² of a line that is pressed as hard as can be."""
COVERS = 0.5
"""How much of what is left of a dot one grain covers."""
LETTERS = "letters"
HEAVY = {"main", "thick", "body", "rod", "joint"}
LIGHT = {"thin", "centre", "phantom", "dashed", "outline", "pin"}
LAYERS = ({"body", "outline", "rod", "over", "paper"}, {"joint", "pin"})
"""Pens that lie over the others, and over these: their closed figures hide what is under them."""


class Pencil(NamedTuple):
    """How somebody draws: widths (mm) and darkness (0 … 1) of light and of heavy lines and of letters.

    ``aside``: of a whole line, mm; ``wobble``: along it, mm; ``past``: how far light lines run on, mm.
    ``dashed``: construction lines are dashed. ``written``: how far a word is turned, degrees.
    """

    light: tuple[float, float] = (0.28, 0.55)
    heavy: tuple[float, float] = (0.5, 0.8)
    letters: tuple[float, float] = (0.4, 0.7)
    aside: float = 0.05
    wobble: float = 0.04
    past: float = 0.6
    dashed: bool = False
    written: float = 4.0


def drawn(lines: list[Inked], size: tuple[float, float], pencil: Pencil, seed: int) -> np.ndarray:
    """Return how far every dot of a sheet is covered, 0 … 255, the lowest row first."""
    random = np.random.default_rng(seed)
    shape = round(size[1] * DOTS), round(size[0] * DOTS)
    made = np.zeros(shape, np.float32)
    for layer in range(len(LAYERS) + 1):
        some = [one for one in lines if _layer(one) == layer]
        for one in some if layer else ():
            if abs(one.points[0] - one.points[-1]) < 1e-3:
                _hide(made, one.points)
        made += _strewn(_as_drawn(some, pencil, random), shape)
    return np.clip(255 * (1 - np.exp(-COVERS * made)), 0, 255).astype(np.uint8)


def ghosts(
    lines: list[Inked], size: tuple[float, float], pencil: Pencil, seed: int, share: float
) -> np.ndarray:
    """Return what is left of lines that were rubbed out, as `drawn`: a ``share`` of their darkness."""
    faint = pencil._replace(light=(pencil.light[0] + 0.1, share), heavy=(pencil.heavy[0], share))
    return drawn(lines, size, faint, seed)


def _layer(one: Inked) -> int:
    return next((k + 1 for k, pens in enumerate(LAYERS) if one.pen in pens), 0)


def _as_drawn(
    lines: list[Inked], pencil: Pencil, random: np.random.Generator
) -> list[tuple[np.ndarray, float, float]]:
    """Return lines as a hand draws them: points, width, darkness."""
    found = []
    bends: dict[int, tuple[complex, complex, np.ndarray]] = {}
    for one in lines:
        if one.pen == "paper" or len(one.points) < 2:
            continue
        wide, dark = _pressed(one.pen, pencil)
        wide *= random.uniform(0.8, 1.2)
        dark *= random.uniform(0.8, 1.15)
        if one.pen == LETTERS:
            whole = [_written(one, lines, bends, pencil, random)]
        elif one.filled:
            whole = _filled(one.points, wide)
        else:
            whole = _dashed(_ruled(one, pencil, random), one, pencil)
        found += [(points, wide, min(dark, 1.0)) for points in whole]
    return found


def _pressed(pen: str, pencil: Pencil) -> tuple[float, float]:
    if pen == LETTERS:
        return pencil.letters
    if pen in LIGHT:
        return pencil.light
    if pen in HEAVY:
        return pencil.heavy
    between = zip(pencil.light, pencil.heavy, strict=True)
    wide, dark = ((a + b) / 2 for a, b in between)
    return wide, dark


def _ruled(one: Inked, pencil: Pencil, random: np.random.Generator) -> np.ndarray:
    """Return a line as it is drawn along a ruler (or a compass): aside, bowed, a little too long."""
    points = along(one.points, STEP)
    closed = abs(one.points[0] - one.points[-1]) < 1e-6
    if len(points) < 3:
        return points
    if len(one.points) == 2:
        way = (points[-1] - points[0]) / abs(points[-1] - points[0])
        most = pencil.past if one.pen in LIGHT else 0.15
        before, after = random.uniform(0, most, 2)
        points = along(np.array([points[0] - way * before, points[-1] + way * after]), STEP)
    way = np.gradient(points)
    way /= np.maximum(abs(way), 1e-9)
    length = len(points) * STEP
    small = min(1.0, length / 10)
    off = small * (
        random.normal(0, pencil.aside) + _smooth(len(points), 20.0, random) * pencil.wobble
    )
    return points + (random.normal(0, pencil.aside) if closed else 1j * way * off)


def _dashed(points: np.ndarray, one: Inked, pencil: Pencil) -> list[np.ndarray]:
    """Return the dashes of a line, of its own pattern or of a construction line's."""
    pattern = one.dashes or ((4.0, 1.5) if pencil.dashed and one.pen == "thin" and one.of else ())
    length = (len(points) - 1) * STEP
    if not pattern or length < 2 * sum(pattern):
        return [points]
    count = max(round((length - pattern[0]) / sum(pattern)), 1)
    scale = length / (count * sum(pattern) + pattern[0])
    found, at, k = [], 0.0, 0
    while at < length - 1e-6:
        until = at + pattern[k % len(pattern)] * scale
        if k % 2 == 0:
            found.append(points[int(at / STEP) : int(until / STEP) + 2])
        at, k = until, k + 1
    return [one for one in found if len(one) > 1]


def _filled(points: np.ndarray, wide: float) -> list[np.ndarray]:
    """Return a small figure filled by going about it smaller and smaller."""
    middle = points.mean()
    size = abs(points - middle).max()
    rounds = max(int(size / (0.7 * wide)), 1)
    return [along(middle + (points - middle) * (k + 0.5) / rounds, STEP) for k in range(rounds)]


def _written(
    one: Inked,
    lines: list[Inked],
    bends: dict[int, tuple[complex, complex, np.ndarray]],
    pencil: Pencil,
    random: np.random.Generator,
) -> np.ndarray:
    """Return a stroke of a word as a hand writes it: the word turned, stretched, put a little aside."""
    if one.word not in bends:
        middle = one.points.mean()
        turn = np.radians(random.normal(0, pencil.written))
        stretch = random.uniform(0.85, 1.15) * np.exp(1j * turn)
        bends[one.word] = middle, stretch, random.normal(0, 0.4, 2) @ np.array([1, 1j])
    middle, stretch, aside = bends[one.word]
    points = along(one.points, STEP)
    shake = _smooth(len(points), 1.5, random) + 1j * _smooth(len(points), 1.5, random)
    return middle + aside + (points - middle) * stretch + 0.06 * shake


def along(points: np.ndarray, step: float) -> np.ndarray:
    """Return a polyline at equal steps."""
    far = np.concatenate([[0.0], np.cumsum(abs(np.diff(points)))])
    count = max(int(np.ceil(far[-1] / step)), 1) + 1
    at = np.linspace(0, far[-1], count)
    return np.interp(at, far, points.real) + 1j * np.interp(at, far, points.imag)


def _smooth(count: int, length: float, random: np.random.Generator) -> np.ndarray:
    """Return smooth noise of standard deviation 1 that changes within ``length``, mm."""
    knots = max(int(count * STEP / length), 1) + 3
    value = random.normal(0, 1.2, knots)
    at = np.linspace(0.5, knots - 1.5, count)
    k = at.astype(int)
    share = at - k
    share = share * share * (3 - 2 * share)
    return value[k] * (1 - share) + value[np.minimum(k + 1, knots - 1)] * share


def _strewn(lines: list[tuple[np.ndarray, float, float]], shape: tuple[int, int]) -> np.ndarray:
    """Return how many grains lie on every dot; one generator, so that a line does not hang on another."""
    random = np.random.default_rng(len(lines))
    whole = np.zeros(shape[0] * shape[1], np.float32)
    if not lines:
        return whole.reshape(shape)
    points = np.concatenate([one for one, _, _ in lines])
    ways = np.concatenate([np.gradient(one) for one, _, _ in lines])
    ways /= np.maximum(abs(ways), 1e-9)
    wide = np.concatenate([w * (1 + 0.2 * _smooth(len(o), 8.0, random)) for o, w, _ in lines])
    dark = np.concatenate([d * (1 + 0.2 * _smooth(len(o), 12.0, random)) for o, _, d in lines])
    wide = np.clip(wide, 0.15, 0.65)
    some = random.poisson(GRAINS * wide * STEP * np.clip(dark, 0.05, 1.2))
    for first in range(0, len(points), 1 << 18):
        part = slice(first, first + (1 << 18))
        at = np.repeat(np.arange(len(points))[part], some[part])
        # denser in the middle of a line than at its edges
        across = (random.random(at.size, np.float32) + random.random(at.size, np.float32)) / 2 - 0.5
        ahead = (random.random(at.size, np.float32) - 0.5) * STEP
        grain = points[at] + ways[at] * (ahead + 1.3j * across * wide[at])
        column, row = (grain.real * DOTS).astype(int), (grain.imag * DOTS).astype(int)
        on = (column >= 0) & (column < shape[1]) & (row >= 0) & (row < shape[0])
        np.add.at(whole, row[on] * shape[1] + column[on], np.float32(1))
    return whole.reshape(shape)


def _hide(made: np.ndarray, points: np.ndarray) -> None:
    """Rub out what lies under a closed figure."""
    left, right = points.real.min(), points.real.max()
    low, high = points.imag.min(), points.imag.max()
    rows = slice(max(int(low * DOTS), 0), int(high * DOTS) + 2)
    columns = slice(max(int(left * DOTS), 0), int(right * DOTS) + 2)
    patch = made[rows, columns]
    if not patch.size:
        return
    y, x = np.indices(patch.shape)
    z = (columns.start + x + 0.5) / DOTS + 1j * (rows.start + y + 0.5) / DOTS
    inside = np.zeros(patch.shape, bool)
    for a, b in itertools.pairwise(points):
        crosses = (a.imag > z.imag) != (b.imag > z.imag)
        rise = b.imag - a.imag
        at = a.real + (z.imag - a.imag) / (rise if rise else 1.0) * (b.real - a.real)
        inside ^= crosses & (z.real < at)
    patch[inside] = 0
