"""DXF: read back by ezdxf without faults, millimetres, layers, a paper layout, the same bytes."""

from __future__ import annotations

import math
import os
import re
import subprocess
import sys

import pytest
from support.dxf_read import at, opened, sheet_of
from support.gallery import composed, paper

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Drawing, Label, Sheet, line
from graphic_tmm.paper.write.dxf import dxf
from graphic_tmm.paper.write.dxf_ink import WEIGHTS
from graphic_tmm.studio import files_of


@pytest.fixture(scope="module")
def sheet():
    return paper("engine")[1][0]


@pytest.fixture(scope="module")
def document(sheet):
    return opened(sheet)


def test_no_faults_and_millimetres(document, sheet) -> None:
    auditor = document.audit()
    assert not auditor.errors
    assert not auditor.fixes
    assert document.dxfversion == "AC1024"
    assert document.units == 4
    assert document.header["$LWDISPLAY"] == 1
    assert document.header["$LIMMAX"] == (sheet.width, sheet.height)


@pytest.mark.slow
def test_the_extents_are_those_of_the_ink(sheet) -> None:
    """By ezdxf's own boxes, of strokes alone: the letters of a font are not known here."""
    document = opened(sheet, stroked=True)
    bbox = pytest.importorskip("ezdxf.bbox")
    found = bbox.extents(document.modelspace(), fast=False)
    for told, due in ((found.extmin, "$EXTMIN"), (found.extmax, "$EXTMAX")):
        assert tuple(told)[:2] == pytest.approx(tuple(document.header[due])[:2], abs=0.05)


def test_the_paper_shows_the_sheet_at_its_size(document, sheet) -> None:
    layout = document.layout(sheet.format)
    assert (layout.dxf.paper_width, layout.dxf.paper_height) == (sheet.width, sheet.height)
    assert (layout.dxf.scale_numerator, layout.dxf.scale_denominator) == (1, 1)
    (window,) = [v for v in layout.viewports() if v.dxf.id != 1]
    assert (window.dxf.width, window.dxf.height) == (sheet.width, sheet.height)
    assert window.dxf.view_height == sheet.height
    assert tuple(window.dxf.center)[:2] == tuple(window.dxf.view_center_point)[:2]
    assert not document.layers.get(window.dxf.layer).dxf.plot


def test_layers_by_view_position_and_line_kind() -> None:
    documents = [opened(sheet) for sheet in paper("engine")[1]]
    layers = {layer.dxf.name: layer for document in documents for layer in document.layers}
    due = {
        "positions-2_rod",
        "positions-5_thin",
        "velocities_main",
        "velocities-1_medium",
        "velocities-5_medium",
    }
    assert {*due, "accelerations-5_medium", "frame_main"} <= set(layers)
    assert layers["velocities_main"].dxf.lineweight == 80
    assert layers["velocities-1_medium"].dxf.lineweight == 40
    assert layers["velocities-1_medium"].description.endswith("все положения, 1, векторы")
    assert all(layer.dxf.lineweight in (*WEIGHTS, -3) for layer in layers.values())
    used = {entity.dxf.layer for document in documents for entity in document.modelspace()}
    assert used <= set(layers)


def test_strokes_and_letters_of_a_position_lie_on_its_layers() -> None:
    """Positions that stand in a drawing together are told by their numbers; others by the drawing's name."""
    own, shared = line("thin", 0j, 9j)._replace(position=2), line("thin", 1j, 9j)
    letter = Label("a", 5j, position=2)
    together = Drawing("plan", "План", (own, shared), (letter,), numbers=((2, "3*"),))
    alone = Drawing("plan-4", "План", (own, shared), (letter,))
    document = opened(Sheet("s", "t", "A4", 210, 297, (together, alone)))
    assert [entity.dxf.layer for entity in document.modelspace()] == [
        *("plan-3~_thin", "plan_thin", "plan-3~_lettering"),
        *("plan-4_thin", "plan-4_thin", "plan-4_lettering"),
    ]


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


def test_the_check_line_is_100_mm(document, sheet) -> None:
    (drawn,) = [s for d in sheet.drawings for s in d.strokes if dict(s.data).get("check-line")]
    ends = [complex(x, y) for x, y, _ in drawn.path]
    found = [[at(made.dxf.start), at(made.dxf.end)] for made in document.modelspace().query("LINE")]
    near = [
        pair for pair in found if max(abs(a - b) for a, b in zip(pair, ends, strict=True)) < 1e-6
    ]
    assert [abs(b - a) for a, b in near] == pytest.approx([100.0], abs=1e-9)


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


@pytest.mark.slow
def test_the_same_bytes_whatever_the_hash_seed_and_the_clock() -> None:
    runs = [
        subprocess.Popen(
            [sys.executable, "-c", ALL_KINDS],
            env={**os.environ, "PYTHONHASHSEED": str(seed), "TZ": f"UTC+{seed}"},
            stdout=subprocess.PIPE,
            text=True,
        )
        for seed in range(1, 3)
    ]
    said = {run.communicate()[0].strip() for run in runs}
    assert len(said) == 1
    assert re.fullmatch("[0-9a-f]{64}", said.pop())


@pytest.mark.slow
@pytest.mark.parametrize("name", ["crank-rocker"])
def test_a_scene_gives_the_same_bytes_whatever_the_hash_seed(name: str, tmp_path) -> None:
    """From its file to the DXF of its sheets: in another process as in this one, whose seed is another."""
    command = [sys.executable, "-m", "graphic_tmm", "draw", name, "-f", "dxf", "-o", tmp_path]
    subprocess.run(command, env={**os.environ, "PYTHONHASHSEED": "1"}, check=True)
    here = files_of(*composed(name), ("dxf",))
    assert {path.name: path.read_text("utf-8") for path in tmp_path.iterdir()} == here


def test_a_place_that_is_none_and_an_unknown_pen_are_refused() -> None:
    for bad in (math.nan, math.inf):
        with pytest.raises(SheetError, match="finite"):
            dxf(sheet_of(line("main", 0j, complex(bad, 1))))
        with pytest.raises(SheetError, match="finite"):
            dxf(sheet_of(line("body", 0j, complex(bad, 1), 9j, closed=True)))
        with pytest.raises(SheetError, match="finite"):
            dxf(sheet_of(labels=(Label("a", complex(1, bad)),)))
    with pytest.raises(SheetError, match="crayon"):
        dxf(sheet_of(line("crayon", 0j, 1j)))


def test_without_ezdxf_the_remedy_is_told(sheet, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "ezdxf", None)
    with pytest.raises(SheetError, match=r'pip install "graphic-tmm\[dxf\]"'):
        dxf(sheet)
