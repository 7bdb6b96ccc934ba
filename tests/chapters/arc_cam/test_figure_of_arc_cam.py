"""The figure of a cam given by arcs reads its log: every step leaves ink, pictures add up to the view."""

from __future__ import annotations

import random

import pytest
from support.arc_cams import FLANKS, KINDS, drawn, random_order
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.gallery import exact

from graphic_tmm.chapters.arc_cam.contour import VIEW
from graphic_tmm.chapters.arc_cam.ink import TRACELESS, ArcNames, draw_contour_ink
from graphic_tmm.chapters.arc_cam.views import arc_views
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject


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
    flank = draw.choice([one for one in FLANKS if kind != "flat" or one in ("convex", "sharp")])
    made, log, reading = drawn(random_order(draw, kind, flank))
    names = ArcNames([str(k) for k in range(len(made.angles))], {"base": "r_{1}"})
    view = finished(draw_contour_ink(Subject(log, reading, "X"), made, names))
    assert not without_ink(log, [view], TRACELESS)
    assert not without_source(view)
    assert_pictures_make_the_view(log, view)
    contours = [stroke for stroke in view.strokes if stroke.part == "contour"]
    assert len(contours) == (3 if flank == "sharp" else 4)
