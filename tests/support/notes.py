"""Notes of the package's scenes, made once; where each number of a note stands in the log, looked up anew."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Mapping
from functools import cache
from xml.etree import ElementTree

import numpy as np

from graphic_tmm.board.execute import execute
from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.fitting.auto import formatted
from graphic_tmm.fitting.choice import SCALES, choices
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.note.document import Document, Number, Source, Text
from graphic_tmm.note.formats import files
from graphic_tmm.note.note import note, wanted
from graphic_tmm.note.section_chapter import page_of
from graphic_tmm.readers.position_count import Finer, finer
from graphic_tmm.readers.protocol import SYNTHESIS, synthesis
from graphic_tmm.readers.table import columns_of, results_of
from graphic_tmm.readers.task_sheet import given_rows
from graphic_tmm.scene.author import Author
from graphic_tmm.studio import make
from support.gallery import scene


@cache
def made(name: str) -> DrawnScene:
    """A scene of the package, drawn for its note; in its usual size, unless its pages are counted."""
    task = scene(name)
    given = None if name == "project" else Composition(usual(formatted(task)), ())
    return make(task, wanted=wanted(task), given=given)


@cache
def spoken(name: str, language: str) -> DrawnScene:
    """A scene of the package, drawn once, told in a language."""
    from dataclasses import replace

    drawn = made(name)
    scene = replace(drawn.scene, language=language)
    boards = tuple(replace(one, project=replace(one.project, scene=scene)) for one in drawn.boards)
    return DrawnScene(scene, boards)


@cache
def noted(name: str, language: str = "ru") -> Document:
    """The note of a scene of the package."""
    return note(spoken(name, language))


@cache
def file_of(name: str, form: str, language: str = "ru") -> bytes:
    """A file of the note of a scene of the package."""
    found = files(noted(name, language), "note", (form,))[f"note.{form}"]
    return found.encode("utf-8") if isinstance(found, str) else found


def looked_up(made: DrawnScene, one: Number) -> float:
    """The value that stands where a number says that it was read."""
    source = one.source
    if source.board == SYNTHESIS:
        found = synthesis(made.scene)
        assert found is not None
        return _aside(found.construction, found.given, source)
    if source.board.startswith(f"{SCALES} "):
        board = source.board.removeprefix(f"{SCALES} ")
        chosen = choices(next(one for one in made.boards if one.board == board))
        return _aside(chosen.construction, chosen.given, source)
    drawn = next(board for board in made.boards if board.board == source.board)
    ways = {
        "mark": _of_mark,
        "size": lambda drawn, source: abs(_of_mark(drawn, source)),
        "segment": _of_segment,
        "column": _of_column,
        "size of column": lambda drawn, source: abs(_of_column(drawn, source)),
        "result": lambda drawn, source: float(results_of(drawn)[source.name][0][0]),
        "due": lambda drawn, source: _finer(drawn).due[source.name][0],
        "off": lambda drawn, source: 100.0 * _finer(drawn).off[source.name],
        "given": _of_given,
        "asked": lambda drawn, source: _of_task(drawn, *source.name.split(".")),
        "deviation": _of_deviation,
        "scale": lambda drawn, source: drawn.scales[source.name].at(source.place).value,
    }
    return ways[source.kind](drawn, source)


def _aside(log: Construction, given: Mapping[Mark, object], source: Source) -> float:
    return float(execute(log, given).figure(_mark(log, source.name))[0, 0])


def _of_mark(drawn: Drawn, source: Source) -> float:
    mark = _mark(drawn.construction, source.name)
    reading = drawn.of(source.view)
    assert reading is not None
    row = reading.figure(mark)[0]
    return float(row[source.place if row.size > 1 else 0])


def _finer(drawn: Drawn) -> Finer:
    found = finer(drawn)
    assert found is not None
    return found


def _of_task(drawn: Drawn, section: str, key: str) -> float:
    return float(getattr(drawn.scene.tasks[section], key))


def _of_deviation(drawn: Drawn, source: Source) -> float:
    """How far a figure is off the exact hand's, % of the largest of its plan and unit."""
    plan, _, name = source.name.partition("/")
    due = drawn.drawn_by(EXACT)
    if not plan:
        told, right = (float(results_of(one)[name][0][0]) for one in (drawn, due))
        return 100.0 * abs(told - right) / abs(right)
    told_, right_ = (
        next(c for c in columns_of(one) if (c.plan, c.segment) == (plan, name))
        for one in (drawn, due)
    )
    alike = [c.value for c in columns_of(due) if c.plan == plan and c.unit == right_.unit]
    largest = max(float(np.nanmax(np.abs(row))) for row in alike if np.isfinite(row).any())
    apart = told_.value[0][source.place] - right_.value[0][source.place]
    return float(100.0 * abs(apart) / largest)


