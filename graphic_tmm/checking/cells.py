<<<<<<< HEAD
"""The figures of a scene one by one, by plan, segment and position: what readings are compared with."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from graphic_tmm.board.values import Point
from graphic_tmm.studio import Made, scene_columns, scene_results

Key = tuple[str, str, str]
"""Plan, segment, position ("" for a result)."""
RESULTS = "results"
POINTED = ("positions", "velocities", "accelerations")
"""Plans whose points can be compared by their coordinates."""


class Cell(NamedTuple):
    """One figure: mm on the sheet (None where nothing is drawn), the quantity, its unit."""

    mm: float | None
    value: float | None
    unit: str


def position_names(made: Made) -> tuple[str, ...]:
    """Return the numbers of the positions of a scene."""
    if made.work is not None:
        return made.work.project.names
    columns = scene_columns(made)
    return tuple(str(k) for k in range(len(columns[0].value))) if columns else ()


def cells(made: Made) -> dict[Key, Cell]:
    """Return every figure that a scene has."""
    names = position_names(made)
    found: dict[Key, Cell] = {}
    for column in scene_columns(made):
        rows = zip(names, column.mm, column.value, strict=True)
        for name, mm, value in rows:
            if mm is not None or value is not None:
                found[column.plan, column.segment, name] = Cell(mm, value, column.unit)
    for name, (value, unit) in scene_results(made).items():
        found[RESULTS, name, ""] = Cell(None, value, unit)
    return found


def longest(found: Mapping[Key, Cell]) -> dict[tuple[str, str], float]:
    """Return the longest segment of every plan and position, mm."""
    most: dict[tuple[str, str], float] = {}
    for (plan, _, position), cell in found.items():
        if cell.mm is not None:
            at = (plan, position)
            most[at] = max(most.get(at, 0.0), abs(cell.mm))
    return most


def plans(found: Mapping[Key, Cell]) -> Iterator[str]:
    """Yield the plans that have figures, in their order."""
    yield from dict.fromkeys(plan for plan, _, _ in found)


def points(made: Made) -> dict[Key, complex]:
    """Return where every point of a mechanism's plans stands, mm from the pole (or the crank's pivot)."""
    work = made.work
    found: dict[Key, complex] = {}
    if work is None:
        return found
    project, everywhere = work.project, tuple(range(len(work.project.names)))
    for step in project.construction.steps:
        plan = step.it.view
        if plan not in POINTED or step.it.kind is not Point or step.op.across:
            continue
        reading, places = (work.reading, everywhere)
        if plan == "accelerations":
            if work.accelerated is None:
                continue
            reading, places = work.accelerated, project.accelerated
        row = reading[step.it][0]
        for k, place in enumerate(places):
            z = complex(row[k if row.size > 1 else 0])
            if cmath.isfinite(z):
                found[plan, step.it.letter, project.names[place]] = z
    return found
=======
"""A table of cells in a text: its separator found out, its columns by name, its rows with their lines."""

from __future__ import annotations

import csv
import io
import re
import unicodedata
from collections.abc import Iterator, Mapping
from itertools import chain
from typing import NamedTuple

from graphic_tmm.scene.quantities import near

HEADS: Mapping[str, str] = {
    "plan": "план",
    "position": "положение",
    "segment": "отрезок",
    "mm": "мм",
    "value": "величина",
    "unit": "единица",
    "x": "x",
    "y": "y",
}
"""The columns that mean something, in English and in Russian."""
SEPARATORS = {",": "comma", ";": "semicolon", "\t": "tab"}
_NAMES = {name: name for name in HEADS} | {russian: name for name, russian in HEADS.items()}
_NAMES |= {"х": "x", "у": "y"}  # the Cyrillic letters that look the same
_RUSSIAN = frozenset(HEADS.values()) - frozenset(HEADS)
_IN_MM = re.compile(r"^([xyху])[\s,(\[]+(?:mm|мм)[)\]]?$")
_SEPARATOR_LINE = re.compile(r'"?sep=.?"?', re.IGNORECASE)


class Row(NamedTuple):
    """The cells of one row and the line where it begins; ``wrong``: why it cannot be split, or ""."""

    line: int
    cells: list[str]
    wrong: str = ""


class Head(NamedTuple):
    """The first row: the separator, the titles as typed, and the place of each column by its name.

    ``twice``: titles of columns named once more; ``wrong``: why the row cannot be split, or "".
    """

    line: int
    separator: str
    titles: tuple[str, ...]
    places: Mapping[str, int]
    twice: tuple[str, ...] = ()
    wrong: str = ""

    @property
    def russian(self) -> bool:
        """Whether a column is named in Russian."""
        return any(_folded(title) in _RUSSIAN for title in self.titles)

    @property
    def spoken(self) -> str:
        """The titles as a message quotes them."""
        shown = ", ".join(title for title in self.titles[:10] if title)
        return f"{shown}, ..." if len(self.titles) > 10 else shown

    def title(self, name: str) -> str:
        """Return the title of a column as it stands in the file, its name if it does not."""
        return self.titles[self.places[name]] if name in self.places else name

    def like(self, name: str) -> str:
        """Return the title that was probably meant for a column that is missing; "" if none."""
        unknown = [title for title in self.titles if _folded(title) not in _NAMES]
        return near(name, unknown, 0.8) or near(HEADS[name], unknown, 0.8)


def table(text: str) -> tuple[Head, Iterator[Row]] | None:
    """Return the first row of a text and an iterator over the others; None if the text is empty.

    Of the separators that one is taken which makes most of the first row columns that are known.
    """
    found = [
        (_head(first, separator), following)
        for separator in SEPARATORS
        for following in (rows(text, separator),)
        for first in (_first(following),)
        if first is not None
    ]
    return max(found, key=lambda one: (len(one[0].places), len(one[0].titles)), default=None)


def rows(text: str, separator: str) -> Iterator[Row]:
    """Yield the rows of a text; blank lines and comments (#) between rows are left out."""
    numbered = enumerate(io.StringIO(text, newline=None), 1)
    for line, first in numbered:
        if not first.strip() or first.lstrip(" ").startswith("#"):
            continue
        lines = chain((first,), (more for _, more in numbered))
        reader = csv.reader(lines, delimiter=separator, skipinitialspace=True, strict=True)
        try:
            yield Row(line, next(reader))
        except csv.Error as error:
            yield Row(line, [], str(error))


def _first(following: Iterator[Row]) -> Row | None:
    """Return the row of titles: not a comment that a spreadsheet has quoted, nor its line ``sep=;``."""
    for row in following:
        start = "".join(row.cells[:2])
        if not start.startswith("#") and not _SEPARATOR_LINE.fullmatch(start.strip()):
            return row
    return None


def _head(row: Row, separator: str) -> Head:
    titles = [" ".join(cell.split()) for cell in row.cells]
    while titles and not titles[-1]:
        titles.pop()
    places: dict[str, int] = {}
    twice = []
    for place, title in enumerate(titles):
        name = _NAMES.get(_folded(title))
        if name in places:
            twice.append(title)
        elif name is not None:
            places[name] = place
    return Head(row.line, separator, tuple(titles), places, tuple(twice), row.wrong)


def _folded(title: str) -> str:
    """Return a title in the form of ``_NAMES``; "x, mm" and "x (мм)" are x."""
    return _IN_MM.sub(r"\1", unicodedata.normalize("NFKC", title).casefold().strip())
>>>>>>> wt-read
