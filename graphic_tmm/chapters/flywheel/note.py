"""The section of a flywheel in a note: reduced moment, works, energies, J both ways, the rim; what follows."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator, Sequence
from functools import partial
from typing import TypeVar

from graphic_tmm.chapters.flywheel.plan import Flywheel
from graphic_tmm.chapters.flywheel.record import BESIDE, Aside
from graphic_tmm.chapters.flywheel.task import ENERGY_MASS, VIEWS
from graphic_tmm.chapters.flywheel.views import FIGURES
from graphic_tmm.chapters.indicator.note import GasPage
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.table import kinematic_columns
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.drawn import single
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Block, Runs, Symbol, lettered
from graphic_tmm.note.figures import readable
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.readers.position_count import told_off

T = TypeVar("T")

BOTH = said(
    "The moment of inertia of the flywheel is {J_fly} by the change of kinetic energy and {J_fly_energy_mass}"
    " by the energy–mass diagram, which does not take the speed for even."
)
ONE = said("The moment of inertia of the flywheel is {J_fly}.")
KEPT = said("With its moment of inertia of {J_fly} the flywheel keeps δ = {delta}.")
LESS = said(
    "By the energy–mass diagram it is less by {J_apart}: the first method, which takes the energies of the "
    "links at the mean speed, is on the safe side."
)
MORE = said("By the energy–mass diagram it is greater: the methods differ by {J_apart}.")
EXCESS = said(
    "The largest excess work is {A_excess}; the mean moment of the cycle {M_mean}, the mean power {power}."
)
FAST = said("The rim, {D_e} across, stays below the {D_max} that its speed allows.")
HOLDS = said("Made in whole millimetres it has J = {J_made} and keeps δ = {delta_made}, as wanted.")
MISSES = said(
    "Made in whole millimetres it has J = {J_made} and keeps δ = {delta_made}, which differs from what is "
    "wanted: the width should be rounded up."
)
NEAR = 0.01
"""A δ that differs from the one wanted by no more than this share of it is that one: nobody reads better."""


AIM = said(
    "The moment of inertia of the flywheel is sought at which the coefficient of irregularity is δ = {delta}."
)
AIM_J = said(
    "The flywheel has the moment of inertia J = {J}; the coefficient of irregularity that it keeps is sought."
)
BY_GAS = said(
    "The force of the gas is reduced to the crank pin by its power, and the reduced moment is that force on "
    "the arm of the crank: M = P·({ratio})·l with P = p·F. The velocities are those of the plans: v = "
    "[pb]·{mu}."
)
ALIKE = said(
    "The force of the gas of cylinder {point} is reduced alike, with {ratio}; the reduced moments add up."
)
BY_LOADS = said(
    "The loads of the links are reduced to the crank by their powers: their moment on the lever is a power, to "
    "scale. Inertia forces are none of them: they belong to the kinetic energies of the links."
)
READ = said("Read off the plans and the indicator diagram")
SIGNS = {
    "resisting": said(
        "The moment drives and stands above the axis in {drives}; it resists and stands below in {resists}."
    ),
    "driving": said(
        "The moment resists and stands above the axis in {resists}; it drives and stands below in {drives}."
    ),
}
"""By the moment that is constant: the other one stands above the axis."""
IN_POSITIONS = said("position {at}", "positions {at}", context="in positions")
CYCLE = said(
    "The working cycle takes {turns} turns of the crank, so the base of the graphs stands for all of them; in"
    " later turns the mechanism stands as in the first one, but the gas is another."
)
STEADY = said(
    "In a cycle of steady motion both works are equal at its end. The {constant} moment is constant, so its "
    "work is the straight line from the beginning to the end of the other."
)
DRIVING, RESISTING = said("driving", context="moment"), said("resisting", context="moment")
SAME = said(
    "ΔT, the energy of the links and that of the flywheel stand on the same axes, to the same scale as the "
    "works."
)
ALONE = said("There are no links that have energies, so ΔT is the energy of the flywheel alone.")
RIM = said("The rim of the flywheel")
LIMIT = said(
    "A rim of this material may run at {speed} at most, so its outer diameter is {most} at most. For "
    "constructive reasons it is made {outer}."
)
MADE = said(
    "Made in whole millimetres the rim has other sizes than those calculated; what it does then:"
)
POWER = said("Mean moment, power, excess work")
SECOND = said("Mean moment, power, excess work; the two methods")


class SteadyPage(GasPage[T]):
    """A flywheel that keeps a cycle steady, whatever its moments come from."""

    @property
    @abstractmethod
    def flywheel(self) -> Flywheel:
        """The flywheel as recorded."""

    @property
    @abstractmethod
    def side_calculation(self) -> Aside:
        """What was calculated beside it."""

    def concludes(self) -> Iterator[Runs]:
        """Yield what the flywheel has to be, by both methods, and what its rim does."""
        results, order = self.results, self.flywheel.order
        if "J_fly" not in results:
            return
        if order.J is None:
            yield self.sentence(BOTH if "J_fly_energy_mass" in results else ONE)
        elif "delta" in results:
            yield self.sentence(KEPT)
        if "J_apart" in results:
            yield self.sentence(LESS if single(results)["J_apart"][0] >= 0.0 else MORE)
        if off := told_off(self.drawn, self.language):
            yield lettered("; ".join(off) + ".")
        if {"A_excess", "M_mean", "power"} <= set(results):
            yield self.sentence(EXCESS)
        if {"D_e", "D_max", "J_made"} <= set(results):
            kept, wanted = single(results)["delta_made"][0], order.delta
            if wanted is None:
                yield self.sentence(FAST)
            else:
                holds = kept <= wanted * (1.0 + NEAR)
                yield self.sentence((FAST, HOLDS if holds else MISSES))

    def blocks(self) -> Iterator[Block]:
        """Yield what is told of the flywheel."""
        yield self._aim()
        yield from self._reduced()
        yield from self._moment()
        yield from self._works()
        yield from self._energies()
        if self.flywheel.energy_mass is not None:
            yield from self.view(ENERGY_MASS, self.figures(ENERGY_MASS))
        yield from self._compared()
        yield from self._rim()
        yield from self.tabled()

    def _aim(self) -> Block:
        flywheel = self.flywheel
        if flywheel.order.J is None:
            return self.says(AIM, delta=flywheel.delta)
        return self.says(AIM_J, J=flywheel.inertia)

    def _reduced(self) -> Iterator[Block]:
        """What is reduced to the crank, and by what readings."""
        if self.flywheel.energies is None:
            return
        cylinder = self.flywheel.cylinder
        if cylinder is None:
            yield self.says(BY_LOADS)
            return
        plans = KINEMATICS_PLAN.on(self.drawn)
        velocities = plans.velocities
        assert velocities is not None
        for one in cylinder.every:
            ratio = f"v_{{{one.indicator.order.point}}}/v_{{{plans.structure.first.pin}}}"
            if one is cylinder:
                yield self.says(BY_GAS, mu=Symbol(velocities.mu.name), ratio=Symbol(ratio))
            else:
                yield self.says(ALIKE, point=one.tag, ratio=Symbol(ratio))
        yield from self.gas()
        yield from self._readings()

    def _readings(self) -> Iterator[Block]:
        """The table of what is read: segments of the plans of velocities, pressures."""
        speeds = [one for one in kinematic_columns(self.drawn) if one.plan == VELOCITIES]
        gas_ = [one for one in self.columns.values() if one.unit == "Pa"]
        some = [(one, True) for one in speeds if one.drawn and one.segment != "pa"]
        some += [(one, False) for one in gas_]
        places = [k for k in range(self.drawn.project.count) if k not in self.drawn.undrawn]
        yield self.upright("table-flywheel-readings", READ, some, places)

    def _moment(self) -> Iterator[Block]:
        """The graph of the moment over the cycle; where it drives, where it resists."""
        yield from self.view(VIEWS["moment"], self.figures(f"{self.chapter.name}-graphs"))
        if self.side_calculation.force is not None:
            yield from self.calculation(self.side_calculation.force)
        drives, resists = self._signs()
        if drives and resists:
            yield self.says(SIGNS[self.flywheel.order.constant], drives=drives, resists=resists)
        turns = KINEMATICS_PLAN.of(self.drawn)
        if turns is not None and turns.turns > 1:
            yield self.says(CYCLE, turns=turns.turns)

    def _signs(self) -> tuple[str, str]:
        """Return the positions where the moment drives and where it resists, "" where it does not."""
        values = self.columns["M"].without(self.drawn.undrawn).first_figures[1]
        driving = 1.0 if self.flywheel.order.constant == "resisting" else -1.0
        there = [
            (name, value * driving)
            for name, value in zip(self.drawn.names, values, strict=False)
            if value
        ]
        drives = [name for name, value in there if value > 0]
        resists = [name for name, value in there if value < 0]
        return self._positions(drives), self._positions(resists)

    def _positions(self, names: Sequence[str]) -> str:
        at = ", ".join(names)
        return self.speech(IN_POSITIONS, at=at, n=len(names)) if names else ""

    def _works(self) -> Iterator[Block]:
        constant = RESISTING if self.flywheel.order.constant == "resisting" else DRIVING
        title = self.view(VIEWS["work"])
        yield next(title)
        yield self.says(STEADY, constant=self.speech(constant))
        yield from title

    def _energies(self) -> Iterator[Block]:
        """The energies of links and flywheel; the rim is told where it stands by itself."""
        rim, title = self.flywheel.rim, self.view(VIEWS["energy"])
        yield next(title)
        yield self.says(SAME if self.flywheel.energies is not None else ALONE)
        if rim is not None:
            self.hide(rim.limit, rim.inner, rim.mean, rim.mass, rim.width)
        yield from title

    def _compared(self) -> Iterator[Block]:
        """The mean moment, its power, the excess work, both moments of inertia beside one another."""
        own = self.side_calculation
        yield self.head(POWER if own.apart is None else SECOND)
        yield from self.sentences(own.moment, own.power, own.excess, own.apart)

    def _rim(self) -> Iterator[Block]:
        """The sizes of the rim, its sketch, and what it does as it is made."""
        rim = self.flywheel.rim
        if rim is None:
            return
        yield self.head(RIM)
        for mark in (rim.limit, rim.inner, rim.mean, rim.mass, rim.width):
            yield from self.again(mark)
            if mark == rim.limit:
                speed = self.drawn.construction.step(mark)
                assert speed is not None
                yield self.says(LIMIT, speed=speed.uses[0], most=mark, outer=rim.outer)
        yield from self.leads(self.figures("flywheel"))
        if self.side_calculation.rim is not None:
            yield self.says(MADE)
            yield from self.sentences(*self.side_calculation.rim)


class FlywheelPage(SteadyPage[Flywheel]):
    """A flywheel of a mechanism."""

    @property
    def flywheel(self) -> Flywheel:
        """The flywheel as recorded."""
        return self.recorded

    @property
    def side_calculation(self) -> Aside:
        """What was calculated beside it."""
        return BESIDE.on(self.drawn)

    def views(self) -> list[Drawing]:
        """Return graphs, the energy-mass diagram, the rim."""
        return readable(self.drawn, *(partial(draw, lettered=True) for draw in FIGURES))


NOTE = Noted(FlywheelPage)
