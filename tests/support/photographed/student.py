"""A student's sheet: what the hand made of a scene, where its points stand, what of it was left out."""

from __future__ import annotations

import functools
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.cells import pointed, points
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.sheet_frame import drawing_area
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import composed_sheets
from support.photographed.ink import Inked, inked

SHEETS = Path(__file__).parents[3] / "sheets"
ENDS, PASSES = 0.3, 2.0
"""How near to a point a line ends that ends there, or passes that shows it (the pin about a pivot), mm."""
NONE = 0.3
"""A vector so short is not drawn by anybody, mm: the point is where the other one is."""
CROSSING = 0.17
"""Lines cross where the sine of the angle between them is more: ten degrees."""
Key = tuple[str, str, str]
"""Plan, point, position: as readings name it."""


class Due(NamedTuple):
    """Where a point stands: on the sheet, and from the pole of its plan (mm); whether it was drawn at all.

    ``apart``: whether pencil can show it: no vector of no length leads to it, nothing is drawn over its end.
    """

    sheet: complex
    spot: complex
    drawn: bool
    apart: bool


class Paper(NamedTuple):
    """A student's sheet: its scene, which of its sheets (from 1), its size and frame (mm), ink and points.

    ``poles``: where the plans stand, (plan, position): mm on the sheet.
    """

    scene: Scene
    number: int
    size: tuple[float, float]
    frame: tuple[float, float, float, float]
    ink: list[Inked]
    points: dict[Key, Due]
    poles: dict[tuple[str, str], complex]


class Left(NamedTuple):
    """What a student does not draw: of each plan, as a share, the whole, or from some point on.

    ``aside``: how far the plans stand from where our sheet has them, mm (standard deviation).
    """

    plans: float = 0.0
    unfinished: float = 0.0
    aside: float = 0.0


WHOLE = Left()
"""Nothing is left out."""


@functools.cache
def _ours(name: str) -> tuple[Scene, DrawnScene, object]:
    scene = read(SHEETS / name / "scene.toml")
    made, found = composed_sheets(scene)
    return scene, made, found


def exact(name: str) -> tuple[DrawnScene, tuple[Sheet, ...]]:
    """Return the scene as it is due, and its sheets."""
    _, made, found = _ours(name)
    return made, found.sheets


def student(name: str, number: int, seed: int, left: Left = WHOLE) -> Paper:
    """Return a student's drawing of a sheet of a scene, composed as ours is."""
    scene, drawn_exactly, found = _ours(name)
    by_hand = replace(scene, hand="student", seed=seed)
    made, ours = composed_sheets(by_hand, found.composition)
    sheet = ours.sheets[number - 1]
    random = np.random.default_rng([seed, number])
    width, height, lines = inked(svg(sheet))
    drawings = {one.name: one for one in sheet.drawings}
    shifts = {name: _some(random, left.aside) for name in drawings}
    shifts["frame"] = 0j
    omitted = {n for n, one in drawings.items() if one.shows and random.random() < left.plans}
    lost = {
        n: _lost(made, one, random)
        for n, one in drawings.items()
        if random.random() < left.unfinished
    }
    ink = [
        one._replace(points=one.points + shifts[one.drawing])
        for one in lines
        if one.drawing not in omitted and not one.of & lost.get(one.drawing, frozenset())
    ]
    due: dict[Key, Due] = {}
    poles = {}
    slots = {mark.key: mark.slot for mark in _marks(made)}
    spots = points(made)
    none = _of_no_length(points(drawn_exactly))
    for one in sheet.drawings:
        for plan in set(one.shows) & set(pointed()):
            at = one.origin(plan) + shifts[one.name]
            own = {p for p in made.mechanism.names if one.name == f"{plan}-{p}"} or set(
                made.mechanism.names
            )
            for key, spot in spots.items():
                if key[0] == plan and key[2] in own:
                    seen, shown = (
                        _inked_at(ink, one.name, slots[key[:2]], at + spot, buried)
                        for buried in (True, False)
                    )
                    due[key] = Due(at + spot, spot, seen, shown and key not in none)
                    poles[plan, key[2]] = at
    area = drawing_area(sheet.format, scene.language, number == 1).inner
    frame = (area.left, area.bottom, area.right, area.top)
    return Paper(scene, number, (width, height), frame, ink, due, poles)


def _some(random: np.random.Generator, much: float) -> complex:
    return complex(*random.normal(0, 1, 2)) * much


def _marks(made: DrawnScene) -> list:
    return [step.it for step in made.mechanism.construction.steps]


def _lost(made: DrawnScene, drawing: object, random: np.random.Generator) -> frozenset[int]:
    """Return the marks of a plan behind the place where the student gave it up."""
    own = [mark.slot for mark in _marks(made) if mark.view in drawing.shows]
    if len(own) < 4:
        return frozenset()
    return frozenset(own[random.integers(len(own) // 2, len(own)) :])


def _of_no_length(spots: dict[Key, complex]) -> set[Key]:
    """Return the points of vectors' plans that should stand at their pole, or where another one does.

    Two points that are one at all positions are one point with two letters.
    """
    near = {}
    for (plan, letter, position), spot in spots.items():
        if plan == "positions":
            continue
        others = {"": 0j} | {
            k[1]: z for k, z in spots.items() if (k[0], k[2]) == (plan, position) and k[1] != letter
        }
        near[plan, letter, position] = {k for k, z in others.items() if abs(spot - z) < NONE}
    always = {
        key[:2]: set.intersection(*(one for k, one in near.items() if k[:2] == key[:2]))
        for key in near
    }
    return {key for key, some in near.items() if some - always[key[:2]]}


def _inked_at(ink: list[Inked], drawing: str, slot: int, at: complex, buried: bool) -> bool:
    """Whether a point is to be seen: a line ends there, two lines cross, or a pin of its own is about it.

    A line that only passes does not show it: nothing tells where along the line it stands. ``buried``: nor
    does, otherwise, the end of one on another that runs on; a head there is seen.
    """
    ways, ends = [], []
    for one in ink:
        if one.drawing != drawing or one.pen == "letters":
            continue
        far, way = _far(one.points, at)
        if min(abs(one.points[[0, -1]] - at)) < ENDS:
            if one.filled:
                return True
            ends.append(way)
        elif far < ENDS:
            ways.append(way)
        if slot in one.of and abs(one.points[0] - one.points[-1]) < 1e-6 and far < PASSES:
            return True
    if any(buried or all(abs((a / b).imag) > CROSSING for b in ways) for a in ends):
        return True
    ways += ends
    return any(abs((a / b).imag) > CROSSING for a in ways for b in ways)


def _far(points: np.ndarray, at: complex) -> tuple[float, complex]:
    """Return how far a place is from a polyline, mm, and how that runs where it is nearest."""
    first, way = points[:-1], np.diff(points)
    share = np.clip(((at - first) / np.where(way == 0, 1, way)).real, 0, 1)
    off = abs(first + share * way - at)
    best = int(off.argmin())
    return float(off[best]), complex(way[best] / (abs(way[best]) or 1.0))
