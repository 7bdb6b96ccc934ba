"""The table of what a scene gives, as the sheet of a task lists it: letters, values, units; board by board."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from graphic_tmm.fitting.views import Draw
from graphic_tmm.language.numbers import number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import small, unit
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.lettering.heights import HEIGHTS, Heights, heights
from graphic_tmm.paper.lettering.indices import markup
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.readers.protocol import synthesis
from graphic_tmm.readers.task_sheet import SIZE, Given, TaskSheet
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.chapter import MECHANISM, chapters
from graphic_tmm.scene.quantities import turns_a_minute
from graphic_tmm.scene.records import Scene

if TYPE_CHECKING:
    from graphic_tmm.drawn import Drawn
    from graphic_tmm.paper.drawing import Drawing


NAME = "table-given"
TALL = 12
"""More rows than these stand side by side."""
DIGITS = 6
"""Significant figures of what is given: more than tasks have; what follows from them has one less."""


def given_rows(scene: Scene, board: str = MECHANISM) -> tuple[Given, ...]:
    """Return what a scene gives for what stands on a board, chapter by chapter; nothing twice."""
    found = (
        _sized(row, scene.language)
        for one in chapters(board)
        for row in TaskSheet.of(one).given(scene)
    )
    return tuple(dict.fromkeys(found))


def _sized(row: Given, language: str) -> Given:
    if row.unit != SIZE or isinstance(row.value, str):
        return row
    value, of = small(row.value, language)
    return row._replace(value=value, unit=of)


def given_speed(index: str, speed: float) -> Given:
    """Return how fast something turns, in turns a minute where it was given so; ``speed``: 1/s."""
    turns = turns_a_minute(speed)
    if turns is not None:
        return Given(f"n_{index}", turns, "rpm")
    return Given(f"ω_{index}", abs(speed), "1/s")


def given_views(board: str) -> dict[str, Draw]:
    """Return what draws the table of what is given for a board of its own, by its place."""
    name = f"{board} given"

    def draw(drawn: Drawn, lettered: bool) -> list[Drawing]:
        return [given_table(drawn.scene, heights(drawn.scene, name), board)]

    return {name: draw}


def sought(scene: Scene) -> frozenset[str]:
    """Return the symbols of what the synthesis finds, if a scene states a task: it is given, but not told."""
    found = synthesis(scene)
    return frozenset(step.it.name for step in found.construction.steps) if found else frozenset()


def given_table(
    scene: Scene,
    heights: Heights = HEIGHTS["A1"],
    board: str = MECHANISM,
    rows: Sequence[Given] | None = None,
    tall: int = TALL,
) -> Drawing:
    """Return the table of what is given; its rows stand side by side where there are more than ``tall``.

    ``rows``: of these, if not of all that is given.
    """
    told = given_rows(scene, board) if rows is None else rows
    language, size = scene.language, heights.number
    words = captions(language)
    cells = [_cells(row, language) for row in told]
    beside = max(1, math.ceil(len(cells) / tall))
    tall = math.ceil(len(cells) / beside)
    padded = [*cells, *[("", "", "")] * (tall * beside - len(cells))]
    lines = [[cell for row in padded[k::tall] for cell in row] for k in range(tall)]
    heads = [words["letter"], words["figure"], words["unit"]] * beside
    return breakable(
        NAME if board == MECHANISM else f"{NAME}-{board}",
        words["given" if board == MECHANISM else f"given {board}"],
        heads,
        lines,
        again=words["continued"],
        size=size,
        title_size=heights.title,
        align=["left", "centre", "centre"] * beside,
    )


def _cells(row: Given, language: str) -> tuple[str, str, str]:
    words = captions(language)
    word = words.get(row.symbol) or markup(symbol(row.symbol, language))
    told = (
        words.get(value, value) if isinstance(value := row.value, str) else figure(value, language)
    )
    return word, escape(told), unit(row.unit, language) or "—"


def figure(value: float, language: str) -> str:
    """Return what is given as it is written, to the digits that it was given with."""
    whole = math.isclose(value, float(f"{value:.{DIGITS}g}"), rel_tol=1e-9)
    return number(value, language, DIGITS if whole else DIGITS - 1)
