"""Force sheets of strangers are read position by position, equations stand with their group: by names alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations
from pathlib import Path

import pytest
from support.gallery import CASES
from support.mechanisms import sample
from support.order import Part, forward, kept_apart, parts_of
from support.rewritten import text_of

from graphic_tmm.fitting.formats import room_on
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.packing import bounds
from graphic_tmm.scene.read import read
from graphic_tmm.studio import composed_sheets

TAIL = """
[effects]
gravity = true
inertia = true
[forces]
positions = [1, 3, 6]
[[sheet]]
format = "{format}"
place = ["force table", "forces", "lever"]
"""
FORMATS = ("A1", "A2", "A1 portrait")


def strangers(count: int) -> Iterator[str]:
    """Yield scenes with forces in three positions: random mechanisms of one to three groups, on all formats."""
    for k, one in enumerate(sample(count, seed=41, dyads=(1, 3))):
        yield text_of(one.mechanism, one.phi, 8, TAIL.format(format=FORMATS[k % len(FORMATS)]))
    for name in ("hydraulic", "upright"):
        yield (CASES / "sheets" / f"{name}.toml").read_text(encoding="utf-8")


def force_parts(text: str, file: Path) -> tuple[list[Part], tuple[Sheet, ...], list[str]]:
    """Return what stands on the force sheets of a scene in the order in which it should be read."""
    file.write_text(text, encoding="utf-8")
    made, found = composed_sheets(read(file))
    assert made.mechanism is not None
    papers = found.sheets
    boxes = [{view.name: bounds(view) for view in sheet.drawings[1:]} for sheet in papers]
    feet = {view.name: view.foot for sheet in papers for view in sheet.drawings[1:]}
    return parts_of(boxes, made.mechanism.names, feet), papers, [sheet.format for sheet in papers]


@pytest.mark.slow
def test_force_sheets_are_read_in_order_and_equations_stand_with_their_group(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    wrong, pairs, apart, groups = list[str](), 0, list[str](), 0
    for k, text in enumerate(strangers(many(60, 12))):
        parts, _, formats = force_parts(text, tmp_path / f"{k}.toml")
        for one, other in combinations(parts, 2):
            pairs += 1
            if one.unit != other.unit or one.sheet == other.sheet:
                wrong += [] if forward(one, other) else [f"{k}: {other.name} before {one.name}"]
        rooms = [room_on(one, "en", n == 0).within.sizes for n, one in enumerate(formats)]
        groups += len({part.unit for part in parts})
        apart += [f"{k}: {name}" for name in kept_apart(parts, rooms)]
    assert pairs > 1000
    assert groups > 60
    assert wrong == []
    assert apart == []


@pytest.mark.slow
def test_tables_come_after_all_groups(tmp_path: Path) -> None:
    for k, text in enumerate(strangers(4)):
        parts, papers, _ = force_parts(text, tmp_path / f"{k}.toml")
        for n, sheet in enumerate(papers):
            tables = [view for view in sheet.drawings[1:] if view.name == "table-forces"]
            for view in tables:
                table = Part("", view.name, n, bounds(view))
                assert all(forward(part, table) for part in parts if part.sheet == n)


def test_the_judge_sees_what_is_out_of_order_and_apart() -> None:
    boxes = [
        {
            "group-4-5-1": (100.0, 300.0, 200.0, 400.0),
            "forces-4-5-1": (20.0, 300.0, 90.0, 400.0),
            "lever-1": (20.0, 100.0, 90.0, 200.0),
        },
        {
            "equations-4-5-1": (20.0, 300.0, 90.0, 400.0),
            "group-1-1": (20.0, 100.0, 90.0, 200.0),
            "equations-lever-1": (100.0, 10.0, 190.0, 410.0),
        },
    ]
    parts = parts_of(boxes, ["0", "1"])
    assert [part.name for part in parts] == [
        *("group-4-5-1", "forces-4-5-1", "equations-4-5-1", "group-1-1"),
        *("lever-1", "equations-lever-1"),
    ]
    wrong = [(one.name, two.name) for one, two in combinations(parts, 2) if not forward(one, two)]
    assert wrong == [
        ("group-4-5-1", "forces-4-5-1"),
        ("equations-4-5-1", "lever-1"),
        ("group-1-1", "lever-1"),
    ]
    assert kept_apart(parts, [[(580.0, 406.0)]] * 2) == ["equations-4-5-1", "equations-lever-1"]
    assert kept_apart(parts, [[(116.0, 406.0), (300.0, 20.0)]] * 2) == ["equations-4-5-1"]
