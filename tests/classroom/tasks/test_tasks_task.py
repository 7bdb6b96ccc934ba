"""Task sheets, read back from their SVG: true to what is given, and nothing of a solution."""

from __future__ import annotations

import json
import math
import re
from bisect import bisect
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest
from support import sheet_reader
from support.gallery import ALL, SHEETS, made
from support.set_tasks import languages_of, sheets

from graphic_tmm.classroom.batch.work import done
from graphic_tmm.classroom.tasks.sentences import conditions
from graphic_tmm.classroom.tasks.work import works
from graphic_tmm.classroom.variants.variant import base
from graphic_tmm.face.reading import read as read_text
from graphic_tmm.note.section_task import task
from graphic_tmm.readers.table import table
from graphic_tmm.studio import make

SVG = "{http://www.w3.org/2000/svg}"
MECHANISMS = [
    name for name in ALL if "[drive]" in (SHEETS / name / "scene.toml").read_text(encoding="utf-8")
]
SOUGHT = [
    name for name in ALL if "\n[task]" in (SHEETS / name / "scene.toml").read_text(encoding="utf-8")
]
_NUMBER = re.compile(r"\d+(?:[.,]\d+)?")


def words(svg: str) -> list[str]:
    """What is lettered on a sheet, but for its frame."""
    return [
        word
        for name, view in sheet_reader.views(svg).items()
        if name != "frame"
        for word in view.words
    ]


def number(text: str) -> float:
    return float(text.replace(",", "."))


def digits(figure: str) -> int:
    return len(figure.replace(",", "").replace(".", "").strip("0"))


def figures(text: str) -> set[float]:
    """The numbers of a text that have three digits or more: shorter ones are alike by chance."""
    found = (one for one in _NUMBER.findall(text) if digits(one) >= 3)
    return set(map(number, found))


def rounded(value: float) -> set[float]:
    """A value as a sheet may show it, to three to six digits, with another unit of the same."""
    found = set()
    for factor in (1.0, 1e3, 1e-3, 1e6):
        for count in (3, 4, 5, 6):
            one = f"{abs(value) * factor:.{count}g}"
            if "e" not in one and digits(one) >= 3:
                found.add(float(one))
    return found


def solved(name: str) -> set[float]:
    """Everything that the table of the drawn scene holds: lengths, quantities, results."""
    told = json.loads(str(table(made(name), "json")))
    found: set[float] = set()

    def gather(one: object) -> None:
        if isinstance(one, dict):
            for key, inner in one.items():
                if key not in ("scales", "angle_deg", "positions", "given"):
                    gather(inner)
        elif isinstance(one, list):
            for inner in one:
                gather(inner)
        elif isinstance(one, float) and math.isfinite(one):
            found.update(rounded(one))

    gather(told)
    return found


def stated(name: str) -> set[float]:
    """The numbers that the author of a scene wrote, in any of the units of a sheet."""
    text = (SHEETS / name / "scene.toml").read_text(encoding="utf-8")
    lines = [line.split("#")[0] for line in text.splitlines()]
    found = [number(one) for line in lines for one in _NUMBER.findall(line)]
    mechanism = made(name).scene.mechanism
    if mechanism is not None:  # speeds that the law of motion gives the plans
        rows = (*mechanism.drive.rates, *mechanism.drive.gains)
        found += [float(f"{abs(one):.6g}") for one in rows]
    return {
        float(f"{value * factor:.6g}")
        for value in found
        for factor in (1.0, 1e3, 1e-3, 1e6, 0.5, 500.0, 98066.5)  # kgf/cm² are shown in Pa
    }


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_no_figure_of_the_solution_stands_on_a_task(name: str) -> None:
    told = {one for svg in sheets(name) for word in words(svg) for one in figures(word)}
    assert (told & solved(name)) <= stated(name)


