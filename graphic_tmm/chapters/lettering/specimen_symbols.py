"""The specimen of lines (ГОСТ 2.303) and of symbols of kinematic schemes (ГОСТ 2.770), with their names."""

from __future__ import annotations

import cmath

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
        strokes.append(
            wavy(start, start + WIDTH) if pen == "wavy" else line(pen, start, start + WIDTH)
        )
        labels.append(Label(speech(name), start + WIDTH + 5.0 - 1.7j, high.point))
    return Drawing("lines", title, tuple(strokes), tuple(labels))


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
    profile = [cmath.rect(9.0 + 4.0 * max(0.0, cmath.cos(t).real), t) for t in _turn(48)]
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
                *cam(-6j, profile),
                circle("joint", 6.5j, 3.5),
                line("rod", 6.5j, 20j),
                *turning_pair(6.5j),
            ),
        ),
    ]


def _turn(count: int) -> list[float]:
    return [2 * cmath.pi * k / count for k in range(count)]
