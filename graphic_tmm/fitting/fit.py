"""How large things are drawn: as large as the sheets ordered hold, or on as few more as they need.

What is drawn has its usual size. Where a view fits no sheet of its format, what its size depends on is made
smaller until it does; then what can grow grows as far as the sheets have room.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from dataclasses import replace

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapter import MECHANISM, Size, chapters, places
from graphic_tmm.drawn import Drawn, doubted
from graphic_tmm.errors import ViewError
from graphic_tmm.fitting.measuring import Cells, TooLarge, Trial, in_mm, needed, shares, too_large
from graphic_tmm.fitting.scales import Fitting, Sizes, executed, reach_of, usual
from graphic_tmm.project import Project, record
from graphic_tmm.scene.records import Scene

MEASURABLE = 40.0
"""What grows is no shorter, mm, if the choice of μ is free and a sheet holds it. Half a division of 0.5 mm is
0.6 % of that."""
NO_DOUBTS = Doubts((), {})
STEP, TRIALS = 0.93, 40
"""By how much at least a size gives way at a time; how often. All of them leave a twentieth."""


def fitted(
    scene: Scene,
    *,
    others: Sequence[Drawn] = (),
    exact: bool = False,
    wanted: Set[str] | None = None,
) -> Drawn:
    """Draw a mechanism with its plans as large as fit on the sheets ordered, or on as few more as they need.

    Every reader of a scene takes this μ, so that a table speaks of the sheet that is drawn. ``others``: boards
    that stand on the sheets too; ``wanted``: places of sheets, if not all is drawn that the scene calls for.
    """
    whole = record(scene)
    project = whole if scene.called == scene.shown else record(scene, wanted=scene.shown)
    trials = _Trials(scene, project, others)
    least = trials.held(trials.least())
    most = max(len(scene.sheets), trials.count(least))
    growing = [size for size in _sizes(project).values() if size.rooms]
    rooms = (
        {**least, **{size.name: max(room, least[size.name]) for size in growing}}
        for room in (growing[0].rooms if growing else ())
    )
    sizes: Sizes = next((found for found in rooms if trials.count(found) <= most), least)
    for size in reversed(growing):
        for room in reversed([r for r in size.rooms if r > sizes[size.name]]):
            larger = {**sizes, size.name: room}
            sizes = larger if trials.count(larger) <= most else sizes
    sizes, drawn = trials.by_hand(sizes)
    final = whole
    if wanted is not None:
        final = project if wanted == scene.shown else record(scene, wanted=wanted)
    if final is not project:
        return trials.final(final, sizes, exact)
    return trials.draw(sizes) if exact else drawn


def fitted_part(
    scene: Scene, board: str, *, exact: bool = False, wanted: Set[str] | None = None
) -> Drawn | None:
    """Draw a part on a board of its own in the usual size, or as much smaller as its sheets need.

    None if it is not ``wanted`` (places of sheets); whether it can be made is found out nevertheless.

    Raises
    ------
    StructureError
        If it cannot be made.
    """
    project = record(scene, board)
    own = {place.name for one in chapters(board) for place in one.places}
    if wanted is not None and not own & wanted:
        return None
    sizes: Sizes = usual(scene)
    normal = drawn = executed(project, sizes, reach_of(project, NO_DOUBTS), None, exact=True)
    for _ in range(TRIALS):
        less = _smaller(too_large(scene, Trial.of(drawn), {}), sizes, scene)
        if less == sizes:
            break
        sizes, shares = less, {name: share for name, share in less.items() if share < 1.0}
        project = record(scene, board, sizes=shares, usual=normal)
        drawn = executed(project, sizes, reach_of(project, NO_DOUBTS), None, exact=True)
    return (
        drawn
        if exact
        else executed(project, sizes, reach_of(project, NO_DOUBTS), None, exact=False)
    )


def _sizes(project: Project) -> dict[str, Size]:
    return {size.name: size for one in project.chapters for size in one.sizes}


class _Trials:
    """The sizes that are tried of one mechanism, with the exact hand; each μ is drawn and measured once."""

    def __init__(self, scene: Scene, project: Project, others: Sequence[Drawn]) -> None:
        self.scene, self.project, self.others = scene, project, others
        self.doubts = doubted(project)
        self.reach = reach_of(project, self.doubts)
        self.cells: Cells = {}
        self.drawn: dict[tuple[float, ...], Drawn] = {}
        self.counts: dict[tuple[float, ...], float] = {}

    def factors(self, sizes: Sizes) -> tuple[float, ...]:
        """What a drawing depends on: μ of the plans, the sizes of all else."""
        return (*(scale.value for scale in self.scales(sizes).values()), *shares(sizes))

    def scales(self, sizes: Sizes) -> Mapping[str, Scale]:
        """Return μ of the plans."""
        return Fitting(self.project, sizes, self.reach).plan_scales()

    def trial(self, sizes: Sizes) -> Trial:
        """Return a drawing that is made when something of it has to be measured."""
        return Trial(MECHANISM, self.scales(sizes), sizes, lambda: self.draw(sizes))

    def draw(self, sizes: Sizes) -> Drawn:
        """Return the drawing with these sizes."""
        key = self.factors(sizes)
        if key not in self.drawn:
            self.drawn[key] = executed(self.project, sizes, self.reach, self.doubts, exact=True)
        return self.drawn[key]

    def final(self, project: Project, sizes: Sizes, exact: bool) -> Drawn:
        """Return what is drawn in the end, with the sizes found; of more than the sheets show, too."""
        doubts, reach = self.doubts, self.reach
        if project is not self.project:
            doubts = doubted(project)
            own = reach_of(project, doubts)
            reach = {name: _joined(self.reach.get(name), more) for name, more in own.items()}
        return executed(project, sizes, reach, doubts, exact=exact)

    def count(self, sizes: Sizes) -> float:
        """Return how many sheets the plans take; without end if one of them fits none."""
        key = self.factors(sizes)
        if key not in self.counts:
            try:
                self.counts[key] = needed(self.scene, self.trial(sizes), self.others, self.cells)
            except ViewError:
                self.counts[key] = math.inf
        return self.counts[key]

    def least(self) -> Sizes:
        """Return the usual sizes, with the least room for what grows at which it can be measured."""
        found = usual(self.scene)
        for size in _sizes(self.project).values():
            if size.rooms:
                rooms = [{**found, size.name: room} for room in reversed(size.rooms)]
                enough = (sizes for sizes in rooms if self._longest(size, sizes) >= MEASURABLE)
                found = next(enough, found)
        return found

    def _longest(self, size: Size, sizes: Sizes) -> float:
        scales = self.scales(sizes)
        found = size.extent(self.reach)
        known = size.name in scales and found > 0.0
        return found / scales[size.name].value if known else math.inf

    def held(self, sizes: Sizes) -> Sizes:
        """Return sizes at which a sheet holds every view, as far as the scene leaves them free."""
        for _ in range(TRIALS):
            found = too_large(self.scene, self.trial(sizes), self.cells)
            less = _smaller(found, sizes, self.scene)
            if less == sizes:
                break
            sizes = less
        return sizes

    def by_hand(self, sizes: Sizes) -> tuple[Sizes, Drawn]:
        """Return the drawing by the scene's own hand, and its sizes.

        Near a singular position a rounded reading may make a plan much larger than it is: it gives way too.
        """
        plans = in_mm()
        orders = (
            replace(order, place=tuple(place for place in order.place if place in plans))
            for order in self.scene.sheets
        )
        scene = replace(self.scene, sheets=tuple(orders))
        for _ in range(TRIALS):
            drawn = self.final(self.project, sizes, exact=False)
            less = _smaller(too_large(scene, Trial.of(drawn), {}), sizes, self.scene)
            if less == sizes:
                break
            sizes = less
        return sizes, drawn


def _joined(tried: object, more: object) -> object:
    """Return the reach that was tried, where it is there, and what else there is."""
    if not isinstance(tried, tuple) or not isinstance(more, tuple):
        return more
    make: Callable[..., object] = type(more)
    return make(*(one or other for one, other in zip(tried, more, strict=True)))


def _smaller(found: Iterable[TooLarge], sizes: Sizes, scene: Scene) -> Sizes:
    """Return sizes of which those that views too large depend on have given way."""
    known = {size.name: size for one in chapters() for size in one.sizes}
    way: dict[str, float] = {}
    for one in found:
        names = depends(one.place, one.view, scene)
        name = next((n for n in names if sizes[n] > known[n].least), None)
        if name is not None:
            way[name] = min(way.get(name, STEP), one.share)
    return {**sizes, **{name: sizes[name] * share for name, share in way.items()}} if way else sizes


def depends(place: str, view: str, scene: Scene) -> tuple[str, ...]:
    """Return the sizes, left free by the scene, that a view depends on, in the order in which they give way."""
    if view.startswith("table"):
        return ()
    known = {size.name: size for one in chapters() for size in one.sizes}
    names = places()[place][1].sizes(scene, view)
    return tuple(name for name in names if not known[name].fixed(scene))
