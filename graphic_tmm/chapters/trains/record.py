"""What is recorded of a train: its plan; aside ratios with the carrier stopped, the teeth that U asks for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from graphic_tmm.board.operations.formulas import turns_a_minute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.trains import formulas as t
from graphic_tmm.chapters.trains.closed_torques import draw_closed_torques, draw_powers
from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN, Planetary, record
from graphic_tmm.chapters.trains.rows import Row, closing_rows, draw_rolling, index, rows_of
from graphic_tmm.chapters.trains.task import PLANETARY_TRAIN
from graphic_tmm.chapters.trains.torques import draw_torques
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside

CALCULATED, BEHIND = "planetary-calculation", "planetary-behind"
"""The views of what is calculated of the train, and behind it."""


class Aside(NamedTuple):
    """Marks (Number).

    ``stopped``: the ratio of each mesh while the carrier stands; ``ring``, ``satellite``: the teeth of a
    train of one row that its ratio asks for, not yet whole; ``most``: the largest number of satellites whose
    teeth do not touch; ``turns``: of the bodies that move, as drawn, and of the wheels outside, rpm;
    ``torques`` on the three shafts, N·m, and the ``efficiency`` where one drives, if asked for, by the
    numbers of what is ``lost``; the ``powers`` (W) on members of a closed differential, and what share of that
    put in ``circulates``; ``speed``: of the last wheel behind the train, rpm, without sign. None where
    there is no such thing. ``rack``: how fast the rack runs, m/s.
    """

    stopped: tuple[Mark, ...]
    ring: Mark | None
    satellite: Mark | None
    most: Mark | None
    turns: Mapping[str, Mark]
    lost: tuple[Mark, ...]
    torques: Mapping[str, Mark]
    efficiency: Mark | None
    speed: Mark | None
    powers: Mapping[str, Mark]
    circulates: Mark | None
    rack: Mark | None = None


BESIDE: Recorded[Aside] = Recorded(aside(PLANETARY_TRAIN))


def locks(drawn: Drawn) -> bool:
    """Return whether losses take more power than is put in, so that no torque of a motion is there."""
    share = BESIDE.on(drawn).efficiency
    return share is not None and not drawn.value(share) > 0.0


def record_beside(bench: Bench) -> Aside:
    """Calculate what a train's drawing does not need."""
    made = PLANETARY_PLAN.on(bench)
    bench.draft.open(CALCULATED)
    ring, satellite = _teeth_for_ratio(bench, made)
    stopped, most = _stopped(bench, made), _most(bench, made)
    turns = {
        body: bench.draft.draw(turns_a_minute, f"n_{index(body)}", omega, unit="rpm")
        for body, omega in {**made.rates.values, **made.pairs.before}.items()
    }
    if behind := rows_of(made.order, made.train.scheme, "behind"):
        driven = turns[made.motion.driven]
        turns |= draw_rolling(bench.draft, behind, driven, made.pairs.teeth)
    if (closing := made.motion.closing) is not None:
        first, (names, teeth, _) = closing_rows(made.order, made.train.scheme, closing)
        rows, outer = (first, Row(names[:-1], teeth[:-1])), turns[closing.joint]
        turns |= draw_rolling(bench.draft, rows, outer, made.pairs.teeth)
        turns[names[-1]] = turns[closing.other]
    closing = made.motion.closing
    if closing is not None and made.order.moment is not None:
        lost, torques, share = draw_closed_torques(bench.draft, made, closing)
    else:
        lost, torques, share = draw_torques(bench.draft, made)
    powers, round_about = draw_powers(bench.draft, made, torques)
    last = _speed(bench, made)
    rack = None
    if behind and behind[-1].rack:
        bench.draft.open(BEHIND)
        driving = behind[-1].names[0]
        of = bench.draft.uses(made.sizes.radii["1"])[0], made.pairs.teeth[driving], turns[driving]
        rack = bench.draft.draw(t.speed_of_rack, f"v_{index(behind[-1].rack)}", *of, unit="m/s")
    return Aside(
        stopped, ring, satellite, most, turns, lost, torques, share, last, powers, round_about, rack
    )


def _teeth_for_ratio(bench: Bench, made: Planetary) -> tuple[Mark | None, Mark | None]:
    """Calculate the teeth of ring and satellite from those of the sun and the ratio."""
    order, draft = made.order, bench.draft
    if made.train.scheme.rows != 1 or order.ratio is None or made.motion.fixed != "3":
        return None, None
    sun = made.sizes.teeth["1"]
    wanted = draft.take(Number, "U", order.ratio)
    asked = t.teeth_of_ring if made.motion.first == "1" else t.teeth_of_driven_ring
    ring = draft.draw(asked, "z′_3", sun, wanted)
    return ring, draft.draw(t.teeth_between, "z′_2", ring, sun)


def _stopped(bench: Bench, made: Planetary) -> tuple[Mark, ...]:
    """Calculate the ratio of each mesh with the carrier stopped: negative where both wheels are outside.

    Of bevel wheels none: their axes are not parallel.
    """
    teeth, scheme = made.sizes.teeth, made.train.scheme
    if scheme.bevel:
        return ()
    found = []
    for k, mesh in enumerate(scheme.meshes):
        driving, driven = (mesh.rim, mesh.wheel) if k else (mesh.wheel, mesh.rim)
        op = t.mesh_outside if mesh.sense > 0 else t.mesh_inside
        letter = f"U_{{{driving}{driven}}}^{{H}}"
        found.append(bench.draft.draw(op, letter, teeth[driven], teeth[driving]))
    return tuple(found)


def _most(bench: Bench, made: Planetary) -> Mark | None:
    """Calculate the largest number of satellites by the condition of neighbours; a single one has none."""
    if made.train.satellites == 1 or made.train.scheme.bevel:
        return None
    sizes, draft = made.sizes, bench.draft
    if len(sizes.tips) == 1:
        return draft.draw(t.most_satellites, "k_{max}", *sizes.tips.values(), sizes.axes)
    rims = [
        draft.draw(t.most_satellites, f"k_{{max{wheel}}}", tip, sizes.axes)
        for wheel, tip in sizes.tips.items()
    ]
    return draft.draw(t.fewer, "k_{max}", *rims)


def _speed(bench: Bench, made: Planetary) -> Mark | None:
    """Calculate the speed of the last wheel behind the train, of its driven shaft if there is none."""
    pairs, motion = made.pairs, made.motion
    if pairs.ratio is None:
        return None
    bench.draft.open(BEHIND)
    before = rows_of(made.order, made.train.scheme, "before")
    behind = rows_of(made.order, made.train.scheme, "behind")
    first = before[-1].names[-1] if before else motion.first
    behind = tuple(row for row in behind if not row.rack)
    last = behind[-1].names[-1] if behind else f"{motion.driven}′"
    omega = pairs.before[first] if before else made.picture.omegas[motion.first]
    driving = bench.draft.draw(turns_a_minute, f"n_{index(first)}", omega, unit="rpm")
    return bench.draft.draw(t.speed_behind, f"n_{index(last)}", driving, pairs.ratio, unit="rpm")


PLAN = Plan(record=record, aside=record_beside)
