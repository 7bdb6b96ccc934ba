"""DXF: read back by ezdxf without faults, millimetres, layers, what is round is round, the same bytes."""

from __future__ import annotations

import cmath
import io
import itertools
import math
import os
import random
import re
import subprocess
import sys

import pytest
from support.each import each
from support.gallery import ALL, paper

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Sheet, Stroke, arc, circle, line
from graphic_tmm.paper.write.dxf import dxf
from graphic_tmm.paper.write.dxf_text import WEIGHTS

ezdxf = pytest.importorskip("ezdxf")


def sheet_of(
    *strokes: Stroke | Bezier, labels: tuple[Label, ...] = (), name: str = "plan"
) -> Sheet:
    return Sheet("s1", "Лист", "A4", 210, 297, (Drawing(name, "План", strokes, labels),))


def opened(made: Sheet, *, stroked: bool = False):
    return ezdxf.read(io.StringIO(dxf(made, stroked=stroked)))


def model(*strokes: Stroke | Bezier, labels: tuple[Label, ...] = ()):
    return list(opened(sheet_of(*strokes, labels=labels)).modelspace())


@pytest.fixture(scope="module")
def sheet():
    return paper("engine")[1][0]


@pytest.fixture(scope="module")
def document(sheet):
    return opened(sheet)


# --- the document ---------------------------------------------------------------------------------


def test_no_faults_and_millimetres(document, sheet) -> None:
    auditor = document.audit()
    assert not auditor.errors
    assert not auditor.fixes
    assert document.dxfversion == "AC1024"
    assert document.units == 4
    assert document.header["$LWDISPLAY"] == 1
    assert document.header["$LIMMAX"] == (sheet.width, sheet.height)


def test_the_extents_are_those_of_the_ink(sheet) -> None:
    """By ezdxf's own boxes, of strokes alone: the letters of a font are not known here."""
    document = opened(sheet, stroked=True)
    bbox = pytest.importorskip("ezdxf.bbox")
    found = bbox.extents(document.modelspace(), fast=False)
    for told, due in ((found.extmin, "$EXTMIN"), (found.extmax, "$EXTMAX")):
        assert tuple(told)[:2] == pytest.approx(tuple(document.header[due])[:2], abs=0.05)


def test_the_paper_shows_the_sheet_at_its_size(document, sheet) -> None:
    layout = document.layout("A1")
    assert (layout.dxf.paper_width, layout.dxf.paper_height) == (sheet.width, sheet.height)
    assert (layout.dxf.scale_numerator, layout.dxf.scale_denominator) == (1, 1)
    (window,) = [v for v in layout.viewports() if v.dxf.id != 1]
    assert (window.dxf.width, window.dxf.height) == (sheet.width, sheet.height)
    assert window.dxf.view_height == sheet.height
    assert tuple(window.dxf.center)[:2] == tuple(window.dxf.view_center_point)[:2]
    assert not document.layers.get(window.dxf.layer).dxf.plot


def test_layers_by_view_and_line_kind(document) -> None:
    layers = {layer.dxf.name: layer for layer in document.layers}
    assert {"positions_rod", "velocities_main", "velocities_medium", "frame_main"} <= set(layers)
    assert layers["velocities_main"].dxf.lineweight == 80
    assert layers["velocities_main"].description.endswith("план скоростей, все положения: main")
    assert all(layer.dxf.lineweight in (*WEIGHTS, -3) for layer in layers.values())
    used = {entity.dxf.layer for entity in document.modelspace()}
    assert used <= set(layers)


def test_dashes_are_those_of_the_pen() -> None:
    document = opened(sheet_of(line("centre", 0j, 60 + 0j)))
    (entity,) = document.modelspace()
    kind = document.linetypes.get(document.layers.get(entity.dxf.layer).dxf.linetype)
    lengths = [tag.value for tag in kind.pattern_tags.tags if tag.code == 49]
    assert lengths == [12.0, -1.5, 1.0, -1.5]


def test_everything_stands_on_the_sheet(document, sheet) -> None:
    for entity in document.modelspace().query("LWPOLYLINE LINE TEXT"):
        for x, y in places(entity):
            assert -1e-6 <= x <= sheet.width + 1e-6
            assert -1e-6 <= y <= sheet.height + 1e-6


def places(entity) -> list[tuple[float, float]]:
    if entity.dxftype() == "LWPOLYLINE":
        return list(entity.get_points("xy"))
    ends = ("start", "end") if entity.dxftype() == "LINE" else ("insert", "align_point")
    return [tuple(entity.dxf.get(end))[:2] for end in ends]


