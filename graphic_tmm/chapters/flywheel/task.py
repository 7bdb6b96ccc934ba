"""What is asked of a flywheel (SI; drawn lengths in mm)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import Bound
from graphic_tmm.board.charts import STANDARD, ScaleOrder
from graphic_tmm.chapters.forces.task import turns_written
from graphic_tmm.chapters.indicator.task import IndicatorTask
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Said, Section, combined_key, key
from graphic_tmm.scene.quantities import kept
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


FLYWHEEL = "flywheel"
VIEWS = {"moment": "moment", "work": "work", "energy": "energy"}
CALCULATED = "flywheel-calculation"
"""The view of what is calculated beside."""
ENERGY_MASS = "energy-mass"
SKETCH = "sketch"
"""The role of the view of the wheel itself, and the name of its size."""


MATERIALS = {"steel": (110.0, 7800.0), "cast iron": (35.0, 7200.0)}
"""Limit of the rim's speed (m/s) and density (kg/m³) by material."""
SHAFT, STUD = 8.0, 28.0
"""Outer diameter of the rim over that of the shaft, and over that of the stud holes, where none is given."""

_CONSTANT = v.choice("resisting", "driving", сопротивления="resisting", движущий="driving")
_INTEGRATION = v.choice(
    "areas", "middles", "chords", площади="areas", середины="middles", хорды="chords"
)
_TANGENTS = v.choice("curve", "points", "none", кривая="curve", точки="points", нет="none")
APART, PROJECTED = "apart", "projected"
_LAID = v.choice(APART, PROJECTED, отдельно=APART, проекции=PROJECTED)
_MATERIAL = v.choice(*MATERIALS, сталь="steel", чугун="cast iron")


@dataclass(frozen=True)
class Rim:
    """A flywheel's rim: outer diameter (m), inner over outer, limit of speed (m/s), density (kg/m³).

    ``shaft`` (m), ``studs`` and their diameter (m) are for the sketch. ``inner``: the inner diameter (m) that
    is made, where it is not left as the ratio gives it.
    """

    outer: float
    ratio: float = 0.85
    speed_limit: float = 110.0
    density: float = 7800.0
    shaft: float = 0.055
    studs: int = 3
    stud: float = 0.016
    inner: float | None = None


def _rim(said: Said) -> Rim | None:
    if said.D_e is None:
        return None
    shaft = said.shaft or round(said.D_e / SHAFT, 3)
    stud = said.stud or round(said.D_e / STUD, 3)
    limit, density = MATERIALS[said.material]
    limits = kept(limit, "speed"), kept(density, "density")
    return Rim(said.D_e, said.ratio, *limits, shaft, said.studs, stud, said.D_i)


@dataclass(frozen=True)
class FlywheelTask:
    """The flywheel of a machine driven by the gas of the indicator diagram.

    It keeps the coefficient of irregularity ``delta``, or has the moment of inertia ``J`` (kg·m²), and what δ
    it keeps is found. ``indicator``: the gas forces of which diagram; None: by the loads of the links.

    ``turns``: of the crank in a cycle; None: as many as the strokes of the indicator diagram take.
    ``constant``: which moment is constant over the cycle, "resisting" or "driving". ``A``: the scale of the
    works, or the pole distance that gives it.
    ``integration``: mean ordinates, of the "areas" below the curve, its ordinates at the "middles" of the
    intervals, or those of "chords". ``tangents``: of the energy–mass curve, at the "curve" or at its "points"
    only; None leaves that method out.
    """

    indicator: IndicatorTask | None
    delta: float | None = key(
        v.number(Bound(0, 2, above=True, below=True), "ratio"),
        "coefficient of irregularity",
        0.04,
        None,
    )
    J: float | None = key(
        v.POSITIVE_INERTIA,
        "moment of inertia of the flywheel, instead of delta",
        "1.8 kg*m^2",
        None,
    )
    constant: str = key(_CONSTANT, "which moment is constant", "resisting", "resisting")
    A: ScaleOrder = combined_key(
        lambda said: ScaleOrder(pole=said.H),
        STANDARD,
        H=key(
            v.DRAWN, "pole distance of the integration", "40 mm", None,
            fixes="size",
        ),
    )  # fmt: skip
    turns: int | None = key(
        v.number(Bound(1, 2, whole=True)),
        "turns of the cycle: 2 of an engine with four strokes; left out: as the indicator diagram has it",
        2,
        None,
    )
    base: float = key(
        v.DRAWN, "length of the base for the whole cycle; if none is given, 180 mm on an A1", "120 mm", 120.0,
        fixes="size",
    )  # fmt: skip
    mu_M: float | None = key(v.mu("scale of moments"), "(N·m)/mm", "8 N*m/mm", None, fixes="size")
    integration: str = key(
        _INTEGRATION,
        "mean ordinates: of areas, at the middles of intervals, of chords",
        "areas",
        "areas",
    )
    tangents: str | None = combined_key(
        lambda said: None if said.tangents == "none" else said.tangents,
        "curve",
        tangents=key(_TANGENTS, "tangents of the energy–mass curve", "curve", "curve"),
    )
    energy_mass: str = key(
        _LAID,
        "how the energy–mass curve stands: apart, or projected: level with ΔT and under J turned by 90°",
        PROJECTED,
        APART,
    )
    rim: Rim | None = combined_key(
        _rim,
        None,
        D_e=key(v.POSITIVE_LENGTH, "outer diameter of the rim", "0.45 m", None),
        ratio=key(
            v.number(v.SHARE, "ratio"), "inner diameter of the rim over the outer", 0.85, 0.85
        ),
        D_i=key(
            v.POSITIVE_LENGTH, "inner diameter that is made, rounded from the ratio", "0.38 m", None
        ),
        material=key(_MATERIAL, "material of the rim", "steel", "steel"),
        shaft=key(v.POSITIVE_LENGTH, "diameter of the shaft", "55 mm", None),
        studs=key(v.number(Bound(1, 24, whole=True)), "how many stud holes", 3, 3),
        stud=key(v.POSITIVE_LENGTH, "their diameter", "16 mm", None),
    )


