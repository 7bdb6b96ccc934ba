"""Graphs in ink: what the log drew and nothing else, over the base, the curve through its points."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shapely
from support.boards import drawn_of
from support.each import each
from support.gallery import SHEETS

from graphic_tmm.board import roles
from graphic_tmm.board.values import Curve
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN
from graphic_tmm.chapters.diagrams.task import KinematicTask
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.clipping import points
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.graph_rules import axes_of
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.shapes import box, flat, shape
from graphic_tmm.paper.views import pole_figures
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import SheetOrder

POINTS = {"windrower": "D", "engine": "B"}
CASES = [
    (n, s, m) for n in POINTS for s in ("displacement", "velocity") for m in ("chords", "tangents")
]


@cache
def drawn(name: str, start: str, method: str) -> Drawn:
    order = KinematicTask(POINTS[name], start=start, method=method)
    sheets = (SheetOrder("A1", ("positions", "velocities", "diagrams")),)
    scene = replace(read(SHEETS / name), sheets=sheets).asking(diagrams=order, flywheel=None)
    return drawn_of(scene, exact=True)


def graph(work: Drawn, symbol: str, *, lettered: bool = True) -> Drawing:
    """A diagram with its letters in their places, or with room for them."""
    names = Names(work.project.names, symbol, "t")
    log, row = work.project.construction, work.project.count
    view = f"diagram {symbol}"
    return finished(draw_graph(Subject(log, work.reading, "X"), view, row, names), lettered)


def length(work: Drawn, symbol: str) -> float:
    marks = axes_of(work.project.construction, f"diagram {symbol}")
    return float(work.reading[marks.length][0, 0])


def fine(curve: Bezier) -> np.ndarray:
    """A curve by 64 chords for each of its arcs: they are off by a 64th of what 8 of them are."""
    return points(curve.controls, 64 * (len(curve.controls) // 3) + 1)


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES, ids="-".join)
@each("symbol", ["S", "V", "a"])
def test_the_curve_stands_over_the_base_and_passes_through_the_readings(
    case: tuple[str, str, str], symbol: str
) -> None:
    work = drawn(*case)
    assert DIAGRAMS_PLAN.of(work) is not None
    chart = DIAGRAMS_PLAN.on(work).charts[symbol]
    pieces = [s for s in graph(work, symbol).strokes if isinstance(s, Bezier)]
    assert pieces
    x = [z.real for piece in pieces for z in piece.controls]
    assert min(x) == pytest.approx(0.0, abs=1e-6)
    assert max(x) == pytest.approx(length(work, symbol), abs=1e-6)
    path = shapely.union_all(
        [shapely.LineString([(z.real, z.imag) for z in fine(p)]) for p in pieces]
    )
    feet = work.reading[axes_of(work.project.construction, chart.view).feet][0]
    ordinates = work.reading[chart.ordinates[0]][0]
    for k, (foot, y) in enumerate(zip(feet, ordinates, strict=True)):
        # so many chords stand for an arc; a position beside the row has a reading of its own
        beside = 0.0 if k < work.project.count else 0.005 * np.abs(ordinates).max()
        assert path.distance(shapely.Point(foot.real, y)) < 0.005 + beside


@pytest.mark.parametrize("case", CASES, ids="-".join)
@each("symbol", ["S", "V", "a"])
def test_no_letter_stands_on_another_and_all_positions_are_numbered(
    case: tuple[str, str, str], symbol: str
) -> None:
    work = drawn(*case)
    view = graph(work, symbol)
    boxes = [box(label) for label in view.labels]
    for k, one in enumerate(boxes):
        assert not any(one.intersects(other) for other in boxes[k + 1 :])
    texts = [label.text for label in view.labels]
    for name in work.project.names:
        assert texts.count(name) == 1
    first, count = work.project.names[0], work.project.count
    assert texts.count(f"{first} ({int(first) + count})") == 1  # where the turn ends
    assert symbol in texts
    assert "t" in texts


def test_every_chord_of_a_differentiation_is_drawn_and_its_ray_is_parallel_to_it() -> None:
    work = drawn("windrower", "velocity", "chords")
    log, row = work.project.construction, work.project.count
    join = next(s for s in log.steps if s.op.name == "join" and s.it.view == "diagram V")
    chords = work.reading[join.it].along[0, :row]
    bare = graph(work, "a", lettered=False)
    thin = [s for s in bare.strokes if isinstance(s, Stroke) and s.pen == "thin"]
    pole = next(s.it for s in log.steps if s.it.view == "diagram a" and s.it.letter == "P")
    start = complex(work.reading[pole][0, 0])
    ways = []
    for stroke in thin:
        ends = [complex(x, y) for x, y, _ in stroke.path]
        if abs(ends[0] - start) < 1e-9 and abs(ends[-1].real) < 1e-9 and ends[-1].imag:
            ways.append((ends[-1] - start) / abs(ends[-1] - start))
    for chord in chords:
        assert min(abs((way * np.conj(chord)).imag) for way in ways) < 1e-9


def test_an_unlettered_graph_takes_the_room_of_its_ink() -> None:
    work = drawn("windrower", "displacement", "chords")
    for symbol in ("S", "V", "a"):
        bare = graph(work, symbol, lettered=False)
        assert bare.cell is not None
        room = shapely.box(*bare.cell)
        assert all(room.covers(shape(s)) for s in graph(work, symbol).strokes)


def test_a_curve_that_a_reading_is_taken_from_is_a_curve_of_the_log() -> None:
    work = drawn("engine", "velocity", "tangents")
    log = work.project.construction
    for symbol in ("S", "V", "a"):
        curves = [s for s in log.steps if s.it.kind is Curve and s.it.view == f"diagram {symbol}"]
        drawn_curves = {s.title for s in graph(work, symbol).strokes if isinstance(s, Bezier)}
        assert drawn_curves == {step.it.letter for step in curves}


@each("symbol", ["V", "a"])
def test_the_distance_of_the_pole_is_dimensioned_above_the_graph(symbol: str) -> None:
    work = drawn("windrower", "displacement", "chords")
    log, view = work.construction, f"diagram {symbol}"
    (pole,) = [s for s in log.steps if s.it.view == view and s.it.role == roles.POLE]
    (text,) = (told := pole_figures(log, work.reading, view, "en")).values()
    names = Names(work.project.names, symbol, "t", lengths=told)
    made = draw_graph(Subject(log, work.reading, "X"), view, work.project.count, names)
    (label,) = [label for label in made.labels if label.text == text]
    strokes = [s for s in made.strokes if s.part == "dimension" and isinstance(s, Stroke)]
    assert strokes
    assert {s.of for s in strokes} == {(pole.it.slot,)} == {label.of}
    spot = complex(work.reading[pole.it][0, 0])
    tips = [s.path[0][0] for s in strokes if s.closed]
    assert sorted(tips) == pytest.approx([spot.real, 0.0], abs=1e-9)
    curves = [z.imag for s in made.strokes if isinstance(s, Bezier) for z in flat(s.controls)]
    assert all(s.path[-1][1] > max(curves) for s in strokes)
    assert text == f"{pole.uses[1].name} = {-spot.real:.4g}"
