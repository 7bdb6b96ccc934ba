"""The sheet of a task: given data as a table, the scheme, the assignments."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, ClassVar, NamedTuple

from graphic_tmm.fitting.views import Draw
from graphic_tmm.language.numbers import number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import small, unit
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing, Stroke, Wanted
from graphic_tmm.paper.formats import HEIGHTS, Heights, heights
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.readers.protocol import synthesis
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.chapter import MECHANISM, Answer, Chapter, chapters
from graphic_tmm.scene.quantities import turns_a_minute
from graphic_tmm.scene.records import Scene

if TYPE_CHECKING:
    from graphic_tmm.drawn import Drawn


SIZE = "size"
"""The unit of lengths that task sheets give in mm."""


class Given(NamedTuple):
    """A given quantity as the sheet of a task lists it: its symbol as marks bear it, its value and unit.

    Sizes of parts are in `SIZE`: kept in m or feet, printed in mm or inches.
    """

    symbol: str
    value: float | str
    unit: str = ""


class Listed(NamedTuple):
    """What a scene gives point by point, as a table: its title, its heads, its rows (mark-up)."""

    name: str
    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


class Posed(NamedTuple):
    """A mechanism in one position, for what acts on it to be shown.

    ``spot``: a letter and the number of its link -> where it stands (complex, mm) and which way it goes (of
    length 1, 0 where it stands still); KeyError if there is no such point. ``size``: of letters, mm. ``turn``:
    the number of a link -> which way its own x axis points (of length 1). ``weights``: those are shown, too.
    """

    spot: Callable[[str, int], tuple[complex, complex]]
    size: float
    turn: Callable[[int], complex]
    weights: bool = False


class LoadSign(NamedTuple):
    """What acts, for who draws it in sizes of his own: its letter as marks bear it, where its sign begins.

    ``way``: of a force, of length 1 (0: nobody knows); it ``pushes`` where its arrow ends there. ``turns``: of
    a moment, 1 counter-clockwise, -1 clockwise. ``end``: of a spring, where it ends.
    """

    letter: str
    at: complex
    way: complex = 0j
    turns: int = 0
    end: complex | None = None
    pushes: bool = False


class Acting(NamedTuple):
    """What is shown to act on a mechanism: ink, its letters, which want a place, and what they are of."""

    strokes: tuple[Stroke, ...]
    wanted: tuple[Wanted, ...]
    sign: LoadSign


class Scheme(NamedTuple):
    """A mechanism as the sheet of a task shows it; its scale, m/mm (0: none); the lines below it."""

    view: Drawing
    mu: float
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class TaskSheet(Answer):
    """A chapter's part of the sheet of a task.

    ``given``: its given data; by default the numbers of its section, each by the letter that is its key or
    that its key has (`given_by_keys`). ``stated``: conditions in words, sentences in a language; ``listed``:
    data point by point, tables in a language. ``scheme``: its picture within a width and a height (complex,
    mm), without its solution; ``acting``: the loads shown there. ``wanted``: by place, the assignments,
    sentences in a language; by default those of the place (`Place.asks`).
    """

    stands: ClassVar[str] = "task_sheet.TASK_SHEET"
    given: Callable[[Scene], Iterable[Given]] | None = None
    stated: Callable[[Scene, str], Iterable[str]] = lambda scene, language: ()
    listed: Callable[[Scene, str], Iterable[Listed]] = lambda scene, language: ()
    scheme: Callable[[Scene, complex], Scheme | None] = lambda scene, room: None
    acting: Callable[[Scene, Posed], Iterable[Acting]] = lambda scene, posed: ()
    wanted: Mapping[str, Callable[[Scene, str], Iterable[str]]] = field(default_factory=dict)


ACROSS = 12
"""So many positions stand beside one another in a table."""


def by_positions(
    name: str,
    title: str,
    rows: Sequence[tuple[str, Sequence[float]]],
    scene: Scene,
    language: str,
) -> Iterator[Listed]:
    """Yield what is given in each position of the row: quantities (mark-up) with their figures."""
    word = captions(language)["position"]
    for k in range(0, scene.row.count, ACROSS):
        here = range(k, min(k + ACROSS, scene.row.count))
        yield Listed(
            f"{name}-{k}",
            "" if k else title,
            (word, *(str(scene.row.first + one) for one in here)),
            tuple((head, *(given_figure(row[n], language) for n in here)) for head, row in rows),
        )


NAME = "table-given"
TALL = 12
"""More rows than these stand side by side."""
LONG = 8
"""Of more figures than these in a row, only from where to where they go is given."""
DIGITS = 6
"""Significant figures of what is given: more than tasks have; what follows from them has one less."""


def given_rows(scene: Scene, board: str = MECHANISM) -> tuple[Given, ...]:
    """Return what a scene gives for what stands on a board, chapter by chapter; nothing twice."""
    found = (_sized(row, scene.language) for one in chapters(board) for row in _given(one, scene))
    return tuple(dict.fromkeys(found))


def _given(chapter: Chapter, scene: Scene) -> Iterable[Given]:
    own = TaskSheet.of(chapter).given
    return given_by_keys(chapter, scene) if own is None else own(scene)


UNITS = {
    "": "",
    "length": SIZE,
    "angle": "°",
    "angular speed": "1/s",
    "speed": "m/s",
    "acceleration": "m/s²",
    "time": "s",
    "mass": "kg",
    "force": "N",
    "moment": "N·m",
    "moment of inertia": "kg·m²",
    "unbalance": "kg·m",
    "pressure": "Pa",
    "density": "kg/m³",
    "power": "W",
    "stiffness": "N/m",
    "damping": "N·s/m",
    "ratio": "",
}
"""The unit in which a quantity of a dimension is given; what has none here is no given size."""
LETTER = re.compile(r"([A-Za-z])(\d?)")


def given_by_keys(chapter: Chapter, scene: Scene) -> Iterator[Given]:
    """Yield what the section of a chapter gives: its numbers, by the letters of their keys."""
    section = chapter.asking
    order = section and scene.tasks.get(section.name)
    if not section or order is None or isinstance(order, tuple):
        return
    for field_ in fields(section.record):
        for written, key in field_.metadata.get("keys", {}).items():
            value = getattr(order, field_.name)
            letter = LETTER.fullmatch(written or field_.name)
            symbol = key.symbol or (letter and "_".join(filter(None, letter.groups())))
            dimension = getattr(key.kind, "unit", None)
            if symbol and not key.fixes and dimension in UNITS and type(value) in (int, float):
                yield Given(symbol, value, UNITS[dimension])


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
    """Return the symbols of lengths that the synthesis finds for a task: they are not printed."""
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
        given_title(board, language),
        heads,
        lines,
        again=words["continued"],
        size=size,
        title_size=heights.title,
        align=["left", "centre", "centre"] * beside,
    )


def given_title(board: str, language: str) -> str:
    """Return what the table of what is given for a board is called."""
    words = captions(language)
    return words.get(f"given {board}", words["given"])


def _cells(row: Given, language: str) -> tuple[str, str, str]:
    words = captions(language)
    word = words.get(row.symbol) or markup(symbol(row.symbol, language))
    told = (
        words.get(value, value)
        if isinstance(value := row.value, str)
        else given_figure(value, language)
    )
    return word, escape(told), unit(row.unit, language) or "—"


def given_figure(value: float, language: str) -> str:
    """Return what is given as it is written, to the digits that it was given with."""
    whole = math.isclose(value, float(f"{value:.{DIGITS}g}"), rel_tol=1e-9)
    return number(value, language, DIGITS if whole else DIGITS - 1)


def given_figures(row: Sequence[float], language: str) -> float | str:
    """Return the only figure of a row, or all in their order; of a long row the least and the largest."""
    between, shown = ("; ", row) if len(row) <= LONG else ("…", (min(row), max(row)))
    return row[0] if len(row) == 1 else between.join(given_figure(one, language) for one in shown)
