"""Kinetostatics of a whole mechanism: groups in reverse order of attachment, the driving link, the lever.

With friction the whole is recorded in passes, the first without it, each further one with the friction that the
reactions of the pass before cause.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import product
from graphic_tmm.board.operations.statics import efficiency, settled, still_open
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.roles import DETACHED, FORCE_POLYGON
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.forces import friction, loads
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.cut_free import Figures
from graphic_tmm.chapters.forces.detached import Detached, Polygon, Reaction, Solution
from graphic_tmm.chapters.forces.driving import Alone, Driven, Place, RodForce, solve_drives
from graphic_tmm.chapters.forces.friction import Joint, Rub, Rubbing, joints
from graphic_tmm.chapters.forces.levers import Balanced, compared, draw_levers
from graphic_tmm.chapters.forces.link_loads import draw_loads
from graphic_tmm.chapters.forces.loads import Acting, Ground, Loads
from graphic_tmm.chapters.forces.statics import Solved, hand_on, solve_group
from graphic_tmm.chapters.forces.task import ASKED, FORCES, ForcesTask, Friction
from graphic_tmm.chapters.forces.tool import Tool, draw_line, draw_tool
from graphic_tmm.chapters.forces.wheels import (
    SolvedWheel,
    hand_on_wheel,
    refuse_friction,
    solve_wheel,
)
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN, Cylinder
from graphic_tmm.chapters.kinematics.bodies import Meshed
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans, chosen
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS
from graphic_tmm.chapters.kinematics.wheels import attached
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

SOLVED = (FORCE_POLYGON, DETACHED)
"""The roles of views in which links are solved: for readers "forces 4-5", "group 4-5"."""
OTHERS = (loads.VIEW, friction.VIEW)


@dataclass(frozen=True)
class Forces:
    """The forces of a mechanism as drawn, of the last pass.

    ``balanced``: every drive by kinetostatics and by its lever. ``tool``: an unknown force, if one is sought:
    then the groups leave nothing at the drive if all is right, and the difference is the share of what they
    leave in what balances the known loads there.
    ``acting``: the forces and couples on each link, reactions handed on among them; ``efficiency``: in %, with
    friction; ``circles``: radii of friction (m) by pin; ``places``: the positions (indices) at which forces
    are asked for; ``views``: those of the board in which they are drawn, of earlier passes too.
    """

    order: ForcesTask
    loads: Loads
    groups: tuple[Solved | SolvedWheel, ...]
    balanced: tuple[Balanced, ...]
    acting: Acting
    efficiency: Mark | None = None
    circles: dict[Mark, Mark] | None = None
    places: tuple[int, ...] = ()
    views: tuple[str, ...] = ()
    tool: Tool | None = None

    @property
    def first(self) -> Balanced:
        """The drive of the row."""
        return self.balanced[0]

    @property
    def driven(self) -> tuple[Driven, ...]:
        """The drives as the groups leave them."""
        return tuple(one.driven for one in self.balanced)

    def rods(self, polygon: Polygon) -> tuple[RodForce, ...]:
        """Return what drives rods as it lies on a polygon."""
        rods = (one.rod for one in self.driven if one.rod is not None)
        return tuple(rod for rod in rods if rod.tail.view == polygon.view)

    @property
    def alone(self) -> tuple[Alone, ...]:
        """What is driven and stands by itself."""
        return tuple(one.alone for one in self.driven if one.alone is not None)

    @property
    def polygons(self) -> tuple[Polygon, ...]:
        """The polygons in the order in which they were drawn."""
        groups = (one.polygon for one in self.groups)
        return (*groups, *(one.polygon for one in self.alone))

    @property
    def figures(self) -> tuple[Detached, ...]:
        """The figures of what is detached, in the order of the polygons."""
        groups = (one.figure for one in self.groups)
        return (*groups, *(one.figure for one in self.alone))

    @property
    def reactions(self) -> tuple[Reaction, ...]:
        """The reactions in the order in which they were found."""
        found = [reaction for group in self.groups for reaction in group.reactions]
        return (*found, *(one.reaction for one in self.alone))


FORCES_PLAN: Recorded[Forces] = Recorded(FORCES)


def record(bench: Bench) -> Forces | None:
    """Draw the forces that the scene asks for; they are told at the positions that it names."""
    order, plans = ASKED.of(bench.scene), KINEMATICS_PLAN.on(bench)
    if order is None:
        return None
    if plans.accelerations is None:
        order = replace(order, inertia=False)  # nothing moves, or gains speed
    cylinder = INDICATOR_PLAN.of(bench) if order.gas is not None else None
    made = draw_forces(_ground(bench, plans), order, cylinder)
    places = chosen(order.positions, bench.names, ASKED.section)
    views = tuple(_views(bench.draft.board.construction(), made.balanced))
    for view in views:
        bench.tell(view, places)
    if order.inertia:
        bench.tell(ACCELERATIONS, places)
    return replace(made, places=places, views=views)


def _views(log: Construction, balanced: tuple[Balanced, ...]) -> Iterator[str]:
    """Yield the views in which forces are drawn, in the order of the log."""
    solved = {view.name for view in log.views if view.role in SOLVED}
    known = {*solved, *OTHERS, *(one.view for one in balanced)}
    yield from (view for view in dict.fromkeys(step.it.view for step in log.steps) if view in known)


def _ground(bench: Bench, plans: KinematicPlans) -> Ground:
    assert plans.velocities is not None
    return Ground(
        bench.draft,
        plans.mechanism,
        plans.positions,
        plans.velocities,
        plans.by_drive,
        plans.accelerations,
        plans.sense if bench.scene.turned else 0,
        plans.tried,
        plans.numbers,
        plans.in_turn,
        plans.turns,
        plans.steps,
    )


class _Pass(NamedTuple):
    groups: tuple[Solved | SolvedWheel, ...]
    driven: tuple[Driven, ...]
    acting: Acting
    rubbing: Rubbing


def draw_forces(ground: Ground, order: ForcesTask, gas: Cylinder | None = None) -> Forces:
    """Record the kinetostatics and the lever; ``gas``: the cylinders whose gas pushes the pistons.

    Raises
    ------
    StructureError
        If a load names what is not there.
    """
    loads = draw_loads(ground, order, gas)
    tool, acting = None, loads
    if order.unknown is not None:
        sought = draw_line(ground, order.unknown)
        levers = draw_levers(ground, order, loads.on_lever, loads.couples_on_lever)
        tool = draw_tool(ground, sought, levers[0])
        acting = replace(loads, forces=[*loads.forces, tool.force])
    figures = Figures(ground)
    friction = order.friction
    count = friction.passes if friction is not None else 0
    found = joints(ground.positions.closings, ground.pairs)
    rub = _rub(ground, friction) if friction is not None else None
    rubbing = Rubbing()
    passes: list[_Pass] = []
    for k in range(count + 1):
        if k and rub is not None:
            rubbing = rub.draw(found, _by_joint(found, passes[-1]), k)
        tried = None if k == count else k
        passes.append(_solve(ground, order, acting, rubbing, figures, tried))
    last = passes[-1]
    balances: list[Mark] = [one.balance for one in last.driven]
    opens: Sequence[Mark | None] = [None] * len(balances)
    share = None
    if friction is not None:
        balances, opens = _settle(ground, passes)
        share = _efficiency(ground, passes[0], balances)
    if tool is None:
        slid = []
        if rub is not None:
            taken = {force.letter for force in loads.forces}
            slid = rub.along_guides(found, _by_joint(found, last), taken)
        couples = [*loads.couples_on_lever, *last.rubbing.couples]
        levers = draw_levers(ground, order, [*loads.on_lever, *slid], couples)
    balanced = tuple(
        compared(ground, *one, left=tool is not None)
        for one in zip(last.driven, balances, levers, opens, strict=True)
    )
    circles = None
    if rub is not None:
        pins = ground.positions
        circles = {pins.point(name): radius for name, radius in rub.circles.items()}
    return Forces(
        order,
        loads,
        last.groups,
        balanced,
        last.acting,
        share,
        circles,
        tool=tool,
    )


def _rub(ground: Ground, friction: Friction) -> Rub:
    """Return what draws friction.

    Raises
    ------
    StructureError
        If several drives stand: nothing tells which way pairs would rub.
    """
    refuse_friction(ground.positions.wheels)
    first, *further = ground.pairs
    if further and ground.mechanism.at_rest:
        raise StructureError(
            said(
                "where several drives stand nothing tells which way pairs rub: give them speeds, or leave "
                "[friction] out"
            ),
            "effects.friction",
            head="friction",
        )
    moves = next((pair for pair in ground.pairs if not pair.held and pair.speed), first)
    return Rub(ground.draft, (ground.positions, ground.velocities), friction, moves)


def _solve(
    ground: Ground,
    order: ForcesTask,
    loads: Loads,
    rubbing: Rubbing,
    figures: Figures,
    tried: int | None,
) -> _Pass:
    acting = Acting()
    frame = ground.mechanism.frame.number
    for force in loads.forces:
        acting.add(force)
    for couple in (*loads.couples, *rubbing.couples):
        acting.add(couple)
    groups = list[Solved | SolvedWheel]()
    for closing in reversed(tuple(attached(ground.positions, FORCES))):
        if isinstance(closing, Meshed):
            of = Solution((closing.leg.link,), tried)
            wheel = solve_wheel(figures.of(closing.leg.link), closing, acting, of)
            hand_on_wheel(wheel, acting, frame, figures.of)
            groups.append(wheel)
            continue
        solved = solve_group(
            figures.of(closing.legs[0].link),
            closing,
            acting,
            Solution(closing.group.links, tried),
            rubbing.slopes,
            rough=order.friction is not None,
        )
        hand_on(solved, acting, frame, figures.of)
        groups.append(solved)
    place = Place(
        ground.draft,
        ground.positions,
        frame,
        order.balance,
        tuple(pair.link for pair in ground.pairs),
        tried,
        rubbing.slopes,
        order.friction is not None,
    )
    driven = solve_drives(place, ground.pairs, figures.of, acting, groups)
    return _Pass(tuple(groups), driven, acting, rubbing)


def _by_joint(found: tuple[Joint, ...], done: _Pass) -> dict[tuple[int, int, str], Reaction]:
    """Return the reaction of every pair in a pass, by (link, body, name of the pair)."""
    made = {}
    for joint in found:
        if joint.closing is None:
            alone = next(one.alone for one in done.driven if one.pair.link == joint.links[0])
            assert alone is not None
            reaction = alone.reaction
        else:
            solved = (group for group in done.groups if isinstance(group, Solved))
            group = next(one for one in solved if one.closing is joint.closing)
            reaction = group.reactions[group.pairs.index(joint.pair)]
        made[(*joint.links, joint.pair.name)] = reaction
    return made


def _settle(ground: Ground, passes: list[_Pass]) -> tuple[list[Mark], list[Mark]]:
    """Tell what further passes can change of each drive, and refuse what does not settle."""
    draft = ground.draft
    draft.open("friction")
    opens, settling = list[Mark](), list[Mark]()
    for k, pair in enumerate(ground.pairs):
        last, before, first = (done.driven[k].balance for done in reversed(passes[-3:]))
        index = f"{{b{pair.link}}}" if len(ground.pairs) > 1 else "b"
        letter = f"{'P' if last.unit == 'N' else 'M'}_{index}"
        opens.append(draft.draw(still_open, f"Δ{letter}", last, before, first, unit=last.unit))
        settling.append(draft.draw(settled, letter, last, opens[-1], unit=last.unit))
    return settling, opens


def _efficiency(ground: Ground, first: _Pass, balances: list[Mark]) -> Mark:
    """Calculate the efficiency: of several drives by the sums of their powers."""
    draft, without = ground.draft, [one.balance for one in first.driven]
    speeds = [
        _speed(ground, pair, force.unit) for pair, force in zip(ground.pairs, without, strict=True)
    ]
    if len(balances) == 1 and speeds[0] is not None:
        return draft.draw(efficiency, "η", without[0], balances[0], speeds[0], unit="%")
    both = [
        _power(ground, forces, speeds, raised)
        for forces, raised in ((without, "^{(0)}"), (balances, ""))
    ]
    return draft.draw(efficiency, "η", *both, draft.take(Number, "1", 1.0), unit="%")


def _speed(ground: Ground, pair: DrivenPair, unit: str) -> Mark | None:
    """Return by what the balance of a drive is multiplied to be a power; None if the drive is held."""
    plan, several = ground.velocities, len(ground.pairs) > 1
    if not isinstance(pair, Crank):
        return plan.speeds.get(pair.link)
    rate = plan.rates.get(pair.link)
    if rate is None or not several or unit != "N":
        return rate
    arm = pair.real_arm(ground.draft, ground.positions)
    return ground.draft.draw(product, f"v_{pair.pin}", rate, arm, unit="m/s")


def _power(ground: Ground, forces: list[Mark], speeds: list[Mark | None], raised: str) -> Mark:
    """Calculate the sum of the powers of all drives; ``raised``: the pass of friction in its letter."""
    draft, total = ground.draft, None
    for pair, force, speed in zip(ground.pairs, forces, speeds, strict=True):
        if speed is not None:
            letter = f"N_{pair.link}{raised}"
            power = draft.draw(product, letter, force, speed, unit="W", why=why.POWER)
            if total is not None:
                power = draft.draw(added, f"N{raised}", total, power, unit="W")
            total = power
    assert total is not None
    return total
