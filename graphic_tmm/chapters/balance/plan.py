"""The shaking force of a mechanism: inertia forces added up in every position, moments; its polar diagram.

With counterweights their inertia forces are laid on behind those of the links: one polygon tells both sums.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from operator import attrgetter
from typing import NamedTuple

from graphic_tmm.board import graphs, roles
from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes, Base
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import cycle_per_mm, in_si, to_board
from graphic_tmm.board.operations.instruments import lay_off, measure
from graphic_tmm.board.operations.statics import arm, inertia_couple, moment
from graphic_tmm.board.operations.supports import farthest
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number, Point
from graphic_tmm.chapters.balance import words as why
from graphic_tmm.chapters.balance.counterweights import (
    Weight,
    draw_given,
    draw_weight,
    image_of,
)
from graphic_tmm.chapters.balance.masses import Unbalance, replace_masses
from graphic_tmm.chapters.balance.operations import removed_percent
from graphic_tmm.chapters.balance.task import (
    ASKED,
    BALANCE,
    FORCE,
    INERTIA,
    MOMENT,
    BalanceTask,
)
from graphic_tmm.chapters.forces.detached import Chain, Side
from graphic_tmm.chapters.forces.link_loads import inertia_force_at
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.masses import inertia_of, mass_centre
from graphic_tmm.mechanism.records import Link
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

BASE = 120.0
"""Length of the graph's base on an A1 where a sheet leaves it as it is, mm."""
ROOM = 60.0
"""Room for the highest ordinate of the moment, mm."""


class Pull(NamedTuple):
    """An inertia force: its letter, its size (N) and its line of action; its moment about the point (N·m)."""

    letter: str
    value: Mark
    line: Mark
    moment: Mark


class Whole(NamedTuple):
    """The shaking force of everything that is counted: the end of its polygon, its length, its size (N).

    ``curve``: the hodograph, ``top``: the largest in mm, ``most`` in N; ``moment``: about the point (N·m),
    ``ordinate``: of its graph, ``high``, ``greatest``: the largest of it, in mm and in N·m.
    """

    end: Mark
    length: Mark
    value: Mark
    curve: Mark
    top: Mark
    most: Mark
    moment: Mark
    ordinate: Mark
    high: Mark
    greatest: Mark


@dataclass(frozen=True)
class Balance:
    """The shaking force as drawn: its scale, its pole, the sides of its polygon in order.

    ``bare``: of the links; ``weighted``: with the counterweights, ``removed``: what these take away, %; None
    where there are none. ``about``: the letter of the point of the moments; ``base``, ``chart``: their graph.
    ``unbalances``: of links whose counterweights were looked for; ``pulls``: the inertia forces.
    """

    order: BalanceTask
    about: str
    mu: Mark
    pole: Mark
    sides: tuple[Side, ...]
    bare: Whole
    weighted: Whole | None
    removed: Mark | None
    weights: tuple[Weight, ...]
    base: Base
    chart: Chart
    unbalances: tuple[Unbalance, ...] = ()
    pulls: tuple[Pull, ...] = ()

    @property
    def wholes(self) -> tuple[Whole, ...]:
        """The shaking force without counterweights and, where there are some, with them."""
        return (self.bare, self.weighted) if self.weighted is not None else (self.bare,)


BALANCE_PLAN: Recorded[Balance] = Recorded(BALANCE)


