"""A scene's own printed table, fed back as somebody's readings, passes its check: for every hand and ruler."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import product
from pathlib import Path

import pytest
from support.command import rows
from support.gallery import ALL, SHEETS
from support.verdicts import Verdicts, verdicts

from graphic_tmm.checking.cells import cells, position_names
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import DOUBTFUL, WRONG
from graphic_tmm.drawn import DrawnScene, single
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.readers.table import scene_columns, scene_results, table
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

HANDS = ("cad", "careful", "student")
RULERS = (0.1, 0.5, 1.0)
HEAD = ("plan", "position", "segment", "mm", "value", "unit")
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−", "0123456789--")
PAIRS = tuple(product(HANDS, RULERS))
"""Each scene is drawn with one of them, or three, so that over the scenes every hand meets every ruler."""


def typed(figure: str) -> str:
    """A figure as the table prints it, as a keyboard has it: 2.5·10⁻⁷ is 2.5e-7."""
    return figure.translate(RAISED).replace("·10", "e").replace("—", "")


def printed(made: DrawnScene) -> Iterator[list[str]]:
    """Every figure with the digits that the table prints for people."""
    names = position_names(made)
    for column in scene_columns(made):
        own = [name for name, _ in column.at] or names
        for name, mm, value in zip(own, *column.first_figures, strict=True):
            length = typed(fixed(mm, 1, "en"))
            figure = "" if value is None else typed(number(value, "en"))
            if length or figure:
                yield [column.plan, name, column.segment, length, figure, column.unit or "1"]
    yield from results(made)


def results(made: DrawnScene) -> Iterator[list[str]]:
    for name, (value, unit) in single(scene_results(made)).items():
        if value == value:
            yield ["results", "", name, "", typed(number(value, "en", 6)), unit or "1"]


def exported(made: DrawnScene) -> Iterator[list[str]]:
    """Every figure as the table is written for machines."""
    for row in rows(str(table(made, "csv"))):
        yield [row[head] or ("1" if head == "unit" else "") for head in HEAD]
    yield from results(made)


def fed_back(name: str, hand: str, ruler: float, folder: Path, trials: int) -> Iterator[Verdicts]:
    scene = replace(read(SHEETS / name), ruler=ruler)
    made = make(scene)
    files = []
    for form in (printed, exported):
        path = folder / f"{form.__name__}.csv"
        with path.open("w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([HEAD, *form(made)])
        files.append((path.name, read_readings(path)))
    if cells(made):
        yield from verdicts(scene, files, hand=hand, trials=trials)


def passes(name: str, hand: str, ruler: float, folder: Path, trials: int) -> None:
    for report in fed_back(name, hand, ruler, folder, trials):
        wrong = [
            (*one.taken.key, one.found, one.due) for one in report.readings if one.verdict == WRONG
        ]
        assert (hand, ruler, wrong) == (hand, ruler, [])
        doubtful = sum(one.verdict == DOUBTFUL for one in report.readings)
        assert doubtful <= 0.03 * len(report.readings)


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_a_printed_table_passes_its_own_check(
    name: str, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    for turn in range(many(3, 1)):
        hand, ruler = PAIRS[(ALL.index(name) + 4 * turn) % len(PAIRS)]
        passes(name, hand, ruler, tmp_path, 100)
