"""What is recorded of a gear pair: its plan; aside ratio, arc of engagement, drawn sizes, sliding."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import in_si, product, to_board, turns_a_minute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.gears import formulas as g
from graphic_tmm.chapters.gears.driven_rack import sliding_on_rack, sliding_velocity_on_rack
from graphic_tmm.chapters.gears.helical import equivalent_teeth, overlap_ratio
from graphic_tmm.chapters.gears.plan import GEARS_PLAN, Gear, record
from graphic_tmm.chapters.gears.rack import least_teeth
from graphic_tmm.chapters.gears.ring import sliding_velocity_inside
from graphic_tmm.chapters.gears.task import GEARS
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside

VIEW = "gear-calculation"
"""The view of what is calculated."""


class Motion(NamedTuple):
    """Angular velocities and speeds (rpm) of both wheels, the velocity of the rolling circles (m/s).

    ``sliding``: by place on the line of action its velocity of sliding (m/s) and that over ``rolling``.
    """

    omega: tuple[Mark, ...]
    turns: tuple[Mark, ...]
    rolling: Mark
    sliding: Mapping[str, tuple[Mark, Mark]]


class Aside(NamedTuple):
    """Marks of a pair.

    ``ratio``: u12, None of a rack; ``path``: how much of the line of action is in use, ``arc``: that of
    engagement on the rolling circles (Number, m). ``drawn``: of dimensions their lengths on the sheet (Length).
    ``start``: N1 from itself (Length); ``limits``: ϑ of wheel 2 in N1 and of wheel 1 in N2 (Number), which a
    ring has no use of; with a rack the first alone. ``z_min``: of each wheel that a rack cuts, the least teeth
    without undercut.
    ``helical``: of a helical pair by name: overlap, both ratios together, equivalent teeth; ``motion``: where
    the speed is given.
    """

    ratio: Mark | None
    path: Mark
    arc: Mark
    drawn: Mapping[Mark, Mark]
    start: Mark
    limits: tuple[Mark, ...]
    z_min: tuple[Mark, ...]
    helical: Mapping[str, Mark]
    motion: Motion | None


BESIDE: Recorded[Aside] = Recorded(aside(GEARS))


def record_beside(bench: Bench) -> Aside:
    """Calculate what the drawing of a pair does not need."""
    gear, draft = GEARS_PLAN.on(bench), bench.draft
    drawn = _laid_off(bench, gear)
    sizes, line = gear.sizes, gear.line
    one, other = sizes.wheels[0], sizes.wheels[-1]
    draft.open(VIEW)
    ratio = None
    if sizes.rack is None:
        ratio = draft.draw(g.ratio_of_teeth, "u_{12}", other.z, one.z)
    path = draft.draw(g.path_of_contact, "g_{α}", sizes.contact_ratio, sizes.p_b, unit="m")
    arc = draft.draw(g.arc_of_engagement, "s_{cd}", path, one.r_w, one.r_b, unit="m")
    for mark in (sizes.h, sizes.h_w, arc):
        drawn[mark] = draft.draw(to_board, f"[{mark.letter}]", mark, line.mu)
    start = draft.take(Length, "N_{1}N_{1}", 0.0, "mm")
    limits: tuple[Mark, ...]
    if sizes.rack is not None:
        limits = (draft.draw(sliding_on_rack, "ϑ_{2N_1}", start, line.length),)
    else:
        limits = (
            draft.draw(g.specific_sliding, "ϑ_{2N_1}", other.z, one.z, start, line.length),
            draft.draw(g.specific_sliding, "ϑ_{1N_2}", one.z, other.z, start, line.length),
        )
    racked = [(w.number, w.cut.rack.straight, w.x_drawn) for w in sizes.wheels if w.cut]
    z_min = tuple(
        draft.draw(least_teeth, f"z_{{min{i}}}", high, sizes.module, x, sizes.alpha)
        for i, high, x in racked
    )
    motion = None if gear.order.speed is None else _motion(draft, gear, ratio, start)
    return Aside(ratio, path, arc, drawn, start, limits, z_min, _helical(draft, gear), motion)


def _helical(draft: Draft, gear: Gear) -> dict[str, Mark]:
    """Calculate what only a helical pair has."""
    sizes, helix = gear.sizes, gear.sizes.helix
    if helix is None:
        return {}
    found = {
        f"z_v{w.number}": draft.draw(equivalent_teeth, f"z_{{v{w.number}}}", w.z, helix.beta)
        for w in sizes.wheels
    }
    if gear.order.width is not None:
        width = draft.take(Number, "b", gear.order.width, "m")
        beta = draft.draw(overlap_ratio, "ε_{β}", width, helix.beta, sizes.m)
        found["overlap_ratio"] = beta
        found["total_ratio"] = draft.draw(added, "ε_{γ}", sizes.contact_ratio, beta)
    return found


def _motion(draft: Draft, gear: Gear, ratio: Mark | None, start: Mark) -> Motion:
    """Calculate the speed of wheel 2 and how fast the flanks slide in the named places."""
    line, places = gear.line, {"N1": start, **_places(gear)}
    omega = draft.take(Number, "ω_{1}", gear.order.speed, "1/s")
    rates = [omega]  # a rack does not turn
    if ratio is not None:
        rates.append(draft.draw(g.driven_speed, "ω_{2}", omega, ratio, unit="1/s"))
    turns = tuple(
        draft.draw(turns_a_minute, f"n_{i}", one, unit="rpm") for i, one in enumerate(rates, 1)
    )
    rolling = draft.draw(product, "v", omega, gear.sizes.wheels[0].r_w, unit="m/s")
    op = g.sliding_velocity if gear.sizes.ring is None else sliding_velocity_inside
    op = op if ratio else sliding_velocity_on_rack
    pole = draft.draw(in_si, "N_{1}P·μ", line.to_pole, line.mu, unit="m")
    found = {}
    for name, x in places.items():
        real = draft.draw(in_si, f"{x.letter}·μ", x, line.mu, unit="m")
        speed = draft.draw(op, f"v_{{s{name}}}", *rates, real, pole, unit="m/s")
        found[name] = speed, draft.draw(g.ratio_of_speeds, f"v_{{s{name}}}/v", speed, rolling)
    return Motion(tuple(rates), turns, rolling, found)


def _places(gear: Gear) -> dict[str, Mark]:
    """Return the ends of the working line and of the line of action, by name, and "s": how far from N1."""
    line = gear.line
    found = {
        name: line.to_ends[end]
        for name, end in zip("ab", line.ends, strict=True)
        if end in line.to_ends
    }
    found["P"] = line.to_pole
    if len(line.limits) == 2 and gear.sizes.ring is None:
        found["N2"] = line.length
    if gear.sliding.further is not None:
        found["s"] = gear.sliding.further.x
    return found


def _laid_off(bench: Bench, gear: Gear) -> dict[Mark, Mark]:
    """Return the lengths on the sheet of the dimensions that the drawing lays off, by dimension."""
    steps = bench.draft.board.construction().steps
    found: dict[Mark, Mark] = {}
    for step in steps:
        if step.op is to_board and step.uses[1] == gear.line.mu:
            found.setdefault(step.uses[0], step.it)
    return found


PLAN = Plan(record=record, aside=record_beside)
