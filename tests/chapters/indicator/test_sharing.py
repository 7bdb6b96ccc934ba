"""One indicator diagram for cylinders that share it; the judge is the same scene with diagrams of their own."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from chapters.indicator.test_plan import (
    COUNT,
    FOUR,
    SHAFT,
    STARS,
    STEPS,
    cylinders,
    drawing,
    scene,
)
from support import gallery
from support.each import each
from support.scenes import written
from support.stars import Star

import graphic_tmm
from graphic_tmm.board.values import Curve
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN, Cylinder
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.cursors import cursors
from graphic_tmm.page.dense import dense
from graphic_tmm.paper.axes import number_rows
from graphic_tmm.paper.labels import Named
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.scene.read import read

SVG = "{http://www.w3.org/2000/svg}"
SHARING = [name for name in STARS if name not in ("offset", "master rod")]
MIXED = Star((90.0, 210.0, 330.0), offsets=(0.0, 0.0, 0.01))
"""The third piston's guide passes the crank by 10 mm: its stroke is another one."""
NARROW = Star((135.0, 63.0))
"""A V of 72°: 4.8 intervals of 15°."""


def folders(parent: Path, texts: Mapping[str, str]) -> list[Drawn]:
    found = []
    for name, text in texts.items():
        (parent / name).mkdir()
        found.append(drawing(parent / name, text))
    return found


def apart(gas: str) -> str:
    """The same gas, each cylinder with pressures that are written for itself."""
    own = gas.split("[[indicator]]\n")[1].split("\n", 1)[1].replace('phase = "0 deg"\n', "")
    return gas.replace('same_as = "B"\n', own)


def views(made: Drawn) -> list[str]:
    return [chart.view for chart in INDICATOR_PLAN.on(made).charts]


def cylinders_of(made: Drawn) -> tuple[Cylinder, ...]:
    return INDICATOR_PLAN.on(made).every


@each("name", SHARING)
@each("steps, more, phases", [(STEPS, SHAFT, ()), (FOUR, "", (0, 360, 0, 360))])
@pytest.mark.slow
def test_pressures_and_forces_are_those_of_diagrams_apart(
    name: str, steps: str, more: str, phases: tuple[int, ...], tmp_path: Path
) -> None:
    star = STARS[name]
    gas = cylinders(star, steps, phases, more)
    texts = {"one": scene(star, gas), "each": scene(star, apart(gas))}
    one, each_ = folders(tmp_path, texts)
    assert views(one) == ["indicator"]
    assert views(each_) == [f"indicator {letter}" for letter in "BCDE"[: len(star.angles)]]
    for shared, own in zip(cylinders_of(one), cylinders_of(each_), strict=True):
        scales = [made.reading[x.indicator.chart.mu] for made, x in ((one, shared), (each_, own))]
        assert scales[0] == scales[1]
        pairs = [(shared.indicator.force, own.indicator.force)]
        for a, b in zip(shared.indicator.sides, own.indicator.sides, strict=True):
            pairs += [(a.pressure, b.pressure), (a.ordinate, b.ordinate), (a.points, b.points)]
        for mark, other in pairs:
            wanted = each_.reading[other]
            close = 1e-12 * np.abs(wanted).max()
            np.testing.assert_allclose(one.reading[mark], wanted, rtol=0, atol=close)


@each("name", SHARING)
@pytest.mark.slow
def test_what_is_common_is_drawn_once(name: str, tmp_path: Path) -> None:
    star = STARS[name]
    made = drawing(tmp_path, scene(star, cylinders(star, STEPS)))
    steps = [s for s in made.construction.steps if s.it.view == "indicator"]
    ops = [step.op.name for step in steps]
    count = len(star.angles)
    assert [ops.count(op) for op in ("taut_curve", "planimeter", "join", "ray")] == [1, 1, 1, 2]
    assert [ops.count(op) for op in ("parallel", "meet", "measure_along")] == [count] * 3
    (curve,) = (made.reading[s.it] for s in steps if s.it.kind is Curve)
    for one in cylinders_of(made):
        (side,) = one.indicator.sides
        row = made.reading[side.points][0]
        behind = {x.points: x.behind for x in one.indicator.chart.followers}.get(side.points, 0)
        np.testing.assert_allclose(row, np.roll(curve.knots[0], behind), atol=1e-9)


