"""What the page knows of a mechanism whose crank is turned: its figures, cursors on diagrams, what is told.

Rows of numbers go into one block of bytes (`pack`), the rest is data as JSON takes it. A coordinate is a number
alone or a row and a distance, thousandths of a millimetre, y upward as on the board.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.numbers import decimal_sign, fixed, number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.page.cursors import Cursor, cursors
from graphic_tmm.page.dense import Dense, dense
from graphic_tmm.page.letters import lettered
from graphic_tmm.page.pack import UNIT, Ints, Packer, packed
from graphic_tmm.page.sentences import indexed
from graphic_tmm.page.strands import (
    STEP,
    Letter,
    Moving,
    MovingFigures,
    MovingStroke,
    Strands,
    folded,
    strands,
)
from graphic_tmm.paper.drawing import Drawing, Label, Sheet
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import letter, plain, svg_path
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.write.svg import clean, shift
from graphic_tmm.paper.write.svg_path import path_data
from graphic_tmm.readers.rounding import rounded_figures

EDGE = 4.0
"""White about a figure, mm."""
BULGE = 1000.0
"""A bulge is told as so many millimetres: to a millionth."""
LETTER = 0.01
"""Letters are placed to this, mm."""
FINE = 1e-5
"""Figures are told to this share of the largest of their row."""
FLOWN = 100.0
"""One that is more than so many times the usual one of its row coarsens the others no further."""


class Turned(NamedTuple):
    """What the page is given: data, and the block of rows that it speaks of."""

    data: dict[str, Any]
    rows: bytes


def crank(made: DrawnScene, sheets: Sequence[Sheet]) -> Turned | None:
    """Return the mechanism of a scene as its crank turns; None if the scene has none, or no crank."""
    drawn = made.mechanism
    found = dense(drawn) if drawn is not None else None
    if drawn is None or found is None:
        return None
    rows: list[Ints] = []
    glyphs = _Glyphs()
    shown = {view.name: view for sheet in sheets for view in sheet.drawings}
    own = {m.name: m for m in _moving(drawn)}
    exact = {m.name: m for m in _moving(found.sheet)}
    figures = [
        _figure(found, moving, exact[moving.name], own[moving.name], shown, rows, glyphs)
        for moving in _moving(found.drawn)
    ]
    language = made.scene.language
    box = pens(sheets[0].format if sheets else "A1")
    data = {
        "whole": found.whole,
        "step": STEP,
        "sense": 1 if found.per > 0 else -1,
        "zero": _place(float(found.angles[0])),
        "more": [_place(float(t)) for t in found.frames[found.whole :]],
        **_ends(found, language),
        "positions": [[name, at] for name, at in zip(drawn.names, found.at, strict=True)],
        "why": _why(found),
        "decimal": decimal_sign(language),
        "pens": {
            name: [pen.width, list(pen.dashes), pen.fill, pen.colour] for name, pen in box.items()
        },
        "figures": figures,
        "cursors": [
            _cursor(one, drawn, found, sheets, rows) for one in cursors(found, drawn, sheets)
        ],
        "glyphs": glyphs.made,
        "lengths": [row.size for row in rows],
    }
    return Turned(data, packed(rows))


def _ends(found: Dense, language: str) -> dict[str, Any]:
    """Return of a row with ends what its place is called, its unit, and how far each step goes in that."""
    if not found.ends:
        return {}
    sweep = found.sweep
    many, of = (1.0, "°") if sweep.turns else (1000.0, "mm")
    return {
        "ends": {
            "letter": indexed(symbol(sweep.name or sweep.letter, language)),
            "unit": of if sweep.turns else f" {unit(of, language)}",
            "from": _place(many * float(found.angles[0])),
            "per": many * found.per,
        }
    }


def _moving(drawn: Drawn) -> Iterator[Moving]:
    for chapter in drawn.project.chapters:
        yield from MovingFigures.of(chapter).figures(drawn)


def _place(value: float) -> float:
    return round(value, 6) + 0.0


def _why(found: Dense) -> list[list[Any]]:
    """Return the runs of angles that cannot be drawn, from and to (indices), and why."""
    runs: list[list[Any]] = []
    for k in found.drawn.undrawn:
        says = found.why.get(k, "")
        if runs and runs[-1][1] == k - 1 and runs[-1][2] == says:
            runs[-1][1] = k
        else:
            runs.append([k, k, says])
    return runs


class _Glyphs:
    """The letters of the page, each once: strokes from the beginning of its base line, their pens."""

    def __init__(self) -> None:
        self.made: list[list[Any]] = []
        self._known: dict[tuple[str, float, bool, float], int] = {}

    def of(self, text: str, size: float, *, inclined: bool = True, turn: float = 0.0) -> int:
        """Return the number of a letter; a new one is drawn."""
        key = (text, size, inclined, turn)
        if key not in self._known:
            self._known[key] = len(self.made)
            written = letter(text, size=size, inclined=inclined)
            strokes = [
                [pen, svg_path(written, 0.0, 0.0, angle=turn, pen=pen)] for pen in written.pens
            ]
            self.made.append([clean(plain(text)), strokes])
        return self._known[key]

    def label(self, label: Label) -> list[Any]:
        """Return a letter that stands: its number, where its base line begins, mm."""
        written = letter(label.text, size=label.size, inclined=label.inclined)
        at = label.at - shift(label, written.width)
        return [
            self.of(label.text, label.size, inclined=label.inclined, turn=label.turn),
            round(at.real, 3),
            round(at.imag, 3),
        ]


def _figure(
    found: Dense,
    moving: Moving,
    exact: Moving,
    own: Moving,
    shown: Mapping[str, Drawing],
    rows: list[Ints],
    glyphs: _Glyphs,
) -> dict[str, Any]:
    made = strands(found, moving)
    still = finished(exact.still()) if exact.still is not None else None
    places = lettered(found, moving, made, shown, still)
    packer = Packer()
    lines = [
        _line(key, row, packer) for key, row in made.rows.items() if isinstance(key, MovingStroke)
    ]
    letters = [
        [
            glyphs.of(key.text, key.size),
            *_coordinates(row, packer, LETTER),
            _presence(row),
        ]
        for key, row in places.items()
    ]
    begun = len(rows)
    rows += [folded(row, found.whole, made.refined) for row in packer.rows]
    data: dict[str, Any] = {
        "name": moving.name,
        "title": clean(plain(moving.title)),
        "caption": indexed(clean(moving.caption)),
        "box": _box(made, places, still),
        "refined": list(made.refined),
        "rows": [begun, len(packer.rows), len(made.drawn)],
        "lines": lines,
        "letters": letters,
        "values": list(_values(found, moving, own, rows)),
    }
    if still is not None:
        data["still"] = [[one.pen, path_data(one, 0.0)] for one in still.strokes]
        data["stands"] = [glyphs.label(label) for label in still.labels]
    if moving.crank is not None and not found.sweep.turns:
        data["crank"] = []
    elif moving.crank is not None:
        pivot, pin = (np.ravel(found.drawn.reading[mark])[0] for mark in moving.crank)
        data["crank"] = [round(float(x), 3) for x in (pivot.real, pivot.imag, abs(pin - pivot))]
    return data


def _line(key: MovingStroke, row: Reals, packer: Packer) -> list[Any]:
    """Return a stroke: its pen, 1 if closed and 2 more if filled, its coordinates, its bulges, where it is."""
    flags = int(key.closed) + 2 * int(key.filled)
    told = [_coordinates(row[:, k : k + 2], packer, UNIT) for k in range(0, row.shape[1], 3)]
    bulges: Any = 0
    if np.nan_to_num(row[:, 2::3]).any():
        bulges = [packer.put(row[:, k] * BULGE) for k in range(2, row.shape[1], 3)]
    return [key.pen, flags, [one for pair in told for one in pair], bulges, _presence(row)]


def _coordinates(row: Reals, packer: Packer, to: float) -> list[list[int]]:
    """Return the x and the y of a place by the rows of a packer, to so many millimetres."""
    return [packer.put(np.round(row[:, k] / to) * to if to > UNIT else row[:, k]) for k in (0, 1)]


def _presence(row: Reals) -> Any:
    """Return from which to behind which row something is there, run by run; 0 if it is always."""
    there = np.isfinite(row[:, 0])
    if there.all():
        return 0
    edges = np.flatnonzero(np.diff(np.concatenate([[0], there.astype(int), [0]])))
    return [int(k) for k in edges]


def _box(made: Strands, places: Mapping[Letter, Reals], still: Drawing | None) -> list[float]:
    """Return left, top (y downward), width and height of the room that a figure takes over the turn, mm."""
    xs = [row[:, 0::3] for key, row in made.rows.items() if isinstance(key, MovingStroke)]
    ys = [row[:, 1::3] for key, row in made.rows.items() if isinstance(key, MovingStroke)]
    for key, row in places.items():
        written = letter(key.text, size=key.size)
        xs += [row[:, :1], row[:, :1] + written.width]
        ys += [row[:, 1:] - written.descent, row[:, 1:] + written.ascent]
    sides = [
        _reach(xs, np.nanmin),
        _reach(ys, np.nanmin),
        _reach(xs, np.nanmax),
        _reach(ys, np.nanmax),
    ]
    if still is not None and still.strokes:
        low = bounds(still)
        sides = [
            *(min(a, b) for a, b in zip(sides[:2], low[:2], strict=True)),
            *(max(a, b) for a, b in zip(sides[2:], low[2:], strict=True)),
        ]
    left, bottom, right, top = sides
    return [
        round(float(x), 2)
        for x in (left - EDGE, -top - EDGE, right - left + 2 * EDGE, top - bottom + 2 * EDGE)
    ]


def _reach(rows: Iterable[Reals], end: Any) -> float:
    found = [float(end(row)) for row in rows if np.isfinite(row).any()]
    return float(end(found)) if found else 0.0


def _values(
    found: Dense, moving: Moving, own: Moving, rows: list[Ints]
) -> Iterator[dict[str, Any]]:
    """Yield what is told along the positions: its letter and unit, its texts there, its row at all angles."""
    language = found.drawn.scene.language
    at_angles = {(c.plan, c.segment): c for c in moving.columns()}
    on_sheet = list(own.columns())
    for column, figures in zip(on_sheet, rounded_figures(on_sheet), strict=True):
        dense_ = at_angles.get((column.plan, column.segment))
        if dense_ is None or not np.isfinite(dense_.value).any():
            continue
        texts = [
            fixed(value, figures.places, language) if value is not None else None
            for value in figures.value
        ]
        row = np.broadcast_to(dense_.value[0], found.turned.shape)
        yield {
            "letter": indexed(symbol(column.quantity or column.letter, language)),
            "unit": unit(column.unit, language),
            "places": figures.places,
            "texts": texts,
            **fine(row, rows),
        }


def fine(row: Reals, rows: list[Ints]) -> dict[str, Any]:
    """Return a row of figures at all angles: the number of its row, what one of it is worth, where it is."""
    largest = float(np.nanmax(np.abs(row)))
    if largest > FLOWN * float(np.nanmedian(np.abs(row))):
        largest /= FLOWN
    worth = 10.0 ** math.floor(math.log10(largest * FINE)) if largest > 0.0 else 1.0
    packer = Packer()
    told_ = packer.put(row, worth)
    rows += packer.rows
    return {
        "row": [len(rows) - 1, 0] if len(told_) > 1 else told_,
        "worth": worth,
        "there": _presence(row[:, None]),
    }


def on_paper(spots: Complexes, sheet: Sheet) -> Complexes:
    """Return places on a sheet, mm; NaN of those beside it."""
    there = (abs(spots.real - sheet.width / 2) <= sheet.width / 2) & (
        abs(spots.imag - sheet.height / 2) <= sheet.height / 2
    )
    return np.where(there, spots, complex("nan"))


def _cursor(
    one: Cursor, drawn: Drawn, found: Dense, sheets: Sequence[Sheet], rows: list[Ints]
) -> dict[str, Any]:
    """Return a cursor: on which view, its point (mm of the sheet, y downward), what it tells, its texts."""
    language, sheet = drawn.scene.language, sheets[one.sheet]
    high, packer = sheet.height, Packer()
    spots = on_paper(one.spots, sheet)
    x, y = packer.put(spots.real), packer.put(high - spots.imag)
    begun = len(rows)
    rows += packer.rows
    texts: list[str | None] = []
    if one.reading is not None and one.reading in drawn.reading:
        value = np.broadcast_to(drawn.reading.figure(one.reading)[0] * one.mu, (len(drawn.names),))
        texts = [number(v, language) if np.isfinite(v) else None for v in value]
    return {
        "view": one.view,
        "letter": indexed(symbol(one.letter, language)) if one.upright or one.reading else "",
        "unit": unit(one.unit, language),
        "mu": one.mu,
        "origin": round(high - one.origin.imag, 3),
        "upright": one.upright,
        "x": [x[0] + begun, x[1]] if len(x) > 1 else x,
        "y": [y[0] + begun, y[1]] if len(y) > 1 else y,
        "there": _presence(spots.real[:, None]),
        "texts": texts,
    }
