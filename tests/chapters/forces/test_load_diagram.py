"""The diagram of a load that varies shows what the scene gives, and where on it the positions stand."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
import shapely
from support.boards import drawn_of
from support.gallery import drawn, scene

from graphic_tmm.chapters.forces.given import given
from graphic_tmm.chapters.forces.load_diagrams import load_views
from graphic_tmm.chapters.forces.task import ASKED, Load
from graphic_tmm.chapters.forces.task import LOADS as PLACE
from graphic_tmm.chapters.kinematics.views import position_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.shapes import shape
from graphic_tmm.scene.drawing import SheetOrder
from graphic_tmm.scene.registry import attended


def diagram(work: Drawn) -> Drawing:
    (view,) = load_views(work, True)
    return view


def lines(view: Drawing) -> list[Stroke]:
    return [s for s in view.strokes if s.part == "given" and isinstance(s, Stroke)]


def told(view: Drawing) -> tuple[float, float]:
    """μ of the base and of the height, as the caption tells them."""
    text = next(label.text for label in view.labels if label.text.startswith("μ_"))
    along, up = (part.split(" = ")[1].split(" ")[0] for part in text.split(", "))
    return float(along), float(up)


def apart() -> Drawn:
    """The press whose load has a sheet of its own."""
    sheets = (SheetOrder("A2", ("positions",)), SheetOrder("A4", (PLACE,)))
    return drawn_of(replace(scene("crank-press"), sheets=sheets))


def test_a_force_over_the_travel_of_a_slider() -> None:
    view = diagram(apart())
    (line,) = lines(view)
    along, up = told(view)
    stroke = 2 * 0.06  # a slider in line with the crank travels twice its arm
    due = [(0.0, 0.0), (0.66, 0.0), (0.7, 24000.0), (1.0, 9000.0)]
    found = [(x * along / stroke, y * up) for x, y, _ in line.path]
    for (share, size), (x, y) in zip(due, found, strict=True):
        assert x == pytest.approx(share, abs=0.1 / (stroke / along))  # the ruler reads the stroke
        assert y == pytest.approx(size)
    dots = {label.text for label in view.labels if label.position is not None}
    assert dots == {"4", "5", "6"}  # the positions in which it acts
    for dot in (s for s in view.strokes if s.position is not None and isinstance(s, Stroke)):
        turn = math.radians(30.0 * (dot.position or 0))
        way = 0.06 * (1 - math.cos(turn)) + math.sqrt(0.24**2 - (0.06 * math.sin(turn)) ** 2) - 0.24
        (left, y, _), (right, _, _) = dot.path[:2]
        assert (left + right) / 2 * along == pytest.approx(way, abs=2e-4)
        share = way / stroke
        due_size = 24000.0 + (share - 0.7) / 0.3 * (9000.0 - 24000.0)
        assert y * up == pytest.approx(due_size, rel=0.02)


def test_a_load_stands_beside_the_guide_each_size_under_its_place() -> None:
    """On the plan, to its scale: by the slider's own places, square to its way, clear of the mechanism."""
    work = drawn("crank-press")
    assert not load_views(work, True)
    (view,) = position_views(work, True)
    mu, up = (
        float(one.text.split(" = ")[1].split(" ")[0])
        for one in view.labels
        if "μ_" in one.text and " = " in one.text
    )
    dots = {}
    for label in (one for one in view.labels if one.text in ("4", "5", "6")):
        near = [
            (abs(z - label.at), z)
            for s in view.strokes
            if isinstance(s, Stroke) and s.part == "given" and s.filled and len(s.path) == 2
            for z in [complex(s.path[0][0] + s.path[1][0], s.path[0][1] + s.path[1][1]) / 2]
        ]
        away, spot = min(near, key=lambda one: one[0])
        if away < 10.0:
            dots[label.text] = spot
    assert set(dots) == {"4", "5", "6"}
    bases = []
    for name, spot in dots.items():
        turn = math.radians(30.0 * int(name))
        way = 0.06 * (1 - math.cos(turn)) + math.sqrt(0.24**2 - (0.06 * math.sin(turn)) ** 2) - 0.24
        size = 24000.0 + (way / 0.12 - 0.7) / 0.3 * (9000.0 - 24000.0)
        assert spot.imag == pytest.approx(-(0.24 + 0.06 + way - 0.12) / mu, abs=0.3)
        bases.append(spot.real - size / up)
    assert max(bases) - min(bases) < 0.6
    strip = shapely.box(-999.0, -0.30 / mu, 999.0, -0.18 / mu)  # along the stroke
    others = [shape(s).intersection(strip) for s in view.strokes if s.part in ("link", "pair")]
    assert min(bases) > 10.0 + max(one.bounds[2] for one in others if not one.is_empty)


