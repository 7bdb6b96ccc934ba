"""Plates on three legs practised: the page lays them where Python does; each task is worked in any order."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import pytest
from support.benches import Packed, numbers, worked
from support.plate_by_hand import SCENE
from support.plates import machine
from support.squares import square

from graphic_tmm.page.practice.pack import Packing
from graphic_tmm.page.practice.tasks import sheet_row
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

NEAR = 1e-9
"""So near are two ways to calculate, as a share of what is calculated; mm where it is less than that."""
TEXTS = {
    "triad": lambda: SCENE.format(language="en"),
    "a guide": lambda: machine(0, guides=1).text,
    "two guides": lambda: machine(2, guides=2).text,
    "along it": lambda: machine(5, slots=1).text,
    "along it, and a guide": lambda: machine(8, slots=1, guides=1).text,
    "two along it": lambda: machine(2, slots=2).text,
    "three guides": lambda: machine(1, guides=3).text,
    "two guides, along it": lambda: machine(1, guides=2, slots=1).text,
    "a guide, two along it": lambda: machine(0, guides=1, slots=2).text,
    "three along it": lambda: machine(2, slots=3).text,
    "a dyad before": lambda: machine(2, before=True).text,
    "a dyad behind": lambda: machine(4, behind=True).text,
    "joined plates": lambda: square(0).text,
}
TRACINGS = (
    "trace",
    "trace_on_guide",
    "trace_on_guides",
    "trace_past",
    "trace_on_guide_past",
    "trace_past_both",
    "lay_on_guides",
    "lay_on_guides_past",
    "lay_on_guide_past",
    "lay_past_all",
    "trace_joined",
)


@cache
def packed(name: str, folder: Path) -> Packed:
    path = folder / "scene.toml"
    path.write_text(TEXTS[name](), "utf-8")
    made = make(read(path), exact=True)
    row = sheet_row(made)
    assert row is not None
    packing = Packing(made, row, ())
    return Packed(name, made, packing, packing.data(()), packing.program())


@pytest.mark.parametrize("name", TEXTS)
def test_the_page_traces_plates_and_takes_them_in_any_order(name: str, tmp_path: Path) -> None:
    scene = packed(name, tmp_path)
    assert any(step.op.name in TRACINGS for step in scene.packing.steps)
    (answer,) = worked([scene], {}, tmp_path / "web", work=True)
    row, compared = scene.packing.row, 0
    one: dict[str, Any]
    for one in answer["worked"]:
        at = one["task"]["at"]
        assert not [order["faults"] for order in one["solved"] if order["faults"]]
        for step in scene.packing.steps:
            if row.there(step.it, at):
                due, found = numbers(row.reading[step.it], at), one["exact"][str(step.it.slot)]
                apart = max(abs(a - b) for a, b in zip(due, found, strict=True))
                assert apart < NEAR * max(1.0, *map(abs, due)), (step.it, at)
                compared += 1
    assert compared > 1_500
