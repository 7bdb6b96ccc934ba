"""Forces through the teeth of wheels on links against Newton and Euler; what a scene is told of them."""

from __future__ import annotations

import math

import pytest
from support import gallery
from support.loaded import errors, order_of, solve, weighed
from support.wheel_loops import FiveBar
from support.wheels import geared, near

import graphic_tmm as tmm
from graphic_tmm.errors import StructureError, TmmError
from graphic_tmm.readers.findings import all_warnings
from graphic_tmm.studio import make

RATIO = 1e-9


def _all_hold(seeds: range, *, belted: bool = False) -> None:
    refused: list[int] = []
    for seed in seeds:
        drawn = geared(seed, 1 + seed % 2, belted=belted)
        loaded = weighed(drawn, seed)
        order = order_of(
            loaded,
            gravity=bool(seed % 2),
            inertia=bool(seed % 3),
            balance="force" if seed % 5 < 3 else "moment",
        )
        poses = {k: pose for k, pose in drawn.poses.items() if k != drawn.mechanism.frame.number}
        try:
            solved = solve(
                loaded, drawn.phi, poses, order, turned=bool(seed % 7 < 3), wound=near(drawn)
            )
        except StructureError as error:  # a link swings by more than a whole turn over the turn
            if "cannot follow" not in str(error):
                raise
            refused.append(seed)
            continue
        found = errors(solved)
        assert max(found.values()) <= RATIO, (seed, found)
    assert len(refused) <= len(seeds) // 50, refused


def test_wheels_on_any_links_bear_as_newton_and_euler_say() -> None:
    _all_hold(range(8))


@pytest.mark.slow
def test_many_wheels_on_any_links_bear_as_newton_and_euler_say() -> None:
    _all_hold(range(100, 250))


def test_belts_on_any_links_pull_as_newton_and_euler_say() -> None:
    _all_hold(range(8), belted=True)


@pytest.mark.slow
def test_many_belts_on_any_links_pull_as_newton_and_euler_say() -> None:
    _all_hold(range(100, 250), belted=True)


LOADED = (
    FiveBar(0.04, 0.12, 0.12, 0.025, 0.12, (40, 20), phase=60.0).scene
    + """
[[load]]
link = 2
point = "B"
force = 150
direction = "-90 deg"
[forces]
positions = [2]
balance = "moment"
"""
)


def test_a_pitch_radius_too_short_to_read_is_no_radius_of_zero() -> None:
    """Three teeth to 10000 on 120 mm leave 0.04 mm: what is read is 0 at this scale, whatever the radius is."""
    text = LOADED.replace("[40, 20]", "[10000, 3]")
    made = make(tmm.read(text))
    told = " ".join(all_warnings(made, "en"))
    assert "R_14^t': the pitch radius is too short to be measured at this scale" in told, told


@pytest.mark.parametrize("alpha", [15.0, 20.0, 25.0])
def test_the_tooth_presses_along_the_line_of_action(alpha: float) -> None:
    """The part along the tangent is M/r whatever α, the force is that by cos α; the balance is the same."""
    text = LOADED.replace("internal = false", f"internal = false\nalpha = {alpha}")
    found = tmm.motion(text, [40.0], plans=("forces",), exact=True)
    plain = tmm.motion(LOADED, [40.0], plans=("forces",), exact=True)
    force, usual = (abs(one.forces["R14"][0]) for one in (found, plain))
    assert force * math.cos(math.radians(alpha)) == pytest.approx(
        usual * math.cos(math.radians(20.0)), rel=1e-12
    )
    assert found.balance["M_bal_forces"][0] == pytest.approx(
        plain.balance["M_bal_forces"][0], rel=1e-12
    )


@pytest.mark.parametrize("turns", ["counterclockwise", "clockwise"])
@pytest.mark.parametrize("resists", [True, False])
def test_a_run_that_would_push_is_told(turns: str, resists: bool) -> None:
    """The run that is drawn pulls at M/r what is turned against a moment; along with it the other run would."""
    text = (gallery.SHEETS / "belt-drive" / "scene.toml").read_text("utf-8")
    sense = 1 if turns == "counterclockwise" else -1
    moment = -12 * sense if resists else 12 * sense
    text = text.replace("-12 N*m", f"{moment} N*m")
    text = text.replace("positions     = 12", f'positions     = 12\nturns = "{turns}"')
    told = [one for one in all_warnings(make(tmm.read(text)), "en") if "would push" in one]
    assert len(told) == (not resists), told
    assert all("in position 8 the run LK of the belt would push link 4" in one for one in told)
    chain = all_warnings(make(tmm.read(text.replace('"ремень"', '"цепь"'))), "en")
    assert sum("the run LK of the chain would push link 4" in one for one in chain) == len(told)
    found = tmm.motion(text, [40.0], plans=("forces",), exact=True)
    assert abs(found.forces["R14"][0]) == pytest.approx(12 / 0.08, rel=1e-12)


def test_friction_is_refused_beside_wheels() -> None:
    text = LOADED + '[effects]\nfriction = true\n[friction]\nf = 0.1\nradius = "10 mm"\n'
    with pytest.raises(TmmError, match="not between the teeth of wheels on links"):
        _ = tmm.draw(text).sheets
