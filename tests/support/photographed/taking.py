"""Photographs by number: of one of six sheets, each by another student, pencil, camera and light."""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from support.photographed.pencil import Pencil, drawn, ghosts
from support.photographed.shooting import Light, Marks, jpeg, shot, soiled
from support.photographed.student import Key, Left, Paper, student
from support.photographs import Camera

SHEETS = (
    ("windrower", 1),
    ("lever", 1),
    ("shaper", 1),
    ("crank-press", 1),
    ("crank-rocker", 2),
    ("slider-diagrams", 1),
)
"""Scenes, and which sheet of them: three A1 and an A4 by ГОСТ, an A2 and an A4 by ISO."""
WIDE, HIGH = 4000, 3000
FOCAL = 0.75
"""Of a telephone's camera, as a share of the photograph's longer side (27 mm of 36)."""
ROOM = 0.015
"""How far the frame stays within the photograph, as a share of its width; the paper's edge may be cut off."""
STEEPEST = 35.0


class Conditions(NamedTuple):
    """All that is chosen about a photograph. ``tilt``: degrees off the vertical, and toward which side.

    ``turn``: of the camera about its axis, degrees; ``quarters``: by which the photograph is turned in its
    file. ``lens``: at the half width, as a share; ``sag``, mm.
    """

    pencil: Pencil = Pencil()
    left: Left = Left()
    marks: Marks = Marks()
    light: Light = Light()
    tilt: tuple[float, float] = (15.0, 90.0)
    turn: float = 0.0
    quarters: int = 0
    lens: float = 0.0
    sag: float = 0.0
    wide: int = WIDE


class Shown(NamedTuple):
    """Where a point stands: sheet (mm), pole of its plan (mm), photograph (px); whether it was drawn.

    ``apart``: whether pencil can show it by itself.
    """

    sheet: complex
    spot: complex
    seen: complex
    drawn: bool
    apart: bool = True


class Taken(NamedTuple):
    """A photograph and the truth: ``points``, ``poles`` of the plans and the frame's ``corners`` (px).

    ``corners``: lower left, lower right, upper right, upper left of the sheet, wherever they are seen.
    """

    name: str
    number: int
    jpeg: bytes
    paper: Paper
    corners: np.ndarray
    points: dict[Key, Shown]
    poles: dict[tuple[str, str], complex]
    conditions: Conditions


def conditions(number: int) -> Conditions:
    """Return what a photograph is taken by: as hard as promised, and everything between."""
    random = np.random.default_rng([2026, number])
    some = random.uniform
    squared = number // len(SHEETS) % 3 == 2
    return Conditions(
        Pencil(
            light=(some(0.2, 0.35), some(0.35, 0.7)),
            heavy=(some(0.35, 0.6), some(0.6, 0.95)),
            letters=(some(0.3, 0.5), some(0.4, 0.8)),
            past=some(0.0, 1.0),
            dashed=bool(random.random() < 0.4),
            written=some(1, 6),
        ),
        Left(plans=0.08, unfinished=0.08, aside=some(0, 1.0)),
        Marks(
            some(0.5, 1.0) if squared else 0.0,
            int(random.integers(0, 4)),
            int(random.integers(0, 6)),
        ),
        Light(
            fall=some(0.5, 0.95),
            shadow=some(0.55, 0.85) if random.random() < 0.5 else 1.0,
            warm=some(0.9, 1.05),
            noise=some(2, 8),
            blur=some(0.5, 1.2),
            quality=int(random.integers(60, 91)),
            table=float(random.choice([45, 80, 120, 165, 215])),
        ),
        (some(0, STEEPEST), some(0, 360)),
        some(-8, 8),
        int(random.choice([0, 0, 0, 2, 1, 3])),
        some(-0.01, 0.02),
        some(0, 2.0) if random.random() < 0.5 else 0.0,
    )


