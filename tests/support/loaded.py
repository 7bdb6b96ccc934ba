"""Bring a loaded mechanism to the board, in one position, and compare its forces with the judge's."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Angle
from graphic_tmm.chapters.forces.loads import Ground
from graphic_tmm.chapters.forces.plan import Forces, draw_forces
from graphic_tmm.chapters.forces.task import ForcesTask, Friction, Load
from graphic_tmm.chapters.kinematics.accelerations import draw_accelerations
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.by_drive import draw_by_drive
from graphic_tmm.chapters.kinematics.closings import PlateClosing
from graphic_tmm.chapters.kinematics.positions import Branches, draw_frame, draw_positions
from graphic_tmm.chapters.kinematics.survey import survey
from graphic_tmm.chapters.kinematics.velocities import draw_velocities
from graphic_tmm.chapters.kinematics.wheels import Wound
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure, dissect
from support import dynamics
from support.dynamics import Loaded, Statics, put_loads
from support.mechanisms import Sampled
from support.oracle import State, solve_fast

RATIO = 1e-9
"""How far forces may be off, of the largest."""


class Solved(NamedTuple):
    """The forces of one position: their log, marks, numbers with all scales 1, and the judge's."""

    log: Construction
    structure: Structure
    positions: Positions
    forces: Forces
    reading: Reading
    judge: Statics
    state: State

    def vector(self, tail: Mark, head: Mark) -> complex:
        """A vector of a polygon, N."""
        return complex((self.reading[head] - self.reading[tail])[0, 0])

    def number(self, mark: Mark) -> float:
        """The value of a mark."""
        return float(self.reading[mark][0, 0])


def places(structure: Structure, positions: Positions) -> dict[str, str]:
    """By the name of a sliding pair: the letter of the inner end of its leg."""
    found = {}
    for closing in positions.closings:
        for own, leg in zip(closing.group.legs, closing.legs, strict=True):
            if own.pair.kind == "P":
                found[own.pair.name] = closing.pin_letter(leg)
        for pair in closing.group.inner_pairs:
            if pair.kind == "P":
                leg = next(one for one in closing.legs if one.link in pair.links)
                found[pair.name] = closing.pin_letter(leg)
    return found


def runs(mechanism: Mechanism, positions: Positions, given: Mapping[Mark, Any]) -> list[int]:
    """On which side of the centres the run that is drawn of each belt leaves its first wheel; 1 of teeth."""
    sides = {mark.name: value for mark, value in given.items() if mark.name.startswith("±")}
    found = []
    for mesh in mechanism.meshes:
        one = next(wheel.rolling for wheel in positions.wheels if wheel.rolling.mesh is mesh)
        side = int(sides.get(f"±{one.far}{one.letter}", 1))
        turned = one.link == mesh.links[1] and mesh.by in ("belt", "chain")
        found.append(-side if turned else side)
    return found


def order_of(loaded: Loaded, **options: Any) -> ForcesTask:
    """The order of a loaded mechanism: its forces in fixed directions, its moments."""
    loads = [
        Load(link, letter, abs(f), math.degrees(math.atan2(f.imag, f.real)))
        for link, letter, f in loaded.forces
    ]
    loads += [Load(link, None, m, 0.0) for link, m in loaded.moments]
    return ForcesTask(("all",), tuple(loads), **options)


def solve(
    loaded: Loaded,
    phi: float,
    poses: Mapping[int, Any],
    order: ForcesTask,
    *,
    turned: bool = False,
    judged: bool = True,
    wound: Wound | None = None,
    branches: Branches | None = None,
) -> Solved:
    """Draw and execute the forces of a mechanism at a crank angle (degrees); ask the judge if ``judged``."""
    mechanism = loaded.mechanism
    structure, draft = dissect(mechanism), Draft()
    frame = draw_frame(draft, mechanism, structure)
    angle = draft.board.take(Angle, "φ", "°")
    positions = draw_positions(draft, mechanism, structure, frame, [angle], wound, branches)
    velocities = draw_velocities(draft, mechanism, structure, positions, turned=turned)
    accelerations = None
    if order.inertia:
        accelerations = draw_accelerations(draft, mechanism, structure, positions, velocities)
    ground = Ground(
        draft,
        mechanism,
        positions,
        velocities,
        tuple(draw_by_drive(draft, mechanism, positions, velocities, turned=turned)),
        accelerations,
        mechanism.drive.sense if turned else 0,
        survey(mechanism, structure),
        np.zeros(1),
        1,
    )
    forces = draw_forces(ground, order)
    log = draft.board.construction()
    given = dict(draft.given)
    for view in log.views:
        if view.scale is not None:
            given[view.scale] = 1.0
    given[forces.first.lever.times] = 2.5
    given[angle] = phi
    for closing in positions.closings:
        if isinstance(closing, PlateClosing):
            given |= dict(zip(closing.near, closing.branch.near(np.array([phi])), strict=True))
    reading = execute(log, given)
    state = solve_fast(mechanism, phi, poses)
    if not judged:
        nothing = Statics({}, {}, {}, {}, math.nan, 0.0, 0.0, 0.0)
        return Solved(log, structure, positions, forces, reading, nothing, state)
    judge = dynamics.statics(
        mechanism,
        state,
        loaded.forces,
        loaded.moments,
        gravity=order.gravity,
        inertia=order.inertia,
        balance="force" if order.balance == "force" else "moment",
        friction=_friction(order.friction),
        at=places(structure, positions),
        runs=runs(mechanism, positions, given),
    )
    return Solved(log, structure, positions, forces, reading, judge, state)


def _friction(friction: Friction | None) -> dynamics.Friction | None:
    return None if friction is None else dynamics.Friction(friction.f, friction.radius)


def errors(solved: Solved) -> dict[str, float]:
    """How far everything found is from the judge's, relative to the largest force there is."""
    judge, forces = solved.judge, solved.forces
    size = solved.state.size
    top = max([abs(f) for f in judge.reactions.values()] + [abs(judge.balance), 1e-300])
    if forces.order.balance == "moment":
        top = max(top, abs(judge.balance) / size)
    scale = {"reactions": 0.0, "closing": 0.0}
    for reaction in forces.reactions:
        due = judge.reactions[reaction.links]
        found = solved.vector(reaction.tail, reaction.head)
        scale["reactions"] = _worse(scale["reactions"], abs(found - due))
        scale["reactions"] = _worse(
            scale["reactions"], abs(solved.number(reaction.value) - abs(due))
        )
    for polygon in (*(g.polygon for g in forces.groups), forces.driven[0].alone.polygon):
        whole = sum(solved.vector(tail, head) for _, tail, head in polygon.sides)
        scale["closing"] = _worse(scale["closing"], abs(whole))
    arm = size if forces.order.balance == "moment" else 1.0
    balance = solved.number(forces.driven[0].balance)
    scale["balance"] = abs(balance - judge.balance) / arm
    scale["lever"] = abs(solved.number(forces.first.lever.balance) - balance) / arm
    return {name: _worse(0.0, value) / top for name, value in scale.items()}


def _worse(worst: float, value: float) -> float:
    return float("inf") if np.isnan(value) else max(worst, value)


def weighed(drawn: Sampled, seed: int) -> Loaded:
    """Loads for a mechanism; a mass stands at a letter."""
    pick = random.Random(seed)
    found = put_loads(lambda most: pick.randint(0, most), drawn.mechanism)
    links = [
        replace(link, centre=link.centre or next(iter(link.points)))
        if link.points
        else replace(link, mass=None)
        for link in found.mechanism.links
    ]
    return found._replace(mechanism=replace(found.mechanism, links=tuple(links)))
