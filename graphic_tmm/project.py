"""What is recorded on one board: chapter after chapter what the scene asks for; the log, no numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Set
from dataclasses import dataclass, field
from itertools import chain
from typing import Any, ClassVar, Protocol

import numpy as np

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.errors import Fault, SceneError, StructureError
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.mechanism.records import Sweep
from graphic_tmm.scene.chapter import (
    MECHANISM,
    Answer,
    Chapter,
    Holder,
    aside,
    boards,
    chapters,
    in_order,
    places,
)
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.tasks import calls_for

DECIMALS = 9
"""Decimals to which a board of its own tells the angles of its positions, °."""
CRANK, EVEN = "crank", "even"
"""What a chapter says that takes only mechanisms which one crank drives, all round; whose drive goes evenly."""


@dataclass(frozen=True)
class Plan(Answer):
    """What a chapter records.

    ``needs``: what else has to be recorded for it, by name: a chapter, or a word that another chapter
    understands. ``record``: records its plan on its board; ``aside``: calculations recorded after everything
    else, in views of their own that nothing uses, so that no drawing changes (`chapter.aside`). ``charts``:
    the graphs on axes of its record.

    ``result``: the marks of its record that are all known at some position if the chapter has a result;
    ``remedy``: why it has none otherwise, and what to do, printed after its name; ``causes``: marks that tell
    more where they are known nowhere, the first of them its reason. ``ranges``: the end of the sentence that
    lists the positions that can be drawn, and what helps.
    """

    stands: ClassVar[str] = "record.PLAN"
    needs: Callable[[Scene], Mapping[str, Any]] = lambda scene: {}
    record: Callable[[Bench], Any] = lambda bench: None
    aside: Callable[[Bench], Any] = lambda bench: None
    charts: Callable[[Any], Iterable[Chart]] = lambda made: ()
    result: Callable[[Any], Iterable[Mark]] = lambda made: ()
    remedy: str = ""
    causes: Callable[[Any], Iterable[tuple[Mark, str]]] = lambda made: ()
    ranges: Callable[[Project], tuple[str, str]] = lambda project: ("", "")


@dataclass(frozen=True)
class Project:
    """The log of a board and what is given on it but for the scale factors that are chosen.

    ``recorded``: what chapters recorded, by chapter. ``names`` and ``coordinates`` (of the drive, degrees or m;
    None where there are none) run along the positions; ``count`` of them make the row; ``sweep``: what the
    coordinate goes through. ``rows``: the positions (indices) at
    which a view is drawn, if not all; ``told``: those at which findings of a view are reported. ``best``:
    computes the position (index) that shows the board best; None where that is unknown.
    """

    board: str
    scene: Scene
    construction: Construction
    given: dict[Mark, object]
    recorded: Mapping[str, Any]
    names: tuple[str, ...]
    coordinates: tuple[float | None, ...]
    count: int
    rows: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    told: Mapping[str, frozenset[int]] = field(default_factory=dict)
    best: Callable[[], int] | None = None
    sweep: Sweep | None = None

    @property
    def chapters(self) -> tuple[Chapter, ...]:
        """The chapters that recorded something, in the order of the book."""
        return tuple(one for one in chapters(self.board) if one.name in self.recorded)

    @property
    def charts(self) -> tuple[Chart, ...]:
        """The graphs on axes, in the order in which they stand one below the other."""
        found = chain.from_iterable(
            Plan.of(one).charts(self.recorded[one.name]) for one in self.chapters
        )
        return tuple({chart.view: chart for chart in found}.values())

    def scale(self, plan: str) -> Mark:
        """Return the mark of a plan's μ."""
        view = self.construction.view(plan)
        assert view is not None
        assert view.scale is not None
        return view.scale

    def ranges(self, *, remedies: bool) -> Said:
        """Return the end of a sentence: where it can be drawn; ``remedies``: and what helps."""
        parts = list[str]()
        for says, remedy in (Plan.of(one).ranges(self) for one in self.chapters):
            parts += [says, *(["; ", remedy] if remedies and remedy else [])]
        return joined("", parts)

    def marks(self, plan: str) -> list[Mark]:
        """Return the marks of the steps drawn in a view, in order."""
        return [step.it for step in self.construction.steps if step.it.view == plan]


class Before(Holder, Protocol):
    """The same drawn before, in another size."""

    @property
    def reading(self) -> Reading:
        """Its numbers at all positions."""


