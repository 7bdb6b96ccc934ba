"""What is asked of an engine: its forces position by position, the masses of its rod (SI, degrees)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import INTERVALS
from graphic_tmm.chapters.indicator.task import IndicatorTask
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Said, Section, combined_key, key
from graphic_tmm.scene.references import no_moving
from graphic_tmm.scene.tasks import SectionKey
from graphic_tmm.scene.units import SI

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


ENGINE = "engine"
VIEW = "engine"
CALCULATED = "engine-calculation"
"""The view of what is calculated beside."""
MASSES = "engine-masses"
"""The view of the sum of the masses that go to and fro."""
WORKS_VIEW = "engine-works"
"""The view of the works over a turn."""
HARMONICS = "harmonics"
TRANSFER = "engine-148"
TRANSFER_PLACE = "engine forces"
"""The place of the figure of all forces."""


@dataclass(frozen=True)
class EngineTask:
    """The forces of the crank mechanism of an engine, over the whole turn.

    Position by position, from the gas to the turning moment. ``point``: where the connecting rod meets the
    piston or crosshead. ``share``: of the rod's mass that goes to and fro with it; None for the exact split by
    the lever rule. ``mass``: the whole mass going to and fro (kg) where it is given so. ``series``: P_in by the
    two-term series instead of the plan of accelerations. ``unit``: of forces, "N" or "kgf". ``base``: the
    length of the diagrams' base, mm.
    """

    indicator: IndicatorTask
    point: str = key(v.LETTER, "the letter where the connecting rod meets the crosshead", "B")
    share: float | None = key(
        v.WITHIN,
        "share of the rod's mass that goes to and fro; left out: by the lever rule",
        0.25,
        None,
    )
    mass: float | None = key(v.MASS, "the whole mass that goes to and fro", "2.18 kgf*s^2/m", None)
    series: bool = combined_key(
        lambda said: said.inertia == "series",
        False,
        inertia=key(
            v.choice("plan", "series", план="plan", ряд="series"),
            "inertia from the plan, or by the two-term series",
            "plan",
            "plan",
        ),
    )
    unit: str = key(v.choice("N", "kgf", Н="N", кгс="kgf"), "the unit of forces", "kgf", "N")
    base: float = key(
        v.DRAWN, "length of the diagrams' base; if none is given, 180 mm on an A1", "120 mm", 120.0,
        fixes="size",
    )  # fmt: skip


ASKED: SectionKey[EngineTask] = SectionKey("engine")


def check(engine: Said, parts: Parts) -> Iterator[Flaw]:
    """What an engine needs besides its own section."""
    if engine.point not in parts.names.moving:
        yield Flaw(("engine", "point"), no_moving(engine.point, parts.names))
    if engine.unit == "kgf" and parts.head is not None and parts.head.units != SI:
        says = said(
            'forces are in pounds-force already; leave it out, or write units = "{si}"', si=SI
        )
        yield Flaw(("engine", "unit"), says)
    if "indicator" not in parts.doc:
        says = said("no pressures are given; write a section [indicator]")
        yield Flaw(("engine",), says)
    if len(parts.said.get("indicator") or ()) > 1:
        says = said(
            "these forces are those of one crank, rod and piston; leave one cylinder, or take [forces] and "
            "[flywheel]"
        )
        yield Flaw(("engine",), says)
    if parts.drive is not None and not INTERVALS.holds(parts.drive.count):
        says = said(
            "diagrams need {least} positions at least; write positions = 12 in [drive]",
            least=INTERVALS.least,
        )
        yield Flaw(("engine",), says)


SECTIONS = (
    Section(
        "engine", EngineTask, "the forces of an engine's crank mechanism",
        begin='point = "B"', check=check,
        joined=lambda others: {"indicator": others["indicator"]},
    ),
)  # fmt: skip
