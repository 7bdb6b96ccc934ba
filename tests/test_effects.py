"""A scene costs what its effects cost: an effect that is not named records no step."""

from __future__ import annotations

from collections import Counter

import pytest
from support.effects import LOADS, PLACED, named, needs, only, steps
from support.gallery import SHEETS

from graphic_tmm.project import record
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

FULL = (
    "windrower",
    "windrower-published",
    "engine",
    "locomobile",
    "lever",
    "crank-press",
    "slider-diagrams",
)


def scene(name: str) -> Scene:
    return read(SHEETS / name)


@pytest.mark.parametrize("name", FULL)
def test_the_steps_of_a_scene_are_those_of_its_plans(name: str) -> None:
    """Each plan's own steps are counted by itself, behind what it needs; the forces with all their loads."""
    whole = scene(name)
    effects = named(whole)
    loads = {effect for effect in effects if effect in LOADS}
    total = steps(whole, ())
    assert total.total() > 0
    for effect in effects:
        if effect in LOADS:
            continue
        before = needs(whole, effect)
        if effect == "forces":
            before = before.union(*(needs(whole, load) for load in loads)) - {"forces"}
        if "forces" in before:
            before = before.union(loads, *(needs(whole, load) for load in loads))
        behind = {effect} | (loads if effect == "forces" else set())
        own, without = steps(whole, before | behind), steps(whole, before)
        assert own > without, effect
        total += own - without
    assert total == steps(whole, effects)
    letters = Counter(step.it for step in record(only(whole, effects)).construction.steps)
    assert set(letters.values()) == {1}


def views(whole: Scene, effects: set[str]) -> set[str]:
    return {step.it.view for step in record(only(whole, effects)).construction.steps}


@pytest.mark.slow
@pytest.mark.parametrize("name", FULL)
def test_a_plan_that_is_not_named_has_no_view(name: str) -> None:
    whole = scene(name)
    effects = set(named(whole))
    due = {
        effect: views(whole, needs(whole, effect) | {effect}) for effect in effects & set(PLACED)
    }
    for effect, shown in due.items():
        depend = {other for other in effects if effect in needs(whole, other)} | {effect}
        if effect == "accelerations":
            depend |= {"inertia"}
        if effect == "forces":
            depend |= set(LOADS)
        rest = effects - depend
        rest -= {other for other in rest if needs(whole, other) & depend}
        own = shown - views(whole, needs(whole, effect))
        assert own, effect
        assert not own & views(whole, rest), effect


def letters(whole: Scene, effects: set[str]) -> set[str]:
    return {step.it.letter for step in record(only(whole, effects)).construction.steps}


@pytest.mark.parametrize("name", ["windrower", "lever", "crank-press"])
def test_a_load_that_is_not_named_has_no_force(name: str) -> None:
    whole = scene(name)
    effects = set(named(whole))
    assert {"gravity", "inertia"} <= effects
    assert any(letter.startswith("G_") for letter in letters(whole, effects))
    assert any(letter.startswith("P_{i") for letter in letters(whole, effects))
    assert not any(letter.startswith("G_") for letter in letters(whole, effects - {"gravity"}))
    still = letters(whole, effects - {"inertia"})
    assert not any(letter.startswith(("P_{i", "M_{i")) for letter in still)


def test_without_inertia_no_acceleration_is_drawn() -> None:
    whole = scene("crank-press")
    assert "accelerations" not in views(whole, {"velocities", "forces", "gravity", "friction"})
    assert "accelerations" in views(whole, {"velocities", "forces", "inertia"})


def test_without_friction_the_polygons_are_drawn_once() -> None:
    whole = scene("crank-press")
    effects = set(named(whole))
    assert "friction" in effects
    frictionless = views(whole, effects - {"friction"})
    assert "friction" not in frictionless
    assert len([view for view in frictionless if view.startswith("forces 2-3")]) == 1
    passes = whole.tasks["forces"].friction.passes
    drawn = [view for view in views(whole, effects) if view.startswith("forces 2-3")]
    assert len(drawn) == passes + 1
