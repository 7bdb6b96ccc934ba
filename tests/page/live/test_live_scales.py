"""A page chooses scale factors anew as Python does for a scene that has those lengths; quantities stay."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support import gallery
from support.boards import in_usual_size
from support.once import read_once
from support.other_lengths import drawn_alike, other
from support.scripts import run

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.scales import common
from graphic_tmm.board.script_rows import RowScript
from graphic_tmm.board.values import Length, Number
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.page.dense import dense
from graphic_tmm.page.live.log import LiveLog
from graphic_tmm.page.live.scales import free_scales, scales_data
from graphic_tmm.page.practice.pack import written_module
from graphic_tmm.scene.records import Scene

SHARES = (0.1, -0.3, 0.4)
"""So much longer or shorter links are than a scene has them, at most."""
NEAR = 1e-9
RIGID = ("parallel-cranks", "rolling-centrodes")
"""Scenes whose links have no other lengths: a link that doubles others would lock the mechanism."""

PROGRAM = """
import "./practice/written.js";
import { LiveRun } from "./live/run.js";
import { chosenScales } from "./live/rescale.js";
const live = new LiveRun(asked.data, asked.whole);
const kept = new Set(asked.kept);
const told = () => asked.values.map(([slot, scale]) => {
  const value = live.marks(asked.positions[0])[slot];
  const mm = typeof value === "number" ? value : Math.hypot(value.re, value.im);
  const worth = mm * (scale < 0 ? 1 : live.marks(asked.positions[0])[scale]);
  return Number.isFinite(worth) ? worth : null;
});
tell(asked.cases.map((changed) => {
  live.give(new Map(changed));
  const before = told();
  const scales = chosenScales(asked.scales, (k) => live.marks(k), asked.positions, kept);
  live.give(new Map([...scales, ...changed]));
  const again = chosenScales(asked.scales, (k) => live.marks(k), asked.positions, kept);
  return { scales: [...scales], again: [...again], before, after: told() };
}));
"""


def _plain(drawn: Drawn, mark: Mark) -> float | None:
    value = np.asarray(drawn.given.get(mark, np.nan))
    own = mark.kind is Number and mark.unit and value.size == 1 and np.isfinite(value)
    return float(value.item()) if own else None


def _quantity(step: Step) -> bool:
    """Whether a step reads a length of its own view, or leaves a quantity that is none of the board."""
    here = {mark.view for mark in step.uses} == {step.it.view}
    number = step.it.kind is Number and step.it.unit and "mm" not in step.it.unit
    return bool(number or (step.it.kind is Length and step.op.reads and here))


def _changed(scene: Scene, own: Drawn) -> list[Drawn]:
    """Return the scene with other lengths, as far as there is such a mechanism."""
    found = []
    for share in SHARES:
        with suppress(StructureError):
            found.append(drawn_alike(other(scene, share), own))
    alike = [str(step) for step in own.construction.steps]
    return [one for one in found if [str(step) for step in one.construction.steps] == alike]


def _chosen(own: Drawn, others: list[Drawn], kept: tuple[int, ...] = ()) -> Any:
    """Return the scale factors that the page of a scene has, and what it chooses with what others are given."""
    found = dense(own)
    assert found is not None
    script = RowScript()
    log = LiveLog(found, script)
    scales = scales_data(log, free_scales(found))
    own_scale = {view.name: view.scale for view in found.log.views}
    free = {*own_scale.values(), *(one.mu for one in free_scales(found))}
    cases = [
        [[m.slot, value] for m in log.own if m not in free and (value := _plain(one, m))]
        for one in others
    ]
    chosen = {one["mu"] for one in scales["free"]}
    values = [
        [step.it.slot, mu.slot if step.op.reads else -1]
        for step in (*log.still, *log.turn)
        if (mu := own_scale.get(step.it.view)) and mu.slot in chosen and _quantity(step)
    ]
    asked = {
        "data": log.data(),
        "whole": found.whole,
        "positions": list(found.at),
        "scales": scales,
        "cases": cases,
        "values": values,
        "kept": kept,
    }
    written = written_module(script, {}, log.functions)
    by_slot = {mark.slot: mark for mark in own.construction.given}
    free_marks = [by_slot[one["mu"]] for one in scales["free"]]
    return free_marks, run(PROGRAM, asked, written=written)


def _scenes() -> list[Path]:
    """Return scenes of the package and of the cases that have a mechanism of other lengths."""
    own = [gallery.SHEETS / name / "scene.toml" for name in gallery.NAMES if name not in RIGID]
    return own + sorted(gallery.CASES.glob("sheets/*.toml"))


@pytest.mark.turns(3)
@pytest.mark.parametrize("name", [str(path.relative_to(gallery.ROOT)) for path in _scenes()])
def test_scale_factors_are_those_of_the_changed_scene(name: str) -> None:
    """All that the scene leaves free: plans, groups, polygons, levers, in the sizes of the sheet."""
    scene = read_once(gallery.ROOT / name)
    own = in_usual_size(scene, exact=True).mechanism
    if own is None or dense(own) is None:
        pytest.skip("nothing turns")
    others = [own, *_changed(scene, own)]
    free, told = _chosen(own, others)
    for drawn, case in zip(others, told, strict=True):
        found = dict(case["scales"])
        due = {mu.slot: common(drawn.given[mu]) for mu in free}
        assert found == pytest.approx(due, rel=NEAR)
        assert dict(case["again"]) == pytest.approx(found, rel=NEAR)
        before, after = (np.array(case[key], dtype=float) for key in ("before", "after"))
        np.testing.assert_allclose(after, before, rtol=NEAR, atol=1e-9)
