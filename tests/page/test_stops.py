"""Every step of a plan is a stop of the page, in an order in which it can be drawn, with its ink."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

import pytest
from support.each import each
from support.gallery import ALL, paper

from graphic_tmm.page.stops import Played
from graphic_tmm.page.views import plays_of
from graphic_tmm.paper.figure import pictures
from graphic_tmm.readers.narration import protocol


@cache
def plays(name: str) -> tuple[Played, ...]:
    made, sheets = paper(name)
    return tuple(play for _, _, play in plays_of(made, sheets))


def in_full(view: Played) -> Iterator[int]:
    """The marks whose steps the protocol of a view tells in its first position."""
    for plan in view.drawing.shows:
        reading, place = view.drawn.of(plan), view.place_in(plan, view.first)
        assert reading is not None
        assert place is not None
        told = protocol(view.log, plan, reading, place, view.language)
        yield from (line.step.it.slot for line in told if line.step is not None)


SOME = ("cam", "engine", "gear-pair", "locomobile")


@pytest.mark.turns(2)
@pytest.mark.parametrize("name", SOME)
def test_stops_are_the_pictures_and_the_lines(name: str) -> None:
    assert_all_is_told(name)


@pytest.mark.slow
@each("name", ALL, turns=4)
def test_stops_of_all_scenes_are_the_pictures_and_the_lines(name: str) -> None:
    assert_all_is_told(name)


def assert_all_is_told(name: str) -> None:
    for view in plays(name):
        assert [s.picture for s in view.stops if s.picture] == list(view.shown)
        first = next((one.position for one in view.shown if one.position is not None), None)
        assert list(view.shown) == list(pictures(view.log, view.drawing, first))
        told = [one.slot for stop in view.stops if not _again(stop) for one in stop.told]
        assert len(told) == len(set(told)), "no step is told twice"
        assert all(stop.told for stop in view.stops[1:] if not _again(stop)), "none is silent"
        inked = {slot for one in view.shown for slot in one.marks}
        if len(plays(name)) == len({play.drawing.shows for play in plays(name)}):
            assert set(told) >= set(in_full(view)), "all lines of the protocol are told"
        assert inked <= {one.slot for stop in view.stops for one in stop.told} | _agains(view)


@pytest.mark.slow
@each("name", ALL, turns=4)
def test_no_step_is_told_before_what_it_uses(name: str) -> None:
    for view in plays(name):
        due = {one.slot for stop in view.stops if not _again(stop) for one in stop.told}
        done: set[int] = set()
        for stop in view.stops:
            for one in stop.told if not _again(stop) else ():
                step = one.line.step
                assert step is not None
                assert {mark.slot for mark in step.uses} & due <= done, (view.drawing.name, step)
                done.add(one.slot)


def test_views_of_one_plan_tell_their_own_parts() -> None:
    """The mesh of a gear pair and the rolling of its flanks are drawn of one plan: each tells what it shows."""
    views = {view.drawing.name: view for view in plays("gear-pair")}
    rolling = views["gear-rolling-1"]
    told = {one.slot for stop in rolling.stops for one in stop.told}
    mesh = {slot for one in views["gear"].shown for slot in one.marks}
    assert told
    assert mesh - told, "what only the mesh shows is not told with the flank"


@pytest.mark.parametrize("name", ["engine", "cam"])
def test_other_positions_tell_their_own_figures(name: str) -> None:
    for view in plays(name):
        firsts = {
            one.slot: one.line.calculation for s in view.stops for one in s.told if not _again(s)
        }
        for stop in filter(_again, view.stops):
            for one in stop.told:
                assert one.line.place == view.place_in(one.view, stop.place)
                assert one.line.calculation != firsts.get(one.slot)


def _again(stop: object) -> bool:
    picture = getattr(stop, "picture", None)
    return picture is not None and bool(picture.again)


def _agains(view: Played) -> set[int]:
    return {slot for stop in view.stops if _again(stop) for slot in stop.picture.marks}  # type: ignore[union-attr]