def test_positions_of_one_place_share_their_number_on_it() -> None:
    """Out and back under one force: 1 and 11 stand under one place, and so do their numbers."""
    order = ASKED.of(scene("crank-press"))
    assert order is not None
    (load,) = order.loads
    both = replace(load, travel=replace(load.travel, back=((0.0, 9000.0), (1.0, 9000.0))))
    both = replace(both, travel=replace(both.travel, out=((0.0, 9000.0), (1.0, 9000.0))))
    asked = replace(order, loads=(both,), friction=None)
    (view,) = position_views(drawn_of(scene("crank-press").asking(forces=asked)), True)
    dots = [s for s in view.strokes if isinstance(s, Stroke) and s.part == "given" and s.filled]
    assert len([s for s in dots if s.pen == "main" and len(s.path) == 2]) == 12
    texts = [one.text for one in view.labels if not one.of and one.size == 3.5]
    assert "4, 8" in texts
    assert "8" not in texts


def with_loads(*loads: Load) -> Drawn:
    order = ASKED.of(scene("windrower"))
    assert order is not None
    asked = replace(order, loads=loads)
    return drawn_of(scene("windrower").asking(forces=asked, flywheel=None))


def test_a_force_by_the_turn_of_the_crank_and_one_by_positions() -> None:
    work = with_loads(Load(5, "D", by_angle=((0.0, 0.0), (90.0, 190.0), (360.0, 0.0))))
    (line,) = lines(diagram(work))
    assert [x / line.path[-1][0] for x, _, _ in line.path] == pytest.approx([0, 0.25, 1])
    sizes = tuple(float(10 * k) for k in range(12))
    view = diagram(with_loads(Load(5, "D", sizes)))
    (line,) = lines(view)
    assert [y / line.path[-1][1] for _, y, _ in line.path] == pytest.approx(
        [k / 11 for k in range(12)]
    )


def test_a_constant_load_has_no_diagram() -> None:
    assert not load_views(drawn("windrower"), True)


def test_it_stands_with_the_plan_of_positions_where_no_sheet_names_it() -> None:
    orders = [("positions", "velocities"), ("forces",)]
    assert PLACE in attended(orders, ["A1", "A1"], {"forces"})[0]
    assert PLACE not in attended(orders, ["A1", "A1"], set())[0]
    assert PLACE not in attended([*orders, (PLACE,)], ["A1", "A1", "A1"], {"forces"})[0]


def test_loads_and_friction_are_among_what_is_given() -> None:
    rows = {one.symbol: one.value for one in given(scene("crank-press"))}
    assert rows == {"F_{3max}": 24000.0, "f": 0.08, "f_{v}": 0.12, "r": pytest.approx(0.04)}
    assert [(one.symbol, one.value) for one in given(scene("windrower"))] == [("F_5", 190.0)]
    two = with_loads(Load(5, "D", 190.0), Load(5, "D", 10.0)).scene
    assert [one.symbol for one in given(two)] == ["F_5", "F_{5(2)}"]
