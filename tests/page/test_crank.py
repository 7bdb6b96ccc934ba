"""What the page is given of a crank that turns: the same each time, its texts those of the tables."""

from __future__ import annotations

import json

import numpy as np
import pytest
from support import gallery
from support.drives import BOOM, LEVER, RACK, SLIDER, rated, scene
from support.scripts import run

import graphic_tmm as tmm
from graphic_tmm.language.numbers import fixed
from graphic_tmm.page.crank import crank
from graphic_tmm.page.pack import unpacked
from graphic_tmm.page.strands import unfolded
from graphic_tmm.readers.rounding import rounded_figures
from graphic_tmm.readers.table import columns_of

NAME = "crank-rocker"


@pytest.mark.slow
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
    made, sheets = gallery.paper(NAME)
    found = crank(made, sheets)
    assert found is not None
    rows = unpacked(found.rows, found.data["lengths"])
    figure = next(one for one in found.data["figures"] if one["name"] == "velocities")
    angles = found.data["zero"] + found.data["sense"] * np.arange(found.data["whole"])
    due = tmm.motion(made.scene, angles, exact=True)
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


PLACE = """
import { placeText } from "./crank-values.js";
tell(asked.map(([zero, sense, k, ends]) =>
  placeText({ zero, sense, whole: 360, more: [40.125], decimal: ",", ...(ends ? { ends } : {}) }, k)));
"""


def test_a_length_is_told_in_millimetres_of_the_row() -> None:
    ends = {"letter": "l_{GN}", "unit": " mm", "from": 600.0, "per": 250.0 / 359}
    asked = [(0, 1, 0, ends), (0, 1, 359, ends), (0, 1, 360, ends)]
    assert run(PLACE, asked) == ["l_{GN} = 600 mm", "l_{GN} = 850 mm", "l_{GN} = 627,9 mm"]
    lever = {"letter": "φ", "unit": "°", "from": 340.0, "per": 0.25}
    assert run(PLACE, [(340, 1, 100, lever)]) == ["φ = 5°"]


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
    assert run(PLACE, list(due)) == [f"φ = {text}°" for text in due.values()]


WITHIN = """
import { indexAt, turnWithin } from "./dense.js";
tell(asked.map(([turn, ends]) => {
  const dense = { whole: 360, more: [40.125], ...(ends ? { ends } : {}) };
  return [turnWithin(dense, turn), indexAt(dense, turn)];
}));
"""


def test_a_row_with_ends_does_not_go_round() -> None:
    asked = [(-5, False), (365, False), (-5, True), (365, True), (359, True), (40.2, True)]
    due = [[355, 355], [5, 5], [0, 0], [359, 359], [359, 359], [40.2, 360]]
    assert run(WITHIN, asked) == due


@pytest.mark.parametrize("text", [BOOM, SLIDER, LEVER, RACK])
@pytest.mark.parametrize("listed", [False, True])
def test_between_the_ends_of_a_row_rates_are_those_of_the_motion(text: str, listed: bool) -> None:
    one = scene(rated(text) if listed else text)
    made = tmm.draw(one, exact=True)._work.drawn_scene
    found = crank(made, ())
    assert found is not None
    rows, data = unpacked(found.rows, found.data["lengths"]), found.data
    many = 1.0 if text is LEVER else 1000.0
    at = (data["ends"]["from"] + data["ends"]["per"] * np.arange(data["whole"])) / many
    due = tmm.motion(one, at, exact=True)
    figure = next(one for one in data["figures"] if one["name"] == "velocities")
    value = next(one for one in figure["values"] if one["letter"] == "ω_{2}")
    own = (rows[value["row"][0]] * value["worth"])[: data["whole"]]
    np.testing.assert_allclose(own, due.omega[2], atol=2 * value["worth"])
    for row in rows:
        assert np.isfinite(row).all()
    assert len(data["figures"][0]["crank"]) == (3 if text is LEVER else 0)
