"""The Geneva wheel as it stands when the pin enters: half a pitch, the square on it, the angle 2φ."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import share
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import (
    incline,
    join,
    lay_off,
    measure,
    meet,
    ray,
    square,
)
from graphic_tmm.board.operations.supports import swung
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.geneva import formulas as f
from graphic_tmm.chapters.geneva import words as why
from graphic_tmm.chapters.geneva.task import ASKED, FREE, GENEVA, PIN, GenevaTask
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.chapters.kinematics.drives.rack import Rack
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import joined, said
from graphic_tmm.mechanism.records import Drive, Mechanism, Slide
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

ANGLES = 0.01
"""A position this near to the entry or the exit, degrees, is in it: crank angles are written so at best."""
CLEAR = 1e-9
"""A slot that passes the wheel's centre by less than this share of the distance of centres goes through it."""


class Crossing(NamedTuple):
    """Where the pin enters or leaves: the line of the slot from the wheel's centre, the place on it."""

    slot: Mark
    at: Mark


@dataclass(frozen=True)
class Geneva:
    """The wheel as drawn about its ``centre``, the crank's ``origin``; lengths on the board unless told else.

    ``apart``: of the centres, ``distance``: in m; ``due``: the crank that is wanted, ``given``: that of the
    scene (Number, m); ``half``: of a pitch, ``engaged``: the angle of engagement (Angle); ``rim``, ``bottom``:
    how far slots begin and end from the centre; ``share``, ``by_slots``: of motion in a turn, as measured and
    by the number of slots; ``fastest``: the greatest ratio of angular velocities; ``motion``, ``dwell``: times
    (s), None where the crank stands or its speed varies.
    """

    order: GenevaTask
    distance: float
    sense: int
    mu: Mark
    origin: Mark
    centre: Mark
    entry: Crossing
    exit: Crossing
    apart: Mark
    crank: Mark
    pin: Mark
    lock: Mark
    rim: Mark
    bottom: Mark
    half: Mark
    engaged: Mark
    due: Mark
    given: Mark
    share: Mark
    by_slots: Mark
    fastest: Mark
    motion: Mark | None
    dwell: Mark | None


GENEVA_PLAN: Recorded[Geneva] = Recorded(GENEVA)


class _Parts(NamedTuple):
    """Letters of the crank's centre and pin, of the wheel's centre; the way between both centres (m)."""

    origin: str
    pin: str
    centre: str
    apart: complex


def record(bench: Bench) -> Geneva | None:
    """Draw the Geneva wheel of the mechanism.

    Raises
    ------
    StructureError
        If no crank drives a stone in a slot through the wheel's pivot, or positions lie beyond the engagement.
    """
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    plans = KINEMATICS_PLAN.on(bench)
    parts = _parts(plans)
    _refuse_beyond(bench, order, plans, parts)
    return _draw(bench.draft, order, plans, parts)


def _draw(draft: Draft, order: GenevaTask, plans: KinematicPlans, parts: _Parts) -> Geneva:
    crank_pair, sense = _crank(plans), plans.sense
    draft.open(GENEVA)
    mu = draft.scale("μ_l", "m/mm")
    origin = draft.take(Point, parts.origin, 0j)
    draft.lay_out(origin)

    def length(letter: str, metres: float) -> tuple[Mark, Mark]:
        """Take a real length, and calculate that on the board."""
        real = draft.take(Number, f"l_{{{letter}}}", metres, "m")
        return real, draft.draw(to_board, letter, real, mu)

    name = f"{parts.origin}{parts.centre}"
    way = draft.direction(math.degrees(cmath.phase(parts.apart)))
    line = draft.draw(ray, f"({name})", origin, way)
    distance, apart = length(name, abs(parts.apart))
    centre = draft.draw(lay_off, parts.centre, line, apart, why=why.CENTRES)
    back = draft.draw(join, f"({parts.centre}{parts.origin})", centre, origin)
    z, pins = (
        draft.take(Number, "z", float(order.slots)),
        draft.take(Number, "k", float(order.pins)),
    )
    half = draft.draw(f.half_pitch, "β", z, unit="°")
    other = draft.draw(f.other_side, "−β", half, unit="°")
    turns = (half, other) if sense > 0 else (other, half)
    entry, exit_ = (
        _crossing(draft, parts, origin, back, turn, k) for k, turn in enumerate(turns, 1)
    )
    rim = draft.draw(measure, f"{parts.centre}E_1", centre, entry.at)
    ends = (origin, entry.at, origin, exit_.at)
    engaged = draft.draw(swung, "2φ", *ends, unit="°", sense=sense)
    given, crank = length(f"{parts.origin}{parts.pin}", abs(crank_pair.arm))
    due = draft.draw(f.crank_due, "R", distance, half, unit="m")
    if order.pin is not None:
        thick = draft.take(Number, "d_{p}", order.pin, "m")
    else:
        thick = draft.draw(share, "d_{p}", given, draft.take(Number, "", PIN), unit="m")
    radius = draft.draw(f.pin_radius, "R_{p}", thick, unit="m")
    pin = draft.draw(to_board, "r_{p}", radius, mu)
    if order.lock is not None:
        held = draft.take(Number, "R_{l}", order.lock, "m")
    else:
        times = draft.take(Number, "", FREE)
        held = draft.draw(f.usual_disc, "R_{l}", given, times, thick, unit="m")
    lock = draft.draw(to_board, "r_{l}", held, mu)
    bottom = draft.draw(f.slot_bottom, "r_{b}", apart, crank, pin)
    middle = draft.draw(lay_off, "M", line, crank)
    rest = draft.draw(measure, f"{parts.centre}M", centre, middle)
    fastest = draft.draw(f.fastest, "u", crank, rest)
    moves = draft.draw(f.share_of_motion, "τ", pins, engaged)
    by_slots = draft.draw(f.share_by_slots, "τ′", pins, z)
    motion = dwell = None
    if speed := _even_speed(plans.mechanism.drive):
        omega = draft.take(Number, f"ω_{crank_pair.link}", speed, "1/s")
        motion = draft.draw(f.time_of_motion, "t_{m}", engaged, omega, unit="s")
        if order.spare > 0:
            dwell = draft.draw(f.time_of_dwell, "t_{d}", pins, omega, motion, unit="s")
    return Geneva(
        order, abs(parts.apart), sense, mu, origin, centre, entry, exit_, apart, crank, pin, lock,
        rim, bottom, half, engaged, due, given, moves, by_slots, fastest, motion, dwell,
    )  # fmt: skip


