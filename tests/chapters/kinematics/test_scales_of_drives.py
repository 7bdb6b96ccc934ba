"""Scale factors fixed by a segment of the drive: as they are drawn, so they are told; else one sentence."""

from __future__ import annotations

import numpy as np
import pytest
from support.boards import drawn_of
from support.drives import BOOM, LEVER, RACK, SLIDER, rated
from support.each import each

import graphic_tmm as tmm
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, PLANS, POSITIONS, VELOCITIES
from graphic_tmm.errors import StructureError
from graphic_tmm.fitting.choice import choices
from graphic_tmm.readers.table import columns_of

GAINING = 'accelerations = "all"\nacceleration = "3 '
EVEN = {"boom": BOOM.replace('acceleration = "0.3 m/s^2"\n', ""), "slider": SLIDER}
EVEN |= {"lever": LEVER, "rack": RACK}
GAINED = {
    name: text.replace(
        'accelerations = "all"', f'{GAINING}{"rad" if name == "lever" else "m"}/s^2"'
    )
    for name, text in EVEN.items()
}
STANDS = {
    name: "\n".join("speed = 0" if one.startswith("speed") else one for one in text.splitlines())
    for name, text in GAINED.items()
}
SCENES = {
    **EVEN,
    **{f"{name} gains": text for name, text in GAINED.items()},
    **{f"{name} stands": f"{text}\n" for name, text in STANDS.items()},
    **{f"{name} listed": rated(text) for name, text in EVEN.items()},
}
KEYS = {
    "OA": ('OA = "40 mm"', POSITIONS),
    "pa": ('pa = "40 mm"', VELOCITIES),
    "mu_v": ('mu_v = "mu_l*omega1"', VELOCITIES),
    "pi_a": ('pi_a = "40 mm"', ACCELERATIONS),
}


def _held(name: str, key: str) -> bool:
    """Whether a drive has what a key fixes."""
    turns, listed = name.startswith(("lever", "rack")), name.endswith("listed")
    gains = turns or name.endswith(("gains", "stands"))
    return {
        "OA": turns,
        "pa": not listed,
        "mu_v": name.startswith("lever") and not listed,
        "pi_a": gains and not listed,
    }[key]


@each("name", SCENES)
@each("key", KEYS)
@pytest.mark.slow
def test_a_segment_fixes_a_scale_factor_where_the_drive_has_it(name: str, key: str) -> None:
    written, plan = KEYS[key]
    scene = tmm.read(f"{SCENES[name]}[scales]\n{written}\n")
    if not _held(name, key):
        with pytest.raises(StructureError, match=rf"scales.{key}: .*write mu_[lva]"):
            drawn_of(scene)
        return
    drawn = drawn_of(scene, exact=True)
    mu = drawn.scales[plan].value
    assert choices(drawn).value(drawn.project.scale(plan)) == pytest.approx(mu, rel=1e-12)
    made = KINEMATICS_PLAN.on(drawn)
    known, most = made.pairs[0].sizes[PLANS.index(plan)], 40.0
    if key == "mu_v":
        most = made.pairs[0].sizes.length / drawn.scales[POSITIONS].value
    assert known / mu == pytest.approx(most, rel=1e-12)
    if made.arms and plan != POSITIONS:
        (vector,) = (c for c in columns_of(drawn) if c.plan == plan and c.segment in ("pa", "πa"))
        assert vector.mm is not None
        np.testing.assert_allclose(vector.mm, most, rtol=1e-9)
