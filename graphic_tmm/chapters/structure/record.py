"""The structure of a mechanism, and its mobility by the formula."""

from __future__ import annotations

from graphic_tmm.chapters.structure.mobility import record_mobility
from graphic_tmm.mechanism.structure import Structure, dissect
from graphic_tmm.project import Bench, Plan


def _record(bench: Bench) -> Structure:
    """Return the structure; it leaves no step."""
    assert bench.scene.mechanism is not None
    return dissect(bench.scene.mechanism)


PLAN = Plan(record=_record, aside=record_mobility)
