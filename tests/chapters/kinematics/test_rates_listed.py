"""A speed, or an acceleration, for each position: every position is as with that speed alone."""

from __future__ import annotations

import numpy as np
import pytest
from support.driven_scenes import BOOM, ROCKER, scene

import graphic_tmm
from graphic_tmm.errors import TmmError

SPEEDS, GAINS = (2.0, 4.0, 5.0, 3.0), (1.0, 0.0, -2.0, 0.5)
TAIL = 'positions = 4\naccelerations = "all"\n'


def listed(speeds: object, gains: object) -> str:
    return f"speed = {speeds}\nacceleration = {gains}\n{TAIL}"


@pytest.mark.slow
def test_every_position_is_as_with_its_own_speed_alone() -> None:
    drawn = graphic_tmm.draw(scene(ROCKER, listed([*SPEEDS], [*GAINS])), exact=True)
    for plan in ("velocities", "accelerations"):
        table = drawn.table(plan)
        for k, (speed, gain) in enumerate(zip(SPEEDS, GAINS, strict=True)):
            alone = graphic_tmm.draw(scene(ROCKER, listed(speed, gain)), exact=True).table(plan)
            for name in alone:
                due = alone[name].value[0, k]
                np.testing.assert_allclose(table[name].value[0, k], due, rtol=1e-9, atol=1e-12)


def test_a_rod_that_runs_out_unevenly() -> None:
    row = 'from = "600 mm"\nto = "850 mm"\npositions = 3\n'
    drawn = graphic_tmm.draw(scene(BOOM, f'speed = ["0.05 m/s", "0.1 m/s", 0]\n{row}'), exact=True)
    even = graphic_tmm.draw(scene(BOOM, f'speed = "0.1 m/s"\n{row}'), exact=True)
    own, due = (one.table("velocities")["omega1"].value[0] for one in (drawn, even))
    np.testing.assert_allclose(own, due * [0.5, 1.0, 0.0], rtol=1e-12, atol=1e-15)


def test_between_positions_the_speed_changes_in_proportion() -> None:
    changing = scene(ROCKER, listed([*SPEEDS], 0))
    found = graphic_tmm.motion(changing, [90.0, 135.0, 315.0], exact=True).omega[1]
    np.testing.assert_allclose(found, [4.0, 4.5, 2.5], rtol=1e-12)


@pytest.mark.parametrize(
    ("drive", "says"),
    [
        ("speed = [1, 2]\npositions = 4\n", "2 are listed for 4 positions: write one for each"),
        ('speed = [1, 2]\npositions = 2\nextra = ["5 deg"]\n', "leave extra out"),
        (
            'speed = [1, 2, 3, 4]\npositions = 4\n[scales]\nmu_v = "mu_l*omega1"\n',
            "write mu_v",
        ),
    ],
)
def test_what_a_list_does_not_tell_is_refused(drive: str, says: str) -> None:
    with pytest.raises(TmmError, match=says):
        graphic_tmm.draw(scene(ROCKER, drive)).table("velocities")
