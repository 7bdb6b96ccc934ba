"""The plan of positions is a figure of the log: every step inked or traceless by name, bodies on marks."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.gallery import NAMES, SHEETS, drawn
from support.mechanisms import sample
from support.rewritten import relettered, text_of
from support.turns import in_turn

from graphic_tmm.chapters.kinematics import views
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke
from graphic_tmm.paper.figure import pictures
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

BODIES = {"link", "guide", "slider", "stone", "pair", "point", "centre", "pivot"}
TAIL = '[hand]\nruler = "exact"\n[[sheet]]\nformat = "A1"\nplace = ["positions"]\n'


@cache
def positions(name: str) -> Drawing:
    (view,) = views.position_views(drawn(name, exact=True), True)
    return view


def assert_is_figure(work: Drawn, view: Drawing) -> None:
    assert not without_ink(work.construction, [view])
    assert not without_source(view)
    assert_pictures_make_the_view(work.construction, view)


@pytest.mark.parametrize("name", NAMES)
def test_the_steps_of_the_plan_are_its_ink(name: str) -> None:
    assert positions(name).shows == ("extremes", "positions")
    assert_is_figure(drawn(name, exact=True), positions(name))


@pytest.mark.slow
def test_random_mechanisms_are_figures_of_their_log(tmp_path: Path) -> None:
    for k, one in in_turn(enumerate(sample(12, seed=31)), 4):
        path = tmp_path / "scene.toml"
        text = text_of(relettered(one.mechanism, k), one.phi, 6, TAIL)
        path.write_text(text, encoding="utf-8")
        work = drawn_of(read(path), exact=True)
        (view,) = views.position_views(work, True)
        assert_is_figure(work, view)


@pytest.mark.parametrize("name", ["windrower", "shaper", "crank-press"])
def test_what_stays_is_bodies_and_paths_and_every_construction_line_is_rubbed_out(
    name: str,
) -> None:
    view = positions(name)
    for stroke in view.strokes:
        if isinstance(stroke, Bezier):
            assert not stroke.part
        else:
            assert stroke.part
    assert view.rubbed
    assert not [stroke for stroke in view.rubbed if stroke.part]
    assert {s.part for s in view.strokes} >= {"link", "guide", "slider", "pair", "pivot"}


def test_a_body_appears_with_the_last_mark_it_stands_on() -> None:
    work, view = drawn("windrower", exact=True), positions("windrower")
    made = pictures(work.construction, view)
    order = {step.it.slot: n for n, step in enumerate(work.construction.steps)}
    for picture in made[1:]:
        for stroke in picture.ink:
            if stroke.part in BODIES and not picture.again:
                last = max(order.get(slot, -1) for slot in stroke.of)
                assert last == max(order[slot] for slot in picture.marks)
    again = [picture for picture in made if picture.again]
    assert len({picture.position for picture in again}) == len(work.names) - 1


@pytest.mark.parametrize("name", ["windrower", "scotch-yoke"])
def test_one_position_by_itself_is_a_figure_too(name: str) -> None:
    work = drawn(name, exact=True)
    view = views.plan_at(work, POSITIONS, 2, "x", "X", ())
    assert_is_figure(work, view)
    assert {stroke.position for stroke in view.strokes} <= {None, 2}


@pytest.mark.parametrize(("told", "sense"), [("30 rad/s^2", 1), ("-30 rad/s^2", -1)])
def test_an_arrow_tells_the_sense_of_the_angular_acceleration(
    told: str, sense: int, tmp_path: Path
) -> None:
    text = (SHEETS / "accelerating-crank" / "scene.toml").read_text(encoding="utf-8")
    file = tmp_path / "scene.toml"
    body = text.partition("[[sheet]]")[0].replace('"30 rad/s^2"', f'"{told}"')
    file.write_text(body, encoding="utf-8")
    (work,) = make(read(file)).boards
    (view,) = views.position_views(work, True)
    assert {"ω_1", "ε_1"} <= {one.text for one in view.labels}
    bows = [
        s for s in view.strokes if s.part == "turning" and isinstance(s, Stroke) and s.path[0][2]
    ]
    assert len(bows) == 2
    assert [round(np.sign(bow.path[0][2])) for bow in bows] == [1, sense]
