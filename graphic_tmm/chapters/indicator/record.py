"""What is recorded of an indicator diagram: its plan; aside the scale of its base."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import scale_of
from graphic_tmm.chapters.indicator.diagram import letter_of
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN, record
from graphic_tmm.chapters.indicator.task import CALCULATED, INDICATOR
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside


class Aside(NamedTuple):
    """The stroke (m) of each diagram, and the scale of its base (m/mm)."""

    strokes: tuple[Mark, ...]
    scales: tuple[Mark, ...]


BESIDE: Recorded[Aside] = Recorded(aside(INDICATOR))


def record_beside(bench: Bench) -> Aside:
    """Calculate the scale of each base: the stroke, as read on the plan of positions, by its length."""
    draft, strokes, scales = bench.draft, list[Mark](), list[Mark]()
    draft.open(CALCULATED)
    for first, *_ in INDICATOR_PLAN.on(bench).diagrams:
        made = first.indicator
        tag = made.tag.replace(" ", "")
        stroke = draft.draw(in_si, letter_of("S", tag), made.stroke, draft.mu_l, unit="m")
        length = draft.uses(made.end)[1]
        mu = draft.draw(scale_of, f"μ_{{S{tag}}}" if tag else "μ_S", stroke, length, unit="m/mm")
        strokes.append(stroke)
        scales.append(mu)
    return Aside(tuple(strokes), tuple(scales))


PLAN = Plan(
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts,
)
