"""What is calculated beside a train: it moves no mark of the drawing, and is what brute force finds."""

from __future__ import annotations

import cmath
import math
from pathlib import Path

import pytest
from support.boards import usual_part
from support.gallery import SHEETS
from support.notes import concluded
from support.scenes import edited, written

from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN
from graphic_tmm.chapters.trains.record import BEHIND, BESIDE, CALCULATED
from graphic_tmm.chapters.trains.table import train_results
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.project import record
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

WANTED = {
    "ring": "teeth = [25, 32, 89]",
    "external-internal": "ratio = 12.0",
    "external-external": "ratio = -8.0",
    "internal-internal": "ratio = 0.6",
}
"""By the scheme: what is asked of a train."""
SCENE = SHEETS / "planetary" / "scene.toml"


def part(scene: Scene) -> Drawn:
    return usual_part("planetary", scene)


def value(drawn: Drawn, name: str) -> float:
    mark = getattr(BESIDE.on(drawn), name)
    return float(drawn.reading[mark].item())


def test_what_is_calculated_beside_a_drawing_moves_none_of_its_marks() -> None:
    """Its steps come after all others, and no other step uses what they leave."""
    log = record(read(SCENE), "planetary").construction
    beside = [step for step in log.steps if step.it.view in (CALCULATED, BEHIND)]
    others = [step for step in log.steps if step not in beside]
    assert beside
    assert min(step.it.slot for step in beside) > max(step.it.slot for step in others)
    assert not {step.it for step in beside} & {mark for step in others for mark in step.uses}


def test_where_no_pair_stands_behind_nothing_is_calculated(tmp_path: Path) -> None:
    alone = edited(tmp_path, ("\nbehind", "\n# behind"), name="planetary")
    project = record(read(alone), "planetary")
    assert BESIDE.on(project).speed is None
    assert not project.marks(BEHIND)


def test_the_wheel_behind_turns_as_the_teeth_say() -> None:
    found = value(part(read(SCENE)), "speed")
    assert found == pytest.approx(2888.0 / 7.6, rel=1e-12)


def test_teeth_and_ratios_are_those_of_the_book() -> None:
    """Document 003: 25, 32 and 89 teeth; the ratio of the train from those of its meshes."""
    drawn = part(read(SCENE))
    assert value(drawn, "ring") == pytest.approx(25 * 3.55, rel=1e-12)
    assert value(drawn, "satellite") == pytest.approx((25 * 3.55 - 25) / 2, rel=1e-12)
    outer, inner = (drawn.reading[mark].item() for mark in BESIDE.on(drawn).stopped)
    assert (outer, inner) == (pytest.approx(-32 / 25), pytest.approx(89 / 32))
    assert 1 - outer * inner == pytest.approx(1 + 89 / 25)


@pytest.mark.parametrize("scheme", WANTED)
def test_the_most_satellites_are_those_that_brute_force_places(scheme: str, tmp_path: Path) -> None:
    text = f"""
title = "T"
language = "en"
[planetary]
scheme = "{scheme}"
module = "4 mm"
speed = "1400 rpm"
{WANTED[scheme]}
satellites = 2
[[sheet]]
place = ["planetary"]
"""
    drawn = part(read(written(tmp_path, text)))
    made = PLANETARY_PLAN.on(drawn)
    axes = drawn.reading[made.sizes.axes].item()
    tips = [drawn.reading[tip].item() for tip in made.sizes.tips.values()]
    spots = ((k, axes * abs(cmath.rect(1, 2 * math.pi / k) - 1)) for k in range(2, 400))
    stopped = math.prod(drawn.reading[mark].item() for mark in BESIDE.on(drawn).stopped)
    assert 1.0 - stopped == pytest.approx(drawn.reading[made.sizes.ratio].item())
    assert value(drawn, "most") == max(k for k, apart in spots if apart > max(tips))


def test_results_and_words_tell_the_meshes_and_that_all_conditions_hold() -> None:
    drawn = part(read(SCENE))
    found = single(train_results(drawn))
    assert found["planetary_mesh_1"][0] == pytest.approx(-32 / 25)
    assert found["planetary_mesh_2"][0] == pytest.approx(89 / 32)
    words = concluded(drawn)[-1]
    taken, most = found["planetary_satellites"][0], found["planetary_most"][0]
    assert taken <= most
    assert f"{taken:g} satellites" in words
    assert f"at most {most:g} have room" in words
