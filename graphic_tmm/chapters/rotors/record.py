"""What is recorded of a rotor."""

from __future__ import annotations

from graphic_tmm.chapters.rotors.plan import record
from graphic_tmm.project import Plan

PLAN = Plan(record=record)