class Bench:
    """The board while chapters record: the scene, the draft, the wanted places, the records so far.

    ``wanted``: places of sheets; ``needed``: what chapters need, the greatest of several wishes. ``sizes``:
    shares of the usual size at which views are drawn; ``usual``: the same project in the usual size, if it
    exists.
    """

    def __init__(
        self,
        board: str,
        scene: Scene,
        wanted: Set[str],
        sizes: Mapping[str, float] | None = None,
        usual: Before | None = None,
    ) -> None:
        self.board, self.scene, self.wanted = board, scene, wanted
        self.draft = Draft()
        self.recorded: dict[str, Any] = {}
        self.needed: dict[str, Any] = {}
        self.sizes, self.usual = sizes or {}, usual
        self.names: tuple[str, ...] = ()
        self.coordinates: tuple[float | None, ...] = ()
        self.sweep: Sweep | None = None
        self.count = 0
        self.rows: dict[str, tuple[int, ...]] = {}
        self.told: dict[str, frozenset[int]] = {}
        self.best: Callable[[], int] | None = None

    def stand(
        self,
        names: Iterable[str],
        coordinates: Iterable[float | None],
        count: int,
        sweep: Sweep | None = None,
    ) -> None:
        """Tell the positions: their names and coordinates, how many make the row; of what drive these are."""
        if sweep is None:
            coordinates = (round(float(one), DECIMALS) for one in coordinates if one is not None)
        self.names, self.coordinates, self.count = tuple(names), tuple(coordinates), count
        self.sweep = sweep

    def tell(self, view: str, where: Iterable[int]) -> None:
        """Set the positions at which findings of a view are reported, unless they are set already."""
        self.told[view] = self.told.get(view, frozenset()) | frozenset(where)

    def enter(self, name: str, made: Any) -> None:
        """Keep the record of a chapter, if it has one."""
        if made is not None:
            self.recorded[name] = made

    def call(self) -> list[Chapter]:
        """Return the chapters to be recorded, in their order, and enter what they need."""
        called = []
        for one in reversed(in_order(self.board)):
            own = {place.name for place in one.places}
            shown = one.always or bool(own & self.wanted)
            if one.name in self.needed or (calls_for(self.scene, one) and shown):
                called.append(one)
                for name, need in Plan.of(one).needs(self.scene).items():
                    self.needed[name] = max(need, self.needed.get(name, need))
        return called[::-1]

    def project(self) -> Project:
        """Return the project; positions without names are numbered from 1."""
        log = self.draft.board.construction()
        given, made = dict(self.draft.given), dict(self.recorded)
        rows, told = dict(self.rows), dict(self.told)
        arrays = (np.asarray(v) for v in given.values() if isinstance(v, np.ndarray))
        whole = max((v.shape[1] for v in arrays if v.ndim == 2), default=1)
        count = self.count or whole
        names = self.names or tuple(str(k + 1) for k in range(whole))
        coordinates = self.coordinates or (None,) * len(names)
        found = (log, given, made, names, coordinates, count, rows, told, self.best)
        return Project(self.board, self.scene, *found, sweep=self.sweep)


def with_plans(wanted: Set[str]) -> set[str]:
    """Return places, with the plans of those that would else show nothing."""
    there = places()
    lone = [there[name][1].shows for name in wanted if name in there]
    return {*wanted, *chain.from_iterable(shown for shown in lone if not wanted & set(shown))}


def draws(scene: Scene, board: str) -> bool:
    """Whether a scene asks for anything that stands on a board."""
    if board == MECHANISM:
        return scene.mechanism is not None
    return any(calls_for(scene, one) for one in chapters(board))


def record(
    scene: Scene,
    board: str = MECHANISM,
    wanted: Set[str] | None = None,
    sizes: Mapping[str, float] | None = None,
    usual: Before | None = None,
) -> Project:
    """Record what the scene calls for on a board, or of that only what is ``wanted`` (places of a sheet).

    ``sizes``, ``usual``: see `Bench`.

    Raises
    ------
    SceneError
        If the board is the mechanism's, and the scene has none.
    StructureError
        If it cannot be drawn; the message names the scene.
    """
    if board == MECHANISM and scene.mechanism is None:
        says = said(
            "this scene has no mechanism, only sheets to draw: write [frame], [[link]] and [drive]"
        )
        raise SceneError(scene.source, (Fault("", 0, says),))
    bench = Bench(
        board, scene, with_plans(scene.called if wanted is None else wanted), sizes, usual
    )
    try:
        for chapter in bench.call():
            _refuse_other_drives(scene, chapter)
            bench.enter(chapter.name, Plan.of(chapter).record(bench))
        for chapter in in_order(board):
            if chapter.name in bench.recorded:
                bench.enter(aside(chapter.name), Plan.of(chapter).aside(bench))
    except StructureError as error:
        raise scene.located(error) from error
    return bench.project()


def _refuse_other_drives(scene: Scene, chapter: Chapter) -> None:
    """Refuse a chapter of a drive that it does not take."""
    mechanism, row, section = scene.mechanism, scene.row, chapter.asking
    if mechanism is None or not chapter.drive:
        return
    link, reason, crank = mechanism.drive.link, None, chapter.drive == CRANK
    if mechanism.further and crank:
        reason = said("{n} links are driven", n=len(mechanism.drives))
    elif mechanism.drive.slides and crank:
        reason = said("link {link} slides", link=link)
    elif mechanism.drive.rack and crank:
        reason = said("a rack turns link {link}", link=link)
    elif mechanism.drive.rates or mechanism.drive.gains:
        reason = said("the speed of link {link} changes", link=link)
    elif mechanism.at_rest:
        reason = said("link {link} stands still", link=link)
    elif row.ends is not None and crank:
        reason = said("the row of link {link} is no whole turn", link=link)
    elif row.places:
        reason = said("the places of link {link} are listed", link=link)
    if reason is not None:
        name = section.name if section is not None else chapter.name
        told = {"reason": reason, "name": name}
        raise StructureError(
            said(
                "it is drawn of a machine that one crank drives all round; here {reason}: leave [{name}] out, "
                "or drive a crank",
                **told,
            )
            if crank
            else said(
                "it is drawn of a row of even steps at one speed; here {reason}: leave [{name}] out, or give "
                "one speed, and from and to",
                **told,
            ),
            name,
            "drive.link",
            head=name,
        )


def own_boards(scene: Scene) -> tuple[str, ...]:
    """Return the boards other than the mechanism's on which a scene wants something drawn."""
    return tuple(one for one in boards() if one != MECHANISM and called_on(scene, one))


def called_on(scene: Scene, board: str) -> bool:
    """Whether a scene calls for something of a board."""
    there = (one for one in chapters(board) if one.name not in scene.left_out)
    own = {place.name for one in there for place in one.places}
    return bool(own & scene.called)
