"""Every step of every plan of every scene is inked by a view that a sheet can show, or leaves no trace by name.

Views are got as sheets get them, by the places of the chapters; no chapter is named.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from importlib import import_module
from pkgutil import walk_packages

import pytest
from support.figures import slots_shown
from support.gallery import ALL, exact

from graphic_tmm import chapters as book
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Length
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.rules import traceless as leaves_none
from graphic_tmm.scene.chapter import chapters

ASIDE = (r"forces \S+ \d+", r"\S+-calculation", r"planetary-behind", r"engine-works")
"""Views that are worked aside and no sheet shows: force polygons of the passes of friction before the last, and
what is calculated beside a drawing, a reading now and then."""
SHORT, SHARE = 0.5, 0.01
"""What is laid off shorter than this, mm, or than this share of the longest in its view, cannot be seen."""
EVERYDAY = ("cam", "crank-press", "engine")


def traceless() -> dict[str, set[str]]:
    """The operations that leave no trace by name, by the chapter that says so."""
    names = {one.folder: one.name for one in chapters()}
    found: dict[str, set[str]] = {name: set() for name in names.values()}
    for module in walk_packages(book.__path__, f"{book.__name__}."):
        own = getattr(import_module(module.name), "TRACELESS", ())
        found[names[".".join(module.name.split(".")[:3])]].update(own)
    return found


def drawings(work: Drawn) -> Iterator[tuple[str, Drawing]]:
    """Every view that a place can show of a board, with its chapter."""
    for one in chapters():
        if one.name in work.recorded:
            for place in one.places:
                yield from ((one.name, view) for view in drawing_of(place.name)(work, False))


def unseen(work: Drawn, step: Step) -> bool:
    """Whether a step lays off, in every position that is drawn, what is too short to be seen; if any is."""
    reading = work.of(step.it.view)
    if reading is None:
        return True
    there = {
        one.it: abs(reading[one.it]).max()
        for one in work.construction.steps
        if one.it.view == step.it.view and one.it.kind is Length and one.it.slot in reading.values
    }
    laid = [there[mark] for mark in step.uses if mark in there]
    return bool(laid) and max(laid) < max(SHORT, SHARE * max(there.values()))


def without_trace(work: Drawn, views: Collection[tuple[str, Drawing]]) -> set[tuple[str, str, str]]:
    """The view, the operation and the letter of each step that nothing on any sheet comes from."""
    inked = set[int]().union(*(slots_shown(view) for _, view in views))
    by_name = traceless()
    named = {
        (shown, op) for chapter, view in views for shown in view.shows for op in by_name[chapter]
    }
    aside = re.compile("|".join(ASIDE))
    return {
        (step.it.view, step.op.name, step.it.name)
        for step in work.construction.steps
        if step.it.slot not in inked
        and not leaves_none(step.op)
        and (step.it.view, step.op.name) not in named
        and not aside.fullmatch(step.it.view)
        and not unseen(work, step)
    }


def assert_all_inked(name: str) -> None:
    for work in exact(name).boards:
        assert without_trace(work, list(drawings(work))) == set()


@pytest.mark.parametrize("name", ALL)
def test_every_step_of_a_scene_is_inked_by_some_view(name: str) -> None:
    assert_all_inked(name)


def test_a_step_that_no_view_inks_is_found() -> None:
    (work,) = exact("engine").boards
    views = list(drawings(work))
    inked = set[int]().union(*(slots_shown(view) for _, view in views))
    for op in ("cut", "lay_off", "parallel", "strike"):
        step = next(s for s in work.construction.steps if s.op.name == op and s.it.slot in inked)
        blind = [(chapter, _without(view, step.it.slot)) for chapter, view in views]
        assert (step.it.view, op, step.it.name) in without_trace(work, blind)


def _without(view: Drawing, slot: int) -> Drawing:
    """A view without all that comes from a step."""
    kept = [
        tuple(one for one in some if slot not in one.of)
        for some in (view.strokes, view.rubbed, view.labels)
    ]
    return view._replace(strokes=kept[0], rubbed=kept[1], labels=kept[2])


def test_what_is_worked_aside_is_there_and_what_is_shown_is_not_called_so() -> None:
    aside = re.compile("|".join(ASIDE))
    (work,) = exact("crank-press").boards
    logged = {step.it.view for step in work.construction.steps}
    shown = {name for _, view in drawings(work) for name in view.shows}
    assert any(map(aside.fullmatch, logged))
    assert not any(map(aside.fullmatch, shown))
