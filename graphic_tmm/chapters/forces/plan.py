"""Kinetostatics of a whole mechanism: groups in reverse order of attachment, the driving link, the lever.

With friction the whole is recorded in passes, the first without it, each further one with the friction that the
reactions of the pass before cause.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

from graphic_tmm.board.operations.statics import (
    apart_percent,
    efficiency,
    settled,
    still_open,
)
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.roles import DETACHED, FORCE_POLYGON
from graphic_tmm.chapters.forces import friction, lever, loads
from graphic_tmm.chapters.forces.detached import Detached, Polygon, Reaction, Solution
from graphic_tmm.chapters.forces.driving import Alone, Driven, Place, solve_drives
from graphic_tmm.chapters.forces.friction import Joint, Rub, Rubbing, joints
from graphic_tmm.chapters.forces.lever import Lever, draw_lever
from graphic_tmm.chapters.forces.link_loads import draw_loads
from graphic_tmm.chapters.forces.loads import Acting, Couple, Force, Ground, Loads
from graphic_tmm.chapters.forces.operations import left_percent
from graphic_tmm.chapters.forces.statics import Solved, hand_on, solve_group
from graphic_tmm.chapters.forces.task import ASKED, FORCES, ForcesTask, Friction
from graphic_tmm.chapters.forces.tool import Tool, draw_line, draw_tool
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN, Cylinder
from graphic_tmm.chapters.kinematics.bodies import dyads
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans, chosen
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

SOLVED = (FORCE_POLYGON, DETACHED)
"""The roles of views in which links are solved: for readers "forces 4-5", "group 4-5"."""
OTHERS = (loads.VIEW, friction.VIEW, lever.VIEW)


@dataclass(frozen=True)
class Forces:
    """The forces of a mechanism as drawn, of the last pass.

    ``balance``: P_bal (N) or M_bal (N·m) by kinetostatics and by the lever, their difference in %. ``tool``: an
    unknown force, if one is sought: then ``balance`` is what the groups leave at the drive, nothing if all is
    right, and the difference is its share of what balances the known loads there.
    ``open``: by how much further passes of friction can change it; ``efficiency`` in %. ``acting``: the forces
    and couples on each link, reactions handed on among them; ``circles``: radii of friction (m) by pin;
    ``places``: the positions (indices) at which forces are asked for; ``views``: those of the board in which
    they are drawn, of earlier passes too.
    """

    order: ForcesTask
    loads: Loads
    groups: tuple[Solved, ...]
    driven: tuple[Driven, ...]
    lever: Lever
    acting: Acting
    balance: Mark
    difference: Mark
    open: Mark | None = None
    efficiency: Mark | None = None
    circles: dict[Mark, Mark] | None = None
    places: tuple[int, ...] = ()
    views: tuple[str, ...] = ()
    tool: Tool | None = None

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
    views = tuple(_views(bench.draft.board.construction()))
    for view in views:
        bench.tell(view, places)
    if order.inertia:
        bench.tell(ACCELERATIONS, places)
    return replace(made, places=places, views=views)


def _views(log: Construction) -> Iterator[str]:
    """Yield the views in which forces are drawn, in the order of the log."""
    solved = {view.name for view in log.views if view.role in SOLVED}
    for view in dict.fromkeys(step.it.view for step in log.steps):
        if view in solved or view in OTHERS:
            yield view


def _ground(bench: Bench, plans: KinematicPlans) -> Ground:
    assert plans.velocities is not None
    return Ground(
        bench.draft,
        plans.mechanism,
        plans.positions,
        plans.velocities,
        plans.accelerations,
        plans.sense if bench.scene.turned else 0,
        plans.tried,
        plans.numbers,
        plans.in_turn,
        plans.turns,
        plans.steps,
    )


class _Figures:
    """The figures in which links are detached, each begun with all its points when it is first wanted."""

    def __init__(self, ground: Ground) -> None:
        self.draft, self.bodies = ground.draft, ground.positions.bodies
        alone = (pair.link for pair in ground.pairs if not pair.driven.telescopes)
        self.links: dict[int, tuple[int, ...]] = {link: (link,) for link in alone}
        self.closing: dict[int, Mark] = {}
        self.known: dict[tuple[int, ...], Detached] = {}
        for closing in dyads(ground.positions.closings, FORCES):
            for link in (*closing.group.links, *closing.group.rods):
                self.links[link], self.closing[link] = closing.group.links, closing.point

    def of(self, link: int) -> Detached:
        """Return the figure that shows a link."""
        links = self.links[link]
        if links not in self.known:
            members = [number for number, own in self.links.items() if own == links]
            points = [mark for number in members for mark in self.bodies[number].marks.values()]
            more = [self.closing[link]] if link in self.closing else []
            name = Solution(links).name
            note = f"II({name})" if more else f"I({name})"
            self.known[links] = Detached(self.draft, links, note, (*points, *more))
        return self.known[links]


class _Pass(NamedTuple):
    groups: tuple[Solved, ...]
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
    draft = ground.draft
    loads = draw_loads(ground, order, gas)
    tool, acting = None, loads
    if order.unknown is not None:
        sought = draw_line(ground, order.unknown)
        lever = _lever(ground, order, (loads.on_lever, loads.couples_on_lever))
        tool = draw_tool(ground, sought, lever)
        acting = replace(loads, forces=[*loads.forces, tool.force])
    figures = _Figures(ground)
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
    balance = last.driven[0].balance
    open_ = share = None
    if friction is not None:
        balance, open_, share = _settle(ground, passes, order.balance)
    if tool is None:
        lever = _lever(ground, order, _carried(ground, loads, rub, found, last))
    draft.open("lever")
    both = (lever.balance, balance) if tool is None else (balance, lever.balance)
    compare = apart_percent if tool is None else left_percent
    difference = draft.draw(compare, "Δ", *both, unit="%")
    circles = None
    if rub is not None:
        pins = ground.positions
        circles = {pins.point(name): radius for name, radius in rub.circles.items()}
    return Forces(
        order,
        loads,
        last.groups,
        last.driven,
        lever,
        last.acting,
        balance,
        difference,
        open_,
        share,
        circles,
        tool=tool,
    )


def _carried(
    ground: Ground, loads: Loads, rub: Rub | None, found: tuple[Joint, ...], last: _Pass
) -> tuple[list[Force], list[Couple]]:
    """Return what is carried onto the lever: loads, friction, what balances further drives."""
    taken = {force.letter for force in loads.forces}
    slid = rub.along_guides(found, _by_joint(found, last), taken) if rub is not None else []
    further = last.driven[1:]
    held = [_imaged(ground, force) for one in further for force in one.carried]
    turned = [one.couple for one in further if one.couple is not None]
    return (
        [*loads.on_lever, *slid, *held],
        [*loads.couples_on_lever, *last.rubbing.couples, *turned],
    )


def _rub(ground: Ground, friction: Friction) -> Rub:
    """Return what draws friction.

    Raises
    ------
    StructureError
        If there are several drives.
    """
    first, *further = ground.pairs
    if further:
        raise StructureError(
            said("friction is drawn of mechanisms with one drive: leave [friction] out"),
            "effects.friction",
            head="friction",
        )
    return Rub(ground.draft, (ground.positions, ground.velocities), friction, first)


def _imaged(ground: Ground, force: Force) -> Force:
    """Return a force with the image of its point on the plan of velocities."""
    body = ground.positions.bodies[force.link]
    return force._replace(image=ground.velocities.images.at(body, force.point))


def _solve(
    ground: Ground,
    order: ForcesTask,
    loads: Loads,
    rubbing: Rubbing,
    figures: _Figures,
    tried: int | None,
) -> _Pass:
    acting = Acting()
    frame = ground.mechanism.frame.number
    for force in loads.forces:
        acting.add(force)
    for couple in (*loads.couples, *rubbing.couples):
        acting.add(couple)
    groups = []
    for closing in reversed(tuple(dyads(ground.positions.closings, FORCES))):
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
            group = next(g for g in done.groups if g.closing is joint.closing)
            pairs = [own.pair for own in joint.closing.group.legs] + [joint.closing.group.inner]
            reaction = group.reactions[pairs.index(joint.pair)]
        made[(*joint.links, joint.pair.name)] = reaction
    return made


def _settle(ground: Ground, passes: list[_Pass], kind: str) -> tuple[Mark, Mark, Mark]:
    """Tell what further passes can change, refuse what does not settle, and find the efficiency."""
    draft = ground.draft
    draft.open("friction")
    unit, letter = ("N", "P_b") if kind == "force" else ("N·m", "M_b")
    last, before, first = (done.driven[0].balance for done in reversed(passes[-3:]))
    open_ = draft.draw(still_open, f"Δ{letter}", last, before, first, unit=unit)
    balance = draft.draw(settled, letter, last, open_, unit=unit)
    link = ground.mechanism.drive.link
    speed = ground.velocities.rates.get(link) or ground.velocities.speeds[link]
    without = passes[0].driven[0].balance
    share = draft.draw(efficiency, "η", without, balance, speed, unit="%")
    return balance, open_, share


def _lever(ground: Ground, order: ForcesTask, loads: tuple[list[Force], list[Couple]]) -> Lever:
    sense = ground.mechanism.drive.sense
    return draw_lever(
        ground.draft,
        ground.positions,
        ground.velocities,
        ground.pairs,
        loads,
        quarters=0 if ground.quarters else -sense,
        sense=sense,
        couples=order.couples,
        moment=order.balance == "moment",
    )
