"""The cheapest way within an error, for ``--budget`` of `draw` and `table`; the best one for ``--nearest``.

Ways are tried from the cheapest on, by minutes at the board. One that is expected to keep within the budget is
drawn as its own sheets would be, and measured; it is taken if nine readings of ten of every wanted quantity
keep within, for sure. Neither what is measured nor the order of ways depends on the budget: a looser one never
takes a dearer way.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice
from typing import NamedTuple

from graphic_tmm.accuracy.drawing import References, draw, pinned
from graphic_tmm.accuracy.measure import Measure
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.settings import enlarge, own_setting
from graphic_tmm.accuracy.sources import sources
from graphic_tmm.accuracy.ways import SIZES, Changes, Way, Ways, wanted, worst
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.board.hand import HANDS
from graphic_tmm.drawn import DrawnScene, hand_of
from graphic_tmm.errors import Fault, SceneError, TmmError
from graphic_tmm.fitting.compose import sheet_count
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.readers.position_count import at_all_positions
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

DRAWINGS = 300
"""How often a hand that slips draws a way that is about to be taken."""
SURE = 2.0
"""Standard errors of an error that a way has to keep within the budget with."""
HOPEFUL = 1.2
"""A way of a hand that slips is drawn if its expected error exceeds the budget by no more; expected errors are
off by some 5 % (tests/accuracy/test_response.py)."""
Tell = Callable[[int, int, str], None]
"""Called with the number of ways tried, of how many, and the next one."""
ALIKE = 1.1
"""To the scales of the scene as it is, errors are as on a way's own sheets within this factor."""
TRIED, DRAWN = 8, 2
"""Ways that are measured to find the nearest one; those of them that are drawn on their own sheets."""


@dataclass(frozen=True)
class Taken:
    """The way taken: the scene to be drawn, minutes at the board, errors measured in %, a sentence."""

    scene: Scene
    way: Way
    errors: Mapping[str, float]
    sentence: str

    @property
    def minutes(self) -> float:
        """Minutes at the board."""
        return self.way.minutes


class Errors(NamedTuple):
    """Errors by quantity, %: as measured, and what they keep within for sure."""

    measured: Mapping[str, float]
    sure: Mapping[str, float]


class Measured:
    """Ways of a scene drawn as their own sheets would be, each measured once."""

    def __init__(self, scene: Scene, minutes: Mapping[str, float] | None = None) -> None:
        self.scene, self.made = scene, make(scene, exact=True)
        scales = pinned(self.made)
        references = References(at_all_positions(scene), scales)
        self.ways = Ways(scene, references, minutes)
        self.measure = Measure(scales, references, clock=False)
        self._room: dict[float, bool] = {1.0: True}
        self._roughly: dict[tuple[object, ...], Errors] = {}
        self._drawn: dict[int, tuple[Scene, Errors] | None] = {}

    def roughly(self, way: Way) -> Errors:
        """Return the errors of a way to the scales of the scene as it is; none if it cannot be drawn."""
        rows = zip(way.boards, self.ways.parts, strict=True)
        each = [self._board(way, changes, row[0].answers.keys()) for changes, row in rows]
        if not all(one.measured for one in each):
            return Errors({}, {})
        return Errors(
            {name: error for one in each for name, error in one.measured.items()},
            {name: error for one in each for name, error in one.sure.items()},
        )

    def _board(self, way: Way, changes: Changes, names: Iterable[str]) -> Errors:
        """Return the errors of quantities of one board with its axes so; of each board measured once."""
        key = changes, way.hand, way.ruler, way.times
        if key not in self._roughly:
            try:
                scene = replace(way, boards=(changes,)).of(self.scene)
                self._roughly[key] = _errors(self.measure, scene, way.times, names)
            except TmmError:
                self._roughly[key] = Errors({}, {})
        return self._roughly[key]

    def of(self, way: Way) -> tuple[Scene, Errors] | None:
        """Return the scene of a way and its errors on its own sheets; None if it has no room."""
        if id(way) not in self._drawn:
            self._drawn[id(way)] = self._draw(way) if self.has_room(way.times) else None
        return self._drawn[id(way)]

    def words(self, way: Way) -> str:
        """Return a way in words."""
        return way.sentence(self.ways.own, self.scene.language)

    @cached_property
    def sheets(self) -> int:
        """How many sheets the scene takes as it is."""
        return _sheets(self.made)

    def has_room(self, times: float) -> bool:
        """Whether the scene as it is has room when it is so many times as large; more so when it is smaller."""
        smaller = [size for size in SIZES if size < times]
        if smaller and not self.has_room(smaller[-1]):
            return False
        if times not in self._room:
            try:
                self._room[times] = self._fits(enlarge(self.scene, self.made, times))
            except TmmError:
                self._room[times] = False
        return self._room[times]

    def _fits(self, scene: Scene) -> bool:
        drawn = make(scene, exact=True)
        return _sheets(drawn) <= self.sheets

    def _draw(self, way: Way) -> tuple[Scene, Errors] | None:
        try:
            scene = way.of(self.scene)
            if way.times != 1.0:
                scene = enlarge(scene, make(scene, exact=True), way.times)
            drawn = make(scene, exact=True)
            if way.times != 1.0 and _sheets(drawn) > self.sheets:
                return None
            scales = pinned(drawn)
            references = References(at_all_positions(scene), scales)
            errors = _errors(Measure(scales, references, clock=False), scene, names=way.errors)
        except TmmError:
            return None
        return (scene, errors) if errors.measured else None


