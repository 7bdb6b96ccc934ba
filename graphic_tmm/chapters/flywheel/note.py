"""The section of a flywheel in a note: reduced moment, works, energies, J both ways, the rim; what follows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN, Flywheel
from graphic_tmm.chapters.flywheel.record import BESIDE, Aside
from graphic_tmm.chapters.flywheel.table import flywheel_columns, flywheel_results
from graphic_tmm.chapters.flywheel.task import ENERGY_MASS, FLYWHEEL, VIEWS, FlywheelTask
from graphic_tmm.chapters.flywheel.views import flywheel_views
from graphic_tmm.chapters.indicator.note import Worked, gas
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.table import kinematic_columns
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.drawn import Drawn, Results, single
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import columns, filled, heading, referred, result_number, results
from graphic_tmm.note.document import Block, Picture, Run, Runs, Symbol, Text, lettered
from graphic_tmm.note.figures import in_hand, is_figure, picture
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.position_count import told_off
from graphic_tmm.scene.chapter import chapters

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


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield what the flywheel has to be, by both methods, and what its rim does."""
    order = FLYWHEEL_PLAN.on(drawn).order
    yield from concluded(drawn, flywheel_results(drawn), order, language)


def concluded(
    drawn: Drawn, results: Results, order: FlywheelTask, language: str, section: str = ""
) -> Iterator[Runs]:
    """Yield it of the results of a flywheel as drawn."""
    _ = speaking(language)

    def sentence_runs(*sentences: str) -> Runs:
        put: dict[str, Run] = {
            name: result_number(drawn, results, name, language) for name in results
        }
        return filled(" ".join(map(_, sentences)), put)

    if "J_fly" not in results:
        return
    if order.J is not None:
        yield sentence_runs(*([KEPT] if "delta" in results else []))
    else:
        yield sentence_runs(BOTH if "J_fly_energy_mass" in results else ONE)
    if "J_apart" in results:
        yield sentence_runs(LESS if single(results)["J_apart"][0] >= 0.0 else MORE)
    if off := told_off(drawn, language):
        yield lettered("; ".join(off) + ".")
    if {"A_excess", "M_mean", "power"} <= set(results):
        yield sentence_runs(EXCESS)
    if {"D_e", "D_max", "J_made"} <= set(results):
        kept, wanted = single(results)["delta_made"][0], order.delta
        if wanted is None:
            yield sentence_runs(FAST)
        else:
            yield sentence_runs(FAST, HOLDS if kept <= wanted * (1.0 + NEAR) else MISSES)


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
BY_LOADS = said(
    "The loads of the links are reduced to the crank by their powers: their moment on the lever is a power, to "
    "scale. Inertia forces are none of them: they belong to the kinetic energies of the links."
)
READ = said("Read off the plans and the indicator diagram")
SIGNS = said(
    "In positions {drives} the moment drives and stands above the axis, in positions {resists} it resists and "
    "stands below."
)
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


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of a flywheel."""
    made = FLYWHEEL_PLAN.of(drawn)
    if made is not None:
        views = flywheel_views(in_hand(drawn), True)
        page = FlywheelPage(drawn, language, made, BESIDE.on(drawn), views)
        yield from page.blocks(list(flywheel_columns(drawn)), FLYWHEEL)


class FlywheelPage(Worked):
    """A flywheel as drawn, what was calculated beside it, its figures by name."""

    def __init__(
        self,
        drawn: Drawn,
        language: str,
        made: Flywheel,
        beside: Aside,
        views: Sequence[Drawing],
    ) -> None:
        super().__init__(drawn, language)
        self.made, self.beside = made, beside
        self.shown = {one.name: picture(one, language) for one in views if is_figure(one)}

    def blocks(self, found: Sequence[Column], chapter: str) -> Iterator[Block]:
        """Yield what is told; ``found``: the columns of the table of a ``chapter``."""
        yield self._aim(chapter)
        yield from self._reduced()
        yield from self._moment(found, chapter)
        yield from self._works()
        yield from self._energies()
        if self.made.energy_mass is not None:
            yield from self.view(ENERGY_MASS, self.figures(ENERGY_MASS))
        yield from self._compared()
        yield from self._rim()
        yield from columns(self.drawn, found, self.language)
        own = next(one for one in chapters() if one.name == chapter)
        yield from results(self.drawn, own, self.language)

    def _aim(self, chapter: str) -> Block:
        given = self.made.delta if self.made.order.J is None else self.made.inertia
        return self.says(
            AIM if self.made.order.J is None else AIM_J,
            delta=self.number(given),
            J=self.number(given),
        )

    def _reduced(self) -> Iterator[Block]:
        """What is reduced to the crank, and by what readings."""
        if self.made.energies is None:
            return
        if self.made.indicator is None:
            yield self.says(BY_LOADS)
            return
        velocities = KINEMATICS_PLAN.on(self.drawn).velocities
        assert velocities is not None
        ratio = f"v_{{{self.made.indicator.order.point}}}/v_{{{KINEMATICS_PLAN.on(self.drawn).structure.pin}}}"
        yield self.says(BY_GAS, mu=Symbol(velocities.mu.name), ratio=Symbol(ratio))
        yield from gas(self, FLYWHEEL)
        yield from self._readings()

    def _readings(self) -> Iterator[Block]:
        """The table of what is read: segments of the plans of velocities, pressures."""
        speeds = [one for one in kinematic_columns(self.drawn) if one.plan == VELOCITIES]
        gas_ = [one for one in flywheel_columns(self.drawn) if one.unit == "Pa"]
        some = [(one, True) for one in speeds if one.drawn and one.segment != "pa"]
        some += [(one, False) for one in gas_]
        places = [k for k in range(self.drawn.project.count) if k not in self.drawn.undrawn]
        yield self.upright("table-flywheel-readings", READ, some, places)

    def _moment(self, found: Sequence[Column], chapter: str) -> Iterator[Block]:
        """The graph of the moment over the cycle; where it drives, where it resists."""
        view = VIEWS["moment"]
        shown = self.figures(f"{chapter}-graphs")
        yield from self.view(view, shown)
        if self.beside.force is not None:
            yield from self.calculation(self.beside.force)
        signs = self._signs(next(one for one in found if one.segment == "M"))
        if signs is not None:
            drives, resists = signs
            yield self.says(SIGNS, drives=Text(drives), resists=Text(resists))
        turns = KINEMATICS_PLAN.of(self.drawn)
        if turns is not None and turns.turns > 1:
            yield self.says(CYCLE, turns=Text(str(turns.turns)))

    def _signs(self, column: Column) -> tuple[str, str] | None:
        """Return the positions where the moment drives and where it resists; None if it only does one."""
        values = column.without(self.drawn.undrawn).first_figures[1]
        driving = 1.0 if self.made.order.constant == "resisting" else -1.0
        there = [
            (name, value) for name, value in zip(self.drawn.names, values, strict=False) if value
        ]
        drives = [name for name, value in there if value * driving > 0]
        resists = [name for name, value in there if value * driving < 0]
        if not drives or not resists:
            return None
        return ", ".join(drives), ", ".join(resists)

    def _works(self) -> Iterator[Block]:
        constant = RESISTING if self.made.order.constant == "resisting" else DRIVING
        title = self.view(VIEWS["work"])
        yield next(title)
        yield self.says(STEADY, constant=Text(self.speech(constant)))
        yield from title

    def _energies(self) -> Iterator[Block]:
        """The energies of links and flywheel; the rim is told where it stands by itself."""
        rim, title = self.made.rim, self.view(VIEWS["energy"])
        yield next(title)
        yield self.says(SAME if self.made.energies is not None else ALONE)
        if rim is not None:
            self.hide(rim.limit, rim.inner, rim.mean, rim.mass, rim.width)
        yield from title

    def _compared(self) -> Iterator[Block]:
        """The mean moment, its power, the excess work, both moments of inertia beside one another."""
        own = self.beside
        yield heading(self.speech(POWER if own.apart is None else SECOND))
        yield from self.sentences(own.moment, own.power, own.excess, own.apart)

    def _rim(self) -> Iterator[Block]:
        """The sizes of the rim, its sketch, and what it does as it is made."""
        rim = self.made.rim
        if rim is None:
            return
        yield heading(self.speech(RIM))
        for mark in (rim.limit, rim.inner, rim.mean, rim.mass, rim.width):
            yield from self.again(mark)
            if mark == rim.limit:
                speed = self.drawn.construction.step(mark)
                assert speed is not None
                put = {"speed": speed.uses[0], "most": mark, "outer": rim.outer}
                yield self.says(LIMIT, {k: self.number(one) for k, one in put.items()})
        shown = self.figures("flywheel")
        if shown:
            yield referred(shown, self.language)
            yield from shown
        if self.beside.rim is not None:
            yield self.says(MADE)
            yield from self.sentences(*self.beside.rim)

    def figures(self, *names: str) -> tuple[Picture, ...]:
        """Return those of some figures that are drawn."""
        return tuple(self.shown[name] for name in names if name in self.shown)


NOTE = Noted(section=note, concludes=concludes)