@each(
    "star, gas, wanted",
    [
        (STARS["offset"], "", ["indicator B", "indicator C"]),
        (STARS["master rod"], "", ["indicator B", "indicator C"]),
        (NARROW, "", ["indicator B", "indicator C"]),
        (MIXED, "", ["indicator B C", "indicator D"]),
        (STARS["v"], 'base = "120 mm"\n', ["indicator B", "indicator C"]),
        (STARS["v"], 'mu_p = "9 kPa/mm"\n', ["indicator B", "indicator C"]),
    ],
)
@pytest.mark.slow
def test_what_cannot_be_shared_is_drawn_apart(
    star: Star, gas: str, wanted: list[str], tmp_path: Path
) -> None:
    made = drawing(tmp_path, scene(star, cylinders(star, STEPS) + gas))
    assert views(made) == wanted


def test_same_as_gives_the_sizes_of_a_drawing_that_are_not_written(tmp_path: Path) -> None:
    sizes = 'base = "150 mm"\nheight = "70 mm"\nmu_p = "8 kPa/mm"\n'
    gas = cylinders(STARS["v"], STEPS, more=sizes)
    first, second = (
        read(written(tmp_path, scene(STARS["v"], gas))).tasks["flywheel"].indicator.every
    )
    assert (second.base, second.height, second.mu) == (first.base, first.height, first.mu)
    assert first.base == 150.0


def test_between_positions_the_force_is_that_of_diagrams_apart(tmp_path: Path) -> None:
    star, found = STARS["w"], []
    gas = cylinders(star, FOUR, (0, 360, 0))
    at = 17.0 + 720.0 * (np.arange(4 * COUNT) + 0.37) / (4 * COUNT)
    for name, text in (("one", gas), ("each", apart(gas))):
        (tmp_path / name).mkdir()
        made = read(written(tmp_path / name, scene(star, text)))
        moved = graphic_tmm.motion(made, at, plans=["forces"], exact=True)
        found.append(moved.balance["M_bal_forces"])
    np.testing.assert_allclose(found[0], found[1], rtol=1e-6, atol=1e-6)
    assert np.abs(found[0]).max() > 10.0


def test_the_sheet_shows_one_curve_and_a_row_of_positions_for_each_piston() -> None:
    tree = ET.parse(gallery.SHEETS / "v-engine" / "v-engine-2.svg")
    (view,) = (g for g in tree.iter(f"{SVG}g") if (g.get("id") or "").endswith("-indicator"))
    titles = [t.text or "" for t in view.iter(f"{SVG}title")]
    assert titles.count("(k–k)") == 1
    rows = titles[titles.index("B") : titles.index("p_(к,ср)")]
    second = rows.index("C")
    named = [
        sorted(int(n) for t in row for n in t.split(", "))
        for row in (rows[1:second], rows[second + 1 :])
    ]
    assert named == [list(range(24))] * 2


@each("seed", range(30))
@pytest.mark.slow
def test_rows_of_numbers_leave_none_out_and_never_meet(seed: int) -> None:
    rng = np.random.default_rng(seed)
    wide, count, size = rng.uniform(60, 240), int(rng.integers(6, 49)), 3.5
    names = [", ".join(map(str, range(k, k + int(rng.integers(1, 5))))) for k in range(count)]
    rows = {
        head: [
            Named(complex(x), name)
            for x, name in zip(rng.uniform(0, wide, count), names, strict=True)
        ]
        for head in "BCDE"[: int(rng.integers(2, 5))]
    }
    labels = number_rows(rows, size, -40.0)
    assert sorted(one.text for one in labels) == sorted([*rows, *names * len(rows)])
    starts = [
        one.at - (letter(one.text, size=size).width if one.anchor == "end" else 0) for one in labels
    ]
    for k, (one, at) in enumerate(zip(labels, starts, strict=True)):
        assert at.imag + size <= -40.0
        for other, there in zip(labels[:k], starts[:k], strict=True):
            clear = abs(at.imag - there.imag) >= size
            left, right = sorted(((at, one), (there, other)), key=lambda pair: pair[0].real)
            clear |= left[0].real + letter(left[1].text, size=size).width < right[0].real
            assert clear, (one, other)


@pytest.mark.slow
def test_each_piston_has_a_cursor_on_the_common_curve() -> None:
    made, sheets = gallery.paper("v-engine")
    assert made.mechanism is not None
    found = dense(made.mechanism)
    assert found is not None
    (view,) = {c.indicator.chart.view for c in cylinders_of(made.mechanism)}
    own = [c for c in cursors(found, made.mechanism, sheets) if c.letter.startswith("p_")]
    assert [one.letter for one in own] == ["p_{kB}", "p_{kC}"]
    assert len({one.curve for one in own}) == 1
    assert view == "indicator"
    ruler = made.mechanism.hand.ruler or 0.1
    for one in own:
        assert one.reading is not None
        told = (one.spots[list(found.at)] - one.origin).imag
        row = made.mechanism.reading[one.reading][0]
        # the ordinate is read to a division, and its foot was found by another reading
        assert np.abs(told[: row.size] - row).max() <= 2 * ruler