@functools.lru_cache(4)
def taken(number: int, given: Conditions | None = None) -> Taken:
    """Return the photograph of a number; ``given``: taken otherwise than the number says."""
    name, sheet = SHEETS[number % len(SHEETS)]
    how = conditions(number) if given is None else given
    paper = student(name, sheet, number, how.left)
    lead = drawn(paper.ink, paper.size, how.pencil, number)
    lead = np.maximum(lead, _rubbed(paper, how, number))
    camera = aimed(paper, how)
    image = shot(camera, soiled(lead, paper.size, how.marks, number), how.light, number)
    image = np.ascontiguousarray(np.rot90(image, how.quarters))

    def seen(points: np.ndarray) -> np.ndarray:
        return turned(camera.seen(points), how.quarters, camera.columns, camera.rows)

    left, bottom, right, top = paper.frame
    frame = np.array([left + 1j * bottom, right + 1j * bottom, right + 1j * top, left + 1j * top])
    places = seen(np.array([due.sheet for due in paper.points.values()]))
    points = {
        key: Shown(due.sheet, due.spot, complex(z), due.drawn, due.apart)
        for (key, due), z in zip(paper.points.items(), places, strict=True)
    }
    stood = seen(np.array(list(paper.poles.values())))
    poles = dict(zip(paper.poles, map(complex, stood), strict=True))
    return Taken(
        name, sheet, jpeg(image, how.light.quality), paper, seen(frame), points, poles, how
    )


def _rubbed(paper: Paper, how: Conditions, number: int) -> np.ndarray:
    """Return what an eraser left of lines that were drawn wrongly at first: some of the plans', moved."""
    random = np.random.default_rng([number, 5])
    ink = [one for one in paper.ink if one.of and one.pen in ("thin", "medium")]
    if not ink or not how.marks.smears:
        return np.zeros((1, 1), np.uint8)
    chosen = [ink[k] for k in random.integers(0, len(ink), 2 * how.marks.smears)]
    moved = [
        one._replace(
            points=one.points[0]
            + (one.points - one.points[0]) * np.exp(1j * np.radians(random.normal(0, 6)))
            + complex(*random.normal(0, 2, 2))
        )
        for one in chosen
    ]
    return ghosts(moved, paper.size, how.pencil, number, 0.06)


def aimed(paper: Paper, how: Conditions) -> Camera:
    """Return the camera that looks at the sheet from its side, just far enough to see the whole frame."""
    width, height = paper.size
    upright = height > width
    columns, rows = (
        (how.wide * HIGH // WIDE, how.wide) if upright else (how.wide, how.wide * HIGH // WIDE)
    )
    steep, side = how.tilt
    tilt = steep * np.cos(np.radians(side)), steep * np.sin(np.radians(side)), how.turn
    left, bottom, right, top = paper.frame
    edge = np.array(
        [
            complex(x, y)
            for x in np.linspace(left, right, 5)
            for y in np.linspace(bottom, top, 5)
            if x in (left, right) or y in (bottom, top)
        ]
    )
    camera = Camera(
        tilt,
        0.5 * max(paper.size),
        FOCAL * how.wide,
        columns,
        rows,
        how.lens,
        how.sag,
        size=paper.size,
    )
    room = ROOM * columns
    for _ in range(200):
        middle = complex(left + right, bottom + top) / 2
        for _ in range(4):
            camera = camera._replace(middle=(middle.real, middle.imag))
            x, y = (way(camera.seen(edge)) for way in (np.real, np.imag))
            off = complex(columns - x.max() - x.min(), rows - y.max() - y.min()) / 2
            here, there = camera.table(
                np.array([complex(columns, rows) / 2, complex(columns, rows) / 2 - off])
            )
            middle += there - here
        if (
            np.ptp(x) < columns - 2.5 * room
            and np.ptp(y) < rows - 2.5 * room
            and x.min() > room
            and y.min() > room
        ):
            return camera
        camera = camera._replace(far=camera.far * 1.02)
    raise AssertionError("the sheet is not seen whole")


def turned(seen: np.ndarray, quarters: int, columns: int, rows: int) -> np.ndarray:
    """Return where places of a photograph are when it is turned counter-clockwise by quarters."""
    x, y = seen.real, seen.imag
    for _ in range(quarters % 4):
        x, y = y, columns - 1 - x
        columns, rows = rows, columns
    return x + 1j * y
