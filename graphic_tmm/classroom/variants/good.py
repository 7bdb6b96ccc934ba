"""Is a variant good: does it assemble, pass its motion on, fill its sheets, and can all of it be measured.

A vector that is measured on a plan of velocities or accelerations in a position asked for must not be shorter
than a limit, by the scene's own hand. A vector that is nothing (less than a thousandth of a millimetre, drawn
exactly) refuses no variant: at its dead centre a ram stands still whatever the lengths are, and there is
nothing to measure. Nor does what is calculated and laid off,
such as normal and Coriolis components: nobody reads it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import chain
from typing import NamedTuple

from graphic_tmm.board.hand import EXACT
from graphic_tmm.classroom.variants.ranges import Good
from graphic_tmm.classroom.variants.variant import Base, Variant, scene_of
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.errors import SceneError, SheetError, TmmError
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.fit import sheets_taken
from graphic_tmm.language.said import said
from graphic_tmm.project import Project, own_boards
from graphic_tmm.readers.any_angles.turn import Turning
from graphic_tmm.readers.columns import Column, Readings, is_called
from graphic_tmm.readers.findings import SILENT
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import draws_mechanism, make

NOTHING, SEEN = 1e-3, 0.5
"""A vector shorter than this, mm, is nothing if the hand is exact, a point on every sheet; by a hand that reads
it with its ruler one longer than that is something."""
SLACK = 1e-6
"""Degrees by which an angle may miss its limit: rounding."""


class Measure(NamedTuple):
    """By what variants are judged: limits, the sizes of the scene as it is, the sheets that it takes itself.

    ``missing``: as for `scene.read.read`.
    """

    good: Good
    sizes: Mapping[str, float]
    sheets: float
    missing: Callable[[str], str]


def measure_of(of: Base, good: Good, missing: Callable[[str], str]) -> Measure:
    """Return by what variants of a scene are judged.

    Raises
    ------
    TmmError
        If the scene itself cannot be drawn.
    """
    scene = scene_of(of, Variant("0", ()), missing=missing)
    made = make(scene, wanted=scene.shown)
    own = made.mechanism
    return Measure(good, own.sizes if own is not None else {}, _taken(made), missing)


def refused(of: Base, variant: Variant, by: Measure) -> str:
    """Return why a variant is no good one, "" if it is; what is told soonest is looked at first."""
    try:
        scene = scene_of(of, variant, missing=by.missing)
    except SceneError as error:
        return said("the scene refuses it: {key}", key=error.faults[0].key)
    try:
        return next(_reasons(scene, by), "")
    except SheetError:
        return said("its sheets do not hold it")
    except TmmError:
        return said("it never assembles, or no side of a group holds through the turn")


def _reasons(scene: Scene, by: Measure) -> Iterator[str]:
    """Yield what speaks against the scene of a variant, the cheap tests first.

    It is good in the sizes of the scene that is varied, as its key is drawn, and in those that it would have by
    itself.
    """
    if by.sizes:
        roughly = make(scene, wanted=scene.shown, given=Composition(by.sizes, ()))
        for board in roughly.boards:
            yield from _moving(board.project, by.good)
        yield from _seen(roughly, by.good)
    made = make(scene, wanted=scene.shown)
    yield from _seen(made, by.good)
    if _taken(made) > by.sheets:
        yield said("it needs more sheets")
    if any(True for one in made.boards for _ in one.advice()):
        yield said("a sheet half white")


def _moving(project: Project, good: Good) -> Iterator[str]:
    """Yield what speaks against the motion over a whole turn."""
    found = (Turning.of(chapter).passed(project) for chapter in project.chapters)
    for one in (passed for passed in found if passed is not None):
        if not one.whole:
            yield said("it does not assemble over the whole turn")
        if not one.least >= good.transmission - SLACK:
            yield said("transmission angle below {limit:g}°", limit=good.transmission)


def _seen(made: DrawnScene, good: Good) -> Iterator[str]:
    """Yield what speaks against a drawing: points in doubt or missing, vectors too short."""
    for drawn in made.boards:
        if drawn.undrawn or any(one.kind not in SILENT for one in drawn.findings()):
            yield said("a step cannot be drawn, or not surely")
        for one in shortest(drawn, good.vector):
            if not any(is_called(one, name) for name in good.short):
                yield said(
                    "{plan}:{segment} shorter than {limit:g} mm",
                    plan=one.plan,
                    segment=one.segment,
                    limit=good.vector,
                )


def shortest(drawn: Drawn, limit: float) -> Iterator[Column]:
    """Yield the vectors that are measured somewhere shorter than a limit, mm, and are not nothing there."""
    short = [one for one in _vectors(drawn) if (one.mm[0] < limit).any()]
    yield from (one for one in short if ((one.mm[0] > SEEN) & (one.mm[0] < limit)).any())
    if short:
        exact = _vectors(drawn.drawn_by(EXACT))
        yield from (one for one in exact if ((one.mm[0] > NOTHING) & (one.mm[0] < limit)).any())


def _vectors(drawn: Drawn) -> list[Column]:
    chapters = drawn.project.chapters
    return list(chain.from_iterable(Readings.of(chapter).vectors(drawn) for chapter in chapters))


def _taken(made: DrawnScene) -> float:
    """Return how many sheets a drawing takes, no fewer than are ordered."""
    mechanism = draws_mechanism(made.scene, own_boards(made.scene))
    taken = sheets_taken(made.scene, mechanism=mechanism)
    return max(float(len(made.scene.sheets)), taken)
