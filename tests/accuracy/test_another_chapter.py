"""A chapter that is written here is measured, told and kept within a budget: nobody outside has to know it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import pytest
from support.gallery import SHEETS

from graphic_tmm.accuracy.answer_text import sentences
from graphic_tmm.accuracy.budget import choose
from graphic_tmm.accuracy.quantities import Accuracy, Axis, Quantity, Value
from graphic_tmm.accuracy.report_json import json_report
from graphic_tmm.accuracy.study import study
from graphic_tmm.board.bounds import Bound
from graphic_tmm.board.operations.instruments import join, lay_off, measure
from graphic_tmm.board.values import Length, Point
from graphic_tmm.errors import SceneError
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench, Plan, Project
from graphic_tmm.scene import values as v
from graphic_tmm.scene.chapter import Chapter, Place, Recorded, added
from graphic_tmm.scene.declare import Section, key
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.scene.tasks import SectionKey

ASKED: SectionKey[int] = SectionKey("strip")
STRIP: Recorded[Any] = Recorded("strip")
WHOLE = 120.0


@dataclass(frozen=True)
class Strip:
    """A strip in equal parts."""

    pieces: int = key(v.number(Bound(1, whole=True)), "its parts", 4)


def record(bench: Bench) -> Any:
    """Lay off one of equal parts along a line; measure it."""
    part, draft = WHOLE / (ASKED.of(bench.scene) or 1), bench.draft
    draft.board.open("strip")
    start, end = draft.take(Point, "A", 0j), draft.take(Point, "B", complex(WHOLE, 0.0))
    due = draft.take(Length, "d", part, "mm")
    line = draft.board.draw(join, "(AB)", start, end)
    point = draft.board.draw(lay_off, "C", line, due)
    return draft.board.draw(measure, "AC", start, point), due


def quantities(project: Project) -> Iterator[Quantity]:
    read_off, due = STRIP.on(project)
    yield Quantity("first_part", "mm", (Value(read_off),), due=(Value(due),))


def divided(scene: Scene) -> Iterator[tuple[str, Scene]]:
    if ASKED.of(scene) is not None:
        for n in (1, 2, 4, 8):
            yield str(n), ASKED.put(scene, n)


CHAPTER = Chapter(
    name="strip",
    number=99,
    board="strip",
    sections=(Section("strip", Strip, "a strip in equal parts", alone=True),),
    places=(Place("strip", 200),),
    answers=(
        Plan(record=record),
        Accuracy(
            quantities=quantities,
            places=("strip",),
            axes=(
                Axis(
                    "pieces",
                    divided,
                    parts=lambda scene: ASKED.of(scene) or 0,
                    counted=said("{n} piece", "{n} pieces"),
                ),
            ),
            words={"first_part": said("the first part"), "pieces": said("pieces of a strip")},
        ),
    ),
)


@pytest.fixture
def scene() -> Iterator[Scene]:
    plain = replace(read(SHEETS / "lettering"), language="en", hand="student", ruler=0.5)
    with added(CHAPTER):
        yield ASKED.put(replace(plain, sheets=(SheetOrder("A4", ("strip",)),)), 4)


def test_a_chapter_of_a_test_is_studied_and_told(scene: Scene) -> None:
    found = study(scene, trials=20, clock=False)
    told = json.loads(json_report(found))
    assert set(told["quantities"]) == {"first_part"}
    values = {run["value"] for run in told["runs"] if run["axis"] == "pieces"}
    assert values == {"1", "2", "4", "8"}
    exact = [r["error_percent"] for r in told["runs"] if r["hand"] == "exact"]
    assert exact == [0.0] * 4
    lines = [*sentences(found.answer)]
    assert any("the first part" in line for line in lines)
    assert any("piece" in line for line in lines)


def test_a_chapter_of_a_test_is_kept_within_a_budget(scene: Scene) -> None:
    """All pieces cost the same; of 120 mm a slip of the hand is a smaller share than of 15 mm."""
    taken = choose(scene, 50.0)
    assert set(taken.errors) == {"first_part"}
    assert "piece" in taken.sentence
    assert ASKED.of(taken.scene) in (1, 2, 4, 8)
    with pytest.raises(SceneError, match="the first part"):
        choose(scene, 1e-6)
