"""Drawn variants are good by loops written without the package, and bad ones by these are refused."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from support.command import tabled
from support.each import each
from support.gallery import SHEETS
from support.turning_loops import LOOPS, Turn

from graphic_tmm.board.hand import EXACT
from graphic_tmm.classroom.variants import drawing
from graphic_tmm.classroom.variants.drawing import (
    DrawnVariants,
    Measure,
    draw_variants,
    measure_of,
    refused,
)
from graphic_tmm.classroom.variants.ranges import Good, Range, Ranges, read_ranges
from graphic_tmm.classroom.variants.variant import (
    Base,
    Value,
    Variant,
    base,
    scene_of,
    source_of,
    text_of,
)
from graphic_tmm.errors import SheetError
from graphic_tmm.paper.lettering.letters import missing
from graphic_tmm.studio import composed_sheets

CALCULATED = re.compile(r".*[nk]\d*|[ωε].*|(?:omega|epsilon).*")
"""The segments of plans that are laid off, not measured: they end at an n or a k; and rates."""


@cache
def scene(name: str) -> Base:
    return base(SHEETS / name)


@cache
def ranges(name: str) -> Ranges:
    return read_ranges(SHEETS / name / "ranges.toml", scene(name))


@cache
def measure(name: str) -> Measure:
    return measure_of(scene(name), ranges(name).good, missing)


@pytest.fixture
def measured_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """What variants of a scene are judged by is the same however often they are drawn."""
    monkeypatch.setattr(drawing, "measure_of", lambda of, *given: measure(of.file.parent.name))


def loop(name: str, variant: Variant) -> Turn:
    numbers = {one.key: float(one.typed) for one in variant.values}
    return LOOPS[name](numbers)


def wide(name: str, random_: random.Random) -> Variant:
    """Return a variant of lengths from a fifth of what the ranges begin with to thrice their end."""
    values = []
    for one in ranges(name).ranges:
        low, high = float(one.values[0]), float(one.values[-1])
        if one.unit == "mm":
            values.append(Value(one.key, f"{random_.uniform(low / 5, 3 * high):.0f}", "mm"))
    return Variant("1", tuple(values))


def all_good(name: str, found: DrawnVariants, count: int) -> None:
    assert len({one.values for one in found.variants}) == len(found.variants) == count
    assert sum(found.refusals.values()) + count == found.tried
    for one in found.variants:
        turn = loop(name, one)
        assert turn.whole
        assert turn.least >= ranges(name).good.transmission - 1e-6


@pytest.mark.slow
@each("name", LOOPS, turns=2)
def test_what_the_loops_call_bad_is_refused_for_that(name: str) -> None:
    random_, seen = random.Random(2), set[str]()
    for _ in range(12):
        one = wide(name, random_)
        turn = loop(name, one)
        if turn.whole and turn.least >= ranges(name).good.transmission - 0.01:
            continue
        says = refused(scene(name), one, measure(name))
        assert says
        assert "shorter than" not in says
        assert "half white" not in says
        seen.add(says.split(":")[0])
    assert any("turn" in says or "transmission" in says for says in seen)


@pytest.mark.slow
@each("name", LOOPS, turns=2)
def test_what_the_loops_call_good_is_never_refused_for_its_motion(name: str) -> None:
    random_, found = random.Random(4), 0
    by = measure(name)._replace(good=Good(ranges(name).good.transmission, 100.0))
    while found < 5:
        numbers = [random_.randrange(len(one.values)) for one in ranges(name).ranges]
        values = (one.at(k) for one, k in zip(ranges(name).ranges, numbers, strict=True))
        one = Variant("1", tuple(values))
        turn = loop(name, one)
        if turn.whole and turn.least >= by.good.transmission + 0.01:
            found += (
                1  # a limit of vectors that nothing keeps ends it before its sheets are searched
            )
            assert "shorter than 100 mm" in refused(scene(name), one, by)


def tables_hold(of: Base, name: str, found: Sequence[Variant], folder: Path) -> None:
    """Whatever the table of a variant tells as measured is long enough, or nothing where all is exact."""
    good = ranges(name).good
    for one in found:
        file = folder / source_of(of, one).name
        file.write_text(text_of(of, one), encoding="utf-8")
        read, exact = tabled(file), tabled(file, "--exact")
        for by_hand, due in zip(read["columns"], exact["columns"], strict=True):
            told = by_hand["plan"] in ("velocities", "accelerations")
            if not told or by_hand["segment"] in good.short:
                continue
            if CALCULATED.fullmatch(by_hand["segment"]):
                continue
            for mm, sure in zip(by_hand["mm"], due["mm"], strict=True):
                assert mm is None or mm >= good.vector or abs(sure) < 1e-3, by_hand["segment"]


@pytest.mark.slow
@pytest.mark.usefixtures("measured_once")
@each("name", [name for name in LOOPS if name != "shaper"], turns=1)
def test_variants_are_good_by_loops_and_tables(
    name: str, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    count = many(10, 1)
    found = draw_variants(scene(name), ranges(name), count, 11, missing=missing)
    all_good(name, found, count)
    tables_hold(scene(name), name, found.variants[::3], tmp_path)


@pytest.mark.slow
def test_shapers_are_good_and_stand_on_the_sheets_ordered(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    """With ``--measured`` three hundred of them."""
    count = many(300, 2)
    found = draw_variants(scene("shaper"), ranges("shaper"), count, 7, missing=missing)
    all_good("shaper", found, count)
    tables_hold(scene("shaper"), "shaper", found.variants[::10], tmp_path)
    made, sheets = composed_sheets(scene_of(scene("shaper"), found.variants[-1]))
    assert len(sheets.sheets) == len(made.scene.sheets)


@pytest.mark.slow
def test_ranges_that_hold_too_few_are_refused_with_the_reasons() -> None:
    long = Ranges((Range("OA", ("330", "340", "350"), "mm"), Range("CD", ("180",), "mm")), Good())
    with pytest.raises(SheetError, match=r"hold 3 variants, 4 are wanted"):
        draw_variants(scene("shaper"), long, 4, 1)
    with pytest.raises(SheetError, match=r"of 3 tried 0 were good; refused: .*no side"):
        draw_variants(scene("shaper"), long, 3, 1)


def test_values_are_rounded_as_a_task_is() -> None:
    steps = {one.key: one.values for one in ranges("shaper").ranges}
    assert steps["OA"] == ("100", "105", "110", "115", "120", "125", "130")
    assert all(np.diff([int(v) for v in steps["OB"]]) == 5)


def test_a_wish_that_nothing_meets_is_soon_told_and_one_that_a_tenth_meets_is_met(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Judged by a fair die instead of a drawing: which reason, and how many were tried."""
    die = random.Random(5)
    monkeypatch.setattr(drawing, "measure_of", lambda *given: None)
    monkeypatch.setattr(drawing, "refused", lambda *given: "too steep")
    with pytest.raises(
        SheetError, match=r"of (\d+) tried 0 were good; refused: \1 too steep"
    ) as told:
        draw_variants(scene("shaper"), ranges("shaper"), 1, 1)
    assert 100 <= int(str(told.value).partition(" tried")[0].split()[-1]) <= 250
    monkeypatch.setattr(drawing, "refused", lambda *given: "" if die.random() < 0.1 else "bad")
    found = draw_variants(scene("shaper"), ranges("shaper"), 30, 1)
    assert len(found.variants) == 30
    assert 100 < found.tried < 900


