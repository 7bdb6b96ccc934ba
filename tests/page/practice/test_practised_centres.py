"""Practice of instantaneous centres: points are carried over, centres found in any order, by other lines."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from support.benches import Packed, by_node, packed

from graphic_tmm.page.practice.words import practice_words

SUPPORT = Path(__file__).parents[2] / "support"
SCENE = "centres-of-six-bar"


def scene() -> Packed:
    found = packed(SCENE)
    assert found is not None
    return found


def task(position: str = "9") -> int:
    """The number of the task: the scheme in a position."""
    data = scene().data
    here = (data["plans"].index("centres"), data["names"].index(position))
    return next(k for k, one in enumerate(data["tasks"]) if (one["plan"], one["at"]) == here)


def worked(steps: list[list[str]], folder: Path) -> dict[str, Any]:
    """What comes of steps, each an instrument and what it is laid to; the rest is then done in its order."""
    program = (SUPPORT / "by_other_lines.mjs").read_text("utf-8")
    told = {"words": practice_words("en"), "n": task(), "steps": steps}
    (found,) = by_node(program, [scene()], [told], folder)
    return found  # type: ignore[no-any-return]


def test_tasks_are_those_that_are_asked_for() -> None:
    data = scene().data
    plan = data["plans"].index("centres")
    assert [data["names"][one["at"]] for one in data["tasks"] if one["plan"] == plan] == ["3", "9"]


@pytest.mark.slow
def test_the_scheme_is_worked_from_the_first_step_and_from_the_last(tmp_path: Path) -> None:
    program, words = (SUPPORT / "practising.mjs").read_text("utf-8"), practice_words("en")
    (answers,) = by_node(program, [scene()], [{"words": words}], tmp_path)
    for one in (answers[task()][how] for how in ("first", "last")):
        assert one["faults"] == []
        assert one["ready"]


CARRIED = [["figure", f"*{letter}"] for letter in "ODABCE"]
BEFORE = [
    ["edge", "A", "O"],
    ["edge", "B", "D"],
    ["meeting", "(AO)", "(BD)"],  # P_20
    ["square", "E", "(x)"],
    ["parallel", "P_20", "(EP_50)"],
]


def test_a_centre_is_found_by_lines_that_are_not_of_the_log(tmp_path: Path) -> None:
    """P_25 by (CE) and (P_20 P_50), before P_15: (A P_15) is spared, and all is done without it."""
    found = worked(
        [*CARRIED, *BEFORE, ["edge", "C", "E"], ["meeting", "(CE)", "(P_20P_50)"]], tmp_path
    )
    assert found["taken"][len(CARRIED) + len(BEFORE) :][:2] == [
        ["drawn", "(CE)"],
        ["asked", "P_25", "fine", False],
    ]
    assert found["ready"]
    assert ["next", "(AP_15)"] not in found["taken"]
    due = len(scene().data["tasks"][task()]["steps"])
    assert found["score"]["count"] == found["done"] == due
    assert found["score"]["once"] == due


def test_lines_through_three_centres_are_one(tmp_path: Path) -> None:
    """(OP_40), due later, leads to P_14, too; lines of no three links are no step."""
    more = [
        ["edge", "C", "P_20"],
        ["meeting", "(CP_20)", "(EP_50)"],
        ["edge", "O", "P_40"],
        ["edge", "A", "C"],
        ["meeting", "(AC)", "(OP_40)"],
        ["edge", "O", "B"],
    ]
    found = worked([*CARRIED, *BEFORE, *more], tmp_path)
    assert found["taken"][len(CARRIED) + len(BEFORE) :][:6] == [
        ["drawn", "(CP_20)"],
        ["asked", "P_40", "fine", False],
        ["drawn", "(OP_40)"],
        ["drawn", "(AC)"],
        ["asked", "P_14", "fine", False],
        ["none", ""],
    ]
