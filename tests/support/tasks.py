"""Scenes ready for the tests of accuracy: their scales as drawn, their settings, a measure of them."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

from graphic_tmm.accuracy.answer import Answer, answer
from graphic_tmm.accuracy.drawing import Pinned, References, draw, pinned
from graphic_tmm.accuracy.effects.effect_study import EffectStudy, Weighed, study_effects
from graphic_tmm.accuracy.measure import Measure
from graphic_tmm.accuracy.quantities import Quantity, quantities
from graphic_tmm.accuracy.settings import Setting, hand_named
from graphic_tmm.accuracy.study import Study, study
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from support import gallery
from support.gallery import exact


@cache
def scene(name: str) -> Scene:
    return at_all_positions(gallery.scene(name))


@cache
def scales(name: str) -> Pinned:
    return pinned(exact(name))


def drawing(name: str, changed: Scene | None = None) -> Project:
    (found,) = draw(changed or scene(name), scales(name))
    return found


def quantity(drawn: Project, name: str) -> Quantity:
    return next(q for q in quantities(drawn) if q.name == name)


def measure(name: str) -> Measure:
    return Measure(scales(name), References(scene(name), scales(name)), clock=False)


def by(name: str, hand: str, trials: int = 100, changed: Scene | None = None) -> Setting:
    task = changed or scene(name)
    return Setting(task, hand, hand_named(hand, task, trials))


@cache
def studied(name: str) -> Study:
    return study(gallery.scene(name), trials=40, clock=False)


@cache
def answered(name: str, language: str = "") -> Answer:
    """The answer for a scene of the package, in its own language or another: what is weighed has none."""
    if not language:
        return answer(gallery.scene(name))
    own = answered(name)
    return replace(own, scene=replace(own.scene, language=language))


def effects_of(own: Scene) -> EffectStudy:
    return study_effects(own, trials=20, clock=False)


@cache
def effects_known(name: str) -> EffectStudy:
    return effects_of(gallery.scene(name))


def effect(found: EffectStudy, name: str) -> Weighed:
    return next(one for one in found.effects if one.name == name)


def text_of(name: str) -> str:
    return (gallery.SHEETS / name / "scene.toml").read_text("utf-8")


def written(tmp_path: Path, text: str, *changes: tuple[str, str]) -> Scene:
    """Read a scene whose text was changed by hand."""
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    file = tmp_path / "scene.toml"
    file.write_text(text, encoding="utf-8")
    return read(file)
