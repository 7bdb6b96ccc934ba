"""Mechanisms found from three positions: of a coupler by bisectors, of crank and rocker by inversion."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.instruments import (
    incline,
    join,
    measure,
    measure_along,
    place,
    ray,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.linkage_synthesis import formulas as f
from graphic_tmm.chapters.linkage_synthesis import words as why
from graphic_tmm.chapters.linkage_synthesis.figure import (
    Circle,
    Position,
    SynthesisBoard,
    SynthesisFigure,
)
from graphic_tmm.mechanism.synthesis_functions import take_pairs
from graphic_tmm.mechanism.synthesis_kinds import PLACES
from graphic_tmm.scene.length_task import Task


def draw_coupler(board: SynthesisBoard, task: Task) -> SynthesisFigure:
    """Draw a four-bar through three positions of its coupler: two pairs of bisectors."""
    draft = board.draft
    zero = board.origin("(0)")
    across = board.axis(zero, "(x)")
    length = board.length("AB", draft.take(Number, "l_{AB}", task.AB, "m"))
    first, second = [], []
    for k, spot, angle in zip(PLACES, task.A, task.angles, strict=True):
        x, y = (
            board.length(
                f"{axis}_{{A{k}}}", draft.take(Number, f"{axis.upper()}_{{A{k}}}", part, "m")
            )
            for axis, part in (("x", spot.real), ("y", spot.imag))
        )
        first.append(draft.draw(place, f"A_{k}", across, x, y))
        alpha = draft.take(Angle, f"α_{k}", angle, "°")
        line = draft.draw(ray, f"(A_{{{k}}}B_{k})", first[-1], alpha, why=why.POINTER)
        second.append(board.off(f"B_{k}", line, length, why.POINTER))
    origin = board.centre("O", first, ("E_1", "E_2"))
    pivot = board.centre("C", second, ("F_1", "F_2"))
    up = draft.draw(square, "(y)", zero, across)
    measured = {
        f"{axis}{name}": draft.draw(
            in_si, f"{axis.upper()}_{{{name}}}",
            draft.draw(measure_along, f"{axis}_{{{name}}}", zero, point, line),
            board.mu, unit="m",
        )
        for name, point in (("O", origin), ("C", pivot))
        for axis, line in (("x", across), ("y", up))
    }  # fmt: skip
    measured["OA"] = board.read("OA", origin, first[0])
    measured["BC"] = board.read("BC", second[0], pivot)
    return _through(board, task, measured, origin, pivot, first, second)


def _through(
    board: SynthesisBoard, task: Task, measured: dict[str, Mark], origin: Mark, pivot: Mark,
    first: Sequence[Mark], second: Sequence[Mark], more: Sequence[Mark] = (),
) -> SynthesisFigure:  # fmt: skip
    return SynthesisFigure(
        task, board.mu, measured,
        tuple(
            Position((origin, a, b, pivot)) for a, b in zip(first, second, strict=True)
        ),
        (origin, pivot), (*first, *second, *more),
        circles=(
            Circle("thin", origin, tuple(first)), Circle("thin", pivot, tuple(second)),
        ),
        places=True,
    )  # fmt: skip


def draw_angles(board: SynthesisBoard, task: Task) -> SynthesisFigure:
    """Draw a four-bar for three pairs of angles: the rocker held, the frame turned back about C."""
    draft = board.draft
    crank, rocker = (
        [draft.take(Angle, f"{letter}_{k}", one, "°") for k, one in zip(PLACES, row, strict=True)]
        for letter, row in (("φ", task.crank), ("ψ", task.rocker))
    )
    return _inverted(board, task, crank, rocker)


def draw_function(board: SynthesisBoard, task: Task) -> SynthesisFigure:
    """Draw a four-bar for a function: three pairs of angles that stand for its points, then as any."""
    return _inverted(board, task, *take_pairs(board.draft, task.given))


def _inverted(
    board: SynthesisBoard, task: Task, crank: Sequence[Mark], rocker: Sequence[Mark]
) -> SynthesisFigure:
    draft = board.draft
    arm = board.length("OA", draft.take(Number, "l_{OA}", task.OA, "m"))
    frame = board.length("OC", draft.take(Number, "l_{OC}", task.OC, "m"))
    origin = board.origin("O")
    axis = board.axis(origin, "(x)")
    pivot = board.off("C", axis, frame)
    first, held = [], []
    turns = {}
    for k, phi, psi in zip(PLACES, crank, rocker, strict=True):
        line = draft.draw(ray, f"(OA_{k})", origin, phi, why=why.CRANK_AT)
        at = board.off(f"A_{k}", line, arm, why.CRANK_AT)
        first.append(at)
        if k == 1:
            held.append(at)
            continue
        turns[k] = draft.draw(f.turned_by, f"ψ_{{1{k}}}", rocker[0], psi, unit="°")
        back = draft.draw(f.counted_back, f"−ψ_{{1{k}}}", turns[k], unit="°")
        reach = draft.draw(measure, f"CA_{k}", pivot, at)
        out = draft.draw(join, f"(CA_{k})", pivot, at)
        turned = draft.draw(incline, f"(CA_{k}′)", pivot, out, back, why=why.BACK)
        held.append(board.off(f"A_{k}′", turned, reach, why.BACK))
    pin = board.centre("B_1", held, ("E_1", "E_2"))
    rod = draft.draw(measure, "AB", first[0], pin)
    swing = draft.draw(measure, "BC", pin, pivot)
    measured = {"AB": board.real("AB", rod), "BC": board.real("BC", swing)}
    start, second = draft.draw(join, "(CB_1)", pivot, pin), [pin]
    for k, turn in turns.items():
        line = draft.draw(incline, f"(CB_{k})", pivot, start, turn, why=why.FORTH)
        second.append(board.off(f"B_{k}", line, swing, why.FORTH))
    return _through(board, task, measured, origin, pivot, first, second, held[1:])
