"""DXF: what is round is round, lengths are those of the paper, signs are blocks."""

from __future__ import annotations

import cmath
import itertools
import math
import random
import re
from collections import Counter

import pytest
from support.dxf_read import at, model, opened, scattered, sheet_of
from support.each import each
from support.gallery import paper

from graphic_tmm.paper.drawing import Bezier, Drawing, Sheet, Stroke, arc, circle, line
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, slider, stone


@each("name, crank", [("crank-rocker", 20.0), ("shaper", 110.0)])
def test_a_crank_is_as_long_as_its_scale_says(name: str, crank: float) -> None:
    """The circle of the crank pin, broken at letters, of l/μ_l (``crank``: OA as the scene has it, mm)."""
    sheet = paper(name)[1][0]
    texts = " ".join(label.text for drawing in sheet.drawings for label in drawing.labels)
    scale = float(re.search(r"μ_l = ([\d.,]+)", texts)[1].replace(",", "."))
    radii = [made.dxf.radius for made in opened(sheet).modelspace().query("CIRCLE ARC")]
    assert min(abs(radius - crank / 1000 / scale) for radius in radii) < 1e-6


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
    ((edge,),) = [path.edges for path in dot.paths]
    assert (at(edge.center), edge.radius, edge.end_angle - edge.start_angle) == (20j, 1.0, 360.0)


def outlines(entities) -> list[list[complex]]:
    """Ends of lines and corners of polylines, in no order."""
    found = []
    for entity in entities:
        if entity.dxftype() == "LINE":
            found.append([at(entity.dxf.start), at(entity.dxf.end)])
        elif entity.dxftype() == "LWPOLYLINE":
            found.append([complex(x, y) for x, y in entity.get_points("xy")])
    return sorted(found, key=lambda ends: [(round(z.real, 3), round(z.imag, 3)) for z in ends])


def test_signs_are_blocks_that_lie_where_their_strokes_do() -> None:
    """Taken apart by ezdxf, which moves and turns them in its own way."""
    spots = scattered(5, 6)
    strokes = [
        *(s for k, z in enumerate(spots[:4]) for s in fixed_pivot(z, 37.0 * k)),
        *slider(spots[4], 20.0),
        *stone(spots[5], -70.0, pin=False),
    ]
    document = opened(sheet_of(*strokes))
    signs = list(document.modelspace())
    assert {sign.dxftype() for sign in signs} == {"INSERT"}
    names = Counter(sign.dxf.name for sign in signs)
    assert names == {"SUPPORT": 4, "PAIR": 5, "SLIDER": 1, "STONE": 1}
    parts = [entity for sign in signs for entity in sign.virtual_entities()]
    circles = [entity for entity in parts if entity.dxftype() == "CIRCLE"]
    assert sorted(at(entity.dxf.center).real for entity in circles) == pytest.approx(
        sorted(z.real for z in spots[:5]), abs=1e-5
    )
    plain = opened(sheet_of(*(stroke._replace(symbol=None) for stroke in strokes))).modelspace()
    made, due = outlines(parts), outlines(plain)
    assert [len(ends) for ends in made] == [len(ends) for ends in due]
    for ends, others in zip(made, due, strict=True):
        assert max(abs(a - b) for a, b in zip(ends, others, strict=True)) < 1e-5


def test_a_sign_is_moved_with_its_drawing() -> None:
    drawing = Drawing("plan", "План", fixed_pivot(50 + 50j, 30.0)).moved(10 + 70j)
    document = opened(Sheet("s", "t", "A4", 210, 297, (drawing,)))
    signs = list(document.modelspace())
    assert [(sign.dxf.name, at(sign.dxf.insert)) for sign in signs] == [
        ("SUPPORT", 60 + 120j),
        ("PAIR", 60 + 120j),
    ]
    found = [e for sign in signs for e in sign.virtual_entities()]
    bare = fixed_pivot(60 + 120j, 30.0)
    due = opened(sheet_of(*(stroke._replace(symbol=None) for stroke in bare))).modelspace()
    for ends, others in zip(outlines(found), outlines(due), strict=True):
        assert max(abs(a - b) for a, b in zip(ends, others, strict=True)) < 1e-5


def test_a_sign_that_looks_otherwise_is_another_block_and_a_twin_is_none() -> None:
    support = fixed_pivot(50 + 50j)
    cut = [s for s in fixed_pivot(90 + 50j) if s.path != fixed_pivot(90 + 50j)[3].path]
    document = opened(sheet_of(*support, *support, *cut))
    names = [sign.dxf.name for sign in document.modelspace()]
    assert sorted(names) == ["PAIR", "PAIR", "SUPPORT", "SUPPORT_2"]
    assert len(document.blocks.get("SUPPORT")) == len(document.blocks.get("SUPPORT_2")) + 1
