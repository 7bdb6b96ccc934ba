"""What a page copies as TOML, read back into its scene, is what was changed."""

from __future__ import annotations

import tomllib
from copy import deepcopy
from typing import Any

import pytest
from support import gallery, strangers
from support.scripts import run

from graphic_tmm.board.script_rows import RowScript
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.dense import dense
from graphic_tmm.page.live.givens import live_log
from graphic_tmm.project import record
from graphic_tmm.scene.read import understood

PROGRAM = """
import { tomlOf } from "./live/toml.js";
const known = asked.filter((one) => one.key !== undefined);
const changed = new Map(known.map((one, k) => [one, one.v * (1 + 0.001 * (k + 1))]));
tell([tomlOf(asked, changed, "{letter}"), known.map((one) => [one.slots, one.minus ?? [], changed.get(one)])]);
"""
LEAST = {
    "accelerating-crank": {"l_OA", "ω_1", "ε_1"},
    "engine": {"l_OA", "D_c", "D_e"},
    "excavator": {"X_G", "Y_G", "m_1"},
    "locomobile": {"l_OA", "d_s", "J_S2"},
    "offset-slider": {"l_OA", "ω_1", "H_x"},
    "v-engine": {"l_OA", "ω_1", "D_e"},
}
"""Letters that are copied at least, by scene: of a list of numbers, of other sections, of a crank that turns
clockwise, beside a letter that follows from two of them."""


def _entered(doc: dict[str, Any], text: str) -> dict[str, Any]:
    """Return a document with the keys of a text in it; links are known by their numbers."""
    found = deepcopy(doc)
    for name, table in tomllib.loads(text).items():
        for one in table if isinstance(table, list) else [table]:
            own = found[name]
            if isinstance(table, list):
                own = next(link for link in own if link["number"] == one["number"])
            for key, value in one.items():
                if isinstance(value, dict) and isinstance(own.get(key), dict):
                    own[key] |= value
                else:
                    own[key] = value
    return found


def judge(drawn: Drawn, least: set[str]) -> None:
    """Hold what the scene is then against what the page has."""
    found = dense(drawn)
    assert found is not None
    data, _ = live_log(found, range(found.log.size), (), RowScript(), "en")
    assert least <= {one["n"] for one in data["sliders"] if "key" in one}
    text, changed = run(PROGRAM, data["sliders"])
    due = {slot: value for slots, _, value in changed for slot in slots}
    due |= {slot: -value for _, slots, value in changed for slot in slots}
    project = drawn.project
    other = record(understood(_entered(dict(project.scene.doc), text), "copied"))
    values = {mark.key: value for mark, value in other.given.items()}
    slots = {mark.slot: mark for mark in project.given}
    assert due
    for slot, value in due.items():
        assert values[slots[slot].key] == pytest.approx(value, rel=1e-9), slots[slot]


@pytest.mark.parametrize("scene", LEAST)
def test_copied_keys_are_those_of_the_scene(scene: str) -> None:
    judge(gallery.in_usual(scene), LEAST[scene])


@pytest.mark.parametrize("case", ["slotting", "fails-a4-diagram"])
def test_copied_keys_of_strangers_are_too(case: str) -> None:
    judge(strangers.mechanism_of(case), {"l_OA", "ω_1"})
