"""The section of an engine in a note, as the book goes: gas, transfer, couples, inertia, works; results."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from itertools import pairwise

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.engine.plan import Engine
from graphic_tmm.chapters.engine.record import BESIDE, WORKS
from graphic_tmm.chapters.engine.task import (
    CALCULATED,
    HARMONICS,
    MASSES,
    TRANSFER,
    TRANSFER_PLACE,
    VIEW,
    WORKS_VIEW,
)
from graphic_tmm.chapters.engine.views import engine_diagram_views, engine_views, transfer_views
from graphic_tmm.chapters.indicator.note import GasPage
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import single
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.note.bricks import columns
from graphic_tmm.note.document import Block, Item, Listed, Runs, Symbol
from graphic_tmm.note.figures import picture, readable
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.drawing import GRAPH, Drawing

GAS = said(
    "The motion to and fro of the piston becomes an even turning of the shaft through the forces that the "
    "mechanism passes on; what drives it is the pressure on the piston."
)
BOTH_SIDES = said(
    "Its force is the difference of the forces on both sides, each the pressure from the indicator diagram "
    "times its area, formula (338); it is positive towards the crank."
)
TRANSFER_HEADING, FIVE = said("Transfer of forces"), said("What acts on the machine")
PASSED = said(
    "In position {position} the force {force} acts along the cylinder on the crosshead. It slides between "
    "guides and is hinged to the rod, so that this force can go to the rod and to the guides only."
)
AT_B = said(
    "The rod, hinged at both ends, takes a force along itself only; the guide, without friction, presses "
    "square to itself. So P′ is resolved into Q along the rod and N square to the guide, the pressure on it. "
    "N = P′·tan β is nought where β is, and grows with λ = R/l, as β does."
)
AT_A = said(
    "Q may be carried along its line from B to A, to the crank pin. There it is resolved into T square to the"
    " crank, which turns it and is tangential to the circle of A, and K along the crank, which only stretches"
    " or presses it. The angle between rod and crank is φ + β, an outer angle of the triangle OAB."
)
AT_O = said(
    "At the bearing O two forces are added that balance one another, Q and −Q. −Q and the force Q on the "
    "crank pin are a couple with the arm h = R·sin(φ + β). The force Q that is left is resolved into P′ along"
    " the cylinder and −N across it; −N and N on the guide are a couple with the arm OB."
)
WITH_INERTIA = said("P′ is the force of the gas with that of the inertia, which is found below.")
ON_COVER = said("on the cylinder acts the pressure on its cover, −P = {force};")
ON_BEARING = said(
    "on the bearings of the shaft, along the cylinder, acts P′ = {force}, the force on the crosshead;"
)
BY_COUPLE = said("the crank is turned by the couple Q, −Q with Q = {force}: M = {moment};")
ON_GUIDE = said("on the guide acts the pressure N = {force};")
BACK = said("on the bearings, across the cylinder, acts −N, equal to it and opposite.")
FRAME = said(
    "P and −P are in balance where one frame joins cylinder and bearings; they do not reach the foundation "
    "then. N and −N are a couple with the arm OB = {arm} that tips the frame against the turning of the "
    "crank: M′ = −M. M is balanced by the moment of the machine that is driven, M′ by that of the base. All "
    "this holds for a level cylinder, an upright one and an inclined one."
)
INERTIA = said("Inertia of the moving parts")
METHOD = said(
    "The parts do not move evenly. In dynamics the acceleration of a mass centre is the sum of the forces "
    "divided by the mass, formula (345). The other way is that of kinetostatics: the parts are stopped in "
    "thought, and to the real forces is added {P_in} = −m·a, formula (346), so that their sum is nought, "
    "formula (347)."
)
TWO_MASSES = said(
    "The rod moves in both ways at once, so its mass is replaced by two: one on the crank pin, one on the "
    "crosshead. The big end is the heavier one: usually 0.67 … 0.75 of the mass belong to the crank pin."
)
BY_PLAN = said("By the plan of accelerations in position {position}:")
BY_SERIES = said(
    "By the book a = ω²·R·(cos φ + λ·cos 2φ) and {P_in} = −m·a, formula (349), which is the sum of two "
    "orders, formulas (350) and (351): projections of vectors that turn once and twice as fast as the crank, "
    "with periods of a turn and of half a turn. The minus holds as φ is counted from the dead centre at the "
    "cover."
)
USUAL_SHARE = said("Here {share} of it is counted at the crosshead, as is usual.")
UNUSUAL = said(
    "Here {share} of it is counted at the crosshead, which is out of the usual 0.25 … 0.33."
)
WORKED = said("Inertia at the dead centres and at right angles")
RESULTING = said("Force on the crosshead with inertia; triangles of forces")
INSTEAD = said(
    "In formulas (339)–(344) P′ = P + {P_in} stands for P, formula (352); forces are positive towards the "
    "crank."
)
BASE_TAKES = said(
    "The cylinder carries −P, the bearings P′: the base takes the difference, the inertia force {force} in "
    "position {position}."
)
OVER_A_TURN = said("Forces over a turn")
GRAPHS = said("Forces over a turn of the crank: {letters}")


LEAST, MOST = 0.25, 0.33
"""What share of a rod's mass is usually counted at the crosshead, by the book."""
QUARTERS = 4
"""The positions between which the book works its example are a quarter of a turn apart."""


