"""Variants drawn from ranges by a seed: no two alike, each good; and why others were refused."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from itertools import chain
from random import Random
from typing import NamedTuple

from graphic_tmm.board.hand import EXACT
from graphic_tmm.classroom.variants.ranges import Good, Ranges
from graphic_tmm.classroom.variants.variant import Base, Variant, scene_of
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.errors import SceneError, SheetError, TmmError, ViewError
from graphic_tmm.fitting.compose import sheet_count
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Turning
from graphic_tmm.readers.columns import Column, Readings, is_called
from graphic_tmm.readers.findings import SILENT
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

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
    made = make(scene, wanted=scene.shown_places)
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
        roughly = make(scene, wanted=scene.shown_places, given=Composition(by.sizes, ()))
        for board in roughly.boards:
            yield from _moving(board.project, by.good)
        yield from _seen(roughly, by.good)
    made = make(scene, wanted=scene.shown_places)
    yield from _seen(made, by.good)
    if _taken(made) > by.sheets:
        yield said("it needs more sheets")
    if any(True for one in made.boards for _ in one.advice()):
        yield said("a sheet half white")


def _moving(project: Project, good: Good) -> Iterator[str]:
    """Yield what speaks against the motion over a whole turn, or its row."""
    found = (Turning.of(chapter).passed(project) for chapter in project.chapters)
    for one in (passed for passed in found if passed is not None):
        if not one.whole and one.ends:
            yield said("it does not assemble over its whole row")
        elif not one.whole:
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
    """Return how many sheets a drawing takes, no fewer than are ordered; inf: a view fits none."""
    try:
        return max(len(made.scene.sheets), sheet_count(made.scene, made.boards))
    except ViewError:
        return math.inf


IN_A_ROW = 200
"""After so many bad variants in a row no more are tried. Where three in two hundred are good, that happens once
in twenty rows; in the packaged ranges a third is good at the least."""
LISTED = 100_000
"""So many variants are put into an order; of more of them numbers are drawn, those that were drawn left out."""
TOLD = 8
"""So many reasons are told, those of the most variants."""
Tell = Callable[[int, int, str], None]
"""done, of how many, what is told of that."""


class DrawnVariants(NamedTuple):
    """Good variants, how many were tried for them, and how many were refused, by reason."""

    variants: tuple[Variant, ...]
    tried: int
    refusals: Mapping[str, int]

    @property
    def sentence(self) -> Said:
        """A sentence: of 113 tried 30 were good; refused: 41 …"""
        head = said("of {tried} tried {good} were good", tried=self.tried, good=len(self.variants))
        if not self.refusals:
            return head
        by_count = sorted(self.refusals.items(), key=lambda item: (-item[1], item[0]))
        listed: list[str] = [
            said("{count} {reason}", count=count, reason=reason)
            for reason, count in by_count[:TOLD]
        ]
        if rest := sum(count for _, count in by_count[TOLD:]):
            listed.append(said("{count} for other reasons", count=rest))
        return said("{head}; refused: {listed}", head=head, listed=joined(", ", listed))


def draw_variants(
    of: Base,
    ranges: Ranges,
    count: int,
    seed: int,
    *,
    missing: Callable[[str], str] = lambda text: "",
    tell: Tell = lambda done, of, name: None,
) -> DrawnVariants:
    """Draw variants of a scene, named 01, 02, …; the same on every machine.

    Parameters
    ----------
    of, ranges
        The scene, and what of it varies; what a good variant is.
    count, seed
        How many are wanted; which of many such rows.
    missing
        As for `scene.read.read`.
    tell
        Told how many there are.

    Raises
    ------
    TmmError
        If the scene itself cannot be drawn.
    SheetError
        If the ranges do not hold so many good variants, or `IN_A_ROW` were bad: why they were.
    """
    if count > ranges.all:
        raise SheetError(
            said(
                "the ranges hold {all} variants, {count} are wanted: widen them, or make steps smaller",
                all=ranges.all,
                count=count,
            )
        )
    by = measure_of(of, ranges.good, missing)
    found, reasons, in_a_row, tried = list[Variant](), Counter[str](), 0, 0
    width = max(2, len(str(count)))
    for number in _numbers(ranges.all, seed):
        if len(found) == count or in_a_row == IN_A_ROW:
            break
        one = _variant(ranges, number, f"{len(found) + 1:0{width}d}")
        reason, tried = refused(of, one, by), tried + 1
        if reason:
            reasons[reason] += 1
            in_a_row += 1
        else:
            found.append(one)
            in_a_row = 0
        tell(len(found), count, said("{tried} tried", tried=tried))
    result = DrawnVariants(tuple(found), tried, dict(reasons))
    if len(found) < count:
        says = said(
            "the ranges do not hold {count} good variants: {told}; widen the ranges, or lower the limits in "
            "[good]",
            count=count,
            told=result.sentence,
        )
        raise SheetError(says)
    return result


def _numbers(count: int, seed: int) -> Iterator[int]:
    """Yield the numbers of variants in an order that a seed sets, each once."""
    random = Random(seed)
    if count <= LISTED:
        numbers = list(range(count))
        random.shuffle(numbers)
        yield from numbers
        return
    seen = set[int]()
    while True:
        number = random.randrange(count)
        if number not in seen:
            seen.add(number)
            yield number


def _variant(ranges: Ranges, number: int, name: str) -> Variant:
    """Return the variant of a number: the last range varies fastest."""
    values = []
    for one in reversed(ranges.ranges):
        number, k = divmod(number, len(one.values))
        values.append(one.at(k))
    return Variant(name, tuple(reversed(values)))
