"""Quantiles of figures that come in blocks are those of all of them at once, to the last bit."""

from __future__ import annotations

import json
import statistics
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.columns import along
from support.gallery import made

from graphic_tmm import studio
from graphic_tmm.board import hand as hands
from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import DrawnScene, hand_of, single
from graphic_tmm.readers import spread as spreads
from graphic_tmm.readers import table as tables
from graphic_tmm.readers.columns import Column, empty
from graphic_tmm.readers.spread import QUANTILES, Quantiles, Spread
from graphic_tmm.readers.table import scene_columns, scene_results, table

SHARES = (0.5, 0.05, 0.95)


def at_once(figures: Reals) -> Reals:
    """The quantiles of each row, by numpy; what is not finite is left out."""
    found = np.full((len(SHARES), len(figures)), np.nan)
    for row, values in enumerate(figures):
        there = values[np.isfinite(values)]
        if there.size:
            found[:, row] = np.quantile(there, SHARES)
    return found


def in_blocks(figures: Reals, block: int, sure: float = 6.0) -> Quantiles:
    """The same figures, a block after the other."""
    found = Quantiles(SHARES, figures.shape[1], sure)
    for start in range(0, figures.shape[1], block):
        found.add(figures[:, start : start + block])
    return found


@st.composite
def rows(draw: st.DrawFn) -> Reals:
    """Rows of figures: fine or in divisions, some of them missing, one missing altogether."""
    rng = np.random.default_rng(draw(st.integers(0, 10**6)))
    shape = draw(st.integers(1, 5)), draw(st.integers(1, 400))
    found = rng.standard_normal(shape) * draw(st.sampled_from([1e-12, 1.0, 1e9]))
    if draw(st.booleans()):
        found = np.round(found * 2.0) / 2.0
    found[rng.random(shape) < draw(st.sampled_from([0.0, 0.02, 0.5, 0.98]))] = np.nan
    found[rng.random(shape) < draw(st.sampled_from([0.0, 0.1]))] = -np.inf
    found[0, draw(st.integers(0, 400)) :] = 3.25
    if draw(st.booleans()):
        found[-1] = np.nan
    return found


@settings(deadline=None)
@given(rows(), st.integers(1, 150), st.sampled_from([6.0, 0.5, 1e12]))
def test_they_are_those_of_all_figures_or_known_to_be_missed(
    figures: Reals, block: int, sure: float
) -> None:
    found = in_blocks(figures, block, sure)
    if found.missed:
        assert sure < 1e12
        due = at_once(figures)
        there = np.isfinite(found.result())
        np.testing.assert_array_equal(found.result()[there], due[there])
    else:
        np.testing.assert_array_equal(found.result(), at_once(figures))


@pytest.mark.parametrize("division", [None, 0.25])
def test_what_is_kept_grows_with_the_root_of_the_figures(division: float | None) -> None:
    rng = np.random.default_rng(4)
    most = []
    for count in (4000, 64000):
        figures = rng.standard_normal((4, count))
        figures = figures if division is None else np.round(figures / division) * division
        found, kept = Quantiles(SHARES, count), 0
        for start in range(0, count, 1000):
            found.add(figures[:, start : start + 1000])
            kept = max(kept, found.kept)
        assert not found.missed
        np.testing.assert_array_equal(found.result(), at_once(figures))
        most.append(kept / len(figures))
    assert most[1] < 5 * most[0]  # 16 times as many figures: 4 times the root
    assert most[1] < 64000 / 20


def test_figures_that_come_sorted_are_missed_and_found_when_all_are_kept() -> None:
    figures = np.sort(np.random.default_rng(2).standard_normal((2, 5000)), axis=1)
    assert in_blocks(figures, 500).missed
    all_kept = in_blocks(figures, 500, sure=1e12)
    assert not all_kept.missed
    np.testing.assert_array_equal(all_kept.result(), at_once(figures))


SCENES = [
    ("windrower", "student", 1),
    ("windrower", "careful", 7),
    ("crank-press", "student", 2),
    ("engine", "careful", 3),
    ("cam", "student", 4),
    ("gear-pair", "student", 5),
    ("planetary", "careful", 6),
    ("oscillating-cylinder", "student", 8),
]
Told = dict[tuple[int, str, str], list[float | None]]
"""Rows by the place of their column, its segment, and whether they are mm or values."""


def by_hand(name: str, hand: str, seed: int) -> DrawnScene:
    """A scene of the package that a hand draws."""
    scene = made(name)
    return scene._replace(scene=replace(scene.scene, hand=hand, seed=seed))


def quantile(figures: list[float], share: float) -> float | None:
    """A quantile of figures, between two of them by their distances."""
    found = sorted(figures)
    place = share * (len(found) - 1)
    low = int(place)
    if not found:
        return None
    high = min(low + 1, len(found) - 1)
    return found[low] + (found[high] - found[low]) * (place - low)


