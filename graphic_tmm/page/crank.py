"""What the page knows of a mechanism whose crank is turned: its figures, cursors on diagrams, what is told.

Rows of numbers go into one block of bytes (`pack`), the rest is data as JSON takes it. A coordinate is a number
alone or a row and a distance, thousandths of a millimetre, y upward as on the board.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.script_rows import RowScript
from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.numbers import decimal_sign, fixed, number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.page.cursors import Cursor, cursors, on_paper
from graphic_tmm.page.dense import Dense, dense
from graphic_tmm.page.figure_columns import figure_columns
from graphic_tmm.page.glyphs import Glyphs
from graphic_tmm.page.letters import BESIDE, lettered
from graphic_tmm.page.live.charts import LiveCharts, live_cursor
from graphic_tmm.page.live.log import LiveLog
from graphic_tmm.page.live.values import place_in_log
from graphic_tmm.page.pack import UNIT, Ints, Packer, packed
from graphic_tmm.page.sentences import indexed
from graphic_tmm.page.strands import (
    STEP,
    Key,
    Letter,
    Moving,
    MovingFigures,
    MovingStroke,
    Strands,
    folded,
    strands,
)
from graphic_tmm.page.tied_pack import FigureTies, Tied
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import letter, plain
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.write.svg import clean
from graphic_tmm.paper.write.svg_path import path_data
from graphic_tmm.readers.columns import Column

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
    """What the page is given: data, and the block of rows that it speaks of; the mechanism at every angle.

    ``slots``: the marks that ink and what is told are of; ``charted``: those of diagrams.
    """

    data: dict[str, Any]
    rows: bytes
    found: Dense
    slots: frozenset[int]
    charted: frozenset[int]


def crank(made: DrawnScene, sheets: Sequence[Sheet], *, live: bool = False) -> Turned | None:
    """Return the mechanism of a scene as its crank turns; None if the scene has none, or no crank.

    ``live``: its ink is tied to the marks of the log, which the page then calculates.
    """
    drawn = made.mechanism
    found = dense(drawn) if drawn is not None else None
    if drawn is None or found is None:
        return None
    rows: list[Ints] = []
    glyphs = Glyphs()
    shown = {view.name: view for sheet in sheets for view in sheet.drawings}
    own = {m.name: m for m in figures_of(drawn)}
    exact = {m.name: m for m in figures_of(found.sheet)}
    there = {m.name: m for m in figures_of(found.drawn)}
    drawn_over = {name: strands(found, moving) for name, moving in there.items()}
    ties = FigureTies(found, figures_of, drawn_over) if live else None
    figures = [
        _figure(
            FigureViews(found, moving, exact[name], own[name], drawn_over[name]),
            shown,
            rows,
            glyphs,
            ties.of(name) if ties is not None else {},
        )
        for name, moving in there.items()
    ]
    slots = ties.slots if ties is not None else frozenset[int]()
    if live:
        columns = [
            [there for _, there, _ in figure_columns(moving, own[name])]
            for name, moving in there.items()
        ]
        slots |= _from_log(found, figures, columns, rows)
    on_charts = list(cursors(found, drawn, sheets))
    charts = LiveCharts(found, drawn, on_charts, sheets) if live and on_charts else None
    charted = charts.slots if charts is not None else frozenset[int]()
    slots |= charts.moving if charts is not None else frozenset[int]()
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
            _cursor(one, drawn, found, sheets, rows) | (live_cursor(one, sheets) if live else {})
            for one in on_charts
        ],
        **(charts.data() if charts is not None else {}),
        "glyphs": glyphs.made,
        "lengths": [row.size for row in rows],
        **({"ties": ties.data()} if ties is not None else {}),
    }
    return Turned(data, packed(rows), found, slots, charted)


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


def figures_of(drawn: Drawn) -> Iterator[Moving]:
    """Yield the figures of a mechanism that move with its crank."""
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


class FigureViews(NamedTuple):
    """A figure that moves: of a mechanism at every angle, at the sheet's positions exactly, as on the sheet.

    ``made``: its ink over the angles.
    """

    found: Dense
    moving: Moving
    exact: Moving
    own: Moving
    made: Strands


def _figure(
    of: FigureViews,
    shown: Mapping[str, Drawing],
    rows: list[Ints],
    glyphs: Glyphs,
    ties: Mapping[Key, Tied],
) -> dict[str, Any]:
    """Return a figure as data; ``rows`` and ``glyphs`` take what is its own."""
    found, moving, exact, own, made = of
    still = finished(exact.still()) if exact.still is not None else None
    places = lettered(found, moving, made, shown, still)
    packer = Packer()
    strokes: dict[MovingStroke, Reals | None] = {
        key: made.rows.get(key) for key in (*made.rows, *ties) if isinstance(key, MovingStroke)
    }
    lines = [_line(key, row, packer, ties.get(key)) for key, row in strokes.items()]
    letters = [
        _letter(key, row, made.rows[key], packer, glyphs, ties.get(key))
        for key, row in places.items()
    ]
    # letters that stand apart with other lengths alone
    aside = [[round(x / UNIT)] for x in (BESIDE.real, BESIDE.imag)]
    only = [key for key in ties if isinstance(key, Letter) and key not in places]
    letters += [[glyphs.of(key.text, key.size), *aside, 0, ties[key].variants] for key in only]
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


def _line(key: MovingStroke, row: Reals | None, packer: Packer, ties: Tied | None) -> list[Any]:
    """Return a stroke: its pen, 1 if closed and 2 more if filled, its coordinates, its bulges, where it is.

    Behind that its variants if it is tied; where these tell everything there are no coordinates.
    """
    flags = int(key.closed) + 2 * int(key.filled)
    if ties is not None and (ties.whole or row is None):
        return [key.pen, flags, [], 0, 0, ties.variants]
    assert row is not None
    told = [_coordinates(row[:, k : k + 2], packer, UNIT) for k in range(0, row.shape[1], 3)]
    bulges: Any = 0
    if np.nan_to_num(row[:, 2::3]).any():
        bulges = [packer.put(row[:, k] * BULGE) for k in range(2, row.shape[1], 3)]
    line = [key.pen, flags, [one for pair in told for one in pair], bulges, _presence(row)]
    return line if ties is None else [*line, ties.variants]


def _letter(
    key: Letter, row: Reals, anchors: Reals, packer: Packer, glyphs: Glyphs, ties: Tied | None
) -> list[Any]:
    """Return a letter: its strokes, where its base line begins, where it is.

    Of a tied one how far that is off its point, and its variants, which tell where this is.
    """
    told: list[Any] = [glyphs.of(key.text, key.size)]
    if ties is None or not ties.whole:
        return [*told, *_coordinates(row, packer, LETTER), _presence(row)]
    return [*told, *_coordinates(row - anchors, packer, LETTER), 0, ties.variants]


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
    for column, dense_, figures in figure_columns(moving, own):
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


def _from_log(
    found: Dense,
    figures: Sequence[dict[str, Any]],
    columns: Sequence[Sequence[Column]],
    rows: list[Ints],
) -> frozenset[int]:
    """Leave to the log of the page what it has of the values of figures; return the marks (slots)."""
    log, slots = LiveLog(found, RowScript()), set[int]()
    for figure, some in zip(figures, columns, strict=True):
        for value, column in zip(figure["values"], some, strict=True):
            if place := place_in_log(log, column):
                row = value["row"]
                if len(row) > 1:
                    rows[row[0]] = rows[row[0]][:0]
                value |= {"row": [0], "log": place}
                slots.update(place[:2])
    return frozenset(slots)


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