def _even_speed(drive: Drive) -> float:
    """Return how fast the crank turns, 1/s; 0 where it stands, or not evenly."""
    uneven = drive.rates or drive.gains or drive.acceleration
    return 0.0 if uneven else abs(drive.speed)


def _crossing(
    draft: Draft, parts: _Parts, origin: Mark, back: Mark, turn: Mark, k: int
) -> Crossing:
    """Draw a slot as it stands at the entry (1) or the exit (2), and where the pin is then."""
    says, there = ((why.SLOT_AT_ENTRY, why.ENTRY), (why.SLOT_AT_EXIT, why.EXIT))[k - 1]
    name = f"{parts.centre}E_{k}"
    centre = draft.uses(back)[0]
    slot = draft.draw(incline, f"({name})", centre, back, turn, why=says)
    across = draft.draw(square, f"({parts.origin}E_{k})", origin, slot)
    return Crossing(slot, draft.draw(meet, f"E_{k}", across, slot, why=there))


def _crank(plans: KinematicPlans) -> Crank:
    pair = plans.pairs[0]
    if not isinstance(pair, Crank) or isinstance(pair, Rack):
        says = said("a crank has to drive it, whose pin slides in the slot of the wheel")
        raise StructureError(says, "drive.link", head="geneva")
    return pair


def _parts(plans: KinematicPlans) -> _Parts:
    """Find the wheel: the link with the slot in which a stone on the crank's pin slides."""
    crank, mechanism = _crank(plans), plans.mechanism
    for stone in mechanism.drawn:
        for slide in stone.slides:
            wheel = mechanism.by_number.get(slide.on)
            if crank.pin not in stone.points or wheel is None or wheel is mechanism.frame:
                continue
            centre = next((one for one in wheel.points if one in mechanism.frame.points), None)
            if centre is None:
                continue
            apart = _apart(mechanism, crank.pivot, centre)
            if not _through(
                wheel.points[centre], stone.points[crank.pin], slide, CLEAR * abs(apart)
            ):
                says = said(
                    "slot and pin of link {n} have to go through its pivot {letter}: leave offset out, and "
                    "let the pin stand in the middle of the slot",
                    n=slide.on,
                    letter=centre,
                )
                raise StructureError(says, "geneva", head="geneva")
            return _Parts(crank.pivot, crank.pin, centre, apart)
    says = said(
        "no stone on the crank's pin {pin} slides in a wheel that turns about the frame; such a wheel is drawn "
        "as a link with a slot",
        pin=crank.pin,
    )
    raise StructureError(says, "geneva", head="geneva")


def _through(centre: complex, pin: complex, slide: Slide, clear: float) -> bool:
    """Whether the slot goes through a place of its link, and the pin, in the stone's axes, along its middle."""
    off = (centre - slide.guide.through) * cmath.rect(1.0, -math.radians(slide.guide.angle))
    beside = pin * cmath.rect(1.0, math.radians(slide.angle))
    return max(abs(off.imag), abs(beside.imag), abs(slide.offset)) <= clear


def _apart(mechanism: Mechanism, origin: str, centre: str) -> complex:
    return mechanism.frame.points[centre] - mechanism.frame.points[origin]


def _refuse_beyond(bench: Bench, order: GenevaTask, plans: KinematicPlans, parts: _Parts) -> None:
    """Refuse positions in which the pin is in no slot: there the wheel stands, a slotted link turns back."""
    middle, half = math.degrees(cmath.phase(parts.apart)), 90.0 - 180.0 / order.slots
    for k, (name, angle) in enumerate(zip(bench.names, bench.coordinates, strict=True)):
        if angle is None or abs((angle - middle + 180.0) % 360.0 - 180.0) <= half + ANGLES:
            continue
        start, end = (round(middle + side * plans.sense * half, 3) for side in (-1, 1))
        says = said(
            "in position {name} the pin is out of the slot: it enters at {start:g}° and leaves at {end:g}°",
            name=name, start=start, end=end,
        )  # fmt: skip
        if k >= bench.count:
            raise StructureError(says, "drive.extra", head="geneva")
        remedy = said(
            'write from = "{start:g} deg", to = "{end:g} deg" and no zero', start=start, end=end
        )
        raise StructureError(joined("; ", (says, remedy)), "drive.from", head="geneva")
