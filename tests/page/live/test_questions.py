"""Questions whose answer is a length: what a page finds of a turn is what closed formulas say."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from support import gallery
from support.scripts import run

from graphic_tmm.board.script_rows import RowScript
from graphic_tmm.page.dense import dense
from graphic_tmm.page.live.givens import live_log
from graphic_tmm.page.practice.pack import written_module

PROGRAM = """
import "./practice/written.js";
import { LiveRun } from "./live/run.js";
import { askedOf, isRight, Trials } from "./live/questions.js";
const { data, whole, tried } = asked;
const run = new LiveRun(data, whole);
run.kept = data.breaks.map(([slot]) => slot);
const there = (mark) => (typeof mark === "number" ? Number.isFinite(mark) : Object.values(mark).every(there));
const stops = (mark) => mark !== undefined && !there(mark);
const broken = (k) => data.breaks.find(([slot]) => stops(run.few(k)[slot]))?.[1] ?? "";
const trials = new Trials(run, data.out, broken);
const with_ = (letter, value) => {
  trials.give(data.sliders.find((one) => one.l === letter), value);
  return trials.turns() ? trials.now() : null;
};
const done = tried.map(([letter, value]) => with_(letter, value));
const questions = askedOf(trials, data.sliders).map(({ kind, slider, target }) => {
  const judged = (value) => {
    trials.give(slider, value);
    return isRight({ kind, slider, target }, value, trials.turns(), trials.turns() ? trials.now() : null);
  };
  const bound = kind === "most" || kind === "least";
  const answers = bound ? [target] : [1.2 * slider.v, 0.8 * slider.v];
  const beyond = bound ? target * (kind === "most" ? 1.002 : 0.998) : slider.v;
  return { kind, letter: slider.l, target, right: answers.map(judged), wrong: [slider.v, beyond].map(judged) };
});
tell({ done, questions });
"""
PEAK = 5e-4
"""K_v is off by so much at most: a parabola through three whole degrees is off by h²/6 of its end, h = π/180,
5e-5 rad of π, and K_v four times that share."""


def asked_of(name: str, *tried: tuple[str, float]) -> dict[str, Any]:
    """Return what a page finds with some lengths tried, and the questions that it asks."""
    found = dense(gallery.drawn(name))
    assert found is not None
    script = RowScript()
    data, logs = live_log(found, {step.it.slot for step in found.log.steps}, (), script, "en")
    asked = {"data": data, "whole": found.whole, "tried": tried}
    told: dict[str, Any] = run(PROGRAM, asked, written=written_module(script, {}, logs))
    return told


def rocker(a: float, b: float, c: float, d: float) -> tuple[float, float]:
    """Return swing (degrees) and K_v of a crank a, rod b, rocker c on a frame d: crank and rod in one line."""

    def apex(rod: float) -> tuple[float, float]:
        at_crank = np.arccos((rod**2 + d**2 - c**2) / (2 * rod * d))
        return np.degrees(at_crank), np.degrees(np.arccos((c**2 + d**2 - rod**2) / (2 * c * d)))

    (far, swung), (near, back) = apex(b + a), apex(b - a)
    theta = abs(far - near)
    return abs(swung - back), (180 + theta) / (180 - theta)


def slider(a: float, b: float, e: float) -> tuple[float, float]:
    """Return travel and K_v of a crank a, rod b and slider off the pivot by e."""
    theta = np.degrees(np.arcsin(e / (b - a)) - np.arcsin(e / (b + a)))
    travel = np.sqrt((b + a) ** 2 - e**2) - np.sqrt((b - a) ** 2 - e**2)
    return travel, (180 + theta) / (180 - theta)


def test_a_rocker_swings_as_the_triangle_says() -> None:
    a, b, c, d = 0.02, 0.06, 0.045, float(np.hypot(0.06, 0.01))
    tried = [("l_{OA}", a * by) for by in (0.7, 1.0, 1.3)]
    for (_, crank), done in zip(tried, asked_of("crank-rocker", *tried)["done"], strict=True):
        swing, ratio = rocker(crank, b, c, d)
        assert done["travel"] == pytest.approx(swing, abs=1e-5)
        assert done["ratio"] == pytest.approx(ratio, abs=PEAK)


def test_a_slider_travels_as_the_triangle_says_and_turns_up_to_its_bound() -> None:
    tried = [("l_{AB}", value) for value in (0.0625, 0.0635, 0.18, 0.3)]
    told = asked_of("offset-slider", *tried)
    assert told["done"][0] is None
    for (_, b), done in zip(tried[1:], told["done"][1:], strict=True):
        travel, ratio = slider(0.045, b, 0.018)
        if b > 0.1:
            assert done["ratio"] == pytest.approx(ratio, abs=PEAK)
        assert done["travel"] == pytest.approx(travel, rel=1e-3)
    (bound,) = (one for one in told["questions"] if one["kind"] == "least")
    assert bound["letter"] == "l_{AB}"
    assert bound["target"] == pytest.approx(0.045 + 0.018, rel=1e-5)


@pytest.mark.parametrize(
    "scene", ["crank-rocker", "offset-slider", "oscillating-cylinder", "shaper", "four-stroke"]
)
def test_what_is_asked_has_an_answer_that_is_not_what_is_given(scene: str) -> None:
    questions = asked_of(scene)["questions"]
    assert 2 <= len(questions) <= 3
    assert len({one["letter"] for one in questions}) >= 2
    for one in questions:
        assert any(one["right"])
        assert not any(one["wrong"])


def test_what_turns_round_with_its_lengths_only_is_asked_nothing() -> None:
    assert asked_of("parallel-cranks")["questions"] == []