# --- lengths and shapes ---------------------------------------------------------------------------


def test_the_check_line_is_100_mm(document) -> None:
    long = [
        abs(line.dxf.end.y - line.dxf.start.y)
        for line in document.modelspace().query("LINE")
        if line.dxf.start.x == line.dxf.end.x == 5.5
    ]
    assert any(abs(length - 100.0) < 1e-9 for length in long)


@each("name, crank", [("crank-rocker", 20.0), ("shaper", 110.0)])
def test_a_crank_is_as_long_as_its_scale_says(name: str, crank: float) -> None:
    """The circle of the crank pin, of l/μ_l (``crank``: OA as the scene's file has it, mm)."""
    sheet = paper(name)[1][0]
    texts = " ".join(label.text for drawing in sheet.drawings for label in drawing.labels)
    scale = float(re.search(r"μ_l = ([\d.,]+)", texts)[1].replace(",", "."))
    radii = [made.dxf.radius for made in opened(sheet).modelspace().query("CIRCLE")]
    assert min(abs(radius - crank / 1000 / scale) for radius in radii) < 1e-6


def scattered(seed: int, count: int) -> list[complex]:
    """Places on an A4, at random."""
    chance = random.Random(seed)
    return [complex(chance.uniform(50, 150), chance.uniform(50, 250)) for _ in range(count)]


def at(vector) -> complex:
    return complex(vector[0], vector[1])


def test_a_circle_is_a_circle() -> None:
    centres = scattered(1, 60)
    found = model(*(circle("main", z, 0.5 + k) for k, z in enumerate(centres)))
    assert len(found) == 60
    for k, (made, centre) in enumerate(zip(found, centres, strict=True)):
        assert made.dxftype() == "CIRCLE"
        assert made.dxf.radius == pytest.approx(0.5 + k, abs=1e-6)
        assert abs(at(made.dxf.center) - centre) < 2e-6


def test_an_arc_is_an_arc() -> None:
    """From its start over its sweep, the way round that is asked for."""
    chance = random.Random(2)
    asked = [
        (z, chance.uniform(0.5, 40), chance.uniform(-360, 360), sign * chance.uniform(1, 359))
        for z in scattered(3, 60)
        for sign in (-1, 1)
    ]
    found = model(*(arc("thin", *one) for one in asked))
    for made, (centre, radius, start, sweep) in zip(found, asked, strict=True):
        assert made.dxftype() == "ARC"
        assert made.dxf.radius == pytest.approx(radius, abs=1e-6)
        first, last = (start, start + sweep) if sweep > 0 else (start + sweep, start)
        for told, due in ((made.start_point, first), (made.end_point, last)):
            assert abs(at(told) - centre - cmath.rect(radius, math.radians(due))) < 5e-6
        long = (made.dxf.end_angle - made.dxf.start_angle) % 360
        assert long == pytest.approx(abs(sweep), abs=1e-4)


@each(
    "path",
    [
        ((0.0, 0.0, 1.0), (10.0, 0.0, 0.0), (20.0, 0.0, 0.0)),  # an arc and a line
        ((0.0, 0.0, 0.5), (10.0, 0.0, 0.5), (20.0, 0.0, 0.0)),  # two arcs of one turn, two centres
        ((0.0, 0.0, 1.0), (10.0, 0.0, -1.0), (20.0, 0.0, 0.0)),  # there and back
        ((0.0, 0.0, 0.0), (10.0, 0.0, 0.0), (20.0, 9.0, 0.0)),  # two lines
    ],
)
def test_what_is_no_arc_as_a_whole_stays_a_polyline(path) -> None:
    (made,) = model(Stroke("main", path))
    assert made.dxftype() == "LWPOLYLINE"
    assert [tuple(point) for point in made.get_points("xyb")] == list(path)


def test_a_curve_is_a_spline_and_the_same_curve() -> None:
    """Two arcs to a curve, at random; against de Casteljau's own halving of each."""
    places = scattered(4, 140)
    curves = [tuple(places[k : k + 7]) for k in range(0, 140, 7)]
    for made, controls in zip(model(*(Bezier("thin", c) for c in curves)), curves, strict=True):
        assert (made.dxftype(), made.dxf.degree) == ("SPLINE", 3)
        tool = made.construction_tool()
        for half, t in itertools.product((0, 1), (0.0, 0.2, 0.5, 0.9, 1.0)):
            row = list(controls[3 * half : 3 * half + 4])
            while len(row) > 1:
                row = [(1 - t) * a + t * b for a, b in itertools.pairwise(row)]
            assert abs(at(tool.point(half + t)) - row[0]) < 2e-6


