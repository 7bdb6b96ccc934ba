"""A sheet drawn in pencil by a student, seen flat: a grey picture, and where its points stand.

The sheet's strokes are moved with the points that a student's hand found; they are rubbed onto dots by plain
distances, with a width and a darkness of their own. Nothing of the package that reads pictures is used.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import spots
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.paper.drawing import Bezier, Drawing, Sheet, Stroke
from graphic_tmm.studio import blocks

PAPER = 235.0
HEAD = 6.0
"""A vector's line ends in its head, mm before its point."""

Key = tuple[str, str, str]


class Pencilled(NamedTuple):
    """``grey`` (rows, columns), the uppermost row first; ``places``: of the points that were drawn, mm.

    ``left_out``: of those that were not. ``poles``: where the plans' origins stand, by plan and position.
    """

    grey: np.ndarray
    dots: float
    places: dict[Key, complex]
    left_out: set[Key]
    poles: dict[tuple[str, str], complex]


class Manner(NamedTuple):
    """How it is drawn: ``dark`` and ``wide`` from … to, ``squared`` paper, ``noise``, ``blur`` (dots).

    ``missing``: the share of plans that is not drawn; ``slips``: how many times the student's errors.
    """

    wide: tuple[float, float] = (0.2, 0.6)
    dark: tuple[float, float] = (70.0, 150.0)
    squared: bool = False
    noise: float = 5.0
    blur: float = 0.6
    shade: float = 0.6
    missing: float = 0.0
    slips: float = 1.0
    dashed: bool = True
    shift: float = 1.0
    writing: bool = True


def pencilled(
    made: DrawnScene, sheet: Sheet, seed: int, manner: Manner = Manner(), dots: float = 4.0
) -> Pencilled:
    """Draw a sheet of a scene in pencil."""
    random = np.random.default_rng(seed)
    (hand,) = blocks(made, HANDS["student"]._replace(seed=seed))
    due, moved = spots(made), spots(hand)
    grey = np.full((int(sheet.height * dots), int(sheet.width * dots)), PAPER)
    if manner.squared:
        _squares(grey, dots, random)
    places: dict[Key, complex] = {}
    left_out: set[Key] = set()
    poles: dict[tuple[str, str], complex] = {}
    drawn = made.mechanism
    assert drawn is not None
    for view in sheet.drawings:
        skipped = random.random() < manner.missing
        by = manner.shift * complex(*random.normal(0, 1, 2)) if view.shows else 0j
        points: list[tuple[Key, int, complex, complex]] = []
        for plan in view.shows:
            shown = {s.position for s in view.strokes}
            for k, place in enumerate(drawn.row(plan)):
                if k not in shown:
                    continue
                name = drawn.names[place]
                pole = view.origin(plan)
                poles[plan, name] = pole + by
                points.append((("", "", ""), k, pole, pole + by))
                for key, row in due.items():
                    if (key[0], key[2]) == (plan, name) and np.isfinite(row[0]):
                        z = view.origin(plan) + complex(row[0])
                        found = complex(moved[key][0])
                        away = manner.slips * (found - complex(row[0])) if np.isfinite(found) else 0
                        points.append((key, k, z, z + away + by))
        if skipped and points:
            left_out |= {key for key, *_ in points if key[0]}
            continue
        places |= {key: z for key, _, _, z in points if key[0]}
        _view(grey, dots, view, [p[1:] for p in points], by, random, manner)
    grey = _blurred(grey, manner.blur)
    rows, columns = grey.shape
    light = np.linspace(1, manner.shade, columns) * np.linspace(1, 0.9, rows)[:, None]
    grey = grey * light + random.normal(0, manner.noise, grey.shape)
    return Pencilled(np.clip(np.rint(grey), 0, 255).astype(np.uint8), dots, places, left_out, poles)


def _view(grey, dots, view: Drawing, points, by, random, manner: Manner) -> None:
    for stroke in view.strokes:
        if stroke.pen == "paper":
            continue
        near = [p for p in points if stroke.position in (None, p[0])] or points
        for part in _parts(stroke):
            z = _moved(part, near, by)
            wide = random.uniform(*manner.wide) * (1.0 if stroke.pen == "thin" else 1.3)
            dark = random.uniform(*manner.dark)
            dashed = manner.dashed and stroke.pen == "thin" and random.random() < 0.3
            _rub(grey, dots, z, wide, dark, random, dashed)
    for label in view.labels if manner.writing else ():
        _write(grey, dots, label.at + by, len(label.text), label.size, random, manner)


