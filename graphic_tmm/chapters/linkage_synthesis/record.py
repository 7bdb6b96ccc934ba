"""What is recorded of a synthesis: its construction; aside the lengths as they are calculated."""

from __future__ import annotations

from collections.abc import Mapping

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.linkage_synthesis.plan import SYNTHESIS_PLAN, record
from graphic_tmm.chapters.linkage_synthesis.task import CHAPTER_NAME
from graphic_tmm.mechanism.synthesis import KINDS
from graphic_tmm.mechanism.synthesis_kinds import take_stroke
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside

VIEW = "synthesis-calculation"
"""The view of what is calculated."""
CALCULATED: Recorded[Mapping[str, Mark]] = Recorded(aside(CHAPTER_NAME))


def calculate(bench: Bench) -> Mapping[str, Mark]:
    """Calculate the lengths that the task does not give, by their letters; the stroke if that was measured."""
    made, draft = SYNTHESIS_PLAN.on(bench), bench.draft
    draft.open(VIEW)
    lengths = KINDS[made.task.kind].calculate(draft, made.task.given)
    found = {name: mark for name, mark in lengths.items() if mark not in draft.given}
    if "S" in made.measured:
        found["S"] = take_stroke(draft, made.task.given)
    return found


PLAN = Plan(record=record, aside=calculate)
