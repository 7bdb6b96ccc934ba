"""The figure reads the log: every step of a plan leaves ink or none by name; pictures add up to the view."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise

import pytest
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.gallery import PLANS, drawn

from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.values import Arc, Curve, Line, Point
from graphic_tmm.chapters.diagrams.views import diagram_views
from graphic_tmm.chapters.kinematics.ink_plans import Place, draw_plan
from graphic_tmm.chapters.kinematics.views import position_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Bezier, Drawing
from graphic_tmm.paper.figure import Picture, pictures
from graphic_tmm.paper.graph_rules import axes_of
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.rules import BY_KIND, RULES, traceless
from graphic_tmm.paper.seen import Subject
from graphic_tmm.scene.chapter import whole_book


def plan(work: Drawn, which: str, index: int) -> Drawing:
    reading = work.of(which)
    assert reading is not None
    mu = work.scales[which].value
    on = Subject(work.construction, reading, "X", name="x")
    return finished(draw_plan(on, which, [Place(index)], mu, ""))


def test_every_operation_leaves_ink_but_what_is_read_calculated_or_named_again() -> None:
    whole_book()
    for op in OPERATIONS.values():
        inked = op.leaves in (Line, Arc, Curve, Point) or op.name in RULES
        named_again = op.name in ("coincide", "following")
        assert traceless(op) == (bool(op.formula) or named_again or not inked), op
    assert set(BY_KIND) == {Line, Arc, Curve, Point}


@pytest.mark.slow
@pytest.mark.parametrize(("name", "which"), PLANS)
def test_steps_of_a_plan_are_its_ink(name: str, which: str) -> None:
    work = drawn(name, exact=True)
    views = [plan(work, which, k) for k in range(len(work.row(which)))]
    assert not without_ink(work.construction, views)
    for view in views:
        assert not without_source(view)
        assert_pictures_make_the_view(work.construction, view)


def test_a_plan_is_drawn_step_by_step() -> None:
    work = drawn("engine", exact=True)
    view = plan(work, "velocities", 1)
    made = pictures(work.construction, view)
    assert made[0].given
    letters = [[label.text for label in picture.letters] for picture in made]
    assert letters[0] == ["p"]
    named = [text for texts in letters for text in texts]
    assert named.index("a") < named.index("b") < named.index("s_{2}")
    rubbed = [picture for picture in made if set(picture.ink) & set(view.rubbed)]
    assert rubbed, "the figure similar to the link is built with lines that do not stay"


@pytest.mark.parametrize("name", ["engine", "windrower", "lever"])
def test_the_same_for_other_positions_is_one_picture_each(name: str) -> None:
    work = drawn(name, exact=True)
    (view,) = position_views(work, True)
    made = pictures(work.construction, view)
    again = [picture.position for picture in made if picture.again]
    assert sorted(again, key=lambda k: k or 0) == again, "in their order"
    assert set(again) == {stroke.position for stroke in view.strokes} - {None, _first(made)}
    assert len(again) == len(set(again))
    curves = {step.it.slot for step in work.construction.steps if step.it.kind is Curve}
    last = max(n for n, picture in enumerate(made) if picture.again)
    assert all(n > last for n, picture in enumerate(made) if curves & set(picture.marks))


def _first(made: tuple[Picture, ...]) -> int | None:
    """The position that is drawn step by step."""
    return next(p.position for p in made if p.position is not None and not p.again)


def test_positions_of_a_diagram_follow_wherever_a_curve_through_all_is_needed() -> None:
    """Speeds; from their curve the mean accelerations; from the curve of these the accelerations."""
    work = drawn("slider-diagrams", exact=True)
    view = next(view for view in diagram_views(work, True) if view.shows)
    made = pictures(work.construction, view)
    again = Counter(picture.position for picture in made if picture.again)
    assert set(again.values()) == {3}
    curves = {step.it.slot for step in work.construction.steps if step.it.kind is Curve}
    last = max(again, key=lambda k: -1 if k is None else k)
    ends = [n for n, picture in enumerate(made) if picture.again and picture.position == last]
    for start, end in pairwise(ends):
        assert any(curves & set(picture.marks) for picture in made[start:end])


@pytest.mark.parametrize("name", ["engine", "slider-diagrams"])
def test_what_a_step_leaves_is_one_picture(name: str) -> None:
    """A body that is there in one position and its letter that is there in all are drawn together."""
    work = drawn(name, exact=True)
    for view in position_views(work, True):
        steps = [one.marks for one in pictures(work.construction, view) if not one.again]
        assert all(before != after for before, after in pairwise(steps))
        assert len(steps) == len(set(steps))


def test_letters_of_a_graph_come_with_its_axes() -> None:
    """No name of an axis and no caption hangs where nothing is drawn yet, on one graph or on several."""
    work = drawn("slider-diagrams", exact=True)
    view = next(view for view in diagram_views(work, True) if view.shows)
    given, *steps = pictures(work.construction, view)
    assert not given.letters
    for one in view.shows:
        axes = axes_of(work.construction, one)
        step = next(step for step in steps if axes.up.slot in step.marks)
        named = [
            label for label in step.letters if set(label.of) == {axes.along.slot, axes.up.slot}
        ]
        assert len(named) >= 2, "both axes are named when both are there"


def test_a_view_knows_where_its_origin_went() -> None:
    """Places of marks count from the origin of their view, wherever that stands on a sheet."""
    work = drawn("slider-diagrams", exact=True)
    view = next(view for view in diagram_views(work, True) if view.shows).moved(40 - 3j)
    for one in view.shows:
        curve = next(
            step.it
            for step in work.construction.steps
            if step.it.view == one and step.it.kind is Curve
        )
        ends = {complex(z) for run in bezier(work.reading[curve]) for z in run[::3]}
        drawn_ = [ink for ink in view.strokes if isinstance(ink, Bezier) and curve.slot in ink.of]
        assert drawn_
        for z in drawn_[0].controls[3:-1:3]:
            assert min(abs(z - view.origin(one) - end) for end in ends) < 1e-9


def test_points_in_one_place_are_named_when_the_first_of_them_is_there() -> None:
    """C, S3 and n4 of the windrower share a place on its acceleration plan: c is named with its own step."""
    work = drawn("windrower", exact=True)
    view = plan(work, "accelerations", 2)
    shared = next(label for label in view.labels if ", " in label.text)
    order = {step.it.slot: n for n, step in enumerate(work.construction.steps)}
    made = pictures(work.construction, view)
    (there,) = (picture for picture in made if shared in picture.letters)
    assert min(order[slot] for slot in shared.of) in [order[slot] for slot in there.marks]