ASKED: SectionKey[FlywheelTask] = SectionKey("flywheel")


def check(flywheel: Said, parts: Parts) -> Iterator[Flaw]:
    """What a flywheel needs besides its own section."""
    yield from parts.intervals("flywheel")
    yield from aims(flywheel)
    yield from _cycle(flywheel, parts)
    if "indicator" not in parts.doc and "forces" not in parts.doc:
        says = said("nothing drives or resists; write a section [indicator], or loads and [forces]")
        yield Flaw(("flywheel",), says)


def _cycle(flywheel: Said, parts: Parts) -> Iterator[Flaw]:
    """A cycle of other turns than the working cycle of the cylinders, or the loads, has."""
    cylinders, loads = parts.said.get("indicator"), parts.said.get("load") or ()
    if flywheel.turns is None or ("indicator" in parts.doc and not cylinders):
        return
    by_loads = max((turns_written(load, parts) for load in loads if load is not None), default=1)
    if not cylinders and flywheel.turns > by_loads:
        says = said(
            "loads come back after a turn; write a section [indicator] with strokes = 4, or leave turns out"
        )
        yield Flaw(("flywheel", "turns"), says)
    elif cylinders and flywheel.turns != cylinders[0].strokes // 2:
        strokes = cylinders[0].strokes
        says = said(
            "the indicator diagram has {strokes} strokes, {turns} in a cycle; write strokes = {due} in "
            "[indicator], or leave turns out",
            strokes=strokes,
            turns=said("one turn") if strokes == 2 else said("two turns"),
            due=2 * flywheel.turns,
        )
        yield Flaw(("flywheel", "turns"), says)


def aims(flywheel: Said, section: str = "flywheel") -> Iterator[Flaw]:
    """What contradicts itself in what is sought: J of a given δ, or δ of a given J; the rim's diameters."""
    if flywheel.delta is None and flywheel.J is None:
        says = said("it is missing; write for example delta = 0.04, or J of the flywheel")
        yield Flaw((section, "delta"), says)
    if flywheel.delta is not None and flywheel.J is not None:
        says = said("delta is given already, and J follows from it; leave one of them out")
        yield Flaw((section, "J"), says)
    if flywheel.D_i is not None and flywheel.D_e is None:
        says = said("a rim has an outer diameter first; write D_e as well")
        yield Flaw((section, "D_i"), says)
    elif flywheel.D_i is not None and flywheel.D_i >= flywheel.D_e:
        says = said("it leaves no rim: make it smaller than D_e")
        yield Flaw((section, "D_i"), says)


def _defaults(flywheel: Said, parts: Parts) -> Iterator[str]:
    if "constant" not in parts.doc["flywheel"]:
        driving = flywheel.constant == "driving"
        yield said(
            "flywheel.constant: it is left out, so the {constant} moment is taken as constant; write "
            'constant = "resisting" for an engine, constant = "driving" for a machine that a motor drives',
            constant=said("driving", context="moment")
            if driving
            else said("resisting", context="moment"),
        )


SECTIONS = (
    Section(
        "flywheel", FlywheelTask, "the flywheel of a machine",
        begin="delta = 0.04", weighs=True, check=check,
        joined=lambda others: {"indicator": others["indicator"]},
        shows=lambda order: () if order.indicator else ("forces",), defaults=_defaults,
    ),
)  # fmt: skip
