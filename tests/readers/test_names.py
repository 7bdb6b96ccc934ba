"""One name for a thing wherever a reader meets it, and nothing that only machines need."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from support.boards import in_usual_size
from support.each import each
from support.examples import most
from support.gallery import SHEETS, made, paper
from support.loaded import order_of, solve, weighed
from support.mechanisms import assemble
from support.parts import PARTS, part_of
from support.scenes import calling, written

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import TALLY, Construction
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.language.symbols import plain, spoken, symbol
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.lettering.markup import plain as lettered
from graphic_tmm.readers.narration import ProtocolLine, protocol
from graphic_tmm.readers.protocol import protocol as told
from graphic_tmm.readers.protocol import steps_of
from graphic_tmm.readers.table import scene_columns, table
from graphic_tmm.readers.task_sheet import given_rows
from graphic_tmm.readers.text import column_name
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.read import read

PACKAGED = sorted(
    p.name for p in SHEETS.iterdir() if (p / "scene.toml").exists() and p.name != "lettering"
)
PLANS = (
    "synthesis", "extremes", "positions", "velocities", "accelerations", "forces", "engine", "diagrams",
    "flywheel", "balance", "centres", "centrodes", "curvature", "hodograph", "analogues", "klein", "ritterhaus",
    "cam", "arc_cam", "gears", "planetary", "cycle",
)  # fmt: skip

LATIN = re.compile(
    r"[ntkr]_[a-zπ][0-9]?[a-zπ][0-9]?$|"  # segments of plans of velocities and accelerations
    r"[^\W\d_]_("
    r"[0-9*]+′?|[A-Z][A-Z0-9′]*|[A-Z]?max|[A-Z]?min[0-9]?|"  # numbers, points, max and min
    r"[0-9][A-Za-zϑ]′?|[0-9]min|I+′?|S[0-9]?|"
    r"[GRFNPQTKMHSVJLA][0-9]*′?|ϑ|"  # the force or the graph that an ordinate or an arm belongs to
    r"[0-9]x|[a-e]|l[0-9]+|lP|[0-9]{2}[A-Z]|cd|M[cd]|h|"  # lengths of a group, an arc, mean moments, of heat
    r"[wabflpFs][0-9]?|[xyntlvakdeoirgm][0-9]?|k0|v0|SE|S2B"  # circles of wheels, axes, the n-th, t, l, v, a
    r")$"
)
"""Latin indices of the field: numbers of links, letters of points and segments, quantities, max and min."""
WORDS = re.compile(
    r"[PM]_b\b|[TJ]_[LFr]\b|_\{?(?:bl|in|red|mean|dr|ser|fA|fB|drv|res)\b|\b[PM]_?i\d|[yh]_P(?:b|i|in)\b"
)
"""Latin words that stood in indices."""
MACHINE = re.compile(r"[#{}\\∃]|∠[A-Z]|′′|\(1\) (?:или|or)|&(?:lt|gt|amp);")


class Told(NamedTuple):
    """A scene told in a language: its protocol, the names of its marks, those of its tables."""

    made: DrawnScene
    lines: tuple[str, ...]


@cache
def scene(name: str, language: str) -> Told:
    found = made(name)
    return Told(found, tuple(steps_of(found, PLANS, None, language)))


def logs(made: DrawnScene) -> Iterator[tuple[Construction, Reading]]:
    for board in made.boards:
        yield board.construction, board.reading


def names(log: Construction, language: str) -> set[str]:
    return {spoken(mark, language) for mark in (*log.given, *(step.it for step in log.steps))}


def faults(name: str) -> Iterator[str]:
    """What is no name for a reader."""
    if TALLY in name or any(part.count("′") > 1 for part in re.split("[–()]", name)):
        yield "primes"
    if MACHINE.search(name):
        yield "machine signs"


def russian_faults(name: str) -> Iterator[str]:
    yield from faults(name)
    if WORDS.search(name):
        yield "a Latin word in an index"
    for part in re.findall(r"[^\W\d_]_[A-Za-z0-9*ϑ′]+", name):
        if re.fullmatch(LATIN, part) is None:
            yield f"{part}: an index that the field does not know"


@pytest.mark.slow
@pytest.mark.parametrize("name", PACKAGED)
@each("language", ["ru", "en"])
def test_no_line_of_a_protocol_holds_what_only_machines_need(name: str, language: str) -> None:
    for line in scene(name, language).lines:
        assert not MACHINE.search(line), line
        assert TALLY not in line
        assert "— = " not in line, line  # no value is put in where there is none


@pytest.mark.slow
@pytest.mark.parametrize("name", PACKAGED)
def test_names_are_those_of_the_field_in_the_language_of_the_reader(name: str) -> None:
    for log, _ in logs(scene(name, "ru").made):
        wrong = {n: list(russian_faults(n)) for n in names(log, "ru") if any(russian_faults(n))}
        assert not wrong
        wrong = {n: list(faults(n)) for n in names(log, "en") if any(faults(n))}
        assert not wrong
        assert not [n for n in names(log, "en") if re.search("[А-Яа-яё]", n)]


def test_the_judge_of_names_knows_what_was_wrong() -> None:
    for name in (
        "P_b",
        "P_bl",
        "P_i3",
        "M_i2",
        "y_Pi3",
        "P_in",
        "J_red",
        "M_A(P_i3)",
        "M_fA1",
        "ε_dr",
    ):
        assert list(russian_faults(name)), name
    for name in ("ΣM′′", "m_3#", "∠G", "g′′", "l_{OA}"):
        assert list(faults(name)), name
    for name in (
        "P_ур",
        "P_и3",
        "M_и3′",
        "R_63^t",
        "ak2",
        "an2",
        "l_OS1",
        "μ_F",
        "ψ_max",
        "h_R43",
    ):
        assert not list(russian_faults(name)), name


def names_in(lines: tuple[str, ...]) -> set[str]:
    """Every name with an index, as it stands in the text of a protocol."""
    return {n for line in lines for n in re.findall(r"[^\W\d_]+′?_[\w*]+(?:\^[\w′]+)?", line)}


def catalogue(language: str) -> set[str]:
    return {lettered(text) for text in captions(language).values() if len(text) < 20}


@pytest.mark.parametrize("name", PACKAGED)
@each("language", ["ru", "en"])
def test_a_table_calls_its_rows_as_the_protocol_does(name: str, language: str) -> None:
    made, lines = scene(name, language)
    given = [mark for log, _ in logs(made) for mark in log.given]
    text = "\n".join([*lines, *(spoken(mark, language) for mark in given)])
    for column in scene_columns(made):
        called = plain(column_name(column, language))
        own = column.letter in captions(language)  # both methods side by side, differences, series
        assert own or called in text or called[0] in "ωε", (column, called)


def indexed(text: str) -> set[str]:
    """Forces, moments, energies and masses with an index, as a sheet, a table or a protocol tells them."""
    low = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
    found = re.findall(r"(?<![\w(])([PGFRMTJNDm][_₀-₉]\(?[\w,₀-₉]*(?:\^\(?[\wЖ]+)?)", text)
    return {re.sub(r"[_()]", "", n).translate(low) for n in found}


@pytest.mark.slow
@pytest.mark.parametrize("name", ["windrower", "engine", "locomobile", "crank-press"])
def test_what_a_sheet_calls_a_quantity_the_protocol_or_the_table_calls_it_too(name: str) -> None:
    scene_of = read(SHEETS / name)
    language = scene_of.language
    made, there = paper(name)
    texts = {label.text for sheet in there for view in sheet.drawings for label in view.labels}
    shown = {n.rstrip(",") for text in texts for n in indexed(lettered(text))}  # "J_{r}, kg·m²"
    known = indexed("\n".join(scene(name, language).lines))
    known |= set().union(*(indexed(plain(column_name(c, language))) for c in scene_columns(made)))
    known |= set().union(*(indexed(text) for text in catalogue(language)))
    task = (markup(symbol(row.symbol, language)) for row in given_rows(scene_of))
    known |= set().union(*(indexed(lettered(text)) for text in task))
    sizes = {"De", "Di", "Dmax", "Np", "Nв", "Nп"}  # given of the rim, indices of pairs
    bars = {n for n in shown if re.fullmatch(r"R\d+n", n)}  # R^n is the side from R^t to R
    known = {n.rstrip(",") for n in known}
    assert shown - known - sizes - bars == set()
    if language == "ru":
        assert not [
            n for n in shown if re.search(r"[PM](?:b|bl|in?\d?)$|[JT][FLr]$|mF|mean|red", n)
        ]


def _lines(log: Construction, reading: Reading, language: str) -> Iterator[ProtocolLine]:
    for view in dict.fromkeys(step.it.view for step in log.steps):
        yield from protocol(log, view, reading, 0, language)


@pytest.mark.slow
@given(st.integers(0, 10**6), st.integers(1, 3), st.booleans(), st.booleans())
@settings(deadline=None, max_examples=most(10), suppress_health_check=list(HealthCheck))
def test_random_mechanisms_under_loads_are_told_in_names_of_the_field(
    seed: int, dyads: int, turned: bool, pairs: bool
) -> None:
    dice = random.Random(seed)
    drawn = assemble(lambda n: dice.randint(0, n), (dyads, dyads))
    loaded = weighed(drawn, seed)
    order = order_of(loaded, gravity=True, inertia=True, couples="pair" if pairs else "moment")
    solved = solve(loaded, drawn.phi, drawn.poses, order, turned=turned, judged=False)
    assert not {n for n in names(solved.log, "ru") if any(russian_faults(n))}
    for language in ("ru", "en"):
        for line in _lines(solved.log, solved.reading, language):
            whole = f"{line.text} {line.calculation}"
            assert not MACHINE.search(whole), whole
            assert TALLY not in whole


SCENES = {
    "a machine under loads": ("effects", "load", "forces", "flywheel", "diagrams"),
    "an engine": ("effects", "indicator", "flywheel", "engine"),
    "friction": (
        "load",
        "[effects]\nfriction = true\n",
        '[friction]\nf = 0.1\nradius = "12 mm"\n',
        "forces",
    ),
}


@pytest.mark.parametrize("what", SCENES)
def test_other_machines_are_told_in_names_of_the_field(what: str, tmp_path: Path) -> None:
    made = in_usual_size(read(calling(tmp_path, *SCENES[what])))
    for log, _ in logs(made):
        assert not {n: list(russian_faults(n)) for n in names(log, "ru") if any(russian_faults(n))}
        assert not {n for n in names(log, "en") if any(faults(n))}
        assert {(op, n) for op, n in _collisions(log) if op != "measure_along"} == set()
    assert made.mechanism is not None
    for language in ("ru", "en"):
        for line in told(made.mechanism, PLANS, None, language):
            assert not MACHINE.search(line), line


@pytest.mark.parametrize("what", PARTS)
def test_other_parts_are_told_in_names_of_the_field(what: str, tmp_path: Path) -> None:
    log = part_of(tmp_path, what).construction
    assert not {n: list(russian_faults(n)) for n in names(log, "ru") if any(russian_faults(n))}
    assert not {n for n in names(log, "en") if any(faults(n))}
    # the stretches of a law by its diagram share the letters of their points
    assert set(_collisions(log)) == set() or "diagram" in what


def _collisions(log: Construction) -> Iterator[tuple[str, str]]:
    """Sentences in which two different marks of one view bear one name; sums and units apart."""
    for step in log.steps:
        if step.op.name in ("added", "in_kgf"):
            continue
        text = step.op.formula or step.op.sentence
        used = [m for a, m in zip(step.op.arguments, step.uses, strict=True) if f"{{{a}}}" in text]
        own = {m: m.name for m in (step.it, *used) if m.view == step.it.view and m.name}
        points = [n for n in own.values() if list(own.values()).count(n) > 1]
        if points and step.it.kind is not None:
            yield step.op.name, points[0]


@pytest.mark.parametrize("name", PACKAGED)
def test_no_sentence_calls_two_things_by_one_name(name: str) -> None:
    for log, _ in logs(scene(name, "ru").made):
        # k, the image of a wheel's point K, is carried over to the lever "k times as large"
        told = {one for one in _collisions(log) if one != ("carry", "k")}
        assert {(op, n) for op, n in told if op not in ("measure_along",)} == set()


TWO_LOADS = """title = "T"
language = "ru"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = ["0.1 m", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["0.35 m", 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = "40 1/s"
positions = 4
[[load]]
link = 3
point = "B"
force = "120 N"
[[load]]
link = 3
point = "B"
force = "20 N"
direction = "-33.5 deg"
[[load]]
link = 3
point = "B"
force = "10 N"
direction = 90
[forces]
positions = [1]
"""


def test_loads_of_one_link_are_told_apart_and_directions_by_their_value(tmp_path: Path) -> None:
    path = written(tmp_path, TWO_LOADS)
    made = in_usual_size(read(path))
    assert made.mechanism is not None
    lines = "\n".join(told(made.mechanism, PLANS, "1", "ru"))
    assert "Из B провести луч (F_3(2)) под углом −33,5° к оси x." in lines
    assert "Из B провести луч (F_3(3)) под углом 90° к оси x." in lines
    assert "F_3 = |F_3|·sgn(pb/pa) = 120·sgn(" in lines
    text = table(made, "csv")
    assert isinstance(text, str)
    assert {"F3", "F3(2)", "F3(3)"} <= {row.split(",")[3] for row in text.splitlines()}
    assert not MACHINE.search(lines)


def test_a_diagram_is_called_by_its_point(tmp_path: Path) -> None:
    lines = scene("slider-diagrams", "en").lines
    assert "Velocity diagram of B, position 2" in lines
    assert "Диаграмма скоростей точки B, положение 2" in scene("slider-diagrams", "ru").lines
    assert not [line for line in lines if "point," in line]


def test_a_sum_of_many_terms_is_one_line_that_counts_its_steps(tmp_path: Path) -> None:
    lines = scene("windrower", "ru").lines
    at = next(k for k, line in enumerate(lines) if "31–37. Вычислить ΣM." in line)
    formula, numbers, result = lines[at + 1].strip().removeprefix("ΣM = ").split(" = ")
    assert formula.count(" + ") == numbers.count(" + ") == 7
    terms = [float(t.strip("()").replace("−", "-").replace(",", ".")) for t in numbers.split(" + ")]
    due = float(result.split()[0].replace("−", "-"))
    assert abs(sum(terms) - due) <= 8 * 0.5  # each term is told to a whole N·mm


@pytest.mark.slow
def test_the_protocol_says_which_moment_varies_as_the_sheet_does() -> None:
    scene_of = read(SHEETS / "windrower")
    assert scene_of.tasks.get("flywheel") is not None
    for constant, what in (("driving", "сил сопротивления"), ("resisting", "движущих сил")):
        changed = scene_of.asking(flywheel=replace(scene_of.tasks["flywheel"], constant=constant))
        made = in_usual_size(changed)
        assert made.mechanism is not None
        title = f"Приведённый момент {what}"
        assert f"{title}, положение 2" in list(told(made.mechanism, ("flywheel",), "2", "ru"))
        places = (p for one in made.mechanism.project.chapters for p in one.places)
        views = (
            view
            for place in places
            if place.name in changed.called
            for view in drawing_of(place.name)(made.mechanism, True)
        )
        texts = {label.text for view in views for label in view.labels}
        assert title in texts
        assert not any("Приведённый момент" in text and what not in text for text in texts)