def test_what_would_be_a_figure_of_the_solution_is_seen() -> None:
    """The oracle is not blind: the sheet of the solution is full of them."""
    from graphic_tmm.paper.write.svg import svg
    from graphic_tmm.studio import sheets as drawn

    scene = made("slider-diagrams").scene
    told = {one for s in drawn(scene)[1] for word in words(svg(s)) for one in figures(word)}
    assert len((told & solved("slider-diagrams")) - stated("slider-diagrams")) > 3


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_no_ink_of_a_plan_stands_on_a_task(name: str) -> None:
    known = re.compile(r"frame|scheme|table-given.*|task-.*")
    parts = {"link", "guide", "pivot", "turning", "number", "stone", "slider", "pair", "load"}
    parts |= {"leader", "frame", "centre", "point", "rail", "joint", ""}
    parts |= {"wheel", "carrier", "contour", "circle", "axis", "sense", "dimension", "follower"}
    parts |= {"roller", "lever", "face", "cylinder", "piston", "belt", "sliding"}
    for svg in sheets(name):
        root = ElementTree.fromstring(svg)
        for group in root.iter(f"{SVG}g"):
            kind, _, drawing = group.get("class", "").partition(" ")
            if kind != "drawing":
                continue
            assert known.fullmatch(drawing), drawing
            for path in group.iter(f"{SVG}path"):
                told = {key for key in path.attrib if key.startswith("data-")}
                assert told <= {"data-of", "data-at", "data-part", "data-check-line"}
                assert path.get("data-at", "0") == "0"
                assert path.get("data-part", "") in parts


def circles(svg: str) -> list[complex]:
    """The centres of the joints, mass centres and points of a scheme, mm."""
    found = []
    root = ElementTree.fromstring(svg)
    scheme = next(g for g in root.iter(f"{SVG}g") if g.get("class") == "drawing scheme")
    for path in scheme.iter(f"{SVG}path"):
        if path.get("data-part") == "number":
            continue
        for part in path.get("d", "").split("M")[1:]:
            ends = re.findall(r"A[\d.]+ [\d.]+ 0 0 \d (-?[\d.]+) (-?[\d.]+)", "M" + part)
            if len(ends) == 4:
                found.append(sum(complex(float(x), float(y)) for x, y in ends) / 4)
    return found


Lettered = list[tuple[str, complex]]


def labels(svg: str, drawing: str) -> Lettered:
    """The words of a drawing, figures as they are written, and where their first strokes begin, mm."""
    root = ElementTree.fromstring(svg)
    found = []
    for group in root.iter(f"{SVG}g"):
        if group.get("class") != f"drawing {drawing}":
            continue
        for label in group.iter(f"{SVG}g"):
            text, path = label.get("aria-label", ""), label.find(f"{SVG}path")
            start = re.match(
                r"M(-?[\d.]+)[ ,]?(-?[\d.]+)", path.get("d", "") if path is not None else ""
            )
            if text and start is not None:
                plain = text.translate(str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789"))
                found.append((plain, complex(float(start[1]), float(start[2]))))
    return found


def points(svg: str) -> dict[str, complex]:
    """About where the letters of points stand on a scheme, mm; a label may name several."""
    return {one: at for text, at in labels(svg, "scheme") for one in text.split(", ")}


def lines(svg: str, drawing: str) -> list[float]:
    """Where the level lines of a table stand, mm."""
    root = ElementTree.fromstring(svg)
    (table,) = (g for g in root.iter(f"{SVG}g") if g.get("class") == f"drawing {drawing}")
    told = " ".join(path.get("d", "") for path in table.iter(f"{SVG}path"))
    found = re.findall(r"M(-?[\d.]+) (-?[\d.]+)L(-?[\d.]+) \2(?![\d.])", told)
    return sorted(float(y) for x, y, end in found if abs(float(end) - float(x)) > 20.0)


def given(svg: str) -> dict[str, str]:
    """The figures of the table of what is given, by their symbols: what stands to the right of each."""
    there, rules = labels(svg, "table-given"), lines(svg, "table-given")
    found = {}
    for symbol, at in there:
        row = [
            (z.real, text)
            for text, z in there
            if z.real > at.real and bisect(rules, z.imag) == bisect(rules, at.imag)
        ]
        if row:
            found.setdefault(symbol, min(row)[1])
    return found


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in MECHANISMS if name not in SOUGHT])
def test_the_scheme_has_the_lengths_that_are_given(name: str) -> None:
    svg = sheets(name)[0]
    spots, letters = circles(svg), points(svg)
    told = sheet_reader.views(svg)["scheme"].words
    (scale,) = (m for word in told for m in re.findall(r"μ_l = ([\d.,]+) (?:m/mm|м/мм)", word)[:1])
    mu = number(scale)
    checked = 0
    for symbol, value in given(svg).items():
        match = re.fullmatch(r"l_([A-Z]\d?)([A-Z]\d?)", symbol)
        if match is None or "…" in value:
            continue
        due = number(value) / 1000.0 / mu
        near = [
            sorted(spots, key=lambda z, at=letters[one]: abs(z - at))[:3] for one in match.groups()
        ]
        off = min(abs(abs(a - b) - due) for a in near[0] for b in near[1])
        assert off < 0.02, (symbol, due, off)
        checked += 1
    assert checked


