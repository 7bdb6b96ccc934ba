"""Loads by the turn and by positions in open rows: outside of them, back, beyond a whole turn."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from support.open_rows import STROKES, drawn, sizes

import graphic_tmm
from graphic_tmm.chapters.forces.plan import FORCES_PLAN


def test_sizes_by_the_turn_before_an_open_row_are_those_of_the_turn(tmp_path: Path) -> None:
    """Where the sheet counted 8° before its first position as 8° behind it."""
    for name in ("crank", "crank back"):
        of = STROKES[name]
        extra = f'extra = ["{of.outside[0]} deg", "{of.outside[1]} deg"]\n'
        ends = f'from = "{of.first} deg"\nto = "{of.last} deg"\npositions = 6\n{extra}'
        more = '[[load]]\nlink = 3\nby_angle = [[0, "10 N*m"], [90, "100 N*m"], [600, "60 N*m"]]\n'
        made = drawn(of.scene(more, ends), tmp_path)
        places = np.array([*np.linspace(of.first, of.last, 6), *of.outside])
        turned = (of.times(places) * of.rate) % 720.0
        wanted = np.interp(turned, [0.0, 90.0, 600.0, 720.0], [10.0, 100.0, 60.0, 10.0])
        np.testing.assert_allclose(sizes(made), wanted, rtol=1e-9)
        told = graphic_tmm.motion(made.scene, places, plans=["forces"], exact=True).balance
        found = made.reading[FORCES_PLAN.on(made).first.balance][0]
        np.testing.assert_allclose(told["P_bal_forces"], found, rtol=1e-9)


def test_sizes_by_position_are_those_of_the_same_angle_beyond_a_whole_turn(tmp_path: Path) -> None:
    of = STROKES["crank past 360°"]
    sized = ", ".join(f'"{10 * k + 10} N*m"' for k in range(6))
    made = drawn(of.scene(f"[[load]]\nlink = 3\nby_position = [{sized}]\n"), tmp_path)
    found = made.reading[FORCES_PLAN.on(made).first.balance][0]
    for at in (np.linspace(340.0, 390.0, 6), np.linspace(340.0, 390.0, 6) % 360.0):
        told = graphic_tmm.motion(made.scene, at, plans=["forces"], exact=True).balance
        np.testing.assert_allclose(told["P_bal_forces"], found, rtol=1e-9)
