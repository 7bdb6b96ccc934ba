"""What is said of effects: the answer first, what is not worth drawing, in two languages, within a terminal."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from support.command import invoke
from support.gallery import scene as gallery
from support.tasks import effect, effects_known, effects_of

from graphic_tmm.accuracy.effects.effect_study import EffectStudy, study_effects
from graphic_tmm.accuracy.effects.report_effects import effects_text, sentences
from graphic_tmm.chapters.forces.task import Load
from graphic_tmm.commands.shared.telling import rendered
from graphic_tmm.project import record


@pytest.mark.slow
def test_what_changes_less_than_the_drawing_errs_is_named_as_not_worth_drawing() -> None:
    own = gallery("crank-press")
    order = own.tasks["forces"]
    scene = own.asking(forces=replace(order, loads=(*order.loads, Load(3, "B", 1.0, -90.0))))
    found = effects_of(scene)
    small = effect(found, "load 2, at B")
    assert [one.quantity for one in small.changes] == ["P_bal", "R"]
    assert all(0.0 < one.percent < one.error for one in small.changes)
    assert not small.worth
    lines = list(sentences(found))
    assert lines[0].startswith(
        "Most matters: load 1, at B. Without it P_bal changes by up to 102 %"
    )
    assert lines[-1] == "Not called for, so no step is recorded, drawn or computed: gas."
    (told,) = [line for line in lines if line.startswith("Not worth drawing")]
    assert "load 2, at B (" in told
    assert "friction" not in told
    assert "gravity" not in told


@pytest.mark.slow
def test_effects_that_are_hidden_each_are_left_out_together_before_it_is_said() -> None:
    """Beside a student's error each of four is nothing; together they are held against it once more."""
    found = study_effects(gallery("crank-press"), clock=False)
    assert found.hidden is None
    together = found.hidden_by_pencil
    assert together is not None
    small = [one for one in found.effects if one.called and not one.worth_pencil]
    assert set(together.names) == {one.name for one in small}
    assert together.all
    assert together.weighed.cost.steps > max(one.cost.steps for one in small)
    assert together.weighed.percent > max(one.percent for one in small)
    assert not together.weighed.worth_pencil
    (line,) = [one for one in sentences(found) if "together" in one]
    assert line.startswith("Nor are they seen all together (reaction R01 by 3.2 %")


def loaded(*sizes: float) -> EffectStudy:
    """Effects of a press with further loads on its ram."""
    own = gallery("crank-press")
    order = own.tasks["forces"]
    loads = (*order.loads, *(Load(3, "B", size, -90.0) for size in sizes))
    return effects_of(own.asking(forces=replace(order, loads=loads)))


@pytest.mark.slow
def test_of_what_would_be_seen_together_a_part_is_left_out() -> None:
    """Three loads, each of some 0.35 of what is just seen: two of them are not seen, three are."""
    tried = effect(loaded(1.0), "load 2, at B")
    most = min(one.error / one.percent for one in tried.changes)
    found = loaded(0.36 * most, 0.34 * most, 0.35 * most)
    assert found.hidden is not None
    assert found.hidden.names == ("load 3, at B", "load 4, at B")
    assert not found.hidden.all
    each = [effect(found, name).percent for name in found.hidden.names]
    assert found.hidden.weighed.percent == pytest.approx(sum(each), rel=1e-3)
    line = next(one for one in sentences(found) if one.startswith("Together leave out only"))
    assert "load 3, at B, load 4, at B (" in line
    pair = loaded(0.6 * most, 0.6 * most)
    assert pair.hidden is not None
    assert len(pair.hidden.names) == 1
    assert "Leave out one of them only: together they are seen." in sentences(pair)


def test_effects_stand_in_the_order_in_which_they_matter() -> None:
    found = effects_known("lever").effects
    called = [one.percent for one in found if one.called]
    assert called == sorted(called, reverse=True)
    assert [one.name for one in found[len(called) :]] == ["gas", "friction"]


@pytest.mark.slow
def test_what_is_always_drawn_costs_nothing() -> None:
    """An engine's P_in is drawn whatever it is: inertia changes M, and adds no step."""
    found = effects_known("locomobile")
    assert effect(found, "inertia").cost.steps == 0
    assert effect(found, "inertia").worth
    printed = rendered(effects_text(found, 80), 80, printed=False)
    (line,) = [
        one for one in printed.splitlines() if "силы инерции" in one and "не прибавляет" in one
    ]
    assert "0" in line


def test_what_a_scene_cannot_do_without_says_why() -> None:
    own = gallery("moment-cycle")
    order = own.tasks["cycle"]
    scene = own.asking(cycle=replace(order, moments=order.moments[1:]))
    (only,) = effects_of(scene).effects
    assert "no moment is given over the cycle" in only.refused
    (line,) = [one for one in sentences(effects_of(scene)) if "отбросить нельзя" in one]
    assert "scene.toml" not in line


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize(
    "name",
    [
        "crank-press",
        "lever",
        "moment-cycle",
        "cam",
        pytest.param("windrower", marks=pytest.mark.slow),
    ],
)
def test_the_report_fits_a_terminal(name: str, language: str) -> None:
    found = effects_known(name)
    told = replace(found, scene=replace(found.scene, language=language))
    lines = rendered(effects_text(told, 80), 80, printed=False).splitlines()
    assert max(map(len, lines)) <= 80
    assert len(lines) > 1


@pytest.mark.slow
def test_the_command_tells_the_answer_first_and_writes_it(tmp_path: Path) -> None:
    found = invoke("accuracy", "crank-press", "--effects", "--trials", "10", "-o", tmp_path)
    assert found.exit_code == 0, found.output
    lines = found.stdout.splitlines()
    assert lines[1].startswith("Most matters: load 1, at B.")
    assert (tmp_path / "crank-press-effects.txt").read_text("utf-8") == found.stdout


@pytest.mark.slow
def test_as_json_it_has_the_same(tmp_path: Path) -> None:
    asked = ("accuracy", "crank-press", "--effects", "--no-time", "-f", "json")
    found = invoke(*asked)
    assert found.exit_code == 0, found.output
    assert found.stdout == invoke(*asked).stdout
    told = json.loads(found.stdout)
    by_name = {one["effect"]: one for one in told["effects"]}
    assert by_name["gas"] == {
        "effect": "gas",
        "called_for": False,
        "steps": 0,
        "minutes": 0.0,
        "seconds": None,
        "seconds_unsure": 0.0,
        "refused": None,
        "worth_drawing": False,
        "changes": [],
        "worth_drawing_by_student": False,
    }
    assert by_name["friction"]["worth_drawing_by_student"] is True
    assert by_name["gravity"]["worth_drawing_by_student"] is False
    assert told["steps"] == len(record(gallery("crank-press")).construction.steps)
    assert told["sentences"][0].startswith("Most matters")