def _of_segment(drawn: Drawn, source: Source) -> float:
    ends = []
    for slot in source.name.split():
        row = drawn.of(source.view)[_mark(drawn.construction, slot)][0]  # type: ignore[index]
        ends.append(row[source.place if row.size > 1 else 0])
    return float(abs(ends[1] - ends[0]))


def _mark(log: Construction, slot: str) -> Mark:
    marks = (*log.given, *(step.it for step in log.steps))
    return next(one for one in marks if str(one.slot) == slot)


def _of_column(drawn: Drawn, source: Source) -> float:
    found = next(one for one in columns_of(drawn) if f"{one.plan}/{one.segment}" == source.name)
    row = (found.mm if source.factor == 0 else found.value)[0]
    return float(row[source.place])


def _of_given(drawn: Drawn, source: Source) -> float:
    values = [
        row.value for row in given_rows(drawn.scene, drawn.board) if row.symbol == source.name
    ]
    found = [value for value in values if isinstance(value, float | int)]
    return float(found[0])


def words_of(author: Author) -> list[str]:
    """All that the author of a note says, text by text."""
    told: list[str] = []
    for value in vars(author).values():
        several = value.values() if isinstance(value, Mapping) else [value]
        for one in several:
            told += [one] if isinstance(one, str) else [*(one if isinstance(one, tuple) else ())]
    return [one for one in told if one]


def worth_of_a_last_digit(made: DrawnScene, one: Number) -> float:
    """What half a hundredth of a mm stands for in a column of quantities; 0 for any other number.

    Such a quantity is told as its mm give it, which have two decimals;
    a quarter thousandth for the digits of μ.
    """
    if one.source.kind != "column" or one.source.factor == 0:
        return 0.0
    drawn = next(board for board in made.boards if board.board == one.source.board)
    mm = _of_column(drawn, one.source._replace(factor=0))
    value = _of_column(drawn, one.source)
    return abs(value) * (0.005 / abs(mm) + 2.5e-4) if np.isfinite(mm) and mm else 0.0


def stands_for(text: str, value: float, more: float = 0.0) -> bool:
    """Whether a number as it is written can be the value: off by half of its last digit, and ``more``."""
    plain = text.replace("−", "-").replace(",", ".")
    found = re.fullmatch(r"(-?\d+(?:\.(\d+))?)(?:·10([⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+))?", plain)
    if found is None:
        return text == "—" and not np.isfinite(value)
    power = int((found[3] or "⁰").translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")))
    decimals = len(found[2] or "")
    digits = len(found[1].replace("-", "").replace(".", "").lstrip("0"))
    half = 0.5 * 10.0 ** (power - decimals)
    if not decimals and digits > 4:  # figures of five digits and more are written whole
        half = max(half, 0.5 * 10.0 ** (digits - 4))
    return abs(float(found[1]) * 10.0**power - value) <= (half + more) * (1 + 1e-6)


def parts(docx: bytes) -> dict[str, bytes]:
    """The parts of a DOCX by name."""
    with zipfile.ZipFile(io.BytesIO(docx)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def document_of(docx: bytes) -> ElementTree.Element:
    """The tree of a DOCX's text."""
    return ElementTree.fromstring(parts(docx)["word/document.xml"])


def concluded(drawn: Drawn, language: str = "en") -> list[str]:
    """Return what a note concludes of the only chapter of a board, a sentence each; letters are left out."""
    (chapter,) = drawn.project.chapters
    return [
        "".join(one.text for one in told if isinstance(one, (Text, Number)))
        for told in page_of(drawn, chapter, language).concludes()
    ]


__all__ = [
    "concluded",
    "document_of",
    "file_of",
    "looked_up",
    "noted",
    "parts",
    "spoken",
    "stands_for",
    "words_of",
    "worth_of_a_last_digit",
]
