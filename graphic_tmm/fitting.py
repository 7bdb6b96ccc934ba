"""How large things are drawn: as large as the sheets ordered hold, or on as few more as they need.

What is drawn has its usual size. Where a view fits no sheet of its format, what its size depends on is made
smaller until it does; then the plans of velocities and accelerations grow as far as the sheets have room.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence, Set
from dataclasses import replace
from typing import TYPE_CHECKING

from graphic_tmm.board.scales import Scale
from graphic_tmm.errors import ViewError
from graphic_tmm.parts import Part, draw_parts, free_sizes, resized
from graphic_tmm.project import Project
from graphic_tmm.scaling import Extents, Sizes, choose_scales, extents
from graphic_tmm.scene.records import Scene
from graphic_tmm.work import Work, doubted, executed, hand_of, record, usual

if TYPE_CHECKING:
    from graphic_tmm.paper.measuring import Cells, TooLarge, Trial

VECTORS = (150.0, 125.0, 100.0, 80.0, 65.0, 50.0)
"""Room for the longest vector of a plan, mm: as much as the sheets hold."""
MEASURABLE = 40.0
"""The longest vector of a plan is no shorter, mm, if the choice of μ is free and a sheet holds it."""
STEP, TRIALS = 0.93, 40
"""By how much at least a size gives way at a time; how often."""
LEAST = {"groups": 0.25, "graphs": 0.2, "forces": 0.1, "lever": 0.05, "engine": 0.5}
"""The least shares; where they are reached something else has to give way."""
PLANS = {
    "positions": ("mu_l", "OA"),
    "velocities": ("mu_v", "pa"),
    "accelerations": ("mu_a", "pi_a"),
}
"""The keys of [scales] that fix the size of a plan."""
FIGURES = ("cam profile", "cam centre", "profile", "centre")
"""What is drawn of a cam besides graphs."""


def fitted(
    scene: Scene,
    *,
    parts: Sequence[Part] = (),
    exact: bool = False,
    wanted: Set[str] | None = None,
) -> Work:
    """Draw a scene with its plans as large as fit on the sheets ordered, or on as few more as they need.

    Every reader of a scene takes this μ, so that a table speaks of the sheet that is drawn. ``parts`` stand on
    the sheets too; ``wanted`` as in `make`.
    """
    whole = record(scene)
    project = whole if scene.called == scene.shown else record(scene, scene.shown)
    trials = _Trials(scene, project, parts)
    least = trials.held(trials.least())
    most = max(len(scene.sheets), trials.count(least))
    rooms = (
        least._replace(
            velocities=max(r, least.velocities), accelerations=max(r, least.accelerations)
        )
        for r in VECTORS
    )
    sizes = next((found for found in rooms if trials.count(found) <= most), least)
    for plan in ("accelerations", "velocities"):
        for room in reversed([r for r in VECTORS if r > getattr(sizes, plan)]):
            larger = sizes._replace(**{plan: room})
            sizes = larger if trials.count(larger) <= most else sizes
    sizes, drawn = trials.by_hand(sizes)
    final = whole if wanted is None else project if wanted == scene.shown else record(scene, wanted)
    if final is not project:
        return trials.final(final, sizes, exact)
    return trials.work(sizes) if exact else drawn


class _Trials:
    """The sizes that are tried of one scene, with the exact hand; each μ is drawn and measured once."""

    def __init__(self, scene: Scene, project: Project, parts: Sequence[Part]) -> None:
        self.scene, self.project, self.parts = scene, project, parts
        self.doubts = doubted(project)
        self.reach: Extents = extents(project, self.doubts)
        self.cells: Cells = {}
        self.drawn: dict[tuple[float, ...], Work] = {}
        self.counts: dict[tuple[float, ...], float] = {}

    def factors(self, sizes: Sizes) -> tuple[float, ...]:
        """What a drawing depends on: μ of the plans, the sizes of all else."""
        return (*(scale.value for scale in self.scales(sizes).values()), *sizes.shares)

    def scales(self, sizes: Sizes) -> dict[str, Scale]:
        """Return μ of the plans."""
        return choose_scales(self.project, self.scene.scales, sizes, self.reach)

    def trial(self, sizes: Sizes) -> Trial:
        """Return a drawing that is made when something of it has to be measured."""
        from graphic_tmm.paper.measuring import Trial

        return Trial(self.scales(sizes), sizes, lambda: self.work(sizes))

    def work(self, sizes: Sizes) -> Work:
        """Return the drawing with these sizes."""
        key = self.factors(sizes)
        if key not in self.drawn:
            self.drawn[key] = executed(
                self.scene, self.project, sizes, self.reach, self.doubts, exact=True
            )
        return self.drawn[key]

    def final(self, project: Project, sizes: Sizes, exact: bool) -> Work:
        """Return what is drawn in the end, with the sizes found; of more than the sheets show, too."""
        doubts, reach = self.doubts, self.reach
        if project is not self.project:
            doubts = doubted(project)
            own = extents(project, doubts)
            reach = Extents(*(tried or more for tried, more in zip(reach, own, strict=True)))
        return executed(self.scene, project, sizes, reach, doubts, exact=exact)

    def count(self, sizes: Sizes) -> float:
        """Return how many sheets the plans take; without end if one of them fits none."""
        from graphic_tmm.paper.measuring import needed

        key = self.factors(sizes)
        if key not in self.counts:
            try:
                made = needed(self.scene, self.trial(sizes), self.parts, self.cells)
                self.counts[key] = made
            except ViewError:
                self.counts[key] = math.inf
        return self.counts[key]

    def least(self) -> Sizes:
        """Return the usual sizes, with the least room for vectors at which the plans can be measured."""
        found = usual(self.scene)
        for plan in ("velocities", "accelerations"):
            rooms = [found._replace(**{plan: room}) for room in reversed(VECTORS)]
            enough = (sizes for sizes in rooms if self._longest(plan, sizes) >= MEASURABLE)
            found = next(enough, found)
        return found

    def _longest(self, plan: str, sizes: Sizes) -> float:
        scales = self.scales(sizes)
        found = float(getattr(self.reach, plan))
        return found / scales[plan].value if plan in scales and found > 0.0 else math.inf

    def held(self, sizes: Sizes) -> Sizes:
        """Return sizes at which a sheet holds every view, as far as the scene leaves them free."""
        from graphic_tmm.paper.measuring import too_large

        for _ in range(TRIALS):
            found = too_large(self.scene, self.trial(sizes), self.parts, self.cells)
            less = _smaller(found, sizes, self.scene)
            if less == sizes:
                break
            sizes = less
        return sizes

    def by_hand(self, sizes: Sizes) -> tuple[Sizes, Work]:
        """Return the drawing by the scene's own hand, and its sizes.

        Near a singular position a rounded reading may make a plan much larger than it is: it gives way too.
        """
        from graphic_tmm.paper.measuring import Trial, too_large

        orders = (
            replace(order, place=tuple(place for place in order.place if place in PLANS))
            for order in self.scene.sheets
        )
        plans = replace(self.scene, sheets=tuple(orders))
        for _ in range(TRIALS):
            drawn = self.final(self.project, sizes, exact=False)
            less = _smaller(too_large(plans, Trial.of(drawn), (), {}), sizes, self.scene)
            if less == sizes:
                break
            sizes = less
        return sizes, drawn


def _smaller(found: Iterable[TooLarge], sizes: Sizes, scene: Scene) -> Sizes:
    """Return sizes of which those that views too large depend on have given way."""
    way: dict[str, float] = {}
    for one in found:
        names = depends(one.place, one.view, scene)
        name = next((n for n in names if getattr(sizes, n) > LEAST.get(n, 0.0)), None)
        if name is not None:
            way[name] = min(way.get(name, STEP), one.share)
    return sizes._replace(**{name: getattr(sizes, name) * share for name, share in way.items()})


def depends(place: str, view: str, scene: Scene) -> tuple[str, ...]:
    """Return the sizes, left free by the scene, that a view depends on, in the order in which they give way."""
    if place in PLANS:
        names: tuple[str, ...] = (place,)
        if place == "velocities" and scene.scales.mu_v_is_mu_l_omega:
            names = ("positions",)
    elif view.startswith("table") or place == "equations":
        return ()
    elif place == "forces" and not view.startswith("indicator"):
        names = ("groups", "positions") if view.startswith("group") else ("forces",)
    elif place == "engine" and not view.startswith("indicator"):
        names = ("engine", "positions")
    else:
        other = {"lever": "lever", "flywheel": "sketch"}
        names = (other.get(view.partition("-")[0], "graphs"),)
    return tuple(name for name in names if not fixed(name, scene))


def fixed(name: str, scene: Scene) -> bool:
    """Whether the scene itself says how large something is."""
    if name in PLANS:
        return any(getattr(scene.scales, key) for key in PLANS[name])
    return (
        name == "forces"
        and scene.tasks.get("forces") is not None
        and scene.tasks["forces"].mu is not None
    )


def fitted_parts(
    scene: Scene, *, exact: bool = False, wanted: Set[str] | None = None
) -> tuple[Part, ...]:
    """Draw the parts that the scene calls for, or of them only those that are ``wanted`` (see `draw_parts`).

    They have the usual size, or are as much smaller as their sheets need.

    Raises
    ------
    StructureError
        If a part cannot be made.
    """
    from graphic_tmm.paper.measuring import too_large

    usual_ones = parts = draw_parts(scene, exact=True, wanted=wanted)
    sizes: dict[str, float] = {}
    for _ in range(TRIALS):
        way: dict[str, float] = {}
        for one in too_large(scene, None, parts, {}):
            name = part_size(one.place, one.view)
            if name in free_sizes(scene, one.place):
                way[name] = min(way.get(name, 1.0), one.share)
        if not way:
            break
        sizes |= {name: sizes.get(name, 1.0) * min(share, STEP) for name, share in way.items()}
        parts = tuple(resized(part, sizes) for part in usual_ones)
    return parts if exact else tuple(part.drawn_by(hand_of(scene)) for part in parts)


def part_size(place: str, view: str) -> str:
    """Return what the size of a part's view is called: its part, or the graphs of a cam; "" for a table."""
    if view.startswith("table"):
        return ""
    return "cam graphs" if place == "cam" and not view.startswith(FIGURES) else place
