"""A dwell found from a task: its arc against a search of centres; what is refused has none there."""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np
import pytest
from support.examples import most

from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.synthesis import lengths_found, synthesis_log
from graphic_tmm.mechanism.synthesis_dwell import best_arc, one_bend, point_of, range_of

CASES = most(24)
FINE = 400


def path(task: dict[str, Any], turns: np.ndarray) -> np.ndarray:
    """Where M is, O at 0 and C at OC: by the angles of the loop, not by its diagonal."""
    a, b, c, d = (task[name] for name in ("OA", "AB", "BC", "OC"))
    found = []
    for phi in np.radians(turns):
        pin = cmath.rect(a, phi)
        to_pivot = cmath.phase(d - pin)
        far = abs(d - pin)
        at_pin = math.acos((b * b + far * far - c * c) / (2.0 * b * far))
        found.append(pin + task["M"] * cmath.exp(1j * (to_pivot + at_pin)))
    return np.array(found)


def searched(spots: np.ndarray) -> float:
    """How far points leave the circle that they leave least: centres tried on finer and finer grids."""
    size = np.abs(spots - spots.mean()).max()
    best = math.inf
    row = np.linspace(-1.0, 1.0, 13)
    # far centres too: along the ways square to the chord, by the power of ten
    way = 1j * (spots[-1] - spots[0]) / abs(spots[-1] - spots[0])
    starts = [
        spots.mean() + way * sign * size * 10**far for sign in (1, -1) for far in (-0.5, 0, 0.5, 1)
    ]
    for start in starts:
        at, reach = start, abs(start - spots.mean())
        for _ in range(60):
            tried = (at + reach * (row[:, None] + 1j * row[None, :])).ravel()
            away = np.abs(tried[:, None] - spots[None, :])
            widths = (away.max(axis=1) - away.min(axis=1)) / 2.0
            k = int(np.argmin(widths))
            at, reach = tried[k], reach * (0.7 if abs(tried[k] - at) < 0.9 * reach else 1.0)
            best = min(best, float(widths[k]))
    return best


def random_task(rng: np.random.Generator) -> dict[str, Any]:
    sizes = rng.uniform(0.06, 0.16, 3)
    start = float(rng.uniform(0, 360))
    return {
        "OA": float(rng.uniform(0.02, 0.05)), "AB": float(sizes[0]), "BC": float(sizes[1]),
        "OC": float(sizes[2]), "M": complex(rng.uniform(-0.05, 0.2), rng.uniform(-0.12, 0.12)),
        "dwell": (start, start + float(rng.uniform(30, 140))), "tolerance": 1.0,
        "E": complex(*rng.uniform(-0.3, 0.3, 2)),
    }  # fmt: skip


def tasks(seed: int, count: int) -> list[dict[str, Any]]:
    """Tasks whose path is one bend while the crank turns."""
    rng, found = np.random.default_rng(seed), list[dict[str, Any]]()
    while len(found) < count:
        task = random_task(rng)
        try:
            lengths_found("dwell", task)
        except StructureError:
            continue
        found.append(task)
    return found


def test_the_arc_is_the_one_that_a_search_of_centres_finds() -> None:
    for task in tasks(1, CASES):
        arc = best_arc(point_of(task), *range_of(task))
        start, sweep = range_of(task)
        spots = path(task, start + sweep * np.linspace(0.0, 1.0, FINE))
        away = np.abs(spots - arc.centre)
        assert np.abs(away - arc.radius).max() == pytest.approx(arc.off, rel=1e-3, abs=1e-12)
        due = searched(spots)
        assert arc.off <= due * (1.0 + 1e-3)
        assert due <= arc.off * 1.05  # the search comes near, so it would find a better one


def test_the_lengths_are_those_of_that_arc() -> None:
    for task in tasks(2, CASES):
        log = synthesis_log("dwell", task)
        lengths = log.values()
        start, sweep = range_of(task)
        spots = path(task, start + sweep * np.linspace(0.0, 1.0, FINE))
        # D is somewhere at DE from E, and at MD from M all the time, but for how far the path leaves the arc
        arc = best_arc(point_of(task), start, sweep)
        assert lengths["MD"] == pytest.approx(arc.radius, rel=1e-9)
        assert lengths["DE"] == pytest.approx(abs(arc.centre - task["E"]), rel=1e-7)
        assert np.abs(np.abs(spots - arc.centre) - lengths["MD"]).max() <= arc.off * 1.001 + 1e-12


