"""Mechanisms found from their dead centres: slider-cranks, crank-rockers, rockers with a stone, cylinders."""

from __future__ import annotations

from graphic_tmm.board.operations.formulas import swing_angle
from graphic_tmm.board.operations.graphs import halve
from graphic_tmm.board.operations.instruments import (
    cross,
    cut,
    incline,
    join,
    measure,
    meet,
    parallel,
    shift,
    square,
    strike,
)
from graphic_tmm.board.operations.supports import swung
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.linkage_synthesis import formulas as f
from graphic_tmm.chapters.linkage_synthesis import words as why
from graphic_tmm.chapters.linkage_synthesis.figure import (
    Between,
    Circle,
    Position,
    SynthesisBoard,
    SynthesisFigure,
)
from graphic_tmm.mechanism.synthesis_four_bar import choose_four_bar, take_angle, take_frame
from graphic_tmm.mechanism.synthesis_kinds import crank_by_pressure, slider_crank, take_stroke
from graphic_tmm.scene.length_task import Task

FREE = 24.0
"""So far, degrees, the locus of a pivot with a freedom left is drawn beyond the place that is taken."""


def draw_slider(board: SynthesisBoard, task: Task) -> SynthesisFigure:
    """Draw a slider-crank: by K_v and e from the circle of θ, else its dead centres from crank and rod."""
    return _slider_by_ratio(board, task) if task.K_v is not None else _slider_by_rod(board, task)


def _theta(board: SynthesisBoard, task: Task) -> Mark:
    return board.draft.draw(swing_angle, "θ", board.draft.take(Number, "K_v", task.K_v))


def _slider_by_ratio(board: SynthesisBoard, task: Task) -> SynthesisFigure:
    draft = board.draft
    theta = _theta(board, task)
    stroke = board.length("B_1B_2", take_stroke(draft, task.given))
    offset = board.length("e_l", draft.take(Number, "e", task.e, "m"))
    near = board.origin("B_1")
    guide = board.axis(near, "(x)")
    far = board.off("B_2", guide, stroke, why.STROKE_LAID)
    angles = (
        draft.draw(f.angle_at_chord, "β", theta, unit="°"),
        draft.draw(f.back_at_chord, "−β", theta, unit="°"),
    )
    middle = board.circle_of_angle(near, far, guide, angles)
    radius = draft.draw(measure, "MB_1", middle, near)
    locus = draft.draw(strike, "(η)", middle, radius)
    level = draft.draw(shift, "(e)", guide, offset, why=why.OFFSET)
    pivot = draft.draw(cut, "O", level, locus, board.side(-1), why=why.PIVOT_ON_LOCUS)
    crank, rod, line = board.crank_and_rod(pivot, near, far)
    pins = [board.dead_centre("A_1", near, pivot, rod), board.off("A_2", line, rod, why.IN_LINE)]
    return SynthesisFigure(
        task, board.mu,
        {"OA": board.real("OA", crank), "AB": board.real("AB", rod)},
        (Position((pivot, pins[1], far), True), Position((pivot, pins[0], near), True)),
        (pivot,), (near, far, middle, *pins), (near, far),
        (Circle("thin", middle, (far, pivot, near)), Circle("centre", pivot, tuple(pins))),
        angles=(Between(pivot, near, far, theta),),
    )  # fmt: skip


