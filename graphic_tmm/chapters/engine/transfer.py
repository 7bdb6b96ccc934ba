"""How the force of the gas is passed on: all forces of the crank mechanism in one figure, as in the book.

At the crosshead P′ is the diagonal of a parallelogram whose sides are Q along the rod and N square to the
guide; carried to the crank pin Q is that of T along the tangent and K along the crank. Q and −Q are added at
the bearing: −Q with Q at the pin is the couple that turns the crank, Q goes into P′ along the cylinder and −N
across it, which with N at the crosshead is the couple that tips the frame. P on the piston and −P on the cover
close in the cylinder. Vectors have a scale of their own, so that the figure may stand on a sheet by itself.
"""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.graphs import at_zero
from graphic_tmm.board.operations.instruments import (
    lay_off,
    measure,
    measure_along,
    meet,
    parallel,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length
from graphic_tmm.chapters.engine import words as why
from graphic_tmm.chapters.engine.formulas import couple_of, moment_of_rod
from graphic_tmm.chapters.engine.plan import Engine
from graphic_tmm.chapters.engine.task import TRANSFER as VIEW
from graphic_tmm.chapters.indicator.plan import Machine

PISTON_ROD, CLEARANCE = 70.0, 12.0
"""How long the piston rod is drawn, and how far the cover stands off the piston at the dead centre, mm:
both are conventional, no length of the machine is meant."""


class Vector(NamedTuple):
    """A force as drawn: where it begins and ends (Point), its letter, whether it is against that."""

    start: Mark
    end: Mark
    letter: str
    against: bool = False


class Transfer(NamedTuple):
    """The figure as drawn.

    ``mu``: μ_F; ``points``: bearing, crank pin, crosshead, piston, cover; ``vectors``: in the order drawn;
    ``foot``: of the perpendicular from the bearing on the rod's line; ``read``: forces by letter (force unit)
    as measured in the figure; ``moments``: of Q, −Q and of N, −N (times metre).
    """

    mu: Mark
    points: tuple[Mark, Mark, Mark, Mark, Mark]
    vectors: tuple[Vector, ...]
    foot: Mark
    read: dict[str, Mark]
    moments: tuple[Mark, Mark]


class _Way(NamedTuple):
    """Where forces act, and along which lines: to the crank, of N, along the rod and along the crank."""

    pivot: Mark
    at_a: Mark
    at_b: Mark
    inward: Mark
    across: Mark
    rod: Mark
    crank: Mark
    sense: int


def draw_transfer(draft: Draft, made: Engine, machine: Machine) -> Transfer:
    """Draw all forces on the mechanism as it stands on the plan of positions."""
    unit = made.order.unit
    draft.open(VIEW)
    mu = draft.scale("μ_F", f"{unit}/mm")
    draft.lay_out()
    way = _way(draft, made, machine)
    gas, piston, cover = _piston(draft, made, way)
    at_b, length_q, length_n = _at_crosshead(draft, made, way)
    at_a, lengths = _at_pin(draft, way, length_q)
    at_o, closing = _at_bearing(draft, way, length_q)
    lengths |= {"Q": length_q, "N": length_n} | closing
    read = {name: draft.draw(in_si, name, one, unit=unit) for name, one in lengths.items()}
    foot, moments = _couples(draft, made, machine, way, read)
    points = (way.pivot, way.at_a, way.at_b, piston, cover)
    return Transfer(mu, points, (*gas, *at_b, *at_a, *at_o), foot, read, moments)


def _way(draft: Draft, made: Engine, machine: Machine) -> _Way:
    """Draw the lines of P′, N and Q at the crosshead."""
    at_a, at_b = made.triangles.at_a, made.triangles.at_b
    inward_was, rod_was = (
        draft.uses(mark)[0] for mark in (made.triangles.end_p, made.triangles.end_qa)
    )
    sense = machine.mechanism.drive.sense
    inward = draft.draw(parallel, "(P′)", at_b, inward_was, why=why.P_LINE)
    across = draft.draw(square, "(N)", at_b, inward, sense=sense, why=why.N_LINE)
    rod = draft.draw(parallel, "(Q)", at_b, rod_was, why=why.Q_LINE)
    crank = machine.positions.bodies[machine.mechanism.drive.link].axis
    pivot = machine.positions.point(machine.pivot)
    return _Way(pivot, at_a, at_b, inward, across, rod, crank, sense)


def _piston(draft: Draft, made: Engine, way: _Way) -> tuple[tuple[Vector, ...], Mark, Mark]:
    """Draw P on the piston and −P on the cover."""
    outward = draft.draw(parallel, "(BC)", way.at_b, way.inward, sense=-1, why=why.PISTON)
    rod = draft.take(Length, "BC", PISTON_ROD, "mm")
    piston = draft.draw(lay_off, "C", outward, rod, why=why.PISTON)
    first = draft.draw(at_zero, "C_0", piston, free=True)
    line = draft.draw(parallel, "(C_0D)", first, way.inward, sense=-1, why=why.COVER)
    cover = draft.draw(
        lay_off, "D", line, draft.take(Length, "C_0D", CLEARANCE, "mm"), why=why.COVER
    )
    length = draft.draw(to_board, "y_P", made.values["P"])
    push = draft.draw(parallel, "(P)", piston, way.inward, why=why.GAS)
    end = draft.draw(lay_off, "P", push, length, why=why.GAS)
    back = draft.draw(parallel, "(−P)", cover, way.inward, sense=-1, why=why.COVER_LOAD)
    other = draft.draw(lay_off, "−P", back, length, why=why.COVER_LOAD)
    return (Vector(piston, end, "P"), Vector(cover, other, "P", against=True)), piston, cover


def _at_crosshead(draft: Draft, made: Engine, way: _Way) -> tuple[tuple[Vector, ...], Mark, Mark]:
    """Resolve P′ into Q and N; return the vectors and both lengths."""
    end = draft.draw(
        lay_off, "P′", way.inward, draft.draw(to_board, "y_{P′}", made.values["P′"]), why=why.P_LINE
    )
    beside = draft.draw(parallel, "(P′Q)", end, way.across, sense=-1, why=why.BY_PARALLELS)
    over = draft.draw(parallel, "(P′N)", end, way.rod, sense=-1, why=why.BY_PARALLELS)
    end_q = draft.draw(meet, "Q", beside, way.rod, why=why.P_RESOLVED)
    end_n = draft.draw(meet, "N", over, way.across, why=why.P_RESOLVED)
    length_q = draft.draw(measure_along, "y_Q", way.at_b, end_q, way.rod, why=why.FORCE_READ)
    length_n = draft.draw(measure_along, "y_N", way.at_b, end_n, way.across, why=why.FORCE_READ)
    vectors = (
        Vector(way.at_b, end, "P′"),
        Vector(way.at_b, end_q, "Q"),
        Vector(way.at_b, end_n, "N"),
    )
    return vectors, length_q, length_n


def _at_pin(draft: Draft, way: _Way, length: Mark) -> tuple[tuple[Vector, ...], dict[str, Mark]]:
    """Carry Q to the crank pin and resolve it into T and K."""
    at = way.at_a
    carried = draft.draw(parallel, "(Q_A)", at, way.rod, why=why.Q_CARRIED)
    end = draft.draw(lay_off, "Q_A", carried, length, why=why.Q_CARRIED)
    tangent = draft.draw(square, "(T)", at, way.crank, sense=way.sense, why=why.T_LINE)
    along = draft.draw(parallel, "(K)", at, way.crank, sense=-1, why=why.K_LINE)
    beside = draft.draw(parallel, "(QT)", end, along, sense=-1, why=why.BY_PARALLELS)
    over = draft.draw(parallel, "(QK)", end, tangent, sense=-1, why=why.BY_PARALLELS)
    end_t = draft.draw(meet, "T", beside, tangent, why=why.Q_RESOLVED)
    end_k = draft.draw(meet, "K", over, along, why=why.Q_RESOLVED)
    read = {
        "T": draft.draw(measure_along, "y_T", at, end_t, tangent, why=why.FORCE_READ),
        "K": draft.draw(measure_along, "y_K", at, end_k, along, why=why.FORCE_READ),
    }
    return (Vector(at, end, "Q"), Vector(at, end_t, "T"), Vector(at, end_k, "K")), read


def _at_bearing(
    draft: Draft, way: _Way, length: Mark
) -> tuple[tuple[Vector, ...], dict[str, Mark]]:
    """Add Q and −Q at the bearing; resolve Q into P′ along the cylinder and −N across it."""
    at = way.pivot
    line = draft.draw(parallel, "(Q_O)", at, way.rod, why=why.TWO_ADDED)
    end = draft.draw(lay_off, "Q_O", line, length, why=why.TWO_ADDED)
    back = draft.draw(parallel, "(−Q)", at, way.rod, sense=-1, why=why.TWO_ADDED)
    against = draft.draw(lay_off, "−Q", back, length, why=why.TWO_ADDED)
    axis = draft.draw(parallel, "(P′_O)", at, way.inward, why=why.ALONG_CYLINDER)
    up = draft.draw(parallel, "(−N)", at, way.across, sense=-1, why=why.ACROSS_CYLINDER)
    beside = draft.draw(parallel, "(QP′)", end, up, sense=-1, why=why.BY_PARALLELS)
    over = draft.draw(parallel, "(QN)", end, axis, sense=-1, why=why.BY_PARALLELS)
    end_p = draft.draw(meet, "P′_O", beside, axis, why=why.ALONG_CYLINDER)
    end_n = draft.draw(meet, "N_O", over, up, why=why.ACROSS_CYLINDER)
    read = {
        "P′_O": draft.draw(measure_along, "y_{PO}", at, end_p, axis, why=why.FORCE_READ),
        "N_O": draft.draw(measure_along, "y_{NO}", at, end_n, up, why=why.FORCE_READ),
    }
    vectors = (
        Vector(at, end, "Q"),
        Vector(at, against, "Q", against=True),
        Vector(at, end_p, "P′"),
        Vector(at, end_n, "N", against=True),
    )
    return vectors, read


def _couples(
    draft: Draft, made: Engine, machine: Machine, way: _Way, read: dict[str, Mark]
) -> tuple[Mark, tuple[Mark, Mark]]:
    """Measure the arms of both couples; return the foot of that of Q, −Q and both moments."""
    off = draft.draw(square, "(h)", way.pivot, way.rod, sense=-way.sense, why=why.ARM_OF_Q)
    foot = draft.draw(meet, "H", off, way.rod, why=why.ARM_OF_Q)
    arm = draft.draw(measure_along, "h", way.pivot, foot, off, why=why.ARM_OF_Q)
    pin = f"{machine.pivot}{made.order.point}"
    distance = draft.draw(measure, pin, way.pivot, way.at_b, why=why.DISTANCE)
    unit = f"{made.order.unit}·m"
    turning = draft.draw(moment_of_rod, "M", read["Q"], arm, draft.mu_l, unit=unit)
    tipping = draft.draw(couple_of, "M′", read["N"], distance, draft.mu_l, unit=unit)
    return foot, (turning, tipping)
