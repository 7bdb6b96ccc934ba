"""What a task shows of what is given: the scheme and the tables; never a figure that is to be found."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import count, islice
from pathlib import Path as File
from typing import NamedTuple

import numpy as np

from graphic_tmm.classroom.tasks.sheet import BESIDE, Block, Setting, below, even, figure, width_of
from graphic_tmm.errors import TmmError
from graphic_tmm.handout.sheets import ratio
from graphic_tmm.handout.words import indexed
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import millimetres, small, unit
from graphic_tmm.mechanism.synthesis import KINDS
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.ruled import ruled_table
from graphic_tmm.readers.given_task import given_by_task
from graphic_tmm.readers.protocol import synthesis
from graphic_tmm.readers.task_sheet import (
    Given,
    Listed,
    Scheme,
    TaskSheet,
    given_rows,
    given_table,
    sought,
)
from graphic_tmm.scene.chapter import MECHANISM, chapters
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.splice import set_to

SHARES = ((1.2, 0.8), (1.1, 0.9), (1.3, 1.0), (0.8, 0.9))
"""By how much K_v − 1 and the stroke are another for a scheme not to scale; the first that can be read."""
STEP, PARTS = 0.01, 13
"""What is given varies within this share, in so many parts, for what is seen to follow."""
LEAST = 0.01
"""What is given as zero varies as if it were this, degrees or m."""
EXACT = 1e-9
"""What follows by no sum of lengths to this share is not told."""


def other(scene: Scene, text: str, share: float, stroke: float) -> Scene:
    """Return a scene whose task gives something else in one or two keys, by shares: K_v and the stroke."""
    task = scene.task
    assert task is not None
    given = task.given
    varied = [name for name in KINDS[task.kind].varied if name in given]
    for name, times in zip(varied, (share, stroke), strict=False):
        value = given[name]
        values = value if isinstance(value, tuple) else (value,)
        moved = [1.0 + (one - 1.0) * times if name == "K_v" else one * times for one in values]
        text = set_to(text, ("task", name), _written(value, moved))
    made = judged(text.encode("utf-8"), File(scene.source))
    return made


def _written(value: object, moved: Sequence[complex]) -> str:
    """Return other values of a key as its file writes them: one, or a list as it was; a point as a pair."""
    made = [[one.real, one.imag] if isinstance(one, complex) else one for one in moved]
    return repr(made if isinstance(value, tuple) else made[0])


def disguised(scene: Scene, text: str) -> Scene | None:
    """Return a scene with other lengths than those sought; None if none can be read."""
    for shares in SHARES:
        try:
            return other(scene, text, *shares)
        except TmmError:
            continue
    return None


def _variants(scene: Scene, text: str) -> list[Scene]:
    """Return scenes whose task gives a little else of all but lengths: more than lengths are to be found."""
    task, found = scene.task, synthesis(scene)
    assert task is not None
    assert found is not None
    varied = {name: value for name, value in task.given.items() if name not in found.lengths}
    several = [scene]
    for k in range(1, len(found.lengths) + 3):
        changed, parts = text, count(2)
        for name, value in varied.items():
            values = value if isinstance(value, tuple) else (value,)
            moved = [
                one + STEP * (k * next(parts) % PARTS) / PARTS * (abs(one) or LEAST)
                for one in values
            ]
            changed = set_to(changed, ("task", name), _written(value, moved))
        with suppress(TmmError):
            several.append(judged(changed.encode("utf-8"), File(scene.source)))
    return several


def told_rows(scene: Scene, text: str, board: str = MECHANISM) -> list[Given]:
    """Return what a scene gives for a board; what follows from what is sought is told by it."""
    hidden = sought(scene)
    rows = [row for row in given_rows(scene, board) if row.symbol not in hidden]
    if scene.task is None or board != MECHANISM:
        return rows
    tried = _variants(scene, text)
    stated = {mark.name for mark in _synthesis(scene)[0]}
    stated |= {row.symbol for row in given_by_task(scene)}
    tables = [{row.symbol: row.value for row in given_rows(one, board)} for one in tried]
    found = list[Given]()
    for row in rows:
        values = [table.get(row.symbol) for table in tables]
        if row.symbol in stated or len(set(values)) == 1:
            found.append(row)
        elif says := _sum(tried, values, scene.language):
            found.append(row._replace(value=says))
    return found


def _synthesis(scene: Scene) -> tuple[frozenset, dict[str, float]]:  # type: ignore[type-arg]
    found = synthesis(scene)
    assert found is not None
    own = {name for name, mark in found.lengths.items() if mark not in found.given}
    return frozenset(found.given), {
        n: small(v, scene.language)[0] for n, v in found.values().items() if n in own
    }


def _sum(tried: Sequence[Scene], values: Sequence[object], language: str) -> str:
    """Return a length as a sum of lengths sought, "480 + 1.25·BC"; "" if it is none."""
    if not all(isinstance(value, (int, float)) for value in values):
        return ""
    lengths = [_synthesis(one)[1] for one in tried]
    names = list(lengths[0])
    sides = np.array([[1.0, *(one[name] for name in names)] for one in lengths])
    due = np.array(values, dtype=np.float64)
    by = np.linalg.lstsq(sides, due, rcond=None)[0]
    if np.abs(sides @ by - due).max() > EXACT * np.abs(due).max() * len(due):
        return ""
    terms = [(by[0], ""), *zip(by[1:], names, strict=True)]
    least = 1e-6
    told = ""
    for factor, name in terms:
        if abs(factor) < (least if name else least * np.abs(due).max()):
            continue
        size = number(abs(float(f"{factor:.6g}")), language, 6)
        term = size if not name else name if size == "1" else f"{size}·{name}"
        sign = "−" if factor < 0 else "+"
        told += f" {sign} {term}" if told else term if factor > 0 else f"−{term}"
    return told


SCHEME = said("Scheme of the mechanism", context="task")
SCALE, NO_SCALE = said("scale {scale}, {mu}"), said("not to scale")
ROOM, BESIDE_HIGH = complex(168.0, 92.0), 108.0
"""Room for the scheme, mm: alone; its height beside a table."""
LEAST_WIDE = 56.0
"""Room for the scheme beside a table is no narrower, mm."""
ALONE, TWICE = 18, 8
"""So many rows of what is given stand in one column beside the scheme; below it they are split sooner."""

Rows = Mapping[str, Sequence[Given]]
"""What is given, by boards."""
Drawer = Callable[[complex], Scheme | None]
"""Draws the scheme within a width and a height, mm."""


class GivenViews(NamedTuple):
    """What is shown: what stands beside one another at the head of all, and the tables below it."""

    beside: tuple[Block, ...]
    below: tuple[Block, ...]


def drawer(scene: Scene, text: str) -> Drawer:
    """Return what draws the scheme of a scene; of lengths that are sought one that tells none."""
    shown = disguised(scene, text) if scene.task is not None else scene
    found = dict[complex, Scheme | None]()

    def draw(room: complex) -> Scheme | None:
        if shown is None:
            return None
        if room not in found:
            made = (TaskSheet.of(chapter).scheme(shown, room) for chapter in chapters())
            found[room] = next((one for one in made if one), None)
        return found[room]

    return draw


def arranged(scene: Scene, rows: Rows, draw: Drawer, setting: Setting) -> Iterator[GivenViews]:
    """Yield the ways in which the scheme and the tables may stand: side by side if there is room, and not."""
    wide = width_of(scene.language)
    talls = (ALONE, 2 * ALONE, TWICE + 2) if setting.under else (ALONE,)
    for tall in talls:
        tables = list(_tables(scene, rows, tall, setting))
        if not tables:
            break
        room = wide - tables[0].width - BESIDE
        if room < LEAST_WIDE:
            continue
        shown = _scheme(scene, draw, complex(room, setting.share * BESIDE_HIGH), setting)
        if shown is None or shown.width > room:
            continue
        yield GivenViews((shown, tables[0]), (*tables[1:], *_listed(scene, setting)))
    shown = _scheme(scene, draw, complex(ROOM.real, setting.share * ROOM.imag), setting)
    tall = TWICE if shown is not None else ALONE
    tables = [*_tables(scene, rows, tall, setting), *_listed(scene, setting)]
    yield GivenViews((shown,) if shown is not None else (), tuple(tables))


def rowed(blocks: Sequence[Block], wide: float) -> tuple[tuple[Block, ...], ...]:
    """Return blocks in rows, as many beside one another as there is room for."""
    found, alone = list[tuple[Block, ...]](), True
    for k, one in enumerate(blocks):
        row = (*found[-1], one) if found else (one,)
        apart = one.follows or any(other.follows for other in blocks[k + 1 : k + 2])
        if alone or apart or sum(b.width for b in row) + BESIDE * (len(row) - 1) > wide:
            found.append((one,))
        else:
            found[-1] = row
        alone = apart
    return tuple(found)


def _scheme(scene: Scene, draw: Drawer, room: complex, setting: Setting) -> Block | None:
    """Return the scheme with its scale."""
    made = draw(room)
    if made is None:
        return None
    _, language = speaking(scene.language), scene.language
    mu = f"μ_{{l}} = {number(made.mu, language)} {unit('m/mm', language)}"
    scale = (
        _(SCALE, scale=ratio(1.0 / millimetres(made.mu, language), language), mu=mu)
        if made.mu
        else ""
    )
    plain = made.mu == 0.0 or scene.task is not None
    title = made.view.title or _(SCHEME)
    told = (escape(title), _(NO_SCALE) if plain else scale, *map(indexed, made.notes))
    view = made.view._replace(title=title)
    return figure(below(view, told, "scheme", setting.text, room.real), above=setting.between)


def _tables(scene: Scene, rows: Rows, tall: int, setting: Setting) -> Iterator[Block]:
    """Yield the tables of what is given, in columns so ``tall``, or in fewer if these are too wide."""
    wide, sizes = width_of(scene.language), Heights(setting.rows, setting.text, setting.rows)
    for board, some in rows.items():
        counts = (max(len(some), 1), 3, 2, 1)
        tried = (max(tall, math.ceil(len(some) / beside)) for beside in counts)
        found = (
            figure(given_table(scene, sizes, board, some, high), above=setting.between)
            for high in tried
            if some
        )
        yield from islice((one for one in found if one.width <= wide), 1)


def _listed(scene: Scene, setting: Setting) -> Iterator[Block]:
    """Yield what is given point by point, as tables."""
    found = (
        one for chapter in chapters() for one in TaskSheet.of(chapter).listed(scene, scene.language)
    )
    wide = width_of(scene.language)
    for one in dict.fromkeys(found):
        above = setting.between if one.title else setting.least
        made = figure(_table(one, wide, setting), above=above)
        yield made._replace(follows=not one.title)


def _table(one: Listed, wide: float, setting: Setting) -> Drawing:
    name, ways, size = f"table-given-{one.name}", ["centre"] * len(one.heads), setting.rows
    bare = ruled_table(name, "", one.heads, one.rows, size=size, title_size=size, align=ways)
    left, _, right, _ = bounds(bare)
    lines = even(one.title, setting.text, max(right - left, wide / 2.0))
    title = "\n".join(line.text for line in lines)
    return ruled_table(
        name, title, one.heads, one.rows, size=size, title_size=setting.text, align=ways
    )