def _errors(
    measure: Measure, scene: Scene, times: float = 1.0, names: Iterable[str] | None = None
) -> Errors:
    """Return the errors of what the sheets of a scene show, or of some quantities."""
    setting = replace(own_setting(at_all_positions(scene), None, DRAWINGS), enlarged=times)
    there = (q for one in measure.drawings(setting) for q in quantities(one))
    shown = [q.name for q in there if wanted(scene, q)] if names is None else [*names]
    runs = measure.runs(setting, "", "", shown)
    measured = {run.quantity: run.error for run in runs}
    if not setting.who.slips:
        return Errors(measured, measured)
    return Errors(measured, {run.quantity: run.error + SURE * run.errors.spread for run in runs})


def choose(
    scene: Scene, percent: float, tell: Tell | None = None, *, nearest: bool = False
) -> Taken:
    """Return the cheapest way of a scene that keeps every wanted quantity within ``percent``.

    ``tell`` is called with the number of ways tried, of how many. ``nearest``: if none does, the best.

    Raises
    ------
    SceneError
        If none does; the message names the best, and what stands in its way.
    """
    return choose_from(Measured(scene), percent, tell, nearest=nearest)


def choose_from(
    measured: Measured, percent: float, tell: Tell | None = None, *, nearest: bool = False
) -> Taken:
    """Return the same of ways that are measured once for several budgets; see `choose`."""
    taken, scene = cheapest(measured, percent, tell), measured.scene
    if taken is not None:
        return taken
    if not measured.ways.every:
        says = said("--budget: nothing on its sheets has an error that could be told")
        raise SceneError(scene.source, (Fault("", 0, says),))
    best = nearest_way(measured)
    text = _sentence("budget none", measured, percent, best[0], best[2])
    text += " " + in_the_way(measured, best[0], best[1], best[2])
    if nearest:
        return Taken(best[1], best[0], best[2], text)
    hint = WORDS[scene.language]["budget hint"]
    raise SceneError(scene.source, (Fault("", 0, f"{text} {hint}"),))


def cheapest(measured: Measured, percent: float, tell: Tell | None = None) -> Taken | None:
    """Return the cheapest way that keeps within ``percent``; None if none does."""
    hopeful = [way for way in measured.ways.every if way.worst <= _hope(way) * percent]
    for k, way in enumerate(hopeful):
        if tell is not None:
            tell(k, len(hopeful), measured.words(way))
        if worst(measured.roughly(way).sure) > ALIKE * percent:
            continue
        drawn = measured.of(way)
        if drawn is not None and worst(drawn[1].sure) <= percent:
            text = _sentence("budget", measured, percent, way, drawn[1].measured)
            return Taken(drawn[0], way, drawn[1].measured, text)
    return None


def _hope(way: Way) -> float:
    """Return by what factor an expected error may exceed a budget; a ruler alone may be lucky: not at all."""
    return HOPEFUL if HANDS[way.hand].slips else 1.0


def nearest_way(measured: Measured) -> tuple[Way, Scene, Mapping[str, float]]:
    """Return the way with the least error on its own sheets of those from which the least is expected."""
    ways = sorted(measured.ways.every, key=lambda way: way.worst)
    for first in range(0, len(ways), TRIED):
        some = ways[first : first + TRIED]
        some.sort(key=lambda way: worst(measured.roughly(way).measured))
        there = ((way, drawn) for way in some if (drawn := measured.of(way)) is not None)
        if best := list(islice(there, DRAWN)):
            way, (scene, errors) = min(best, key=lambda one: worst(one[1][1].measured))
            return way, scene, errors.measured
    return measured.ways.own, measured.scene, measured.ways.own.errors


def in_the_way(measured: Measured, way: Way, scene: Scene, errors: Mapping[str, float]) -> str:
    """Return in a sentence which source of the worst quantity's error is the largest there."""
    words, language = WORDS[measured.scene.language], measured.scene.language
    name = max(errors, key=lambda key: errors[key])
    full, scales = at_all_positions(scene), pinned(make(scene, exact=True))
    references = References(full, scales)
    for drawing in draw(full, scales):
        there = [q for q in quantities(drawing) if q.name == name]
        for shares in sources(drawing, there, references, hand_of(scene)).values():
            first, share = next(iter(shares.parts.items()))
            percent = number(100.0 * share, language, 2)
            return words["budget source"].format(
                quantity=words[name], source=words[f"from {first}"], share=percent
            )
    return ""


def _sheets(made: DrawnScene) -> int:
    """Return how many sheets a scene takes."""
    return sheet_count(made.scene, made.boards)


def _sentence(
    key: str, measured: Measured, percent: float, way: Way, errors: Mapping[str, float]
) -> str:
    language = measured.scene.language
    words, (first, *others) = WORDS[language], sorted(errors, key=lambda name: -errors[name])
    each = f"{words[first]} {number(errors[first], language, 2)} %"
    if others:
        most = number(errors[others[0]], language, 2)
        each += ", " + words["budget others"].format(error=most)
    return words[key].format(
        percent=number(percent, language),
        setting=measured.words(way),
        minutes=fixed(way.minutes, 0, language),
        errors=each,
    )
