"""The cheapest setting within an error, for ``--budget`` of `draw` and `table`.

The hand is given: the scene's or the option's. What may vary: the number of parts of the drawing (positions
named by the scene keep their places), chords or tangents, the pole distance, the size of the drawing as far as
its sheets hold it. Every quantity on the scene's sheets has to stay within the error in nine readings of ten.
Settings are tried from the cheapest on, by minutes at the board; the chosen one is measured with the very
scales with which it is drawn.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from graphic_tmm.accuracy.cost import count, varying
from graphic_tmm.accuracy.drawing import Pinned, References, draw, pinned
from graphic_tmm.accuracy.measure import Measure
from graphic_tmm.accuracy.quantities import Accuracy, Quantity, quantities
from graphic_tmm.accuracy.settings import (
    Setting,
    can_move,
    enlarge,
    farther,
    is_long,
    own_setting,
    rows,
)
from graphic_tmm.accuracy.study import Tell
from graphic_tmm.accuracy.words import WORDS, counted
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import Fault, SceneError, TmmError
from graphic_tmm.fitting.compose import sheet_count
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

DRAWINGS, FEW = 100, 20
"""How often a hand that slips draws at a setting; and to see whether it is worth more."""
HOPELESS = 2.0
"""A setting whose error exceeds the budget by this factor in a few drawings is dropped. Chosen by eye."""
SIZES = (1.0, 2.0)
"""How many times as large a drawing is tried; chosen by eye."""
POLES = (1.0, 2.0)
"""How many times as large pole distances are tried; chosen by eye."""


@dataclass(frozen=True)
class Candidate:
    """A setting that may be taken: ``scene`` as it would be drawn but for size and poles."""

    scene: Scene
    divided: tuple[tuple[str, str], ...]
    free: tuple[str, ...]
    enlarged: float
    pole: float

    def sentence(self, language: str) -> str:
        """Return the setting in words."""
        words = WORDS[language]
        found = [counted(int(value), axis, language) for axis, value in self.divided]
        found += [words[value] for value in self.free]
        for key, times in (("pole", self.pole), ("size", self.enlarged)):
            if times != 1.0:
                found.append(words[f"budget {key}"].format(times=number(times, language)))
        return ", ".join(found)


@dataclass(frozen=True)
class Taken:
    """The setting taken: the scene to be drawn, minutes at the board, errors in % by quantity, a sentence."""

    scene: Scene
    candidate: Candidate
    minutes: float
    errors: Mapping[str, float]
    sentence: str


def choose(scene: Scene, percent: float, tell: Tell | None = None) -> Taken:
    """Return the cheapest setting of a scene that keeps every wanted quantity within ``percent``.

    ``tell`` is called with the number of settings tried, of how many.

    Raises
    ------
    SceneError
        If no setting does; the message names the best one.
    """
    made = make(scene, exact=True)
    scales = pinned(made)
    judge = References(at_all_positions(scene), scales)
    tried: list[tuple[Candidate, float, dict[str, float]]] = []
    row = sorted(_candidates(scene, scales), key=_order)
    for k, (minutes, candidate) in enumerate(row):
        if tell is not None:
            tell(k, len(row), candidate.sentence(scene.language))
        errors = _measured(candidate, judge, percent)
        if errors and _worst(errors) <= percent:
            drawn, errors = _as_drawn(candidate, made)
            if drawn is not None and _worst(errors) <= percent:
                sentence = _sentence("budget", scene, percent, candidate, errors, minutes)
                return Taken(drawn, candidate, minutes, errors, sentence)
        if errors:
            tried.append((candidate, minutes, errors))
    if not tried:
        says = said("--budget: nothing on its sheets has an error that could be told")
        raise SceneError(scene.source, (Fault("", 0, says),))
    candidate, minutes, errors = min(tried, key=lambda one: _worst(one[2]))
    errors = _measured(candidate, judge, float("inf"))
    text = _sentence("budget none", scene, percent, candidate, errors, minutes)
    raise SceneError(scene.source, (Fault("", 0, text),))


def _order(one: tuple[float, Candidate]) -> tuple[float, float, float]:
    minutes, candidate = one
    return minutes, candidate.enlarged, candidate.pole


def _worst(errors: Mapping[str, float]) -> float:
    """Return the largest error; without end if one of them is not known."""
    return max(float("inf") if np.isnan(e) else e for e in errors.values())


def _candidates(scene: Scene, scales: Pinned) -> Iterator[tuple[float, Candidate]]:
    """Yield every candidate with its minutes at the board."""
    poles = POLES if can_move(scene) else (1.0,)
    for divided, one in _divided(scene):
        for free, own in _free(one):
            try:
                minutes = _minutes(own, scales)
            except TmmError:
                continue
            for enlarged, pole in product(SIZES, poles):
                yield minutes, Candidate(own, divided, free, enlarged, pole)


def _free(scene: Scene) -> list[tuple[tuple[str, ...], Scene]]:
    """Return the scene with all that may be chosen freely, along all axes of that sort that it has."""
    found: list[tuple[tuple[str, ...], Scene]] = [((), scene)]
    for axis in (axis for one in chapters() for axis in Accuracy.of(one).axes if axis.free):
        if any(True for _ in axis.scenes(scene)):
            found = [
                ((*told, value), other) for told, one in found for value, other in axis.scenes(one)
            ]
    return found


def _divided(scene: Scene) -> Iterator[tuple[tuple[tuple[str, str], ...], Scene]]:
    """Yield the scene divided into more parts or fewer, along all axes that it has."""
    found: list[tuple[tuple[tuple[str, str], ...], Scene]] = [((), scene)]
    for axis in [name for name, _ in rows(scene)]:
        finer = []
        for told, one in found:
            values = next(row for name, row in rows(one) if name == axis)
            finer += [((*told, (axis, v)), s) for v, s in values if not is_long(axis, v)]
        found = finer
    yield from found


def _wanted(scene: Scene, quantity: Quantity) -> bool:
    return not quantity.places or bool(scene.called & set(quantity.places))


def _minutes(scene: Scene, scales: Pinned) -> float:
    """Return the minutes at the board for all wanted quantities of a scene together."""
    total = 0.0
    for drawing in draw(at_all_positions(scene), scales):
        marks = [m for q in quantities(drawing) if _wanted(scene, q) for m in q.marks]
        if marks:
            varies = varying(drawing.given)
            total += count(drawing.construction, varies, marks, positions=drawing.count).minutes
    return total


def _errors(measure: Measure, setting: Setting, scene: Scene) -> dict[str, float]:
    """Return the errors of the quantities that the sheets of ``scene`` show."""
    there = (q for drawing in measure.drawings(setting) for q in quantities(drawing))
    asked = [q.name for q in there if _wanted(scene, q)]
    return {run.quantity: run.error for run in measure.runs(setting, "", "", asked)}


def _measured(candidate: Candidate, judge: References, percent: float) -> dict[str, float]:
    """Return the errors of a candidate to the scales of the scene as it is; none if it cannot be drawn."""
    scene = at_all_positions(candidate.scene)
    measure = Measure(judge.scales, judge, clock=False)
    errors: dict[str, float] = {}
    try:
        for drawings in (FEW, DRAWINGS):
            setting = own_setting(scene, None, drawings)
            setting = replace(setting, enlarged=candidate.enlarged, pole=candidate.pole)
            errors = _errors(measure, setting, candidate.scene)
            if not setting.who.slips or _worst(errors) > HOPELESS * percent:
                return errors
    except TmmError:
        return {}
    return errors


def _as_drawn(candidate: Candidate, made: DrawnScene) -> tuple[Scene | None, dict[str, float]]:
    """Return the scene of a candidate and its errors with the scales that its own sheets give it."""
    scene = candidate.scene
    try:
        if candidate.pole != 1.0:
            scene = farther(scene, made, candidate.pole)
        if candidate.enlarged != 1.0:
            scene = enlarge(scene, make(scene, exact=True), candidate.enlarged)
        drawn = make(scene, exact=True)
        if _sheets(drawn) > _sheets(made):
            return None, {}
        full, scales = at_all_positions(scene), pinned(drawn)
        measure = Measure(scales, References(full, scales), clock=False)
        return scene, _errors(measure, own_setting(full, None, DRAWINGS), scene)
    except TmmError:
        return None, {}


def _sheets(made: DrawnScene) -> int:
    """Return how many sheets a scene takes."""
    return sheet_count(made.scene, made.boards)


def _sentence(
    key: str,
    scene: Scene,
    percent: float,
    candidate: Candidate,
    errors: Mapping[str, float],
    minutes: float,
) -> str:
    language, words = scene.language, WORDS[scene.language]
    each = ", ".join(f"{words[k]} {number(e, language, 2)} %" for k, e in errors.items())
    return words[key].format(
        percent=number(percent, language),
        setting=candidate.sentence(language),
        minutes=fixed(minutes, 0, language),
        errors=each,
    )
