"""What is recorded of a gear pair: its plan; aside ratio, arc of engagement, drawn sizes, sliding."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length
from graphic_tmm.chapters.gears import formulas as g
from graphic_tmm.chapters.gears.plan import GEARS_PLAN, Gear, record
from graphic_tmm.chapters.gears.task import GEARS
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside

VIEW = "gear-calculation"
"""The view of what is calculated."""


class Aside(NamedTuple):
    """Marks of a pair.

    ``ratio``: u12; ``path``: how much of the line of action is in use, ``arc``: that of engagement on the
    rolling circles (Number, m). ``drawn``: of dimensions (by their marks) the lengths on the sheet (Length).
    ``start``: N1 from itself (Length); ``limits``: ϑ of wheel 2 in N1 and of wheel 1 in N2 (Number).
    """

    ratio: Mark
    path: Mark
    arc: Mark
    drawn: Mapping[Mark, Mark]
    start: Mark
    limits: tuple[Mark, Mark]


BESIDE: Recorded[Aside] = Recorded(aside(GEARS))


def record_beside(bench: Bench) -> Aside:
    """Calculate what the drawing of a pair does not need."""
    gear, draft = GEARS_PLAN.on(bench), bench.draft
    drawn = _laid_off(bench, gear)
    sizes, line = gear.sizes, gear.line
    one, other = sizes.wheels
    draft.open(VIEW)
    ratio = draft.draw(g.ratio_of_teeth, "u_{12}", other.z, one.z)
    path = draft.draw(g.path_of_contact, "g_{α}", sizes.contact_ratio, sizes.p_b, unit="m")
    arc = draft.draw(g.arc_of_engagement, "s_{cd}", path, one.r_w, one.r_b, unit="m")
    for mark in (sizes.h, sizes.h_w, arc):
        drawn[mark] = draft.draw(to_board, f"[{mark.letter}]", mark, line.mu)
    start = draft.take(Length, "N_{1}N_{1}", 0.0, "mm")
    limits = (
        draft.draw(g.specific_sliding, "ϑ_{2N_1}", other.z, one.z, start, line.length),
        draft.draw(g.specific_sliding, "ϑ_{1N_2}", one.z, other.z, start, line.length),
    )
    return Aside(ratio, path, arc, drawn, start, limits)


def _laid_off(bench: Bench, gear: Gear) -> dict[Mark, Mark]:
    """Return the lengths on the sheet of the dimensions that the drawing lays off, by dimension."""
    steps = bench.draft.board.construction().steps
    found: dict[Mark, Mark] = {}
    for step in steps:
        if step.op is to_board and step.uses[1] == gear.line.mu:
            found.setdefault(step.uses[0], step.it)
    return found


PLAN = Plan(record=record, aside=record_beside)
