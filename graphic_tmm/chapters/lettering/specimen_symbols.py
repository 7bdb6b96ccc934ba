"""The specimen of lines (ГОСТ 2.303) and of symbols of kinematic schemes (ГОСТ 2.770), with their names."""

from __future__ import annotations

import cmath
import math

from graphic_tmm.language.catalogue import Speech, speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Stroke, circle, line
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.symbols.gears import cam, gear, gear_side, wavy
from graphic_tmm.paper.symbols.kinematic import (
    fixed_pivot,
    guide,
    plate,
    rigid_joint,
    round_arrow,
    slider,
    stone,
    turning_pair,
)

LINES = (
    ("main", said("main, s")),
    ("thin", said("thin, s/3")),
    ("wavy", said("wavy, s/3")),
    ("dashed", said("dashed")),
    ("centre", said("dash-dot, thin")),
    ("phantom", said("dash and two dots")),
    ("thick", said("thick")),
    ("medium", said("vectors of plans, s/2")),
)
WIDTH, PITCH = 70.0, 9.0
"""Length of a line shown, distance of two, mm."""
OPEN = 15.0
"""Length of a stroke of the open line, mm (ГОСТ 2.303: 8…20)."""
CAM, NOSE, LIFT = 8.0, 3.0, 9.0
"""Radii of the base circle of the cam shown and of its nose, from one centre to the other, mm."""
ROLLER = 3.5
"""Radius of its roller, mm."""
CELL, COLUMNS, TALL = 72.0, 5, 52.0
"""Width of a symbol's cell, how many stand in a row, height of a row, mm."""


def specimen_symbols(language: str, high: Heights) -> list[Drawing]:
    """Return the view of the lines and that of the symbols."""
    _ = speaking(language)
    return [_lines(_("Lines"), _, high), _symbols(_("Symbols of kinematic schemes"), _, high)]


def _lines(title: str, speech: Speech, high: Heights) -> Drawing:
    labels, strokes = [Label(title, 0j, high.title)], list[Stroke | Bezier]()
    for k, (pen, name) in enumerate(LINES):
        start = -1j * PITCH * (k + 1.5)
        strokes += _shown(pen, start, start + WIDTH)
        labels.append(Label(speech(name), start + WIDTH + 5.0 - 1.7j, high.point))
    return Drawing("lines", title, tuple(strokes), tuple(labels))


def _shown(pen: str, start: complex, end: complex) -> list[Stroke | Bezier]:
    """Return a line as it is drawn; the open one is two strokes at the ends of a section's plane."""
    if pen == "wavy":
        return [wavy(start, end)]
    if pen == "thick":
        return [line(pen, start, start + OPEN), line(pen, end - OPEN, end)]
    return [line(pen, start, end)]


def _symbols(title: str, speech: Speech, high: Heights) -> Drawing:
    labels, strokes = [Label(title, 0j, high.title)], list[Stroke | Bezier]()
    for k, (name, made) in enumerate(_gallery()):
        row, column = divmod(k, COLUMNS)
        at = complex(CELL * (column + 0.5), -TALL * row - 34.0)
        moved = Drawing("", "", made).moved(at)
        strokes += moved.strokes
        labels.append(Label(speech(name), at - 24j, high.number, "middle"))
    return Drawing("symbols", title, tuple(strokes), tuple(labels))


def _gallery() -> list[tuple[str, tuple[Stroke, ...]]]:
    """Return the symbols about 0 with their names."""
    rod = (line("rod", -20 + 0j, 20 + 0j),)
    corner = (line("rod", -18 - 8j, 0j), line("rod", 0j, 18 - 8j))
    triangle = (-14 - 9j, 14 - 9j, 2 + 13j)
    pins = tuple(stroke for z in triangle for stroke in turning_pair(z))
    high = (CAM + ROLLER - 6.0) * 1j
    return [
        (said("fixed pivot"), fixed_pivot(0j)),
        (said("turning pair"), (*rod, *turning_pair(0j))),
        (said("slider on a guide"), (*guide(-22 + 0j, 22 + 0j), *slider(0j))),
        (
            said("sliding block"),
            (line("main", -20 - 8j, 20 + 8j), *stone(0j, 21.8)),
        ),
        (
            said("rigid joint"),
            (*corner, *rigid_joint(0j, -18 - 8j, 18 - 8j)),
        ),
        (said("ternary link"), (*plate(*triangle), *pins)),
        (said("sense of rotation"), round_arrow(0j, 10.0, 20.0, 140.0)),
        (said("gear pair"), (*gear(-12 + 0j, 9.0), *gear(12 + 0j, 15.0))),
        (
            said("gear on a shaft"),
            (line("main", -16 + 0j, 16 + 0j), *gear_side(0j, 13.0, 7.0)),
        ),
        (
            said("cam with a roller follower"),
            (
                *cam(-6j, _profile()),
                circle("joint", high, ROLLER),
                line("rod", high, 20j),
                *turning_pair(high),
            ),
        ),
    ]


def _profile(toward: float = math.radians(200.0), parts: int = 40) -> list[complex]:
    """Return a cam: base circle and nose with their common tangents; ``toward``: where the nose points, rad."""
    half = math.acos((CAM - NOSE) / LIFT)
    turns = (2.0 * (math.pi - half), 2.0 * half)
    starts = (toward + half, toward - half)
    centres = (0j, cmath.rect(LIFT, toward))
    return [
        centre + cmath.rect(radius, start + turn * k / parts)
        for centre, radius, start, turn in zip(centres, (CAM, NOSE), starts, turns, strict=True)
        for k in range(parts + 1)
    ]