GREATEST = said("The greatest inertia force is {exact} by the plans (position {position}).")
SERIES = said("By the series of two terms it is {series} (position {position}).")

EQUAL = said(
    "Over a turn the tangential force does the work {work_T}, the gas {work_P}: they differ by {work_apart}, "
    "so they are equal but for what the graphs can show."
)
UNEQUAL = said(
    "Over a turn the tangential force does the work {work_T}, the gas {work_P}: they differ by {work_apart}, "
    "more than the graphs explain."
)
CLOSE = 5.0
"""Works that differ by no more than this, %, agree: graphs with twelve positions are no better."""


NOTHING = said(
    "In positions {positions} the pressure on the guide and the turning moment are nought: the rod lies along"
    " the cylinder."
)
GUIDE = said("The pressure on the guide is greatest in position {position}: {N}.")
ONE_WAY = said(
    "It presses one side of the guide all the time: its sense goes by the sense of turning, not by that of the "
    "piston."
)
TURNED = said(
    "In positions {positions} it turns round, as the gas is compressed at the end of the stroke."
)
MOMENT = said("The turning moment is greatest in position {position}: {M}.")
DRIVES = said("It acts in the sense of turning in all positions of the row.")
BACKWARDS = said(
    "In positions {positions} it acts against the turning, as the compressed gas resists."
)
COVER = said(
    "The acceleration of the parts that move to and fro is greatest in position {position}, {a_B}; it changes "
    "its sign between positions {before} and {after}."
)
EARLY = said("That is before the crank stands square to the cylinder: the rod is not endless.")
USUAL = said("That is between 50° and 80° from the dead centre, as experience has it.")
NOUGHT = 1e-9
"""What is less than this share of the greatest is nought."""