def _parts(stroke: Stroke | Bezier) -> list[np.ndarray]:
    """The straight pieces of a stroke as their ends, its arcs as small chords."""
    if isinstance(stroke, Bezier):
        return [np.array(stroke.controls[k : k + 4 : 3]) for k in range(0, len(stroke.controls) - 1, 3)]
    path = [*stroke.path, stroke.path[0]] if stroke.closed else stroke.path
    found = []
    for (x, y, bulge), (u, v, _) in zip(path, path[1:], strict=False):
        a, b = complex(x, y), complex(u, v)
        if abs(bulge) < 1e-9:
            found.append(np.array([a, b]))
            continue
        half = 2 * np.arctan(bulge)
        middle = (a + b) / 2 + 1j * (b - a) / 2 / np.tan(half)
        turn = np.exp(1j * np.linspace(0, 2 * half, 13))
        arc = middle + (a - middle) * turn
        found += [arc[k : k + 2] for k in range(12)]
    return found


def _moved(part: np.ndarray, points, by) -> np.ndarray:
    """A piece of a stroke, moved with the two outermost points on its line, or with the nearest point."""
    if not points:
        return part + by
    a, b = part
    spots = np.array([p[1] for p in points])
    goals = np.array([p[2] for p in points])
    length = abs(b - a)
    if length > 4.0:
        own = (spots - a) / (b - a) * length
        on = np.flatnonzero((abs(own.imag) < 0.3) & (own.real > -HEAD) & (own.real < length + HEAD))
        if on.size:
            first, last = on[own.real[on].argmin()], on[own.real[on].argmax()]
            if abs(spots[last] - spots[first]) > 3.0:
                ratio = (goals[last] - goals[first]) / (spots[last] - spots[first])
                return goals[first] + (part - spots[first]) * ratio
            return part + goals[first] - spots[first]
    k = abs(spots - part.mean()).argmin()
    return part + goals[k] - spots[k]


def _rub(grey, dots, z, wide, dark, random, dashed) -> None:
    """A pencil line between two places: it wavers, and it is of uneven darkness."""
    a, b = z
    length = abs(b - a)
    if not np.isfinite(length) or length == 0:
        return
    rows, columns = grey.shape
    top = rows / dots
    low, high = min(a.real, b.real) - 1, max(a.real, b.real) + 1
    left, right = max(int(low * dots), 0), min(int(high * dots) + 1, columns)
    up = max(int((top - max(a.imag, b.imag) - 1) * dots), 0)
    down = min(int((top - min(a.imag, b.imag) + 1) * dots) + 1, rows)
    if left >= right or up >= down:
        return
    x = (np.arange(left, right) + 0.5) / dots
    y = top - (np.arange(up, down)[:, None] + 0.5) / dots
    own = (x + 1j * y - a) / (b - a) * length
    wave = 0.06 * np.sin(own.real / random.uniform(8, 20) + random.uniform(0, 6))
    aside = np.maximum(abs(own.imag - wave * (length > 5)), np.maximum(-own.real, own.real - length))
    part = np.clip((wide / 2 - aside) * dots + 0.5, 0, min(1, wide * dots))
    if dashed:
        part = part * ((own.real % 5.0) < 3.5)
    uneven = 1 - 0.25 * np.sin(own.real / 7 + random.uniform(0, 6)) ** 2
    patch = grey[up:down, left:right]
    patch += (np.minimum(dark, patch) - patch) * part * uneven


def _write(grey, dots, at, count, size, random, manner: Manner) -> None:
    for k in range(min(count, 12)):
        base = at + k * size * 0.7
        ends = base + size * (random.uniform(0, 0.6, 4) + 1j * random.uniform(0, 1, 4))
        for a, b in zip(ends, ends[1:], strict=False):
            dark = random.uniform(*manner.dark)
            _rub(grey, dots, np.array([a, b]), 0.35, dark, random, False)


def _squares(grey, dots, random) -> None:
    rows, columns = grey.shape
    ink = PAPER - random.uniform(25, 45)
    begin = random.uniform(0, 5, 2)
    for axis, count in ((0, rows), (1, columns)):
        at = (np.arange(count) + 0.5) / dots
        off = abs((at - begin[axis] + 2.5) % 5.0 - 2.5)
        part = np.clip((0.1 - off) * dots + 0.5, 0, 0.2 * dots)
        part = part[:, None] if axis == 0 else part
        grey += (np.minimum(ink, grey) - grey) * part


def _blurred(grey: np.ndarray, sigma: float) -> np.ndarray:
    if sigma <= 0:
        return grey
    reach = int(3 * sigma) + 1
    weights = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    weights /= weights.sum()
    for axis in (0, 1):
        padded = np.pad(grey, [(reach, reach) if k == axis else (0, 0) for k in (0, 1)], "edge")
        count = grey.shape[axis]
        grey = sum(
            w * np.take(padded, range(k, k + count), axis=axis) for k, w in enumerate(weights)
        )
    return grey
