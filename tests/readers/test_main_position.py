"""One position stands for all: drawn heavy, told, played and practised first; it is no dead centre."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from support.boards import in_usual_size

from graphic_tmm.board.execute import execute
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.handout.chosen import chosen
from graphic_tmm.page.stops import Played
from graphic_tmm.readers.protocol import steps_of
from graphic_tmm.scene.read import read

CASES = Path(__file__).parents[1] / "cases" / "sheets"


@cache
def made(name: str, main: str | None = None) -> DrawnScene:
    return in_usual_size(replace(read(CASES / name), main=main), exact=True)


def board(name: str, main: str | None = None) -> Drawn:
    found = made(name, main).mechanism
    assert found is not None
    return found


def heavy(drawn: Drawn) -> set[int | None]:
    """The positions whose pins bear the sign of a pair: the one that is drawn heavy."""
    (view,) = drawing_of("positions")(drawn, True)
    return {one.position for one in view.strokes if getattr(one, "part", "") == "turning"}


@pytest.mark.parametrize("main", [None, "7"])
def test_all_begin_with_it(main: str | None) -> None:
    drawn = board("upright.toml", main)
    assert heavy(drawn) == {drawn.main}
    name = drawn.names[drawn.main]
    assert name == (main or "4")
    (view,) = drawing_of("positions")(drawn, True)
    assert Played(drawn, view, "en").first == drawn.main
    one = next(c for c in chosen(made("upright.toml", main), ["velocities"], None))
    assert one.place == drawn.main
    told = list(steps_of(made("upright.toml", main), ("positions",), None, "en"))
    assert told[0] == f"Plan of positions, position {name}"


def test_a_plan_without_the_main_position_is_told_in_its_own() -> None:
    """Accelerations are drawn at 2 and 4, the author's position is 7."""
    told = list(steps_of(made("upright.toml", "7"), ("accelerations",), None, "en"))
    assert told[0] == "Acceleration plan, position 2"


@pytest.mark.parametrize("name", ["upright.toml", "rotary.toml", "whitworth-pin-S.toml"])
def test_it_is_no_dead_centre(name: str) -> None:
    """There no vector of the velocity plan is short that is long elsewhere: by the plan's own points."""
    drawn = board(name)
    view = drawn.construction.view("velocities")
    assert view is not None
    assert view.pole is not None
    reading = execute(drawn.construction, drawn.given)
    points = [
        s.it for s in drawn.construction.steps if s.it.view == "velocities" and s.op.name == "meet"
    ]
    assert points
    for mark in points:
        speed = abs(reading[mark][0] - reading[view.pole][0])
        assert speed[drawn.main] > 0.3 * speed.max()
