"""Every plan of every scene of the package plays in a browser: picture by picture, to the sheet's own view."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from support import pages
from support.browser import Opened
from support.command import invoke
from support.command import rows as csv_rows
from support.gallery import ALL, SHEETS
from support.lesson import Played, at_the_end, names, walk
from support.pixels import alone, at, show_alone

from graphic_tmm.errors import SceneError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.page.words import WORDS
from graphic_tmm.paper.write.svg import ids
from graphic_tmm.readers.protocol import plans, protocol

NUMBERED = re.compile(r"^\s*\d+(–\d+)?\. ")
MEASURED = re.compile(r"(?P<segment>\S+) = (?P<mm>−?[\d.,]+) (?:мм|mm)")
AT = re.compile(r", (?:положение|position) (\S+)$")
VALUES = re.compile(r"(?:Значения, положение|Values, position) (\S+)")
FAINT = 80
"""Where two pictures differ by no more than this of 255, their lines are smoothed otherwise (67 was met)."""

EDGE = 4
"""So many px around the drawing of a page may be its frame."""


class Lesson(NamedTuple):
    """The page of a scene, open, and what was met when all of it was played."""

    tab: Opened
    met: list[Played]
    faults: list[str]


@pytest.fixture(scope="module")
def lesson(browser: Any, files: Callable[..., Path]) -> Iterator[Callable[[str], Lesson]]:
    """Play all of a scene once; its page stays open until those of three others were asked for."""
    kept: dict[str, Lesson] = {}

    def of(name: str) -> Lesson:
        if name not in kept:
            if len(kept) > 2:
                kept.pop(next(iter(kept))).tab.close()
            tab = Opened(browser, files(name))
            tab.page.get_by_role("tab").first.wait_for()
            kept[name] = Lesson(tab, walk(tab.page, pages.language(name)), tab.settle())
        return kept[name]

    yield of
    for one in kept.values():
        one.tab.close()


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", ALL)
def test_the_pictures_are_those_that_the_log_tells(name: str, lesson) -> None:
    met = lesson(name).met
    due = Counter((one.title, len(one.pictures)) for one in pages.views(name, pages.language(name)))
    assert Counter((one.title, one.pictures) for one in met) == due
    assert [(one.title, one.count) for one in met if one.count != str(one.stops)] == []
    assert lesson(name).faults == []


@pytest.mark.parametrize("name", ALL)
def test_nothing_is_seen_that_nobody_can_read(name: str, lesson) -> None:
    assert [one.faults for one in lesson(name).met if one.faults] == []
    assert [one.address for one in lesson(name).met if not all(one.lines)] == []


@pytest.mark.parametrize("name", ALL)
def test_every_view_has_an_address_of_its_own(name: str, lesson) -> None:
    addresses = Counter(one.address for one in lesson(name).met)
    assert [one for one, times in addresses.items() if times > 1] == []


@pytest.mark.parametrize("name", ALL)
def test_the_last_picture_is_the_view_of_the_sheet(
    name: str, lesson, opened, tmp_path, many
) -> None:
    """Of each plan in one position, which it is by turns; in all of them when measured."""
    spoken, shown = pages.language(name), lesson(name)
    _, sheets = pages.on_sheets(name, spoken)
    paper = opened(alone(sheets, tmp_path / "alone.html"))
    titled = places(name)
    stand = [(one, titled[one.title].pop(0)) for one in shown.met]
    plans: dict[str, list[tuple[Played, tuple[int, str]]]] = {}
    for one, place in stand:
        plans.setdefault(one.address.split("/")[0], []).append((one, place))
    turn = ALL.index(name)
    some = [of[(turn + k) % len(of)] for k, of in enumerate(plans.values())]
    for one, place in stand if many(1, 0) else some:
        there = at_the_end(shown.tab.page, spoken, one.address)
        show_alone(paper.page, *place, there)
        played, due = (at(page, there) for page in (shown.tab.page, paper.page))
        assert (due < 128).any(), one.title
        assert unlike(played, due) <= FAINT, one.title
    assert shown.tab.settle() == []


def places(name: str) -> dict[str, list[tuple[int, str]]]:
    """Where the views of a title stand: the number of their sheet, their id on it."""
    spoken = pages.language(name)
    _, sheets = pages.on_sheets(name, spoken)
    found: dict[str, list[tuple[int, str]]] = {}
    for view in pages.views(name, spoken):
        place = sheets.index(view.sheet), ids(view.sheet)[view.number]
        found.setdefault(view.title, []).append(place)
    return found


def unlike(played: np.ndarray, due: np.ndarray) -> int:
    """By how much two pictures differ at most, where they do most."""
    return int(np.abs(played - due)[EDGE:-EDGE, EDGE:-EDGE].max())


def test_the_judge_of_pictures_can_fail(lesson, opened, tmp_path) -> None:
    """The last but one picture still has its helping lines, or lacks its last stroke."""
    shown = lesson("crank-rocker")
    _, sheets = pages.on_sheets("crank-rocker", "en")
    paper = opened(alone(sheets, tmp_path / "alone.html"))
    titled, told = places("crank-rocker"), names("en")
    for one in shown.met:
        there = at_the_end(shown.tab.page, "en", one.address)
        show_alone(paper.page, *titled[one.title].pop(0), there)
        shown.tab.page.get_by_role("button", name=told["previous"], exact=True).click()
        assert unlike(at(shown.tab.page, there), at(paper.page, there)) > FAINT, one.title


def spoken_in(name: str) -> set[str]:
    """What the protocol of a scene says, in all positions, as `bare` text."""
    made, _ = pages.on_sheets(name, pages.language(name))
    found: set[str] = set()
    for board in made.boards:
        for place in board.names:
            try:
                told = protocol(board, plans(), place, made.scene.language, why=True)
                found.update(bare(NUMBERED.sub("", line)) for line in told)
            except SceneError:
                continue
    return found


def said_by_the_page(name: str) -> set[str]:
    """What a page itself says of stops: what is given, what is ready, what is the same elsewhere."""
    speech = speaking(pages.language(name))
    found = {bare(speech(WORDS[key])) for key in ("given", "ready")}
    made, _ = pages.on_sheets(name, pages.language(name))
    again = speech(WORDS["again"])
    return found | {bare(again.format(name=one)) for b in made.boards for one in b.names}


def bare(text: str) -> str:
    """Text without the marks of its indices, brackets, spaces."""
    return re.sub(r"[\s_^{}\[\]]", "", text)


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", ALL)
def test_what_is_told_is_what_the_protocol_tells(name: str, lesson) -> None:
    told = [
        (one.address, line)
        for one in lesson(name).met
        for lines in one.lines
        for line in lines
        if " = " in line or line.endswith(".")
    ]
    assert told or not lesson(name).met
    due = spoken_in(name) | said_by_the_page(name)
    assert [one for one in told if bare(one[1]) not in due][:5] == []


@pytest.mark.parametrize("name", ALL)
def test_lengths_are_those_of_the_tables(name: str, lesson) -> None:
    """The tables tell lengths, the protocol their senses too."""
    out = invoke("table", SHEETS / name, "-f", "csv").stdout
    cells: dict[tuple[str, str, str], set[float]] = {}
    for row in csv_rows(out):
        if row["mm"]:
            key = row["plan"], row["position"], bare(row["segment"])
            mm = abs(float(row["mm"]))  # as a ruler reads it, where a scene has none too
            cells.setdefault(key, set()).update((mm, round(mm, 1), round(mm, 2)))
    wrong = []
    for one in lesson(name).met:
        plan, place = re.match(r"#(\w+)", one.address), AT.search(one.title)
        for line in one.readings if plan and place else ():
            found = MEASURED.match(line)
            due = found and cells.get((plan[1], place[1], bare(found["segment"])))
            if due and float(found["mm"].replace(",", ".").lstrip("−")) not in due:
                wrong.append((one.address, line, due))
    assert wrong == []


Cells = dict[tuple[str, str, str], set[str]]


def printed(name: str) -> Cells:
    """What tables of the sheets print, by plan, letter, position: a cell stands below its position's number."""
    _, sheets = pages.on_sheets(name, pages.language(name))
    found: Cells = {}
    for table in (
        one for sheet in sheets for one in sheet.drawings if one.name.startswith("table-")
    ):
        rows: dict[float, list[tuple[float, str]]] = {}
        for label in table.labels:
            rows.setdefault(round(label.at.imag, 2), []).append((label.at.real, label.text))
        head: list[tuple[float, str]] = []
        for _, cells in sorted(rows.items(), reverse=True):
            (_, letter), *others = sorted(cells)
            if letter in ("Величина", "Quantity"):
                head = others[1:]
                continue
            for x, text in others[1:] if head else ():
                place = min(head, key=lambda one: abs(one[0] - x))[1]
                key = table.name.split("-")[1], bare(letter), bare(place)
                found.setdefault(key, set()).add(text)
    return found


TABLED = ("windrower", "crank-press", "oscillating-cylinder")
"""Scenes whose sheets print tables of plans, position by position."""


@pytest.mark.parametrize("name", TABLED)
def test_values_are_the_texts_of_the_tables_on_the_sheets(name: str, lesson) -> None:
    due, met, wrong = printed(name), 0, []
    for one in lesson(name).met:
        plan = re.match(r"#(\w+)", one.address)
        for caption, rows in one.tables if plan else ():
            place = VALUES.match(caption)
            for segment, mm, _, told in rows[1:] if place else ():
                letter, _, value = told.rpartition(" = ")
                for symbol, text in ((segment, mm), (letter or segment, value)):
                    cells = due.get((plan[1], bare(symbol), bare(place[1])))
                    if cells and text:
                        met += 1
                        if text.split(" ")[0] not in cells:
                            wrong.append((one.address, symbol, text, cells))
    assert wrong == []
    assert met > 20
