"""What a scene asks for, after reading: frozen records in SI, nothing of pydantic or TOML left."""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass, field
from itertools import chain
from typing import TYPE_CHECKING

from graphic_tmm.mechanism.records import Mechanism, Row

if TYPE_CHECKING:
    from graphic_tmm.chapters.cam.task import CamOrder
    from graphic_tmm.chapters.diagrams.task import KinematicOrder
    from graphic_tmm.chapters.engine.task import EngineOrder
    from graphic_tmm.chapters.flywheel.task import FlywheelOrder
    from graphic_tmm.chapters.forces.task import ForcesOrder
    from graphic_tmm.chapters.gears.task import GearOrder
    from graphic_tmm.chapters.planetary.task import PlanetaryOrder

FORCE_PLACES = ("forces", "lever", "force table")
"""What a sheet can show of forces."""
ENGINE_PLACES = ("engine", "engine diagrams")
"""What a sheet can show of an engine's forces."""
FREE_PLACES = ("lettering", "symbols")
"""What a sheet can show without a mechanism or a part."""
PART_PLACES = ("cam", "gears", "planetary")
"""What a sheet can show of parts that need no mechanism."""


SECTIONS: Mapping[str, tuple[str, ...]] = {
    "diagrams": ("diagrams",),
    "flywheel": ("flywheel",),
    "forces": FORCE_PLACES,
    "engine": ENGINE_PLACES,
    **{part: (part,) for part in PART_PLACES},
}
"""The sections that call for more than plans, and what a sheet can show of each."""
PLAN_PLACES = (
    "positions", "velocities", "accelerations", "equations",
    "diagrams", "flywheel", *FORCE_PLACES, *ENGINE_PLACES, "structure", "results",
)  # fmt: skip
"""What a sheet can show of a mechanism, in the order in which it stands on one that does not say."""
NEEDS: Mapping[str, tuple[str, ...]] = {
    "velocity table": ("velocities",),
    "acceleration table": ("accelerations",),
    **dict.fromkeys(("equations", "results"), ("velocities", "accelerations")),
}
"""The plans of which a place shows something."""
ALL_PLACES = (*PLAN_PLACES, *PART_PLACES)
"""What stands on a sheet that does not say what does, of what the scene calls for."""


def with_plans(places: Set[str]) -> set[str]:
    """Return places, with the plans of those that would else show nothing."""
    lone = [plans for place, plans in NEEDS.items() if place in places and not places & set(plans)]
    return {*places, *chain.from_iterable(lone)}


@dataclass(frozen=True)
class Scales:
    """What the scene fixes of its scale factors; None is left to the choice of a standard μ.

    ``mu_l`` in m/mm, ``mu_v`` in (m/s)/mm, ``mu_a`` in (m/s²)/mm; ``mu_v_is_mu_l_omega`` asks for
    μ_v = μ_l·ω1 (so that pa = OA). ``OA``, ``pa``, ``pi_a`` fix the drawn length in mm of the
    crank, of its pin's velocity and its acceleration instead. At most one of each family is set.
    """

    mu_l: float | None = None
    mu_v: float | None = None
    mu_a: float | None = None
    mu_v_is_mu_l_omega: bool = False
    OA: float | None = None
    pa: float | None = None
    pi_a: float | None = None


@dataclass(frozen=True)
class SheetOrder:
    """One sheet: its format ("A1", "A1 portrait", "A4"), and the plans placed on it, in order."""

    format: str = "A1"
    place: tuple[str, ...] = ("positions", "velocities", "accelerations")


@dataclass(frozen=True)
class Task:
    """A mechanism found from a task: its kind ("rocker"), and what was given (SI)."""

    kind: str
    given: Mapping[str, float]


@dataclass(frozen=True)
class Scene:
    """A scene: the mechanism, its motion, the plans wanted and the sheets they are placed on.

    ``common_pole``: the velocity plans of all positions have one pole. ``main``: the number of the position
    drawn in heavy lines. ``behind``: the teeth of the pair of gears behind the planetary train. ``remarks``:
    what of the file comes to nothing, and defaults that matter, a line each. ``told``: the keys that the file
    writes in its sections, as section.key.
    """

    source: str
    title: str
    language: str
    mechanism: Mechanism | None = None
    row: Row = field(default_factory=Row)
    turned: bool = False
    common_pole: bool = False
    diagrams: KinematicOrder | None = None
    flywheel: FlywheelOrder | None = None
    forces: ForcesOrder | None = None
    engine: EngineOrder | None = None
    cam: CamOrder | None = None
    gears: GearOrder | None = None
    planetary: PlanetaryOrder | None = None
    behind: tuple[int, ...] = ()
    main: str | None = None
    trajectories: tuple[str, ...] = ()
    scales: Scales = field(default_factory=Scales)
    ruler: float | None = 0.1
    hand: str = "exact"
    seed: int = 0
    sheets: tuple[SheetOrder, ...] = (SheetOrder(),)
    title_block: Mapping[str, str] = field(default_factory=dict)
    task: Task | None = None
    remarks: tuple[str, ...] = ()
    told: frozenset[str] = frozenset()

    @property
    def shown(self) -> frozenset[str]:
        """What the sheets show: their places."""
        return frozenset(place for sheet in self.sheets for place in sheet.place)

    @property
    def called(self) -> frozenset[str]:
        """What the scene calls for, whether or not a sheet shows it: places of its sections, and plans."""
        found = {place for name in SECTIONS if getattr(self, name) for place in SECTIONS[name]}
        if self.row.accelerations:
            found.add("accelerations")
        return self.shown | found
