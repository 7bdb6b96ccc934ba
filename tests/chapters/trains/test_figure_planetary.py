"""The figure of a planetary train reads its log: every step leaves ink, pictures add up to the view."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from itertools import combinations

import pytest
from support import train_oracle as oracle
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.gallery import exact

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Construction
from graphic_tmm.chapters.trains.ink import TRACELESS, Captions, draw_planetary_ink
from graphic_tmm.chapters.trains.plan import draw_planetary
from graphic_tmm.chapters.trains.task import SCHEMES, PlanetaryTask
from graphic_tmm.chapters.trains.views import planetary_views
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.figure import pictures
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.shapes import box, shape


def drawn(order: PlanetaryTask) -> tuple[Construction, Drawing]:
    draft = Draft()
    made = draw_planetary(draft, order)
    log = draft.board.construction()
    reading = execute(log, draft.given)
    view = draw_planetary_ink(Subject(log, reading, "X"), made, Captions())
    return log, finished(view)


def assert_laws(log: Construction, view: Drawing) -> None:
    assert not without_ink(log, [view], TRACELESS)
    assert not without_source(view)
    assert_pictures_make_the_view(log, view)


def test_steps_of_the_scene_are_its_ink() -> None:
    found = [work for work in exact("planetary").boards if "planetary" in work.recorded]
    assert found
    for work in found:
        (view,) = (one for one in planetary_views(work, True) if one.shows)
        assert_laws(work.construction, view)


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_steps_of_random_trains_are_their_ink(scheme: str) -> None:
    draw = random.Random(scheme)
    for k in range(6):
        order = oracle.valid(draw, scheme)
        pair = (draw.randint(12, 40), draw.randint(12, 60)) if k % 2 else ()
        assert_laws(*drawn(replace(order, behind=(pair,) if pair else ())))


@pytest.mark.parametrize(
    "order",
    [
        PlanetaryTask("external", 0.005, 10.0, "H", teeth=(36, 45), satellites=(1,)),
        PlanetaryTask("internal", 0.005, (10.0, -4.0), ("1", "H"), teeth=(60, 24)),
        PlanetaryTask(
            "3K",
            0.005,
            10.0,
            teeth=(24, 30, 84, 18, 72),
            behind=((15, 25), (18, 20, 30)),
            before=((20, 30),),
        ),
        PlanetaryTask("3K", 0.005, 10.0, "3", "5", teeth=(24, 30, 84, 18, 72)),
    ],
)
def test_steps_of_two_wheels_and_of_three_central_ones_are_their_ink(order: PlanetaryTask) -> None:
    assert_laws(*drawn(order))


def test_letters_of_random_trains_stand_clear(many: Callable[[int, int], int]) -> None:
    """Of two wheels and of three central ones, any member standing: no letter on another or on a heavy line."""
    draw = random.Random("letters")
    for k in range(many(36, 6)):
        scheme = ("external", "internal", "3K")[k % 3]
        driving, fixed = draw.sample(SCHEMES[scheme].members, 2)
        teeth = oracle.random_teeth(draw, scheme)
        order = PlanetaryTask(
            scheme, 0.005, 100.0, driving, fixed, teeth=teeth, satellites=(draw.randint(1, 4),)
        )
        _, view = drawn(order)
        boxes = [box(label) for label in view.labels]
        assert all(one.disjoint(other) for one, other in combinations(boxes, 2)), order
        heavy = [shape(s) for s in view.strokes if s.pen in ("main", "rod", "joint")]
        assert all(one.disjoint(line) for one in boxes for line in heavy), order


def test_the_train_is_drawn_step_by_step() -> None:
    log, view = drawn(PlanetaryTask("ring", 0.008, 302.4, teeth=(25, 32, 89), behind=((15, 25),)))
    made = pictures(log, view)
    order = [label.text for picture in made for label in picture.letters]
    assert order.index("A") < order.index("a") < order.index("P")
    again = [picture for picture in made if picture.again]
    assert {picture.position for picture in again} == {1, 2}, "the other satellites are repeated"