def test_a_tolerance_is_kept_or_refused_with_what_does() -> None:
    for task in tasks(3, max(4, CASES // 4)):
        start, sweep = range_of(task)
        due = searched(path(task, start + sweep * np.linspace(0.0, 1.0, FINE)))
        assert lengths_found("dwell", {**task, "tolerance": due * 1.001})
        with pytest.raises(StructureError, match="every arc leaves the path") as error:
            lengths_found("dwell", {**task, "tolerance": due * 0.8})
        assert error.value.keys == ("task.tolerance",)
        words = str(error.value).split()
        least = float(words[words.index("mm") - 1]) / 1000.0
        assert lengths_found("dwell", {**task, "tolerance": least})
        low, high = (float(words[words.index(k) + 1].rstrip("°")) for k in ("from", "to"))
        if high > low:
            shorter = {**task, "tolerance": due * 0.8, "dwell": (low, high)}
            assert lengths_found("dwell", shorter)
            wider = (high - low) * 0.02 + 0.2
            shorter["dwell"] = (low - wider, high + wider)
            with pytest.raises(StructureError, match="every arc leaves the path"):
                lengths_found("dwell", shorter)


BASE: dict[str, Any] = {
    "OA": 0.05, "AB": 0.12, "BC": 0.12, "OC": 0.14, "M": 0.1 + 0.09j, "dwell": (120.0, 200.0),
    "tolerance": 0.001, "E": 0.2 + 0.2j,
}  # fmt: skip


@pytest.mark.parametrize(
    ("change", "key", "words"),
    [
        ({"OA": 0.13}, "OA", "only while OA is less than 100 mm"),
        ({"OC": 0.3}, "OA", "does not turn all round; take other"),
        ({"M": 0.12 + 0j}, "M", "take M beside A and B"),
        ({"M": 0j}, "M", "take M beside A and B"),
        ({"dwell": (90.0, 90.0)}, "dwell", "no length"),
        ({"dwell": (90.0,)}, "dwell", "2 values are wanted here, not 1"),
        ({"dwell": (0.0, 300.0)}, "dwell", "bends both ways"),
    ],
)
def test_what_has_no_dwell_is_refused(change: dict[str, Any], key: str, words: str) -> None:
    with pytest.raises(StructureError, match=words) as error:
        lengths_found("dwell", {**BASE, **change})
    assert error.value.keys == (f"task.{key}",)


def test_a_pivot_in_the_centre_of_the_arc_is_refused() -> None:
    arc = best_arc(point_of(BASE), *range_of(BASE))
    with pytest.raises(StructureError, match="DE has no length"):
        lengths_found("dwell", {**BASE, "E": arc.centre})


def test_a_range_may_go_over_zero() -> None:
    task = next(one for one in tasks(5, 40) if one["dwell"][0] < 360.0 < one["dwell"][1] - 1.0)
    start, end = task["dwell"]
    due = lengths_found("dwell", task)
    for ends in ((start, end - 360.0), (start - 360.0, end - 360.0)):
        assert lengths_found("dwell", {**task, "dwell": ends}) == pytest.approx(due, rel=1e-9)


def test_a_bend_is_one_where_no_line_crosses_it_three_times() -> None:
    rng, both = np.random.default_rng(4), set[bool]()
    for _ in range(CASES):
        task = random_task(rng)
        task |= {"AB": 0.12, "BC": 0.12, "OC": 0.14, "OA": 0.04}
        start, sweep = range_of(task)
        spots = path(task, start + sweep * np.linspace(0.0, 1.0, FINE))
        most_crossings = 0
        for _ in range(300):
            first, other = rng.choice(spots, 2, replace=False)
            side = np.sign(((spots - first) * np.conj(other - first)).imag)
            side = side[np.abs(side) > 0]
            most_crossings = max(most_crossings, int((np.diff(side) != 0).sum()))
        if one_bend(point_of(task), start, sweep):
            assert most_crossings <= 2
        both.add(one_bend(point_of(task), start, sweep))
    assert both == {True, False} or CASES < 20