def record(bench: Bench) -> Balance | None:
    """Draw the shaking force that the scene asks for.

    Raises
    ------
    StructureError
        If no mass moves, or a counterweight is put on a link that does not turn about a pin.
    """
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    plans = KINEMATICS_PLAN.on(bench)
    about = order.about or plans.structure.origin
    at = plans.positions.bodies[plans.mechanism.frame.number].marks[about]
    found = replace_masses(bench, plans, order) if order.method is not None else ()
    if order.method is None:
        weights = [draw_given(bench, plans, one) for one in order.counterweights]
    else:
        weights = [
            draw_weight(bench, plans, one.link, one.held) for one in found if one.held is not None
        ]
    pulls, couples = _links(bench.draft, plans, at)
    if not pulls:
        says = said(
            "no mass moves but about itself: write mass and centre in the [[link]] of those that do"
        )
        raise StructureError(says, BALANCE, head=BALANCE)
    more = [pull for one in weights for pull in _of_weight(bench, plans, one, at)]
    bench.tell(ACCELERATIONS, range(len(bench.names)))
    made = _draw(bench, plans, order, about, (pulls, couples, more, tuple(weights)))
    return replace(made, unbalances=found, pulls=(*pulls, *more))


def _links(draft: Draft, plans: KinematicPlans, at: Mark) -> tuple[list[Pull], list[Mark]]:
    """Calculate the inertia forces of the links with their moments, and the couples of inertia."""
    pulls, couples, plan = list[Pull](), list[Mark](), plans.accelerations
    assert plan is not None
    draft.open(INERTIA)
    for link in sorted(plans.mechanism.links, key=attrgetter("number")):
        n = link.number
        if link.mass:
            centre = mass_centre(plans.mechanism, link)
            mass = draft.constant(f"m_{n}", link.mass, "kg")
            point = plans.positions.bodies[n].marks[centre]
            end = plan.images.by_letter[n][centre]
            pulls += _pull(draft, plans, at, f"P_{{i{n}}}", (mass, point, end))
        if link.inertia and n in plan.rates:
            couples.append(_couple(draft, link, plan.rates[n]))
    return pulls, couples


def _couple(draft: Draft, link: Link, rate: Mark) -> Mark:
    inertia = inertia_of(draft, link)
    letter = f"M_{{i{link.number}}}"
    return draft.draw(inertia_couple, letter, inertia, rate, unit="N·m", role=roles.INERTIA)


def _of_weight(bench: Bench, plans: KinematicPlans, weight: Weight, at: Mark) -> list[Pull]:
    end = image_of(bench, plans, weight)
    bench.draft.open(INERTIA)
    of = (weight.mass, weight.at, end)
    return _pull(bench.draft, plans, at, f"P_{{ic{weight.tag}}}", of)


def _pull(
    draft: Draft, plans: KinematicPlans, at: Mark, letter: str, of: tuple[Mark, Mark, Mark]
) -> list[Pull]:
    """Calculate the inertia force of a mass (kg, its place, its image), its moment; none where it stands."""
    plan = plans.accelerations
    assert plan is not None
    drawn = inertia_force_at(draft, plan, letter, *of)
    if drawn is None:
        return []
    value, line = drawn
    height = draft.draw(arm, f"h_{{{letter[3:-1]}}}", at, line, why=why.ARM_ABOUT)
    turning = draft.draw(moment, f"M_{{{at.letter}}}({letter})", value, height, unit="N·m")
    return [Pull(letter, value, line, turning)]


class _Moment(NamedTuple):
    """The axes of the graph of moments, its base."""

    base: Base
    axes: Axes
    mu: Mark


