"""The driving link: the balancing force at the crank pin, or the balancing moment, and the frame's reaction."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.instruments import measure, square
from graphic_tmm.board.operations.statics import balancing, reversed_
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.forces import reasons as why
from graphic_tmm.chapters.forces.detached import Detached
from graphic_tmm.chapters.forces.loads import Acting, Force
from graphic_tmm.chapters.forces.polygons import Polygon, Reaction, Views
from graphic_tmm.chapters.kinematics.bodies import Body


class Driver(NamedTuple):
    """The driving link: its body, the letters of its pivot and its pin, its drawn arm (Length)."""

    body: Body
    pivot: Mark
    pin: Mark
    arm: Mark


class Driven(NamedTuple):
    """The driving link as solved: the balancing force (N) or moment (N·m), the frame's reaction, the polygon.

    ``force``: the balancing force as it is drawn, None for a moment; ``arm``: of it (Length).
    ``total``: the sum of moments that it balances (N·m); ``figure``: the link as detached.
    """

    balance: Mark
    force: Force | None
    reaction: Reaction
    polygon: Polygon
    total: Mark
    arm: Mark
    figure: Detached


def solve_driver(
    figure: Detached,
    driver: Driver,
    acting: Acting,
    views: Views,
    frame: int,
    kind: str,
    tried: str = "",
) -> Driven:
    """Balance the driving link; ``kind``: "force" or "moment".

    ``tried``: the number of a pass that others follow.
    """
    number, draft = driver.body.link.number, figure.draft
    draft.open(figure.view)
    forces = acting.forces.get(number, [])
    couples = acting.couples.get(number, [])
    total = figure.sum(driver.pivot, forces, couples, f"ΣM_{number}")
    if total is None:
        total = draft.take(Number, f"ΣM_{number}", 0.0, "N·m")
    sides = [(force.letter, force.line, force.value) for force in forces]
    arm = figure.length(driver.pivot, driver.pin)
    force, raised = None, f"^{{({tried})}}" if tried else ""
    if kind == "force":
        letter = f"P_b{raised}"
        balance = draft.draw(balancing, letter, total, arm, figure.mu, unit="N")
        line = draft.draw(
            square,
            f"({letter})",
            figure.point(driver.pin),
            driver.body.axis,
            sense=1,
            why=why.BALANCING_LINE,
        )
        force = Force(letter, number, driver.pin, line, balance)
        sides.append((letter, line, balance))
    else:
        balance = draft.draw(reversed_, f"M_b{raised}", total, unit="N·m", why=why.BALANCING_MOMENT)
    chain = views.begin(draft)
    start = chain.end
    for letter, line, value in sides:
        chain.add(letter, line, value)
    end = chain.end
    name = f"R_{{{frame}{number}}}"
    length = draft.draw(measure, f"y_{{R{frame}{number}}}", end, start, why=why.CRANK_REACTION)
    value = draft.draw(in_si, name, length, unit="N")
    reaction = Reaction(name, (frame, number), end, start, length, value, value)
    return Driven(
        balance,
        force,
        reaction,
        Polygon(views.polygon, chain.mu, (*chain.sides, (name, end, start))),
        total,
        arm,
        figure,
    )