def _slider_by_rod(board: SynthesisBoard, task: Task) -> SynthesisFigure:
    """Draw the dead centres of a slider-crank whose rod is chosen by λ, or by the greatest pressure angle."""
    draft, measured, aslant_at = board.draft, dict[str, Mark](), list[Mark]()
    pivot = board.origin("O")
    guide = axis = board.axis(pivot, "(x)")
    side = 1
    offset = None
    if task.pressure is not None and task.e is None:
        stroke = board.length("S_l", take_stroke(draft, task.given))
        end = board.off("S_1", axis, stroke, why.STROKE_LAID)
        middle = draft.draw(halve, "S_2", pivot, end, why=why.HALF_STROKE)
        crank = draft.draw(measure, "OA", pivot, middle)
        measured["OA"] = board.real("OA", crank)
    elif task.pressure is not None:
        crank = board.length("OA", crank_by_pressure(draft, task.given))
        offset = draft.take(Number, "e", task.e, "m")
    else:
        found = slider_crank(draft, task.given)
        crank, rod, offset = board.length("OA", found["OA"]), found["AB"], found.get("e")
    if offset is not None:
        back = draft.draw(parallel, "(x′)", pivot, axis, sense=-1)
        by = board.length("e_l", offset)
        guide, side = draft.draw(shift, "(e)", back, by, why=why.OFFSET), -1
    if task.pressure is not None:
        across = draft.draw(square, "(OA)", pivot, axis)
        pin = board.off("A", across, crank, why.ASLANT)
        level = draft.draw(parallel, "(A)", pin, axis)
        aslant = draft.take(Angle, "[α]", task.pressure, "°")
        down = draft.draw(f.counted_back, "−α", aslant, unit="°")
        line = draft.draw(incline, "(AB)", pin, level, down, why=why.ASLANT)
        slid = draft.draw(meet, "B", guide, line, why=why.ASLANT)
        rod, aslant_at = draft.draw(measure, "AB", pin, slid), [pin, slid]
        measured["AB"] = board.real("AB", rod)
    else:
        rod = board.length("AB", rod)
    long, short = (
        draft.draw(op, letter, rod, crank)
        for op, letter in ((f.stretched, "OB_2"), (f.overlapping, "OB_1"))
    )
    ends = []
    for k, reach in ((1, short), (2, long)):
        arc = draft.draw(strike, f"(k_{k})", pivot, reach, why=why.DEAD_CENTRE)
        ends.append(draft.draw(cut, f"B_{k}", guide, arc, board.side(side), why=why.DEAD_CENTRE))
    pins = [
        board.dead_centre(f"A_{k}", end, pivot, rod) for k, end in zip((1, 2), ends, strict=True)
    ]
    measured["S"] = board.read("B_1B_2", ends[0], ends[1])
    return SynthesisFigure(
        task, board.mu, measured,
        (Position((pivot, pins[1], ends[1]), True), Position((pivot, pins[0], ends[0]), True)),
        (pivot,), (*ends, *pins, *aslant_at), (ends[0], ends[1]), (Circle("centre", pivot, tuple(pins)),),
    )  # fmt: skip


def draw_crank_rocker(board: SynthesisBoard, task: Task) -> SynthesisFigure:
    """Draw a crank-rocker: the circle of θ over the chord of B, O on it, the worst places of transmission."""
    draft, chosen = board.draft, choose_four_bar(task.given)
    theta = _theta(board, task)
    swing = draft.take(Angle, "ψ", task.psi, "°")
    rocker = board.length("BC", draft.take(Number, "l_{BC}", task.BC, "m"))
    if chosen.about:
        frame, angle = rocker, take_angle(draft, task.given, chosen)
    else:
        frame = board.length("OC", take_frame(draft, task.given, chosen))
    pivot = board.origin("C")
    axis = board.axis(pivot, "(y)", 90.0)
    ends = []
    for k, op in ((1, f.half_angle), (2, f.half_angle_back)):
        half = draft.draw(op, f"ψ_{k}", swing, unit="°")
        line = draft.draw(incline, f"(CB_{k})", pivot, axis, half, why=why.EXTREME)
        ends.append(board.off(f"B_{k}", line, rocker, why.EXTREME))
    near, far = ends
    chord = draft.draw(join, "(B_1B_2)", near, far)
    ops = (f.angle_at_chord, f.back_at_chord)[:: chosen.side]
    angles = [draft.draw(op, f"β_{k}", theta, unit="°") for k, op in zip((1, 2), ops, strict=True)]
    middle = board.circle_of_angle(near, far, chord, angles)
    radius = draft.draw(measure, "MB_1", middle, near)
    locus = draft.draw(strike, "(η)", middle, radius)
    if chosen.about:
        line = draft.draw(incline, "(CO)", pivot, axis, angle, why=why.ABOUT)
        origin = board.off("O", line, radius, why.PIVOT_ON_LOCUS)
    else:
        about = draft.draw(strike, "(OC)", pivot, frame)
        side = board.side(-1 if chosen.centre > 0.0 else 1)
        origin = draft.draw(cross, "O", locus, about, side, why=why.PIVOT_ON_LOCUS)
    crank, rod, line = board.crank_and_rod(origin, near, far)
    pins = [board.dead_centre("A_1", near, origin, rod), board.off("A_2", line, rod, why.IN_LINE)]
    seen = () if chosen.about else (middle,)  # the letter of C stands there
    worst, least = _transmission(board, origin, pivot, crank, rod, rocker, frame, chosen.sense)
    return SynthesisFigure(
        task, board.mu,
        {"OA": board.real("OA", crank), "AB": board.real("AB", rod)},
        (Position((origin, pins[1], far, pivot)), Position((origin, pins[0], near, pivot))),
        (origin, pivot), (near, far, *seen, *pins, *(one for at in worst for one in at.joints[1:3])),
        worst=worst,
        circles=(Circle("thin", middle, (far, origin, near), FREE), Circle("centre", origin, tuple(pins))),
        transmission=least,
        angles=(Between(origin, near, far, theta), Between(pivot, far, near, swing)),
    )  # fmt: skip