def _draw(
    bench: Bench,
    plans: KinematicPlans,
    order: BalanceTask,
    about: str,
    of: tuple[list[Pull], list[Mark], list[Pull], tuple[Weight, ...]],
) -> Balance:
    pulls, couples, more, weights = of
    draft = bench.draft
    draft.open(INERTIA)
    sums = [_sum(draft, [one.moment for one in pulls] + couples, "M_Φ")]
    if more:
        also = _sum(draft, [one.moment for one in more], "ΣM_{c}")
        sums.append(draft.draw(added, "M_Φ′", sums[0], also, unit="N·m", why=why.BOTH_SUMS))
    draft.open(FORCE)
    mu = draft.scale("μ_Φ", "N/mm")
    pole = draft.take(Point, "o", 0j)
    draft.lay_out(pole)
    chain, ends = Chain(draft, mu, pole), []
    for some, vertex in ((pulls, "f"), (more, "f′")):
        for k, one in enumerate(some, 1):
            chain.add(one.letter, one.line, one.value, vertex if k == len(some) else "")
        ends += [chain.end] if some else []
    graph = _graph(draft, plans)
    wholes = [
        _whole(draft, plans, pole, end, total, graph, "′" * k)
        for k, (end, total) in enumerate(zip(ends, sums, strict=True))
    ]
    removed = None
    if more:
        draft.open(FORCE)
        removed = draft.draw(removed_percent, "ΔΦ", wholes[0].most, wholes[1].most, unit="%")
    ordinates = tuple(one.ordinate for one in wholes)
    chart = Chart(MOMENT, "M", "N·m", graph.mu, ordinates, True, None, ROOM)
    weighted = wholes[1] if more else None
    return Balance(
        order, about, mu, pole, tuple(chain.sides), wholes[0], weighted, removed, weights,
        graph.base, chart,
    )  # fmt: skip


def _sum(draft: Draft, parts: list[Mark], letter: str) -> Mark:
    """Add up moments (N·m)."""
    total = parts[0]
    for more in parts[1:]:
        total = draft.draw(
            added, letter, total, more, unit="N·m", role=roles.SUM, why=why.MOMENTS_SUM
        )
    return total


def _graph(draft: Draft, plans: KinematicPlans) -> _Moment:
    """Draw the axes of the graph of the moment over the turn."""
    draft.open(MOMENT)
    mu = draft.scale("μ_M", "(N·m)/mm")
    length = draft.take(Length, "L", BASE, "mm", roles.BASE)
    turns = draft.take(Number, "n_t", float(plans.turns))
    along = draft.draw(cycle_per_mm, "μ_φ", turns, length, unit="rad/mm")
    base = graphs.lay_base(draft, length, along, plans.count, plans.numbers[None, :])
    return _Moment(base, graphs.draw_axes(draft, MOMENT, base, mu), mu)


def _whole(
    draft: Draft,
    plans: KinematicPlans,
    pole: Mark,
    end: Mark,
    total: Mark,
    graph: _Moment,
    prime: str,
) -> Whole:
    """Measure a shaking force, draw its hodograph and the graph of its moment, find the largest of both."""
    draft.open(FORCE)
    row, axes = plans.in_turn, graph.axes
    length = draft.draw(measure, f"{pole.letter}{end.letter}", pole, end, why=why.SHAKING)
    value = draft.draw(in_si, f"Φ{prime}", length, unit="N")
    curve = draft.draw(
        french_curve, f"({end.letter}–{end.letter})", end, row=row, why=why.HODOGRAPH
    )
    far = draft.draw(farthest, f"f{prime}_{{max}}", pole, end, row=row, why=why.LARGEST)
    top = draft.draw(measure, f"{pole.letter}{far.letter}", pole, far, why=why.LARGEST)
    most = draft.draw(in_si, f"Φ{prime}_{{max}}", top, unit="N")
    draft.open(MOMENT)
    height = draft.draw(to_board, f"y_{{M{prime}}}", total, graph.mu)
    at = graphs.lay_ordinates(draft, axes, height, f"q{prime}")
    graphs.through(draft, axes, at)
    ordinate = graphs.measure_ordinates(draft, axes, at.points, f"M{prime}")
    level = draft.draw(lay_off, f"t{prime}", axes.up, height, why=why.LEVELLED)
    highest = draft.draw(farthest, f"u{prime}", axes.origin, level, row=row, why=why.LARGEST)
    high = draft.draw(measure, f"Ou{prime}", axes.origin, highest, why=why.LARGEST)
    greatest = draft.draw(in_si, f"M{prime}_{{max}}", high, unit="N·m")
    return Whole(end, length, value, curve, top, most, total, ordinate, high, greatest)
