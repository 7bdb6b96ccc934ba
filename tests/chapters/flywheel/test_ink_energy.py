"""Indicator and energy–mass diagrams in ink: their curves, axes, tangents and letters."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
import shapely
from support.gallery import drawn, paper

from graphic_tmm.chapters.flywheel.ink_energy import (
    draw_energy_mass_ink,
)
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN, Flywheel
from graphic_tmm.chapters.indicator.ink import (
    draw_indicator_ink,
)
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.shapes import box, flat, shape


def flywheel() -> Flywheel:
    made = FLYWHEEL_PLAN.on(drawn("engine", exact=True))
    assert made is not None
    return made


def view(which: str, lettered: bool = True) -> Drawing:
    work, names = drawn("engine", exact=True), drawn("engine", exact=True).project.names
    log = work.project.construction
    if which == "indicator":
        made = flywheel().cylinder.indicator
        return finished(
            draw_indicator_ink(Subject(log, work.reading, "X"), {"": made}, names), lettered
        )
    second = flywheel().energy_mass
    assert second is not None
    figures = ("ab = 1", "ψ_{1} = 2°", "ψ_{2} = 3°")
    return finished(
        draw_energy_mass_ink(Subject(log, work.reading, "X"), second, names, figures), lettered
    )


def curves(of: Drawing) -> list[shapely.LineString]:
    found = [flat(s.controls) for s in of.strokes if isinstance(s, Bezier)]
    return [shapely.LineString([(z.real, z.imag) for z in points]) for points in found]


@pytest.mark.parametrize("which", ["indicator", "energy-mass"])
def test_the_curve_passes_through_its_points(which: str) -> None:
    second = flywheel().energy_mass
    assert second is not None
    mark = flywheel().cylinder.indicator.sides[0].points if which == "indicator" else second.points
    (curve,) = curves(view(which))
    for spot in drawn("engine", exact=True).reading[mark][0]:
        assert curve.distance(shapely.Point(spot.real, spot.imag)) < 1e-9


@pytest.mark.parametrize("which", ["indicator", "energy-mass"])
def test_letters_stand_clear_and_every_position_is_numbered(which: str) -> None:
    made = view(which)
    boxes = [box(label) for label in made.labels]
    assert all(a.disjoint(b) for a, b in combinations(boxes, 2))
    texts = ", ".join(label.text for label in made.labels).split(", ")
    assert all(name in texts for name in drawn("engine", exact=True).project.names)


@pytest.mark.parametrize("which", ["indicator", "energy-mass"])
def test_an_unlettered_view_has_room_for_its_ink(which: str) -> None:
    bare = view(which, lettered=False)
    assert bare.cell is not None
    room = shapely.box(*bare.cell)
    assert all(room.covers(shape(s)) for s in view(which).strokes)


def test_lines_of_the_division_are_parallel() -> None:
    thin = [
        s for s in view("indicator", False).strokes if isinstance(s, Stroke) and s.pen == "thin"
    ]
    below = []
    for stroke in thin:
        a, b = (complex(x, y) for x, y, _ in (stroke.path[0], stroke.path[-1]))
        if a.imag < -1.0 and abs(b.imag) < 1e-9 and abs(b) > 1e-9:
            below.append((b - a) / abs(b - a))
    assert len(below) == 12  # from the farthest point two, its own and that to the end of the base
    assert max(abs(way - below[0]) for way in below) < 1e-9


def test_the_tangents_leave_the_curve_on_one_side_and_end_in_a_and_b() -> None:
    made = flywheel().energy_mass
    assert made is not None
    beziers = [s for s in view("energy-mass").strokes if isinstance(s, Bezier)]
    curve = np.array([z for s in beziers for z in flat(s.controls)])
    lines = [
        s
        for s in view("energy-mass", False).strokes
        if isinstance(s, Stroke) and s.pen == "main" and not s.closed
    ]
    assert len(lines) == 2
    for stroke, sign in zip(lines, (1, -1), strict=True):
        a, b = (complex(x, y) for x, y, _ in stroke.path)
        assert a.real == pytest.approx(0.0, abs=1e-9)
        above = sign * ((curve - a) * np.conj(1j * (b - a) / abs(b - a))).real
        assert above.max() == pytest.approx(0.0, abs=0.05)  # eight chords stand for an arc
        assert above.max() <= 1e-9
    texts = {label.text for label in view("energy-mass").labels}
    assert {"a", "b", "ΔT", "J_{red}"} <= texts


@pytest.mark.slow
def test_the_engine_stands_complete_on_one_sheet() -> None:
    _, (sheet,) = paper("engine")
    names = {d.name for d in sheet.drawings}
    assert {
        "positions", "velocities", "indicator", "flywheel-graphs", "energy-mass", "flywheel",
        "table-flywheel", "table-results",
    } <= names  # fmt: skip
    texts = {label.text for d in sheet.drawings for label in d.labels}
    assert {
        "A_{дс}",
        "A_{пс}",
        "ΔT",
        "T_{зв}",
        "T_{м}",
        "c",
        "d",
        "J_{м}",
        "1,769",
        "1,623",
        "[cd] = 60,7",
    } <= texts
    assert "μ_A = 16,76 Дж/мм, μ_φ = 0,05236 рад/мм" in texts
    assert "H = 40" in texts