def _transmission(
    board: SynthesisBoard, origin: Mark, pivot: Mark, crank: Mark, rod: Mark, rocker: Mark, frame: Mark,
    sense: int,
) -> tuple[tuple[Position, ...], tuple[Mark, ...]]:  # fmt: skip
    """Measure the angles between coupler and rocker where crank and frame lie in one line."""
    draft, angles = board.draft, list[Mark]()
    positions = list[Position]()
    whole = draft.draw(f.stretched, "CA_4", frame, crank)
    pins = (
        board.on("A_3", origin, pivot, crank, why.WITH_FRAME),
        board.on("A_4", pivot, origin, whole, why.WITH_FRAME),
    )
    for k, pin in zip((3, 4), pins, strict=True):
        first = draft.draw(strike, f"(l_{k})", pin, rod)
        second = draft.draw(strike, f"(b_{k})", pivot, rocker)
        end = draft.draw(cross, f"B_{k}", first, second, board.side(sense))
        positions.append(Position((origin, pin, end, pivot)))
        angles.append(draft.draw(swung, f"γ_{k - 2}", end, pin, end, pivot, unit="°", sense=sense))
    return tuple(positions), tuple(angles)


def draw_rocker(board: SynthesisBoard, task: Task) -> SynthesisFigure:
    """Draw a rocker with its stone: two lines under θ, the crank square to them, the arm by the stroke."""
    draft = board.draft
    theta = _theta(board, task)
    apart = board.length("OB", draft.take(Number, "l_{OB}", task.OB, "m"))
    pivot = board.origin("B")
    axis = board.axis(pivot, "(y)", 90.0)
    origin = board.off("O", axis, apart)
    down = draft.draw(parallel, "(y′)", pivot, axis, sense=-1)
    stroke = draft.take(Number, "S", task.stroke, "m")
    half_stroke = draft.draw(f.half_length, "S/2", board.length("S_l", stroke))
    pins, arms = [], []
    for k, op in ((1, f.half_angle), (2, f.half_angle_back)):
        half = draft.draw(op, f"θ_{k}", theta, unit="°")
        line = draft.draw(incline, f"(BA_{k})", pivot, axis, half, why=why.TOUCHING)
        across = draft.draw(square, f"(OA_{k})", origin, line, why=why.TOUCHING)
        pins.append(draft.draw(meet, f"A_{k}", line, across, why=why.TOUCHING))
        arm = draft.draw(incline, f"(BC_{k})", pivot, down, half)
        away = draft.draw(shift, f"(S_{k})", down if k == 1 else axis, half_stroke)
        arms.append(draft.draw(meet, f"C_{k}", arm, away))
    measured = {"OA": board.read("OA_1", origin, pins[0]), "BC": board.read("BC_1", pivot, arms[0])}
    return SynthesisFigure(
        task, board.mu, measured,
        tuple(
            Position((origin, pin, arm))
            for pin, arm in zip(pins, arms, strict=True)
        ),
        (origin, pivot), (*pins, *arms), circles=(Circle("centre", origin, tuple(pins)),),
        angles=(Between(pivot, pins[1], pins[0], theta),),
    )  # fmt: skip


def draw_cylinder(board: SynthesisBoard, task: Task) -> SynthesisFigure:
    """Draw a swinging cylinder: the circle of the crank pin touches both its extreme lines."""
    draft = board.draft
    swing = draft.take(Angle, "ψ", task.psi, "°")
    stroke = board.length("S_l", take_stroke(draft, task.given))
    crank = draft.draw(f.half_length, "OA", stroke)
    pivot = board.origin("C")
    axis = board.axis(pivot, "(x)")
    sides = [
        draft.draw(incline, f"(CA_{k})", pivot, axis,
                   draft.draw(op, f"ψ_{k}", swing, unit="°"), why=why.SWUNG)
        for k, op in ((1, f.half_angle_back), (2, f.half_angle))
    ]  # fmt: skip
    beside = draft.draw(shift, "(r)", sides[0], crank, why=why.CYLINDER)
    origin = draft.draw(meet, "O", axis, beside, why=why.CYLINDER)
    pins = []
    for k, side in zip((1, 2), sides, strict=True):
        across = draft.draw(square, f"(OA_{k})", origin, side)
        pins.append(draft.draw(meet, f"A_{k}", side, across, why=why.CYLINDER))
    measured = {"OA": board.read("OA_1", origin, pins[0]), "OC": board.read("OC", pivot, origin)}
    return SynthesisFigure(
        task, board.mu, measured,
        tuple(Position((origin, pin, pivot)) for pin in pins),
        (origin, pivot), tuple(pins), circles=(Circle("centre", origin, tuple(pins)),),
        angles=(Between(pivot, pins[0], pins[1], swing),),
    )  # fmt: skip
