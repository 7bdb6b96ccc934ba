"""What the number of positions costs: results held against the same at a finer row, in figures and in words."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import ClassVar, NamedTuple

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import execute
from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import common
from graphic_tmm.drawn import Drawn, Numbers, single
from graphic_tmm.errors import TmmError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.project import Project, record
from graphic_tmm.readers.columns import Tabled
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.chapter import MECHANISM, Answer, Chapter, chapters
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.tasks import calls_for

Figures = Mapping[str, tuple[float, str]]
"""Results by name: a figure and its unit."""
FINE = 360
"""Positions of a row that has converged: J of the shipped flywheels changes by less than 0.01 % beyond them."""
USUAL = (8, 12, 16, 18, 24, 30, 36, 48, 60, 72, 90, 96, 108, 120, 144, 180, 216, 240, 288)
"""Numbers of positions that are drawn."""
SHARE = 0.01
"""A result within this share of its true value is printed without a remark."""


@dataclass(frozen=True)
class FinerRow(Answer):
    """What follows for a chapter when the row of positions gets another number of them.

    ``whole``: the scene with all drawn at all positions of its row. ``at_count``: what follows when the row,
    which still has its old number of positions, gets another; None if it has not what a scene names then.
    What is given position by position is taken to be straight between them.

    ``by_positions``: results of curves through the positions, each with its dangerous side: −1 too small, +1
    too large, 0 none. ``sampled``: whether the scene gives its data only at the positions of these curves.
    """

    stands: ClassVar[str] = "accuracy.FINER"
    whole: Callable[[Scene], Scene] = lambda scene: scene
    at_count: Callable[[Scene, int], Scene | None] = lambda scene, count: scene
    by_positions: Mapping[str, int] = field(default_factory=dict)
    sampled: Callable[[Scene], bool] = lambda scene: False


class Finer(NamedTuple):
    """Results of a finer row of positions.

    ``own``: the number of positions of a turn as drawn (of the cycle without a crank), ``fine``: of the finer
    row. ``due``: by result, its figure there and the unit; ``off``: the error of the drawing that comes from
    too few positions, a signed share. ``enough``: the least usual number of positions at which no result is off
    by more than `SHARE`; None if there is none.
    """

    own: int
    fine: int
    due: Figures
    off: Mapping[str, float]
    enough: int | None

    @property
    def far(self) -> tuple[str, ...]:
        """The results that are off by more than `SHARE`."""
        return tuple(name for name, share in self.off.items() if abs(share) > SHARE)


def at_all_positions(scene: Scene) -> Scene:
    """Return the scene with its plans at all positions of the row; one without a mechanism has no row."""
    if scene.mechanism is not None:
        for chapter in _called(scene, MECHANISM):
            scene = FinerRow.of(chapter).whole(scene)
    return scene


def at_count(scene: Scene, count: int, board: str = MECHANISM) -> Scene | None:
    """Return the scene with another number of positions in the row of a board.

    Positions that the scene names keep their places in the turn; None if one of them is not a position of the
    new row, or if the scene lists its places or its speeds. What else is given position by position is taken to
    be straight between them.
    """
    if board == MECHANISM and count == scene.row.count:
        return scene
    if board == MECHANISM and scene.mechanism is not None:
        drive = scene.mechanism.drive
        if scene.row.places or drive.rates or drive.gains:
            return None
    found: Scene | None = scene
    for chapter in _called(scene, board):
        found = FinerRow.of(chapter).at_count(found, count) if found is not None else None
    if found is None or board != MECHANISM:
        return found
    return replace(found, row=replace(found.row, count=count))


def _called(scene: Scene, board: str) -> Iterator[Chapter]:
    """Yield the chapters of a board that a scene calls for."""
    return (one for one in chapters(board) if calls_for(scene, one))


def sampled(drawn: Drawn) -> bool:
    """Whether the scene gives something at the positions only of what curves are drawn through."""
    return any(FinerRow.of(one).sampled(drawn.scene) for one in _curved(drawn.project))


def finer(drawn: Drawn) -> Finer | None:
    """Return the results of a finer row for a board; None if it has no results of curves.

    It depends on the scene alone, but for lengths on the drawing, and is cached with it.
    """
    if not _curved(drawn.project) or sampled(drawn):
        return None
    key, cache = ("finer", drawn.board), drawn.scene.cache
    if key not in cache:
        cache[key] = _finer(drawn)
    found: Finer | None = cache[key]
    return found and found._replace(due=_as_drawn(drawn, found))


def _as_drawn(drawn: Drawn, of: Finer) -> Figures:
    """Return the figures of a finer row, lengths as this drawing has them: to its own scale factors."""
    if all(measured != "mm" for _, measured in of.due.values()):
        return of.due
    own = _results(drawn.project, drawn.given)
    return {
        name: (own[name][0] / (1.0 + of.off[name]) if measured == "mm" else figure, measured)
        for name, (figure, measured) in of.due.items()
    }


def _curved(project: Project) -> tuple[Chapter, ...]:
    """Return the chapters that have results of curves."""
    return tuple(one for one in project.chapters if FinerRow.of(one).by_positions)


def _finer(drawn: Drawn) -> Finer | None:
    own = _positions(drawn)
    count = own * math.ceil(FINE / own)
    due = _at(drawn, count)
    if due is None:
        return None
    off = _off(_results(drawn.project, drawn.given), due)
    if not off:
        return None
    enough: int | None = own
    if any(abs(share) > SHARE for share in off.values()):
        enough = next(_enough(drawn, due), None)
    due = {name: one for name, one in due.items() if name in off}
    return Finer(own, count, due, off, enough)


def _off(own: Figures, due: Figures) -> dict[str, float]:
    """Return how far figures are off, as a share of what is due, signed; where both are known."""
    pairs = {name: (own[name][0], figure) for name, (figure, _) in due.items() if name in own}
    return {
        name: value / figure - 1.0
        for name, (value, figure) in pairs.items()
        if math.isfinite(value) and math.isfinite(figure) and figure
    }


def _positions(drawn: Drawn) -> int:
    """Return the positions of a turn, or of the cycle of a board that has no mechanism."""
    return drawn.scene.row.count if drawn.board == MECHANISM else drawn.project.count


def _enough(drawn: Drawn, due: Figures) -> Iterator[int]:
    """Yield the usual numbers of positions, greater than the drawing's, at which nothing is far off.

    Those come first at which the positions that the scene names are positions still.
    """
    more = [count for count in USUAL if count > _positions(drawn)]
    for count in [n for n in more if at_count(drawn.scene, n, drawn.board)] or more:
        there = _at(drawn, count)
        if there is not None and all(abs(share) <= SHARE for share in _off(there, due).values()):
            yield count


def _at(drawn: Drawn, count: int) -> Figures | None:
    """Return the results of curves at another number of positions by the exact hand; None if there are none."""
    scene = at_count(at_all_positions(drawn.scene), count, drawn.board)
    if scene is None:
        return None
    scene = replace(scene, row=replace(scene.row, extra=()))
    wanted = {place.name for one in _curved(drawn.project) for place in one.places}
    try:
        project = record(scene, drawn.board, wanted)
    except TmmError:
        return None
    # scale factors that positions have of their own are those of other positions
    known = {
        mark.key: common(value) if mark.unit.endswith("/mm") else value
        for mark, value in drawn.given.items()
    }
    given = {mark: known.get(mark.key, 1.0) for mark in project.construction.given}
    lengths = {mark.key: value for mark, value in drawn.sheet_lengths.items()}
    own = {m: lengths.get(m.key, value) for m, value in project.given.items()}
    return _results(project, given | own)


def _results(project: Project, given: Mapping[Mark, object]) -> Figures:
    reading = execute(project.construction, given)
    nothing = Doubts((), {})
    numbers = Numbers(reading, {}, reading)
    exact = Drawn(project, given, {}, numbers, EXACT, nothing, undrawn=(), sizes={}, reach={})
    found: dict[str, tuple[float, str]] = {}
    for chapter in _curved(project):
        there = single(Tabled.of(chapter).results(exact))
        found |= {name: there[name] for name in FinerRow.of(chapter).by_positions if name in there}
    return found


ALIKE = 0.001
"""Results whose shares differ by less than this are off for the same reason: only the first is reported."""
_SIDES = {
    -1: said("this is on the dangerous side"),
    1: said("this is on the safe side"),
}
_SAMPLED = said(
    "What acts is given at the positions only. Between them the curve that is drawn through them is all that "
    "is known, so more positions would tell nothing more."
)


def told_off(drawn: Drawn, language: str, *, remedies: bool = True) -> tuple[str, ...]:
    """Return, as lettered, a line each, which results are far off for want of positions; none if none is.

    ``remedies``: with how many positions would do, which helps whoever draws and nobody who reads the sheet.
    """
    found = finer(drawn)
    if found is None or not found.far:
        return ()
    return (*_lines(drawn, found, language), *([_remedy(found, language)] if remedies else ()))


def is_sampled(language: str) -> str:
    """Return that nothing is known between the positions."""
    return speaking(language)(_SAMPLED)


def _lines(drawn: Drawn, found: Finer, language: str) -> Iterator[str]:
    _, words, first = speaking(language), captions(language), found.far[0]
    figures = ", ".join(_figure(name, found, language) for name in _apart(found))
    first_line = _("with {own} positions: {figures}", own=found.own, figures=figures)
    yield first_line[:1].upper() + first_line[1:]
    due, of = found.due[first]
    yield _(
        "with {count} positions {name} = {due} {unit}",
        count=found.fine,
        name=words[first],
        due=number(due, language),
        unit=unit(of, language),
    )
    if side := _side(drawn, first, found.off[first]):
        yield _(_SIDES[side])


def _remedy(found: Finer, language: str) -> str:
    """Return how many positions would do."""
    _, share = speaking(language), number(100 * SHARE, language)
    if found.enough is None:
        return _("no usual number of positions keeps within {share} %", share=share)
    return _("within {share} % with {enough} positions", share=share, enough=found.enough)


def _apart(found: Finer) -> list[str]:
    """Return the results that are far off, of those that are alike the first."""
    kept: list[str] = []
    for name in found.far:
        if all(abs(found.off[name] - found.off[other]) > ALIKE for other in kept):
            kept.append(name)
    return kept


def _figure(name: str, found: Finer, language: str) -> str:
    share, _ = found.off[name], speaking(language)
    put = {
        "name": captions(language)[name],
        "percent": number(abs(100 * share), language, 2),
    }
    if share < 0.0:
        return _("{name} is too small by {percent} %", **put)
    return _("{name} is too large by {percent} %", **put)


def _side(drawn: Drawn, name: str, share: float) -> int:
    """Return -1 if it is dangerous that a result is off so, 1 if it is safe, 0 if it is neither."""
    sides = (FinerRow.of(one).by_positions.get(name, 0) for one in drawn.project.chapters)
    dangerous = next((side for side in sides if side), 0)
    return (-1 if share * dangerous > 0.0 else 1) if dangerous else 0
