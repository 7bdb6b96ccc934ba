"""Readings from wherever they stand are judged as the command judges them."""

from __future__ import annotations

import json
import pickle
from pathlib import Path

import pytest
from support.command import invoke
from support.each import each
from support.gallery import SHEETS

import graphic_tmm as tmm

NAME = "engine"
FILE = SHEETS / NAME / "published.csv"
DRAWN = tmm.draw(NAME)
READINGS = [
    {"plan": "velocities", "position": 3, "segment": "pb", "mm": 65.0},
    {"plan": "velocities", "position": 4, "segment": "pb", "mm": 20.0},
    {"plan": "velocities", "position": 5, "segment": "pb", "mm": float("nan")},
]
TEXT = "plan,position,segment,mm\nvelocities,3,pb,65\nvelocities,4,pb,20\n"


class Frame:
    """What of a data frame of pandas is asked for."""

    columns = ("plan", "position", "segment", "mm")

    def to_dict(self, orient: str) -> list[dict[str, object]]:
        assert orient == "records"
        return [dict(one) for one in READINGS]


@pytest.mark.slow
@each("options", [{}, {"hand": "careful", "trials": 60, "doubtful": 0.9, "wrong": 3.0}])
def test_a_file_is_judged_as_the_command_judges_it(options) -> None:
    told = [word for key, value in options.items() for word in (f"--{key}", value)]
    due = json.loads(invoke("check", NAME, FILE, "-f", "json", *told).stdout)
    found = DRAWN.check(FILE, **options)
    assert found.to_dict() == due
    assert found.to_records() == due["readings"]
    assert [one.verdict for one in found.verdicts] == [one["verdict"] for one in due["readings"]]
    assert [one.name for one in found.mistakes] == [one["name"] for one in due["mistakes"]]
    assert found.ok == (found.wrong == 0) == (not due["counts"]["wrong"])


@pytest.mark.slow
@each(
    "readings",
    [
        READINGS,
        tuple(READINGS),
        {key: [one[key] for one in READINGS] for key in READINGS[0]},
        TEXT,
        TEXT.encode(),
        Frame(),
    ],
)
def test_readings_are_the_same_wherever_they_stand(readings) -> None:
    due = DRAWN.check(TEXT)
    found = DRAWN.check(readings)
    assert [one.found for one in found.verdicts] == [65.0, 20.0]
    assert found.to_dict() == due.to_dict()
    assert found.wrong == 1


@pytest.mark.slow
def test_a_report_prints_is_shown_and_goes_to_another_process() -> None:
    found = DRAWN.check(TEXT)
    assert "pb" in repr(found)
    page = found._repr_html_()
    assert page.startswith("<iframe")
    assert page.count("<") == 2
    assert DRAWN.check(READINGS[:1]).ok
    assert [*map(repr, pickle.loads(pickle.dumps(found.verdicts)))] == [*map(repr, found.verdicts)]


def test_a_hand_draws_once_for_all_that_is_judged_alike(monkeypatch: pytest.MonkeyPatch) -> None:
    from graphic_tmm.checking import check

    made = []
    draw = check.make
    monkeypatch.setattr(
        check, "make", lambda *args, **options: made.append(1) or draw(*args, **options)
    )
    drawn = tmm.draw("slider-diagrams")
    for mm in (10.0, 20.0):
        drawn.check([{"plan": "velocities", "position": 1, "segment": "pb", "mm": mm}], trials=20)
    assert len(made) == 1


@each(
    "ask, error, says",
    [
        (
            lambda: DRAWN.check(TEXT, hand="exact"),
            tmm.AbsentError,
            "there are cad, careful, student",
        ),
        (lambda: DRAWN.check(TEXT, points="papr"), tmm.AbsentError, 'did you mean "paper"'),
        (
            lambda: DRAWN.check(TEXT, trials=3),
            tmm.SheetError,
            "^trials: a number from 20 to 100000",
        ),
        (lambda: DRAWN.check(TEXT, wrong=0.5), tmm.SheetError, "^wrong: a number from 1 to 100"),
        (lambda: DRAWN.check(Path("nowhere.csv")), tmm.SceneError, "nowhere.csv"),
        (
            lambda: DRAWN.check([{"plan": "velocities"}]),
            tmm.SceneError,
            "the column position is missing",
        ),
        (lambda: DRAWN.check([1, 2]), tmm.SceneError, "^readings: readings are a file, its text"),
        (lambda: DRAWN.check(3.0), tmm.SceneError, "not float"),
        (lambda: DRAWN.check([{**READINGS[0], "segment": "qq"}]), tmm.SceneError, "^readings:2: "),
    ],
)
def test_what_cannot_be_judged_is_refused(ask, error, says) -> None:
    with pytest.raises(error, match=says):
        ask()