@pytest.mark.slow
def test_lengths_that_are_sought_are_neither_told_nor_drawn(
    many: Callable[[int, int], int],
) -> None:
    for name in SOUGHT[-many(len(SOUGHT), 1) :]:
        nothing_sought_is_told(name)


def nothing_sought_is_told(name: str) -> None:
    """By the formulas of a textbook: θ = 180°(K − 1)/(K + 1), OA = OB·sin(θ/2), BC = S/(2·sin(θ/2))."""
    half = math.radians(180.0 * 0.45 / 2.45) / 2.0
    crank, arm = 480.0 * math.sin(half), 95.0 / (2.0 * math.sin(half))
    told = " ".join(word for svg in sheets(name, "en") for word in words(svg))
    for length in (crank, arm, 480.0 + 1.25 * arm, crank / 2.0):
        assert not figures(told) & rounded(length)
    assert "480 + 1.25·BC" in told
    assert "0.5·OA" in told
    assert "not to scale" in told
    assert " m/mm" not in " ".join(sheet_reader.views(sheets(name, "en")[0])["scheme"].words)
    spots = circles(sheets(name, "en")[0])
    centres = min(
        (abs(a - b) for a in spots for b in spots if abs(a.real - b.real) < 0.01 and a != b),
        key=lambda d: abs(d - 48.0),
    )
    shares = {round(abs(a - b) / centres, 3) for a in spots for b in spots}
    assert round(crank / 480.0, 3) not in shares


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_a_task_is_a_true_a4_sheet_and_says_what_is_wanted(
    name: str, many: Callable[[int, int], int]
) -> None:
    asked = {"ru": ("Выполнить", "Сдать", "снятых"), "en": ("To be drawn", "handed in", "read off")}
    measured = name not in ("lettering", "moment-cycle")  # there is nothing to measure
    for language in languages_of(name, many):
        found = sheets(name, language)
        for svg in found:
            root = ElementTree.fromstring(svg)
            assert (root.get("width"), root.get("height")) == ("210mm", "297mm")
        told = " ".join(word for svg in found for word in words(svg))
        assert all(one in told for one in asked[language][: 3 if measured else 2])


@pytest.mark.parametrize("name", ALL)
@pytest.mark.slow
def test_sentences_are_numbered_one_after_another(name: str) -> None:
    told = [word for svg in sheets(name) for word in words(svg)]
    numbers = [int(m[1]) for word in told if (m := re.match(r"(\d+)\. [А-ЯA-Z]", word))]
    assert numbers == list(range(1, len(numbers) + 1))
    assert numbers


@pytest.mark.slow
def test_a_long_title_and_many_data_go_on_in_the_usual_letters(tmp_path: Path) -> None:
    text = (SHEETS / "four-stroke" / "scene.toml").read_text(encoding="utf-8")
    title = (
        "Двигатель четырёхтактный с весьма длинным названием, которое не помещается в строку " * 2
    )
    old = re.search(r'title\s*= "(.*)"', text)
    assert old is not None
    (tmp_path / "long.toml").write_text(text.replace(old[1], title), encoding="utf-8")
    (work,) = works(base(tmp_path / "long.toml"), (), keys=())
    files = done(work).files
    assert len(files) > 1
    for svg in map(str, files.values()):
        assert all(inside(svg))
        for name, view in sheet_reader.views(svg).items():
            assert view.words or name == "frame"
        sizes = re.findall(r'надписи ([\d,]+)"', svg[svg.index('class="drawing t') :])
        assert min(map(number, sizes)) >= 2.5


def inside(svg: str) -> list[bool]:
    """Whether every stroke that tells something lies within the frame, 20 … 205 mm."""
    return [
        20.0 <= z.real <= 205.0
        for name, view in sheet_reader.views(svg).items()
        if name != "frame"
        for stroke in view.strokes
        for z in (stroke.start, stroke.end)
    ]


@pytest.mark.slow
def test_what_two_sections_state_of_a_cylinder_is_said_once() -> None:
    """Forces and flywheel both have the gas of a V engine; its second cylinder fires a turn later."""
    text = (SHEETS / "v-engine" / "scene.toml").read_text("utf-8")
    more = "[effects]\ngas = true\n[forces]\npositions = [3]\n[flywheel]\n"
    scene = read_text(text.replace("[flywheel]\n", more))
    assert sum("360°" in one for one in conditions(scene)) == 1
    assert repr([*task(make(scene), "ru")]).count("на 360° позже") == 1
