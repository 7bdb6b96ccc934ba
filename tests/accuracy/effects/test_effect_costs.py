"""Effects cost what logs recorded by hand cost: steps, minutes at the positions drawn; what is timed."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from support.gallery import scene as gallery
from support.tasks import effect, effects_known, scales, text_of, written

from graphic_tmm.accuracy.cost import MINUTES, done, varying
from graphic_tmm.accuracy.drawing import draw
from graphic_tmm.accuracy.effects import effect_costs, effect_study
from graphic_tmm.accuracy.effects.effect_study import study_effects
from graphic_tmm.accuracy.geometrography import elements, symbol
from graphic_tmm.accuracy.timing import Calls, Key, Seconds, Stopwatch
from graphic_tmm.project import Project, record

LOAD = "[[load]]" + text_of("crank-press").partition("[[load]]")[2].partition("[forces]")[0]
BY_HAND = [
    ("gravity", "gravity  = true", "gravity = false"),
    ("inertia", "inertia  = true", "inertia = false"),
    ("friction", "friction = true", "friction = false"),
    ("load 1, at B", LOAD, ""),
]


def minutes(log: Project) -> float:
    """The minutes of a log whose forces stand at one position: of views of forces each step once."""
    own = {view for view in log.told if view not in ("positions", "velocities", "accelerations")}
    total = 0.0
    for step in log.construction.steps:
        if step.it.view in own:
            done = elements(symbol(step.op), step.choice.get("row", 1))
            total += sum(n * MINUTES[name] for name, n in done.items())
    return total


@pytest.mark.parametrize(("name", "old", "new"), BY_HAND)
def test_an_effect_costs_what_the_log_has_less_without_it(
    tmp_path: Path, name: str, old: str, new: str
) -> None:
    whole = record(gallery("crank-press"))
    without = record(written(tmp_path, text_of("crank-press"), (old, new)))
    found = effect(effects_known("crank-press"), name)
    assert found.called
    assert found.cost.steps == len(whole.construction.steps) - len(without.construction.steps) > 0
    assert found.cost.minutes == pytest.approx(minutes(whole) - minutes(without))


@pytest.mark.slow
def test_what_a_flywheel_takes_from_the_lever_is_drawn_at_all_positions() -> None:
    """The windrower's polygons stand at one position, its J goes by the moments of loads at all twelve."""
    log = record(gallery("windrower"))
    elsewhere = [step.it for step in log.construction.steps if step.it.view not in log.told]
    at = {view: len(rows) for view, rows in log.told.items()}
    varies, times = varying(log.given), Counter[int]()
    for own in (
        done(log.construction, varies, positions=12, only=at),
        done(log.construction, varies, elsewhere, positions=12),
    ):
        times |= Counter({one.step.it.slot: one.times for one in own})
    total = 0.0
    for one in done(log.construction, varies):
        each = elements(symbol(one.step.op), one.row)
        total += times[one.step.it.slot] * sum(n * MINUTES[name] for name, n in each.items())
    assert effects_known("windrower").whole.minutes == pytest.approx(total)


@pytest.mark.slow
def test_a_log_that_stays_the_same_takes_no_longer() -> None:
    found = study_effects(gallery("crank-press"), trials=10)
    assert found.whole.seconds is not None
    assert found.whole.seconds > 0.0
    assert effect(found, "gas").cost.seconds == 0.0
    assert effect(found, "friction").cost.seconds != 0.0


class Watch(Stopwatch):
    """A watch that takes every call to last 2 s and a tenth, and keeps what it was to time."""

    def __init__(self) -> None:
        super().__init__(tick=0.0)
        self.rows: list[Any] = []

    def in_turns(self, calls: Calls[Key]) -> dict[Key, Seconds]:
        self.rows = [call.args[0] for call in calls.values()]  # type: ignore[attr-defined]
        lasting = zip(calls, (2.1, 2.0), strict=False)
        return {key: Seconds(one, one, one + 0.15, one + 0.3) for key, one in lasting}


def test_curves_that_stay_the_same_are_not_timed() -> None:
    """Of an engine its curves are most of a run; the mass of a link changes none of their steps."""
    scene, watch = gallery("engine"), Watch()
    drawings = draw(scene, scales("engine"))
    every = effect_study.effects(scene, drawings)
    lighter = next(one for one in every if one.name == "masses of link 2")
    rest = draw(lighter.without(scene), scales("engine"))
    more, unsure = effect_costs.seconds_apart(drawings, rest, watch)
    assert more == pytest.approx(0.1)
    assert unsure == pytest.approx(0.3)  # so far the runs scatter
    programs = [[program for program, _ in row] for row in watch.rows]
    assert all(not across for row in programs for one in row for _, across in one.strata)
    whole, less = (sum(len(one.strata[0][0]) for one in row) for row in programs)
    assert whole - less == 4


def test_curves_that_change_are_timed_too() -> None:
    scene, watch = gallery("four-stroke"), Watch()
    drawings = draw(scene, {})
    (gas,) = [one for one in effect_study.effects(scene, drawings) if "gas" in one.name]
    effect_costs.seconds_apart(drawings, draw(gas.without(scene), {}), watch)
    assert any(across for row in watch.rows for one, _ in row for _, across in one.strata)
