"""What the page is given of a crank that turns: the same each time, its texts those of the tables."""

from __future__ import annotations

import json

import numpy as np
from support import gallery
from support.scripts import run

from graphic_tmm.language.numbers import fixed
from graphic_tmm.page.crank import crank
from graphic_tmm.page.pack import unpacked
from graphic_tmm.page.strands import unfolded
from graphic_tmm.readers.rounding import rounded_figures
from graphic_tmm.readers.table import columns_of

NAME = "crank-rocker"


def test_the_same_scene_gives_the_same_bytes() -> None:
    first, second = (crank(*gallery.paper(NAME)) for _ in range(2))
    assert first is not None
    assert second is not None
    assert first.rows == second.rows
    texts = [json.dumps(one.data, allow_nan=False) for one in (first, second)]
    assert texts[0] == texts[1]


def test_a_scene_without_a_mechanism_has_nothing_to_turn() -> None:
    assert crank(*gallery.paper("gear-pair")) is None


def test_texts_at_the_positions_are_those_of_the_tables() -> None:
    made, sheets = gallery.paper(NAME)
    found = crank(made, sheets)
    assert found is not None
    assert made.mechanism is not None
    by_plan = {figure["name"]: figure for figure in found.data["figures"]}
    for plan in ("velocities", "accelerations"):
        columns = [one for one in columns_of(made.mechanism) if one.plan == plan]
        due = [
            [fixed(v, one.places, "en") if v is not None else None for v in one.value]
            for one in rounded_figures(columns)
        ]
        assert [value["texts"] for value in by_plan[plan]["values"]] == due


def test_figures_between_positions_are_those_of_a_motion() -> None:
    """The rows of values come back, at each degree the rate that an independent reading of the plans gives."""
    import graphic_tmm

    made, sheets = gallery.paper(NAME)
    found = crank(made, sheets)
    assert found is not None
    rows = unpacked(found.rows, found.data["lengths"])
    figure = next(one for one in found.data["figures"] if one["name"] == "velocities")
    angles = found.data["zero"] + found.data["sense"] * np.arange(found.data["whole"])
    due = graphic_tmm.motion(made.scene, angles, exact=True)
    for number in (2, 3):
        value = next(one for one in figure["values"] if one["letter"] == f"ω_{{{number}}}")
        own = (rows[value["row"][0]] * value["worth"])[: found.data["whole"]]
        np.testing.assert_allclose(own, due.omega[number], atol=2 * value["worth"])


def test_rows_of_figures_are_kept_folded() -> None:
    found = crank(*gallery.paper(NAME))
    assert found is not None
    rows = unpacked(found.rows, found.data["lengths"])
    for figure in found.data["figures"]:
        begun, count, drawn = figure["rows"]
        for row in rows[begun : begun + count]:
            assert row.size == drawn
            whole = unfolded(row, found.data["whole"], figure["refined"])
            assert np.abs(whole).max() < 2_000_000


BEARING = """
import { bearing } from "./crank-values.js";
tell(asked.map(([zero, sense, k]) => bearing({ zero, sense, whole: 360, more: [40.125], decimal: "," }, k)));
"""


def test_the_direction_of_the_crank_is_within_a_turn_whichever_way_it_turns() -> None:
    """From 30 degrees a quarter of a turn and more, there and back; the angle behind the whole degrees."""
    due = {
        (30, 1, 90): "120",
        (30, -1, 90): "300",
        (-30, -1, 350): "340",
        (300, 1, 60): "0",
        (0.004, -1, 0): "0",
        (-0.001, 1, 0): "0",
        (30, -1, 360): "349,9",
    }
    assert run(BEARING, list(due)) == list(due.values())