def test_an_arrowhead_is_solid_and_a_dot_is_filled() -> None:
    head, dot = model(
        line("main", 0j, 5 + 1j, 5 - 1j, closed=True, filled=True),
        circle("main", 20j, 1, filled=True),
    )
    assert (head.dxftype(), dot.dxftype()) == ("SOLID", "HATCH")


# --- lettering ------------------------------------------------------------------------------------


def letters_of(markup: str) -> str:
    """The letters of a mark-up, by reading it as a person does: without marks and spaces."""
    escaped = re.sub(r"\\([_^{}\\])", lambda m: chr(0xE000 + ord(m[1])), markup)
    bare = re.sub(r"\\(bar|uu|u)(?={)|[_^{}\s]", "", escaped)
    return "".join(chr(ord(c) - 0xE000) if "\ue000" <= c <= "\uf8ff" else c for c in bare)


def share_of_text(sheet: Sheet) -> tuple[int, int]:
    """How many letters of a sheet are TEXT, and how many it has."""
    texts = opened(sheet).modelspace().query("TEXT")
    written = sum(len(re.sub(r"\s", "", text.plain_text())) for text in texts)
    return written, sum(len(letters_of(la.text)) for d in sheet.drawings for la in d.labels)


def test_letters_are_text(sheet) -> None:
    written, due = share_of_text(sheet)
    assert 0.99 * due < written <= due


@pytest.mark.slow
@each("name", ALL)
def test_letters_of_every_scene_are_text(name: str) -> None:
    for sheet in paper(name)[1]:
        document = opened(sheet)
        assert not document.audit().errors
        written, due = share_of_text(sheet)
        assert 0.95 * due <= written <= due


def test_letters_as_strokes_are_had_on_wish(sheet) -> None:
    document = opened(sheet, stroked=True)
    assert not document.modelspace().query("TEXT")
    assert not len(document.groups)


@each("turn", [0.0, 90.0, 30.0])
@each("anchor, share", [("start", 0.0), ("middle", 0.5), ("end", 1.0)])
def test_a_run_of_text_stands_where_our_letters_stand(
    turn: float, anchor: str, share: float
) -> None:
    """ГОСТ 2.304, type B: five Н of 6/10 h with four gaps of 2/10 h, half a gap on either side."""
    label = Label("ННННН", 100 + 100j, 10, anchor, turn, inclined=False)
    (text,) = model(labels=(label,))
    assert (text.dxf.text, text.dxf.height, text.dxf.oblique) == ("ННННН", 10.0, 0.0)
    assert text.get_align_enum().name == "FIT"
    way = cmath.rect(1, math.radians(turn))
    ends = [at(text.dxf.get(end)) for end in ("insert", "align_point")]
    begin, end = ((z - 100 - 100j) / way for z in ends)
    assert begin == pytest.approx(-38 * share - 1, abs=1e-5)
    assert end - begin == pytest.approx(40, abs=1e-5)


def test_indices_are_smaller_text_and_bars_are_lines_of_one_group() -> None:
    """v is 5/10 h wide, the index begins 1.5/10 h behind it, 3/10 h lower; A of 7 mm is 4.9 mm wide."""
    document = opened(sheet_of(labels=(Label(r"\bar{v}_{A}", 50 + 50j, 10, inclined=False),)))
    found = {entity.dxftype(): entity for entity in document.modelspace()}
    v, index = document.modelspace().query("TEXT")
    bar = found["LWPOLYLINE"]
    assert (v.dxf.text, v.dxf.height) == ("v", 10.0)
    assert (index.dxf.text, index.dxf.height) == ("A", 7.0)
    assert tuple(index.dxf.insert)[:2] == pytest.approx((50 + 5 + 1.5 - 0.7, 47), abs=1e-5)
    assert tuple(index.dxf.align_point)[:2] == pytest.approx((56.5 + 4.9 + 0.7, 47), abs=1e-5)
    (group,) = [group for _, group in document.groups]
    assert set(group) == {v, index, bar}
    assert group.dxf.description == "v_A"


