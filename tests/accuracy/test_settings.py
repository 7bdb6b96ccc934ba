"""An axis for what a scene calls for, and none for what it does not."""

from __future__ import annotations

import pytest
from support.tasks import by, drawing, scene

from graphic_tmm.accuracy.settings import COUNTS, LONG, grid, singly

ALWAYS = {"slip", "ruler", "size", "trials"}
EACH = [
    ("offset-slider", {"positions"}, set()),
    ("slider-diagrams", {"positions"}, {"method", "start", "pole"}),
    ("engine", {"positions"}, {"pole"}),
    ("windrower", {"positions"}, {"method", "start", "pole"}),
    ("crank-press", {"positions"}, {"passes"}),
    ("locomobile", {"positions"}, {"rod", "inertia"}),
    ("cam", {"parts"}, set()),
    ("gear-pair", {"steps"}, set()),
]


@pytest.mark.every
@pytest.mark.parametrize(("name", "divided", "own"), EACH)
def test_effects_that_a_scene_does_not_call_for_have_no_axis(
    name: str, divided: set[str], own: set[str]
) -> None:
    setting = by(name, "scene")
    assert {place.axis for place in grid(setting, 20)} == divided
    assert {place.axis for place in singly(setting, 20)} == ALWAYS | own


def test_each_of_the_five_slips_stands_alone() -> None:
    fields = ("prick", "compass", "swing", "reading", "digits")
    rows = [p.setting.who for p in singly(by("windrower", "scene"), 20) if p.axis == "slip"]
    assert [[f for f in fields if getattr(who, f)] for who in rows] == [[f] for f in fields]
    assert {who.ruler for who in rows} == {None}


def test_only_the_exact_hand_draws_hundreds_of_positions() -> None:
    places = [p for p in grid(by("windrower", "scene"), 20) if p.axis == "positions"]
    long = {p.setting.hand for p in places if int(p.value) in LONG}
    short = {p.setting.hand for p in places if int(p.value) in COUNTS}
    assert long == {"exact"}
    assert short == {"exact", "cad", "careful", "student", "scene"}
    assert max(LONG) == 768


def test_one_thing_is_varied_at_a_time() -> None:
    own = by("windrower", "scene")
    for place in singly(own, 20):
        same = {
            "scene": place.setting.scene == own.scene,
            "who": place.setting.who == own.who,
            "enlarged": place.setting.enlarged == own.enlarged,
        }
        varied = {key for key, alike in same.items() if not alike}
        assert len(varied) <= 1


@pytest.mark.slow
def test_passes_of_friction_and_steps_of_rolling_change_the_log() -> None:
    for name, axis in (("crank-press", "passes"), ("gear-pair", "steps"), ("cam", "parts")):
        own = by(name, "scene")
        along = [p.setting.scene for p in (*singly(own, 9), *grid(own, 9)) if p.axis == axis]
        changed = (along[0], along[-1])
        sizes = {len(drawing(name, one).construction.steps) for one in changed}
        counts = {drawing(name, one).count for one in changed}
        assert len(sizes) > 1 or len(counts) > 1
    assert scene("windrower").tasks.get("diagrams") is not None
