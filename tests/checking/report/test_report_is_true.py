"""Finished reports, read by somebody who looks up every number: drawings with mistakes of all chapters."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest
from support.gallery import CASES
from support.report_reader import Reader
from support.reports import LANGUAGES
from support.students.early import EARLY
from support.students.late import LATE
from support.students.outside import OUTSIDE
from support.students.planting import plant
from support.students.writing import csv_of

from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.check import Checked, Checker, known_readings
from graphic_tmm.checking.mutations.diagnosis import diagnosed
from graphic_tmm.checking.mutations.mistaken_scene import mistaken_scenes
from graphic_tmm.checking.mutations.mistakes import Mistakes
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import WRONG, Taken
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.scene.read import read

PLANTED = (
    # kind, mechanism, seed, how it was read, ruler
    ("mass for weight", "fsc", 62517, "quantities", 0.1),
    ("couple left out of the moments", "fsc", 1, "mm", 0.5),
    ("force of the polygon the other way", "fsc", 2, "mm", 0.5),
    ("inertia not reversed", "fsc", 3, "quantities", 0.5),
    ("pole distance of the other diagram", "dsc", 5, "mm", 0.5),
    ("slipped triangle", "dsc", 63405, "mm", 0.5),
    ("path left out of the radius", "fol", 6, "mm", 0.5),
    ("pressure angle by the second derivative", "fol", 7, "mm", 0.5),
    ("Coriolis left out", "rpr", 8, "mm", 0.5),
    ("one figure tenfold", "rpr", 65546, "quantities", 1.0),
    ("row tenfold", "sc", 65445, "mm", 0.5),
    ("mirrored similarity", "fb", 9, "mm", 0.5),
    ("normal component from the wrong end", "six", 10, "mm", 0.5),
    ("given misread", "sc", 65839, "mm", 0.5),
    ("crank turned the other way", "rpr", 64637, "points", 0.5),
    ("ω/r for ωr", "fb", 11, "quantities", 0.5),
)
CASES_OF = {
    "normal_from_the_wrong_end_sc": "sc",
    "normal_forgotten_sc": "sc",
    "Coriolis_turned_six": "six",
    "wrong_length_sc": "sc",
    "honest_six_mm": "six",
    "honest_six_points": "six",
}
KINDS = {kind.name: kind for kind in (*EARLY, *LATE, *OUTSIDE)}


@cache
def checker(machine: str, language: str) -> Checker:
    return Checker(replace(read(CASES / "check" / f"{machine}.toml"), language=language))


def drawings(folder: Path) -> Iterator[tuple[str, tuple[Taken, ...]]]:
    """Yield drawings: of which mechanism, what was read of them."""
    for name, *how in PLANTED:
        one = plant(KINDS[name], *how)  # type: ignore[arg-type]
        assert one is not None, name
        path = folder / "readings.csv"
        path.write_text(csv_of(one.rows), "utf-8")
        yield how[0], read_readings(path)  # type: ignore[misc]
    for name, machine in CASES_OF.items():
        yield machine, read_readings(CASES / "check" / f"{name}.csv")


class Case(NamedTuple):
    """A drawing as it was checked in a language."""

    language: str
    of: Checker
    rows: tuple[Taken, ...]
    checked: Checked


@pytest.fixture(scope="module")
def cases(tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest) -> list[Case]:
    """All drawings, checked in one language and the other by turns; in both with ``--measured``."""
    found = []
    for k, (machine, rows) in enumerate(drawings(tmp_path_factory.mktemp("drawings"))):
        own = LANGUAGES if request.config.getoption("--measured") else (LANGUAGES[k % 2],)
        for of, language in ((checker(machine, language), language) for language in own):
            found.append(Case(language, of, rows, of.of(rows)))
    return found


def faults(of: Checker, rows: tuple[Taken, ...], page: str) -> list[str]:
    known, _ = known_readings(of.made, rows, "")
    return Reader(of.made, known, page).faults()


@pytest.mark.slow
@pytest.mark.parametrize("language", LANGUAGES)
def test_every_number_is_read_due_or_drawn(language: str, cases: list[Case]) -> None:
    pages = [
        (one.of, one.rows, html_report(one.checked.report))
        for one in cases
        if one.language == language
    ]
    assert len(pages) >= len(PLANTED) // 2
    assert [fault for page in pages for fault in faults(*page)] == []


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("case", ["normal_from_the_wrong_end_sc", "normal_forgotten_sc"])
def test_numbers_of_a_slider_crank_are_read_due_or_drawn(language: str, case: str) -> None:
    of, rows = checker("sc", language), read_readings(CASES / "check" / f"{case}.csv")
    assert faults(of, rows, html_report(of.of(rows).report)) == []


@cache
def from_the_wrong_end() -> tuple[tuple[Taken, ...], str]:
    rows = read_readings(CASES / "check" / "normal_from_the_wrong_end_sc.csv")
    return rows, html_report(checker("sc", "en").of(rows).report)


@pytest.mark.parametrize(
    ("was", "now"),
    [
        ("(58.5·0.025)²", "(57.5·0.025)²"),  # a length that he never gave
        ("= 12.22 mm", "= 11.91 mm"),
        ("You have 12.2 mm, as", "You have 12.8 mm, as"),
        ("you have 83.0 mm", "you have 56.1 mm"),
        ("Explains 6 of 6", "Explains 6 of 7"),
        ("14–15, 30–31", "13–15, 30–31"),
        ("Acceleration plan, step 5: the", "Acceleration plan, step 55: the"),
        ("step 5: an2</h2>", "step 6: an2</h2>"),
        ("Fine 50", "Fine 51"),
        ("56.07", "57.07"),
        ("points away from the centre", "was taken 3.7 times as large, off the centre"),
        ("position 3:", "position 30:"),
    ],
)  # fmt: skip
def test_a_number_that_is_not_so_is_a_fault(was: str, now: str) -> None:
    rows, page = from_the_wrong_end()
    assert was in page
    assert faults(checker("sc", "en"), rows, page.replace(was, now, 1))


@pytest.mark.slow
def test_what_a_mistake_explains_is_nearer_to_it_than_to_what_is_due(cases: list[Case]) -> None:
    """Of the lines that are said to be explained by what is sure, but for one in ten."""
    count = 0
    for one in cases:
        for near in _nearer(one.of, one.checked):
            count += 1
            assert sum(near) >= 0.9 * len(near), one.of.made.scene.name
    assert count >= 7


def _nearer(of: Checker, checked: Checked) -> Iterator[list[bool]]:
    """Yield for each mistake that is sure whether each wrong reading of its lines is nearer to its drawing."""
    report = checked.report
    diagnosis = diagnosed(Mistakes(of.made), checked.compared, report.readings, rare=False)
    scenes = mistaken_scenes(report.mistakes, diagnosis, of.made)
    for finding, scene in zip(report.mistakes, scenes, strict=True):
        if scene is None or finding.chance < 0.8:
            continue
        amiss = cells(scene.drawn)
        near = []
        for one in report.readings:
            cell = amiss.get(one.taken.key)
            if one.verdict != WRONG or one.taken.line not in finding.lines or cell is None:
                continue
            figure = cell.mm if one.unit == "mm" else cell.value
            if one.taken.pointed or figure is None or math.isnan(figure):
                continue
            size = (lambda x: x) if one.taken.signed or one.found < 0.0 else abs
            read, drawn, due = map(size, (one.found, figure, one.due))
            near.append(abs(read - drawn) < abs(read - due))
        if near:
            yield near
