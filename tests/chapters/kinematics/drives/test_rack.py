"""A rack turns its link as a crank of the same angular velocity does."""

from __future__ import annotations

import math

import numpy as np
from support.driven_scenes import ROCKER, TORQUE, scene

import graphic_tmm

RADIUS = 0.04


def test_a_rack_moves_all_links_as_the_crank_that_it_turns() -> None:
    rack = scene(
        ROCKER,
        'speed = "0.2 m/s"\nacceleration = "0.1 m/s^2"\nrack = "40 mm"\nfrom = "10 mm"\nto = "120 mm"\n',
    )
    crank = scene(ROCKER, 'speed = "5 rad/s"\nacceleration = "2.5 rad/s^2"\n')
    ways = np.linspace(0.01, 0.12, 7)
    rolled = graphic_tmm.motion(rack, ways, exact=True)
    turned = graphic_tmm.motion(crank, np.degrees(ways / RADIUS), exact=True)
    for name in ("places", "velocities", "accelerations", "omega", "epsilon"):
        own, due = getattr(rolled, name), getattr(turned, name)
        assert own.keys() == due.keys()
        for key, row in own.items():
            np.testing.assert_allclose(row, due[key], rtol=1e-12, atol=1e-13)


def test_a_rack_that_goes_back_turns_the_link_clockwise() -> None:
    drive = 'speed = "0.2 m/s"\nrack = "40 mm"\nfrom = "120 mm"\nto = "10 mm"\npositions = 4\n'
    table = graphic_tmm.draw(scene(ROCKER, drive), exact=True).table("velocities")
    np.testing.assert_allclose(table["omega1"].value[0], -0.2 / RADIUS, rtol=1e-12)


def test_a_rack_holds_what_its_crank_holds() -> None:
    drive = 'speed = "0.2 m/s"\nrack = "40 mm"\nfrom = "10 mm"\nto = "120 mm"\npositions = 2\n'
    drawn = graphic_tmm.draw(scene(ROCKER, drive + TORQUE), exact=True).table("forces")
    angle = math.degrees(0.12 / RADIUS)
    crank = f'speed = "5 rad/s"\npositions = 2\nzero = "{angle - 180.0} deg"\n'
    due = graphic_tmm.draw(scene(ROCKER, crank + TORQUE), exact=True).table("forces")
    for name in ("P_bal_forces", "P_bal_lever"):
        np.testing.assert_allclose(drawn[name].value[0, 1], due[name].value[0, 1], rtol=1e-9)
