"""The energy–mass curve and the sketch are read off the log: of the scenes and of machines drawn at random."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.boards import drawn_of
from support.each import each
from support.flywheels import crank, scene_of
from support.gallery import asking, drawn
from support.graphs import assert_read_off_the_log

from graphic_tmm.chapters.flywheel.ink_energy import draw_energy_mass_ink
from graphic_tmm.chapters.flywheel.ink_sketch import Sizes, draw_flywheel
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.flywheel.task import VIEWS
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.graph_rules import axes_of
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.scene.read import read

WHEELS = asking("flywheel")


def energy_mass(work: Drawn) -> Drawing:
    second, names = FLYWHEEL_PLAN.on(work).energy_mass, work.project.names[: work.project.count]
    assert second is not None
    log, figures = work.construction, ("ab", "ψ1", "ψ2")
    return finished(draw_energy_mass_ink(Subject(log, work.reading, "X"), second, names, figures))


@pytest.mark.slow
@each("name", WHEELS)
def test_the_energy_mass_curve_of_the_scenes(name: str) -> None:
    work = drawn(name, exact=True)
    if FLYWHEEL_PLAN.on(work).order.tangents is not None:
        assert_read_off_the_log(work.construction, [energy_mass(work)])


@each("name", WHEELS)
@pytest.mark.slow
def test_the_constant_moment_is_one_line_over_the_cycle_named_at_its_end(name: str) -> None:
    work = drawn(name, exact=True)
    log, view = work.construction, VIEWS["moment"]
    marks = {step.it.letter: step for step in log.steps if step.it.view == view}
    letter = "M_c" if "M_c" in marks else "M_d"
    height = complex(work.reading[marks[letter].it][0, 0]).imag
    length = float(work.reading[axes_of(log, view).length][0, 0])
    names = Names([str(k) for k in range(work.project.count)], "M", "φ", points={})
    graph = finished(
        draw_graph(Subject(log, work.reading, "X"), view, work.project.count, names), True
    )
    level = marks[f"({letter})"].it
    (line,) = (s for s in graph.strokes if level.slot in s.of and isinstance(s, Stroke))
    (start, low, _), (end, high, _) = line.path
    assert (start, end) == pytest.approx((0.0, length))
    assert (low, high) == pytest.approx((height, height))
    assert line.pen == "main"
    (label,) = (one for one in graph.labels if one.of == (marks[letter].it.slot,))
    assert label.at.real > length


@pytest.mark.slow
@each("seed", range(20, 26))
def test_the_energy_mass_curve_of_machines_drawn_at_random(seed: int, tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    tangents = ("curve", "points")[seed % 2]
    text = scene_of(crank(seed), (8, 12, 24)[seed % 3], more=f'tangents = "{tangents}"')
    path.write_text(text, encoding="utf-8")
    work = drawn_of(read(path), exact=True)
    assert_read_off_the_log(work.construction, [energy_mass(work)])


def test_the_sketch_stands_on_the_sizes_of_the_rim() -> None:
    rim = FLYWHEEL_PLAN.on(drawn("engine", exact=True)).rim
    assert rim is not None
    marks = (rim.outer, rim.inner, rim.width)
    view = draw_flywheel(Sizes(0.45, 0.3825, 0.115, 0.055), 5.0, "x", "ru", marks)
    of = {mark.slot for mark in marks}
    assert all(set(one.of) == of for one in (*view.strokes, *view.labels))
    assert {stroke.part for stroke in view.strokes} == {"rim", "dimension"}