class EnginePage(GasPage[Engine]):
    """An engine as drawn, in the order of the book."""

    def views(self) -> list[Drawing]:
        """Return triangles of forces, rotating vectors, the transfer of forces."""
        draws = (partial(draw, lettered=True) for draw in (engine_views, transfer_views))
        return readable(self.drawn, *draws)

    @property
    def inertia(self) -> Symbol:
        """The letter of the inertia force."""
        return Symbol(symbol("P_{in}", self.language))

    def blocks(self) -> Iterator[Block]:
        """Yield what is told, in the order of the book."""
        yield self.says(GAS)
        if len(INDICATOR_PLAN.on(self.drawn).indicator.sides) > 1:
            yield self.says(BOTH_SIDES)
        yield from self.gas()
        yield from self._transfer()
        yield from self._acting()
        yield from self._inertia()
        yield from self._resulting()
        yield from self._turn()

    def _transfer(self) -> Iterator[Block]:
        """What goes on to rod and guide, pin and bearing: formulas (339) to (344)."""
        yield self.head(TRANSFER_HEADING)
        yield self.says(PASSED, force=self.number(self.recorded.values["P′"], size=True))
        yield self.says(WITH_INERTIA)
        yield from self.leads(self.figures(TRANSFER), *map(self.says, (AT_B, AT_A, AT_O)))
        yield from self.alone(TRANSFER, bare=True)
        yield from self.view(CALCULATED)

    def _acting(self) -> Iterator[Block]:
        """The five forces on cylinder, bearings, crank and guide; what closes in the frame."""
        yield self.head(FIVE)
        sizes = {
            name: self.number(self.recorded.values[name], size=True)
            for name in ("P", "P′", "Q", "M", "N")
        }
        sentences = (
            self.says(ON_COVER, force=sizes["P"]),
            self.says(ON_BEARING, force=sizes["P′"]),
            self.says(BY_COUPLE, force=sizes["Q"], moment=sizes["M"]),
            self.says(ON_GUIDE, force=sizes["N"]),
            self.says(BACK),
        )
        yield Listed(tuple(Item(str(k), (one,)) for k, one in enumerate(sentences, 1)))
        arm = self.drawn.construction.step(self.recorded.values["NOB"])
        assert arm is not None
        yield self.says(FRAME, arm=self.number(arm.uses[1], size=True))

    def _inertia(self) -> Iterator[Block]:
        """Masses, accelerations, inertia forces of both orders: formulas (345) to (351)."""
        yield self.head(INERTIA)
        yield self.says(METHOD, P_in=self.inertia)
        lumped, values = self.recorded.lumped, self.recorded.values
        if lumped.at_crank is not None:
            yield self.says(TWO_MASSES)
            yield from self._share()
            yield from self.calculation(lumped.at_slider, lumped.at_crank, lumped.mass)
            yield from self.calculation(lumped.inertia, lumped.lost)
        if BESIDE.on(self.drawn).parts is not None:
            yield from self.alone(MASSES)
        yield self.says(BY_PLAN)
        yield from self.calculation(self.recorded.acceleration, *self._newtons(values["P_in"]))
        yield self.says(BY_SERIES, P_in=self.inertia)
        yield from self.view(HARMONICS, self.figures("rotating"))
        yield from self._quarters()

    def _share(self) -> Iterator[Block]:
        """Whether the share of the rod's mass that goes to and fro is a usual one, where it is given."""
        share = self.recorded.order.share
        if share is not None:
            usual = LEAST <= share <= MOST
            yield self.says(USUAL_SHARE if usual else UNUSUAL, share=self.ordered("share"))

    def _newtons(self, force: Mark) -> tuple[Mark, ...]:
        """Return a force with what it was converted from, if it was."""
        step = self.drawn.construction.step(force)
        if step is None or self.recorded.order.unit == "N":
            return (force,)
        return step.uses[0], force

    def _quarters(self) -> Iterator[Block]:
        """The inertia at the dead centres and half way between, as the book works it."""
        count = KINEMATICS_PLAN.on(self.drawn).count
        if count % QUARTERS:
            return
        there = [k * count // QUARTERS for k in range(QUARTERS - 1)]
        wanted = ("a_B", "a_B_series", "P_in", "P_in_series", "P_in1", "P_in2")
        some = [(self.columns[name], False) for name in wanted]
        yield self.upright("table-engine-quarters", WORKED, some, there)

    def _resulting(self) -> Iterator[Block]:
        """The force with inertia, and the triangles of the worked position: formula (352)."""
        yield self.head(RESULTING)
        yield self.says(INSTEAD, P_in=self.inertia)
        yield from self.calculation(self.recorded.values["P"], self.recorded.values["P′"])
        base = self.recorded.turning[0].base
        self.hide(base.mu, base.x)
        yield from self.leads(self.figures(f"{VIEW}-{self.position}"), *self.alone(VIEW))
        yield self.says(BASE_TAKES, force=self.recorded.values["P_in"])

    def _turn(self) -> Iterator[Block]:
        """The graphs over a turn, the table of all positions in the unit of the task, the works of T and P."""
        yield self.head(OVER_A_TURN)
        yield from self.again(self.recorded.turning[0].base.mu)
        drawn = readable(self.drawn, lambda held: engine_diagram_views(held, True))
        views = [view for view in drawn if view.role == GRAPH]
        charts = [chart.symbol for chart in self.recorded.charts]
        half = (len(charts) + 1) // 2
        shown = []
        for view, some in zip(views, (charts[:half], charts[half:]), strict=True):
            caption = self.sentence(GRAPHS, letters=Symbol(", ".join(some)))
            shown.append(picture(view, self.language)._replace(caption=caption))
        yield from self.leads(shown)
        found = [one for name, one in self.columns.items() if not name.endswith("_SI")]
        yield from columns(self.drawn, found, self.language)
        yield from self.view(WORKS_VIEW)

    # ------------------------------------------------------------ conclusions

    def concludes(self) -> Iterator[Runs]:
        """Yield what follows for guide, crank and moving parts, the inertia both ways, the works."""
        yield from self._guide()
        yield from self._moment()
        yield from self._acceleration()
        yield from self.extreme(GREATEST, "P_in", "exact")
        yield from self.extreme(SERIES, "P_in_series", "series")
        yield from self._works()

    def _signs(self, segment: str) -> list[tuple[str, int]]:
        """Return the positions that are drawn with the signs of a column there; 0 where it is nought."""
        drawn = self.drawn
        column = self.columns[segment].without(drawn.undrawn)
        values = column.first_figures[1][: drawn.project.count]
        most = max((abs(value) for value in values if value is not None), default=0.0)
        there = ((name, value) for name, value in zip(drawn.names, values, strict=False))
        return [
            (name, 0 if abs(value) <= NOUGHT * most else (1 if value > 0 else -1))
            for name, value in there
            if value is not None
        ]

    def _guide(self) -> Iterator[Runs]:
        """Yield where the pressure on the guide is nought, where it is greatest, whether it turns round."""
        signs = self._signs("N")
        if nowhere := _named(signs, 0):
            yield self.sentence(NOTHING, positions=nowhere)
        turned = _named(signs, -1)
        words = (GUIDE, TURNED if turned else ONE_WAY)
        yield from self.extreme(words, "N", "N", positions=turned)

    def _moment(self) -> Iterator[Runs]:
        """Yield where the turning moment is greatest, where it resists."""
        against, most = _named(self._signs("M"), -1), self.greatest("M")
        if most is not None:
            angle = self.drawn.names.index(most[1]) * 360.0 / self.drawn.project.count
            usual = (USUAL,) if 50.0 <= angle <= 80.0 else ()
            words = (MOMENT, *usual, BACKWARDS if against else DRIVES)
            yield from self.extreme(words, "M", "M", positions=against)

    def _acceleration(self) -> Iterator[Runs]:
        """Yield where the acceleration is greatest, and where on the way out it changes its sign."""
        turns = [(a, b) for (a, s), (b, t) in pairwise(self._signs("a_B")) if s * t < 0]
        if turns:
            before, after = turns[0]
            early = 4 * self.drawn.names.index(after) <= self.drawn.project.count
            words = (COVER, EARLY) if early else COVER
            yield from self.extreme(words, "a_B", "a_B", before=before, after=after)

    def _works(self) -> Iterator[Runs]:
        """Yield whether the tangential force does the work of the gas over a turn."""
        results = single(self.results)
        values = [value for name, (value, _) in results.items() if name in WORKS]
        if len(values) == len(WORKS) and all(map(math.isfinite, values)):
            yield self.sentence(EQUAL if abs(values[-1]) <= CLOSE else UNEQUAL)


def _named(signs: list[tuple[str, int]], sign: int) -> str:
    return ", ".join(name for name, own in signs if own == sign)


NOTE = Noted(EnginePage, places=(TRANSFER_PLACE,))
