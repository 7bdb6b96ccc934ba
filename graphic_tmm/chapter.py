"""A chapter of the book: what it asks of a scene, records on a board, shows on sheets.

A chapter is a folder of `graphic_tmm.chapters` whose package declares a `Chapter` called CHAPTER. It is found
by being there, and gone when its folder is. What a chapter is asked and what it made are got by keys (`Asked`,
`Made`) that stand beside its records. What it leaves out of its declaration it has nothing to say to.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, Protocol, TypeVar

from graphic_tmm.varied import NOTHING, Accuracy

if TYPE_CHECKING:
    import numpy as np

    from graphic_tmm.board.charts import Chart
    from graphic_tmm.board.doubt import Doubts
    from graphic_tmm.board.execute import Reading
    from graphic_tmm.board.findings import Finding
    from graphic_tmm.board.hand import Hand
    from graphic_tmm.board.record import Mark
    from graphic_tmm.board.scales import Scale
    from graphic_tmm.drawn import Drawn, Results
    from graphic_tmm.fitting.choice import Ledger
    from graphic_tmm.fitting.scales import Fitting
    from graphic_tmm.language.catalogue import Speech
    from graphic_tmm.moving import Between, Moving, Passed, Told, Turn
    from graphic_tmm.note.document import Block, Runs
    from graphic_tmm.paper.drawing import Drawing, Stroke, Wanted
    from graphic_tmm.project import Bench, Project
    from graphic_tmm.readers.columns import (
        Column,
    )
    from graphic_tmm.scene.declare import Section
    from graphic_tmm.scene.records import Scene

T = TypeVar("T")
MECHANISM = "mechanism"
"""The board on which everything is drawn that moves with the mechanism."""


@dataclass(frozen=True)
class Asked(Generic[T]):
    """What a section of a scene asks for, by the name of the section."""

    section: str

    def of(self, scene: Scene) -> T | None:
        """Return what the scene asks for; None if it has no such section."""
        found: T | None = scene.tasks.get(self.section)
        return found

    def put(self, scene: Scene, task: T | None) -> Scene:
        """Return the scene asking for ``task`` instead; None: not asking."""
        return scene.asking(**{self.section: task})


class Holder(Protocol):
    """What holds what chapters made: a bench while it is recorded, a project and a drawn board afterwards."""

    @property
    def made(self) -> Mapping[str, Any]:
        """What was made, by chapter."""


@dataclass(frozen=True)
class Made(Generic[T]):
    """What a chapter made on a board, by the name of the chapter."""

    chapter: str

    def of(self, holder: Holder) -> T | None:
        """Return what was made; None if the chapter was not called for."""
        found: T | None = holder.made.get(self.chapter)
        return found

    def on(self, holder: Holder) -> T:
        """Return what was made where it is known to have been."""
        found: T = holder.made[self.chapter]
        return found


def aside(chapter: str) -> str:
    """Return the name under which is held (see `Made`) what a chapter calculated beside its drawing."""
    return f"{chapter} aside"


@dataclass(frozen=True)
class Size:
    """How large something is drawn, by a name.

    ``usual``: room for it ``in_mm``, which sets the μ of a plan, or a share (1) of its usual room; what the
    formats of a scene's sheets suggest; ``small``: less, from where it may begin; ``unseen``: where no sheet
    shows it. ``least``: where this is reached, something else has to give way. ``cap``: what share of a sheet's
    height its views grow to, as far as the sheets have room; 0: it does not grow; ``step``: by how much at
    least at a time. ``seen``: whether what comes of it is seen in scale factors. ``extent``: what there is to
    draw, SI, of a board's reach. ``fixed``: the key by which a scene itself says how large it is, "" if it
    does not; ``freed``: the scene without saying so; ``remedy``: of a drawing made with a free size, what to
    write for the key. ``keys``: those of [scales] of which one fixes it.
    """

    name: str
    usual: Callable[[Scene], float] = lambda scene: 1.0
    in_mm: bool = False
    least: float = 0.0
    small: float = 0.0
    unseen: float = 0.0
    cap: float = 0.0
    step: float = 1.1
    seen: bool = True
    extent: Callable[[Mapping[str, Any]], float] = lambda reach: 0.0
    fixed: Callable[[Scene], str] = lambda scene: ""
    freed: Callable[[Scene], Scene] = lambda scene: scene
    remedy: Callable[[Drawn, str], str] = lambda drawn, key: ""
    keys: tuple[str, ...] = ()


SIZE = "size"
"""The unit of lengths that task sheets give in mm."""


class Given(NamedTuple):
    """What a scene gives, as the sheet of a task lists it: its symbol as marks bear it, its value and unit.

    Sizes of parts are in `SIZE`: as they are kept, told in mm or in inches.
    """

    symbol: str
    value: float | str
    unit: str = ""


class Listed(NamedTuple):
    """What a scene gives point by point, as a table: its title, its heads, its rows (mark-up)."""

    name: str
    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


class Posed(NamedTuple):
    """A mechanism in one position, for what acts on it to be shown.

    ``spot``: a letter and the number of its link -> where it stands (complex, mm) and which way it goes (of
    length 1, 0 where it stands still); KeyError if there is no such point. ``size``: of letters, mm.
    """

    spot: Callable[[str, int], tuple[complex, complex]]
    size: float


class Acting(NamedTuple):
    """What is shown to act on a mechanism: ink, and its letters, which want a place."""

    strokes: tuple[Stroke, ...]
    wanted: tuple[Wanted, ...]


class Scheme(NamedTuple):
    """A mechanism as the sheet of a task shows it, to what scale, m/mm (0: none); what is told below it."""

    view: Drawing
    mu: float
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Place:
    """What a sheet can show, by the name that scenes write.

    ``draw``: a drawn board, lettered? -> its views; ``plain``: a scene -> views that no board is needed for.
    ``rank``: where it stands on a sheet that does not say what stands there; 0 where only a sheet that names
    it shows it. ``shows``: the plans of which it shows something, ``beside``: those of which it does so where
    they are drawn; ``follows``: the plans whose μ its room depends on. ``together``: it is these places, one
    after the other. ``attends``: it stands behind this one even where no sheet asks for it; ``tells``: a part
    of another place stands behind this one, on the sheet that shows it. ``sizes``: a scene and the name of a
    view -> the sizes on which that depends, in the order in which they give way. ``asks``: how the sheet of a
    task asks for it, sentences in a language.
    """

    name: str
    rank: int
    draw: Callable[[Drawn, bool], list[Drawing]] = lambda drawn, lettered: []
    plain: Callable[[Scene], list[Drawing]] = lambda scene: []
    shows: tuple[str, ...] = ()
    beside: tuple[str, ...] = ()
    follows: tuple[str, ...] = ()
    together: tuple[str, ...] = ()
    attends: str = ""
    tells: str = ""
    sizes: Callable[[Scene, str], tuple[str, ...]] = lambda scene, view: ()
    asks: Callable[[Scene, str], Iterable[str]] = lambda scene, language: ()


def _no_plan(
    drawn: Drawn, plan: str, place: int, name: str, title: str, upon: Sequence[Stroke]
) -> Drawing:
    raise KeyError(plan)


@dataclass(frozen=True)
class Chapter:
    """What a chapter declares of itself; what it leaves out it has nothing to say to.

    **What it is.** ``number``: its place in the book, and in everything that is read. ``board``: on which board
    it stands, "" for none: then what it draws is told by a scene alone. ``builds_on``: the chapters whose marks
    it uses, which therefore record before it.

    **What is asked.** ``sections``: what scenes may write for it; ``asked``: whether a scene calls for it;
    ``always``: then it is recorded whatever sheets show. ``needs``: what else has to be recorded for it, by
    name: a chapter, or what another chapter understands. ``given``: what a scene gives for it, as the sheet
    of a task lists it; ``stated``: what it says besides in words, a sentence each in a language; ``listed``:
    what it gives point by point, as tables in a language. ``scheme``: what a task shows of it within a width
    and a height (complex, mm), without its solution; ``acting``: what is shown there to act on it.

    **What it records and draws.** ``record``: what it leaves on its board; ``aside``: of what it made, what is
    calculated beside it when everything on the board was recorded, in views of its own and used by nothing, so
    that no drawing changes for it; see `aside`. ``charts``: of what it made, the graphs on axes. ``places``:
    what sheets can show of it, ``sizes``: how large.

    ``result``: of what it made, the marks that are all known at some position where the chapter has a result;
    ``remedy``: why it has none where one of them is not, and what to do, behind its name.

    **Its scale factors.** ``reach``: what they go by, found once. ``plan_scales``: μ of the plans at a size,
    without drawing them. ``scales``: the values of its scale factors, put into what is given; ``choice``:
    enters how they were chosen. ``named``:
    further scale factors as drawn, by view, of those that were given a value; ``scale_key``: what machines
    call the scale factor of a view.

    **What goes wrong.** ``undrawn``: the positions that cannot be drawn; ``ranges``: the end of a sentence that
    tells those that can, and what helps. ``nothing``: by slot, where a figure has no meaning; ``coarse``: by
    slot, what leaves fewer digits of it. ``compared``: a finding, its positions -> what is told of it;
    ``findings``: findings of its own; ``warnings``: what else people are told.

    **What readers tell.** ``columns``, ``results``, ``facts``: what tables tell. ``plans``: what protocols call
    its plans, ``plans_rank``: where these stand among the plans of all chapters if not in the order of the book
    (ten a chapter); ``views``: the views of the board that each is drawn in. ``equations``: a view -> lines
    that stand before its protocol. ``captions``: what its views, plans, letters of columns and results are
    called, English, by name; ``called``: a view whose name it makes up -> what that is called in a language;
    ``titles``: a view -> what it is called in the protocol of what was made, where that tells more.
    ``note``: a drawn board, a language -> its section of the explanatory note; None: what the log tells of it;
    ``noted``: the places that it shows of, whatever sheets ask for;
    ``concludes``: what follows from its results, a sentence each; ``sources``: the books that it follows, as
    the note calls them; ``symbols``: its letters, what they stand for, their units.
    ``accuracy``: what it tells of its accuracy.

    **What moves with the crank.** ``between``: of a drawn board, at any angles of a turn, what its own given
    marks are there, and those that are read off what is drawn, not run again; ``moving``: the figures that it
    shows of one position, whichever it is. ``passed``: how well the mechanism passes its motion on
    over a turn; ``vectors``: the columns of the vectors that are measured on its plans. ``told``: what of it
    can be had at any angle; ``free``: the scene as it is recorded for that.

    **What a check reads.** ``pointed``: the plans of which readings may give points; ``plan_at``: such a plan
    in one position, lettered clear of what is drawn upon it. ``named_marks``: marks by plan and the name that
    machines read; ``speeds``: the marks that tell how fast the mechanism runs.
    """

    name: str
    number: int
    board: str = MECHANISM
    builds_on: tuple[str, ...] = ()
    places: tuple[Place, ...] = ()
    sections: tuple[Section, ...] = ()
    sizes: tuple[Size, ...] = ()
    asked: Callable[[Scene], bool] = lambda scene: False
    always: bool = False
    needs: Callable[[Scene], Mapping[str, Any]] = lambda scene: {}
    given: Callable[[Scene], Iterable[Given]] = lambda scene: ()
    stated: Callable[[Scene, str], Iterable[str]] = lambda scene, language: ()
    listed: Callable[[Scene, str], Iterable[Listed]] = lambda scene, language: ()
    scheme: Callable[[Scene, complex], Scheme | None] = lambda scene, room: None
    acting: Callable[[Scene, Posed], Iterable[Acting]] = lambda scene, posed: ()
    record: Callable[[Bench], Any] = lambda bench: None
    aside: Callable[[Bench], Any] = lambda bench: None
    charts: Callable[[Any], Iterable[Chart]] = lambda made: ()
    result: Callable[[Any], Iterable[Mark]] = lambda made: ()
    remedy: str = ""
    reach: Callable[[Project, Doubts], Any] = lambda project, doubts: None
    plan_scales: Callable[[Fitting], Mapping[str, Scale]] = lambda fitting: {}
    scales: Callable[[Fitting], Mapping[Mark, object]] = lambda fitting: {}
    choice: Callable[[Drawn, Ledger], None] = lambda drawn, ledger: None
    named: Callable[[Project, Reading, Container[Mark]], Mapping[str, Scale]] = (
        lambda project, reading, given: {}
    )
    scale_key: Callable[[str], str] = lambda view: ""
    undrawn: Callable[[Project, Reading], tuple[int, ...]] = lambda project, reading: ()
    ranges: Callable[[Project], tuple[str, str]] = lambda project: ("", "")
    nothing: Callable[[Project, Doubts], Mapping[int, np.ndarray]] = lambda project, doubts: {}
    coarse: Callable[[Project, Mapping[Mark, object], Hand], Mapping[int, Doubts]] = (
        lambda project, given, hand: {}
    )
    compared: Callable[[Drawn, Finding, set[int]], Finding] = lambda drawn, one, places: one
    findings: Callable[[Drawn], Iterable[Finding]] = lambda drawn: ()
    warnings: Callable[[Drawn, str], Iterable[str]] = lambda drawn, language: ()
    columns: Callable[[Drawn], Iterable[Column]] = lambda drawn: ()
    results: Callable[[Drawn], Results] = lambda drawn: {}
    facts: Callable[[Drawn], Mapping[str, Any]] = lambda drawn: {}
    plans: tuple[str, ...] = ()
    plans_rank: int = 0
    views: Callable[[Project], Mapping[str, Iterable[str]]] = lambda project: {}
    equations: Callable[[Drawn, str, str], Iterable[str]] = lambda drawn, view, language: ()
    pointed: tuple[str, ...] = ()
    plan_at: Callable[[Drawn, str, int, str, str, Sequence[Stroke]], Drawing] = _no_plan
    named_marks: Callable[[Project], Mapping[tuple[str, str], Mark]] = lambda project: {}
    speeds: Callable[[Project], Iterable[Mark]] = lambda project: ()
    captions: Mapping[str, str] = field(default_factory=dict)
    called: Callable[[str, Speech], str] = lambda view, speech: ""
    titles: Callable[[Holder, str, str], str] = lambda holder, view, language: ""
    note: Callable[[Drawn, str], Iterable[Block] | None] = lambda drawn, language: None
    noted: tuple[str, ...] = ()
    concludes: Callable[[Drawn, str], Iterable[Runs]] = lambda drawn, language: ()
    sources: tuple[str, ...] = ()
    symbols: tuple[tuple[str, str, str], ...] = ()
    accuracy: Accuracy = NOTHING
    between: Callable[[Drawn, Turn], Between] = lambda drawn, turn: {}
    moving: Callable[[Drawn], Iterable[Moving]] = lambda drawn: ()
    passed: Callable[[Project], Passed | None] = lambda project: None
    vectors: Callable[[Drawn], Iterable[Column]] = lambda drawn: ()
    told: Callable[[Project], Iterable[Told]] = lambda project: ()
    free: Callable[[Scene], Scene] = lambda scene: scene


_ADDED: list[Chapter] = []


@cache
def chapters(board: str | None = None) -> tuple[Chapter, ...]:
    """Return the chapters that there are, in the order of the book; only those of a ``board`` if it is told."""
    found = sorted((*_found(), *_ADDED), key=lambda chapter: chapter.number)
    return tuple(one for one in found if board is None or one.board == board)


def boards() -> tuple[str, ...]:
    """Return the boards on which chapters stand, in the order of the book."""
    return tuple(dict.fromkeys(one.board for one in chapters() if one.board))


@cache
def places() -> Mapping[str, tuple[Chapter, Place]]:
    """Return what sheets can show, by name, each with its chapter."""
    return {place.name: (one, place) for one in chapters() for place in one.places}


def _forget() -> None:
    chapters.cache_clear()
    places.cache_clear()


def in_order(board: str) -> tuple[Chapter, ...]:
    """Return the chapters of a board in the order in which they record: each behind those it builds on."""
    there = {one.name: one for one in chapters(board)}
    found: dict[str, Chapter] = {}

    def enter(one: Chapter) -> None:
        for name in one.builds_on:
            if name in there and name not in found:
                enter(there[name])
        found.setdefault(one.name, one)

    for one in there.values():
        enter(one)
    return tuple(found.values())


@cache
def _found() -> tuple[Chapter, ...]:
    book = import_module("graphic_tmm.chapters")
    rooms = sorted(module.name for module in pkgutil.iter_modules(book.__path__))
    return tuple(import_module(f"{book.__name__}.{room}").CHAPTER for room in rooms)


@cache
def whole_book() -> None:
    """Import all of every chapter, late as it may be: every operation and every formula is known then."""
    book = import_module("graphic_tmm.chapters")
    for module in pkgutil.walk_packages(book.__path__, f"{book.__name__}."):
        import_module(module.name)


@contextmanager
def added(chapter: Chapter) -> Iterator[None]:
    """Add a chapter that stands elsewhere, as long as the context lasts."""
    _ADDED.append(chapter)
    _forget()
    try:
        yield
    finally:
        _ADDED.remove(chapter)
        _forget()