class Row(NamedTuple):
    segment: str
    mm: np.ndarray


class Plans:
    """A drawing: rows of mm as its own hand reads them, and as they are drawn exactly."""

    def __init__(self, read: list[float], exact: list[float]) -> None:
        self.read, self.exact = read, exact

    def drawn_by(self, hand: object) -> Plans:
        assert hand is EXACT
        return Plans(self.exact, self.exact)


@pytest.mark.parametrize(
    ("read", "exact", "short"),
    [
        ([40.0, 3.5], [40.1, 3.4], False),
        ([40.0, 2.5], [40.1, 2.4], True),
        ([40.0, 0.0], [40.1, 0.0], False),  # at its dead centre a ram stands still
        ([40.0, 0.0], [40.1, 0.3], True),  # the ruler reads nothing of what is there
        ([40.0, 0.5], [40.1, 2e-4], False),
        ([3.0, 9.0], [2.9, 9.0], False),  # the ruler says 3
    ],
)
def test_a_vector_is_short_if_it_is_something_and_less_than_the_limit(
    read: list[float], exact: list[float], short: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(drawing, "_vectors", lambda plans: [Row("pb", np.array([plans.read]))])
    assert bool(list(drawing.shortest(Plans(read, exact), 3.0))) is short  # type: ignore[arg-type]