def one_by_one(scene: DrawnScene, trials: int) -> tuple[Told, dict[str, float]]:
    """The quantiles of columns (mm and value) and of results, from a table a trial."""
    rows: dict[tuple[int, str, str], list[list[float | None]]] = {}
    results: dict[str, list[float]] = {}
    order: dict[int, list[str]] = {}
    for drawn in studio.drawings(scene, hand_of(scene.scene, trials)):
        for k, column in enumerate(scene_columns(drawn)):
            heads = [name for name, _ in column.at]
            for key, row in zip(("mm", "value"), column.first_figures, strict=True):
                if heads:  # a list may stand in another order in another drawing
                    first = order.setdefault(k, heads)
                    row = [row[heads.index(head)] for head in first]
                rows.setdefault((k, column.segment, key), []).append(row)
        for name, (figure, _) in single(scene_results(drawn)).items():
            results.setdefault(name, []).append(figure)
    told: Told = {}
    for (k, segment, key), each in rows.items():
        for name, share in QUANTILES.items():
            told[k, f"{segment}_{name}", key] = [
                quantile([x for x in place if x is not None], share)
                for place in zip(*each, strict=True)
            ]
    known = {name: [x for x in figures if np.isfinite(x)] for name, figures in results.items()}
    return told, {
        f"{name}_{key}": found
        for name, figures in known.items()
        for key, share in QUANTILES.items()
        if (found := quantile(figures, share)) is not None
    }


def as_told(document: Mapping[str, Any]) -> Told:
    """The figures of a table in JSON, those of many drawings."""
    return {
        (k // (1 + len(QUANTILES)), one["segment"], key): one[key]
        for k, one in enumerate(document["columns"])
        if one["segment"].rpartition("_")[2] in QUANTILES
        for key in ("mm", "value")
    }


@pytest.mark.turns(2)
@pytest.mark.parametrize(("name", "hand", "seed"), SCENES)
@pytest.mark.slow
def test_a_table_of_trials_is_what_a_table_a_trial_comes_to(
    monkeypatch: pytest.MonkeyPatch, name: str, hand: str, seed: int
) -> None:
    """Drawn in five blocks, of which the last is not full."""
    for room in (hands, studio):
        monkeypatch.setattr(room, "MOST", 16)
    scene, trials = by_hand(name, hand, seed), 70
    text = table(scene, "json", trials)
    assert isinstance(text, str)
    document = json.loads(text)
    told, results = one_by_one(scene, trials)
    found = as_told(document)
    assert found.keys() == told.keys()
    for key, row in found.items():
        figures, due = (np.array(one, dtype=np.float64) for one in (row, told[key]))
        np.testing.assert_allclose(figures, due, rtol=1e-11, atol=1e-15)
    facts = {key: one["value"] for key, one in document["results"].items() if isinstance(one, dict)}
    spread = {key: x for key, x in facts.items() if key.rpartition("_")[2] in QUANTILES}
    assert spread == pytest.approx(results, rel=1e-11)
    # and they scatter
    low, high = (
        [row for key, row in found.items() if key[1].endswith(end)] for end in ("_p5", "_p95")
    )
    assert low != high


@pytest.mark.slow
def test_a_spread_that_misses_a_quantile_is_drawn_once_more(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Here next to nothing is kept at first; what is told is the same."""
    for room in (hands, studio):
        monkeypatch.setattr(room, "MOST", 16)
    scene = by_hand("crank-rocker", "student", 1)
    due = table(scene, "json", 600)
    drawn: list[float] = []

    class Noted(Spread):
        def __init__(self, *given: Any) -> None:
            drawn.append(given[-1])
            super().__init__(*given)

    monkeypatch.setattr(tables, "Spread", Noted)
    monkeypatch.setattr(tables, "ATTEMPTS", (0.0, spreads.ATTEMPTS[-1]))
    monkeypatch.setattr("graphic_tmm.readers.spread.SLACK", 0)
    assert table(scene, "json", 600) == due
    assert drawn == [0.0, spreads.ATTEMPTS[-1]]


def test_quantiles_of_a_table_leave_out_the_trials_that_failed() -> None:
    """Every seventh trial lacks its second position, all lack the third; a result may not be there at all."""
    rows = np.random.default_rng(8).standard_normal((50, 3))
    bad = np.arange(50) % 7 == 3
    base = Column("velocities", "pb", "pb", "m/s", empty(3), along(0.0, 0.0, None))
    trials = np.where(bad[:, None] & [False, True, False], np.nan, rows)
    trials[:, 2] = np.nan
    one, figures = {"J": (np.ones(1), "kg")}, np.where(bad, np.nan, rows[:, 0])
    figures[:2] = np.nan, np.inf
    spread = Spread([base], one, 50)
    for part in (slice(0, 20), slice(20, 50)):
        some = {"J": (figures[part], "kg")}
        spread.add([replace(base, value=trials[part])], some, len(trials[part]))
    found = {c.segment: c for c in spread.columns()}
    for name, share in QUANTILES.items():
        due = [np.quantile(rows[:, 0], share), np.quantile(rows[~bad, 1], share)]
        assert found[f"pb_{name}"].first_figures == ([None] * 3, [*due, None])
    assert spread.results()["J_median"] == (statistics.median(rows[2:][~bad[2:], 0]), "kg")
    nothing = Spread([base], one, 50)
    nothing.add([base], {}, 50)
    assert nothing.results() == one


def test_what_is_alike_in_some_blocks_counts_as_often_as_it_was_drawn() -> None:
    base = Column("velocities", "pb", "pb", "m/s", along(1.0, 2.0), along(5.0, 6.0))
    rows = np.random.default_rng(9).standard_normal((3, 2))
    parts = [(4, base.value), (3, base.value), (3, rows), (2, base.value)]
    spread = Spread([base], {}, 12)
    for trials, value in parts:
        spread.add([replace(base, value=value)], {}, trials)
    every = np.concatenate([np.broadcast_to(value, (n, 2)) for n, value in parts])
    told, median, *_ = spread.columns()
    assert told is base
    np.testing.assert_array_equal(median.value, np.median(every, axis=0)[None])
    np.testing.assert_array_equal(median.mm, base.mm)
