"""The figures of a gear pair read its log: every step leaves ink, pictures add up to the views."""

from __future__ import annotations

import random

import pytest
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.gallery import exact
from support.teeth import pair

from graphic_tmm.board.record import Construction
from graphic_tmm.chapters.gears.ink import draw_gear_ink
from graphic_tmm.chapters.gears.ink_rolling import draw_rolling_ink
from graphic_tmm.chapters.gears.ink_sliding import draw_sliding_ink
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.chapters.gears.views import gear_views
from graphic_tmm.errors import TmmError
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.figure import pictures
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject

WALL = HEIGHTS["A1"]


def views(order: GearTask) -> tuple[Construction, list[Drawing]]:
    of = pair(order)
    on = Subject(of.log, of.reading, "X", WALL, "ru")
    made = [draw_gear_ink(on, of.gear), draw_sliding_ink(on, of.gear)]
    made += [draw_rolling_ink(on, of.gear, k) for k in (0, 1)]
    return of.log, [finished(view) for view in made]


def assert_laws(log: Construction, drawn: list[Drawing]) -> None:
    assert not without_ink(log, drawn)
    for view in drawn:
        assert not without_source(view)
        assert_pictures_make_the_view(log, view)


def random_pairs(draw: random.Random, count: int) -> list[GearTask]:
    """Pairs that mesh well enough to be drawn whole: teeth and shifts at random."""
    found: list[GearTask] = []
    while len(found) < count:
        z1, z2 = draw.randint(12, 40), draw.randint(14, 70)
        x1, x2 = round(draw.uniform(0.2, 0.6), 2), round(draw.uniform(-0.1, 0.5), 2)
        order = GearTask(z1, z2, draw.choice((0.002, 0.004, 0.008)), x1, x2)
        try:
            held = not pair(order).failed()
        except TmmError:
            continue
        if held:
            found.append(order)
    return found


def test_steps_of_the_scene_are_its_ink() -> None:
    (work,) = (work for work in exact("gear-pair").boards if "gears" in work.recorded)
    assert_laws(work.construction, [view for view in gear_views(work, True) if view.shows])


@pytest.mark.slow
def test_steps_of_random_pairs_are_their_ink() -> None:
    for order in random_pairs(random.Random("gears"), 6):
        assert_laws(*views(order))


def test_a_tooth_is_rolled_point_by_point_and_drawn_when_its_curves_are() -> None:
    log, drawn = views(GearTask(15, 25, 0.008, 0.83, 0.445))
    rolling = drawn[2]
    made = pictures(log, rolling)
    again = {picture.position for picture in made if picture.again}
    assert len(again) > 8
    parts = [{stroke.part for stroke in picture.ink} for picture in made]
    first = next(n for n, found in enumerate(parts) if "tooth" in found)
    assert first == max(n for n, found in enumerate(parts) if found), "the tooth comes last"
    assert rolling.rubbed, "radii and tangents helped only"
