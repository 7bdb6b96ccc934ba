"""The figure of a cam given by arcs reads its log: every step leaves ink, pictures add up to the view."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from support.arc_cams import FLANKS, FLATS, KINDS, drawn, random_order
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.gallery import exact

from graphic_tmm.chapters.arc_cam.contour import VIEW
from graphic_tmm.chapters.arc_cam.ink import TRACELESS, ArcNames, draw_contour_ink
from graphic_tmm.chapters.arc_cam.scheme import scheme
from graphic_tmm.chapters.arc_cam.task import ArcTask, Flank
from graphic_tmm.chapters.arc_cam.views import arc_views
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.scene.records import Scene


def test_steps_of_the_scene_are_its_ink() -> None:
    (work,) = exact("arc-cam").boards
    views = [view for view in arc_views(work, True) if VIEW in view.shows]
    assert len(views) == 1
    assert not without_ink(work.construction, views, TRACELESS)
    assert not without_source(views[0])
    assert_pictures_make_the_view(work.construction, views[0])


@pytest.mark.parametrize("kind", KINDS)
def test_steps_of_random_cams_are_their_ink(kind: str) -> None:
    draw = random.Random(f"ink {kind}")
    flank = draw.choice([one for one in FLANKS if kind not in FLATS or one in ("convex", "sharp")])
    made, log, reading = drawn(random_order(draw, kind, flank))
    names = ArcNames([str(k) for k in range(len(made.angles))], {"base": "r_{1}"})
    view = finished(draw_contour_ink(Subject(log, reading, "X"), made, names))
    assert not without_ink(log, [view], TRACELESS)
    assert not without_source(view)
    assert_pictures_make_the_view(log, view)
    contours = [stroke for stroke in view.strokes if stroke.part == "contour"]
    assert len(contours) == (3 if flank == "sharp" else 4)


def leaders(view: Drawing) -> list[tuple[complex, complex]]:
    """The ends of the leaders of radii: off the arc, on it."""
    lines = [s for s in view.strokes if isinstance(s, Stroke) and s.part == "dimension"]
    ends = [
        [complex(x, y) for x, y, _ in s.path] for s in lines if len(s.path) == 2 and not s.filled
    ]
    return [(one[0], one[1]) for one in ends]


@pytest.mark.parametrize("flank", ["convex", "hollow"])
def test_every_radius_has_a_leader_that_points_at_its_arc_square_to_it(flank: str) -> None:
    made, log, reading = drawn(random_order(random.Random(f"led {flank}"), KINDS[0], flank))
    contour = made.contour
    arcs = [one for one in contour.arcs.values() if one.centre is not None]
    radii = {one.name: f"r_{{{n}}}" for n, one in enumerate(arcs, 1) if one.radius is not None}
    names = ArcNames([str(k) for k in range(len(made.angles))], radii)
    view = draw_contour_ink(Subject(log, reading, "T"), made, names)
    found = leaders(view)
    assert len(found) == len(radii)
    for tail, spot in found:
        due = [
            (abs(spot - c) - r, ((spot - tail) / (spot - c)).imag)
            for one in arcs
            if one.name in radii
            for c in [complex(np.ravel(reading[one.centre])[0])]
            for r in [float(np.ravel(reading[one.radius])[0])]
        ]
        assert min(abs(off) + abs(aslant) for off, aslant in due) < 1e-6
    assert "ω_{1}" in [one.text for one in view.wanted]


def bows(view: Drawing, part: str) -> list[tuple[complex, complex, float]]:
    """Where the arcs and lines of a part begin and end, and their radii, mm (0: a line)."""
    found = []
    for stroke in view.strokes:
        if stroke.part == part and isinstance(stroke, Stroke):
            spots = [complex(x, y) for x, y, _ in stroke.path]
            half = 2.0 * math.atan(stroke.path[0][2])
            radius = abs(spots[1] - spots[0]) / (2.0 * abs(math.sin(half))) if half else 0.0
            found.append((spots[0], spots[-1], radius))
    return found


@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
@pytest.mark.parametrize("flank", [None, 0.06])
def test_the_contour_of_a_task_is_closed_by_arcs_of_the_radii_given(
    flank: float | None, turns: str
) -> None:
    """Base 20 mm, nose 7 mm, flanks straight or of 60 mm, whose ends lie on both circles."""
    order = ArcTask(0.02, 0.022, 0.007, Flank(flank), Flank(flank), turns=turns)
    shown = scheme(Scene("x", "", "en").asking(arc_cam=order), 150 + 150j)
    assert shown is not None
    parts = bows(shown.view, "contour")
    assert [one[2] * shown.mu for one in parts] == pytest.approx(
        [0.02, flank or 0.0, 0.007, flank or 0.0]
    )
    begins, ends = ([one[k] for one in parts] for k in (0, 1))
    assert ends == pytest.approx(begins[1:] + begins[:1])