def test_inclined_letters_lean_by_15_degrees_and_raised_ones_stand_farther_right() -> None:
    document = opened(sheet_of(labels=(Label("a^n", 50 + 50j, 10),)))
    a, n = document.modelspace()
    style = document.styles.get(a.dxf.style)
    assert (a.dxf.oblique, style.dxf.oblique, style.dxf.height) == (15.0, 15.0, 0.0)
    upright = opened(sheet_of(labels=(Label("a^n", 50 + 50j, 10, inclined=False),)))
    rise = n.dxf.insert.y - 50
    shifted = n.dxf.insert.x - list(upright.modelspace())[1].dxf.insert.x
    assert shifted == pytest.approx(rise * math.tan(math.radians(15)), abs=1e-5)


def test_signs_that_fonts_do_not_hold_are_drawn_among_the_text() -> None:
    made = model(labels=(Label("AB ⊥ CD", 50 + 50j, 5),))
    assert [text.dxf.text for text in made if text.dxftype() == "TEXT"] == ["AB", "CD"]
    drawn = [e for e in made if e.dxftype() == "LWPOLYLINE"]
    reach = [x for e in drawn for x, _ in e.get_points("xy")]
    first, second = (text for text in made if text.dxftype() == "TEXT")
    assert first.dxf.align_point.x < min(reach) < max(reach) < second.dxf.insert.x + 1.0


@each("text", [r"\\U+0041", "a \\^ b", "%%c 100%", r"\{x\}", "№ «5»", "  a  "])
def test_no_letter_of_a_text_becomes_a_mark(text: str) -> None:
    """Of a percent sign twice three each time: what "%%%" means to CAD programs, ezdxf leaves as it is."""
    found = [
        t.plain_text() for t in model(labels=(Label(text, 50 + 50j),)) if t.dxftype() == "TEXT"
    ]
    told = "".join(found).replace("%%%", "%").replace(" ", "")
    assert told == re.sub(r"[\\^]", "", letters_of(text))


# --- the same bytes -------------------------------------------------------------------------------

ALL_KINDS = """
import hashlib, sys
from graphic_tmm.paper.drawing import *
from graphic_tmm.paper.write.dxf import dxf
strokes = (line("main", 0j, 9j), line("paper", 0j, 1j, 2 + 2j, closed=True), circle("joint", 5j, 1.5),
           arc("thin", 9j, 4, 0, 100), line("thin", 0j, 1j, 2 + 2j, closed=True, filled=True),
           circle("main", 9j, 1, filled=True), Bezier("dashed", (0j, 1j, 2j, 3 + 3j)),
           line("centre", 0j, 5j, 5 + 5j))
labels = (Label("v_A = 5 ⊥", 9 + 9j), Label("План", 20j, 5, "middle", 90, False))
drawings = tuple(Drawing(f"plan-{k}", "План", strokes, labels) for k in range(3))
text = dxf(Sheet("s", "t", "A4", 210, 297, drawings))
print(hashlib.sha256(text.encode()).hexdigest())
"""


def test_the_same_bytes_whatever_the_hash_seed_and_the_clock() -> None:
    runs = [
        subprocess.Popen(
            [sys.executable, "-c", ALL_KINDS],
            env={**os.environ, "PYTHONHASHSEED": str(seed), "TZ": f"UTC+{seed}"},
            stdout=subprocess.PIPE,
            text=True,
        )
        for seed in range(1, 6)
    ]
    said = {run.communicate()[0].strip() for run in runs}
    assert len(said) == 1
    assert re.fullmatch("[0-9a-f]{64}", said.pop())


@pytest.mark.slow
def test_a_scene_gives_the_same_bytes_whatever_the_hash_seed(tmp_path) -> None:
    """From its file to the DXF of its sheets."""
    command = [sys.executable, "-m", "graphic_tmm", "draw", "crank-rocker", "-f", "dxf", "-o"]
    runs = [
        subprocess.Popen(
            [*command, str(tmp_path / seed)],
            env={**os.environ, "PYTHONHASHSEED": seed},
            stdout=subprocess.DEVNULL,
        )
        for seed in "12345"
    ]
    assert not any(run.wait() for run in runs)
    found = {
        tuple(path.read_bytes() for path in sorted((tmp_path / seed).iterdir())) for seed in "12345"
    }
    assert [len(files) for files in found] == [len(paper("crank-rocker")[1])]


def test_without_ezdxf_the_remedy_is_told(sheet, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "ezdxf", None)
    with pytest.raises(SheetError, match=r"pip install 'graphic-tmm\[dxf\]'"):
        dxf(sheet)
