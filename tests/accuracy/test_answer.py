"""What the sentences say is true: each number by drawings with another seed, drawn with the change proposed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache

import pytest
from support import gallery
from support.drawn_at_random import errors, scenes
from support.switched_off import brute, tasks
from support.tasks import answered

from graphic_tmm.accuracy.answer import Answer, answer
from graphic_tmm.accuracy.answer_text import sentences
from graphic_tmm.accuracy.drawing import draw, pinned
from graphic_tmm.accuracy.measure import work_of
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.ways import Way, pace, wanted
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

FRESH = 70_000
SHEETS = ("slider-diagrams", "crank-rocker", "cam", "engine", "gear-pair")
STRANGERS = ("whitworth-pin-S", "dsc", "random 3")


def scene(name: str) -> Scene:
    if name.startswith("random"):
        return [*scenes(4)][int(name.split()[1])].scene
    if name in SHEETS:
        return gallery.scene(name)
    return read(next(gallery.CASES.rglob(f"{name}.toml")))


@cache
def weighed(name: str) -> Answer:
    return answered(name) if name in gallery.ALL else answer(scene(name))


def says(own: Answer, figure: float) -> str:
    return f"{number(figure, own.scene.language, 2)} %"


def minutes(drawn: Scene, way: Way) -> float:
    """Count the minutes off the logs of what the sheets show."""
    due = 0.0
    for drawing in draw(drawn, pinned(make(drawn, exact=True))):
        marks = [m for q in quantities(drawing) if wanted(drawn, q) for m in q.marks]
        due += work_of(drawing, marks).minutes
    return due * pace(way.hand, way.ruler)


def close(own: Answer, measured: Mapping[str, float], due: Mapping[str, float]) -> None:
    """Of a quantity that is one number 300 drawings leave its error uncertain by some 6 %."""
    for task in tasks(own.scene):
        for quantity in (q for q in task.asked if q.name in measured):
            within = 0.12 if quantity.row else 0.2
            assert measured[quantity.name] == pytest.approx(due[quantity.name], rel=within)


def true(name: str) -> None:
    own = weighed(name)
    far, halved, wasted, knee, *_ = sentences(own)
    scales = pinned(make(own.scene, exact=True))
    _how_far(own, name, far)
    _halved(own, halved)
    rows = [(knee, own.knee)] + ([(wasted, own.wasted)] if own.wasted is not None else [])
    for line, row in rows:
        assert says(own, row.worst) in line
        if row.way.times == 1.0:
            due = errors(row.way.of(own.scene), FRESH, 1000, scales)
            close(own, row.errors, due)
    if own.wasted is not None:
        assert own.wasted.worst >= 0.9 * own.own.worst
        more = minutes(own.wasted.way.of(own.scene), own.wasted.way) - own.own.way.minutes
        assert fixed(more, 0, own.scene.language) in wasted
    assert fixed(minutes(own.knee.way.of(own.scene), own.knee.way), 0, own.scene.language) in knee


def _how_far(own: Answer, name: str, far: str) -> None:
    due = errors(own.scene, FRESH)
    assert {*own.own.errors, *own.lost} == due.keys()
    close(own, own.own.errors, due)
    assert due[own.worst] >= 0.9 * max(due[quantity] for quantity in own.own.errors)
    assert says(own, own.own.worst) in far
    if own.printed is not None:
        as_printed = errors(replace(own.scene, hand="exact", ruler=scene(name).ruler), FRESH)
        assert own.printed == pytest.approx(as_printed, rel=0.01)
        assert says(own, as_printed[own.worst]) in far


def _halved(own: Answer, line: str) -> None:
    if own.halved is None:
        assert own.nearest is not None
        assert own.nearest[0].worst > 0.5 * own.own.worst
        assert says(own, own.nearest[0].worst) in line
        return
    due = errors(own.halved.scene, FRESH)
    assert max(due.values()) <= 0.5 * own.own.worst
    close(own, own.halved.errors, due)
    assert says(own, max(own.halved.errors.values())) in line
    for drawn, way in ((own.halved.scene, own.halved.way), (own.scene, own.own.way)):
        assert way.minutes == pytest.approx(minutes(drawn, way), rel=0.03)
        assert fixed(way.minutes, 0, own.scene.language) in line


def test_the_sentences_are_true() -> None:
    true("crank-rocker")


@pytest.mark.turns(1, "sentences")
@pytest.mark.slow
@pytest.mark.parametrize("name", [*SHEETS, *STRANGERS])
def test_the_sentences_are_true_of_other_scenes_and_of_strangers(name: str) -> None:
    true(name)


@pytest.mark.turns(1, "sentences")
@pytest.mark.slow
@pytest.mark.parametrize("name", ["slider-diagrams", "crank-rocker", "dsc"])
def test_where_the_error_comes_from_is_true(name: str) -> None:
    own = weighed(name)
    (origin,) = [one for one in own.origins if one.hand == own.own.way.hand]
    (task,) = tasks(own.scene)
    due = brute(task, own.own.way.hand, 6000)[own.worst]
    assert origin.of[own.worst].parts == pytest.approx(due, abs=0.04)
    first = max(due, key=lambda source: due[source])
    assert next(iter(origin.of[own.worst].parts)) == first
