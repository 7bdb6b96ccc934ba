"""What is recorded of centrodes, and that they need velocities where pivots and guides give no normals."""

from __future__ import annotations

from graphic_tmm.chapters.centrodes.plan import needs, record
from graphic_tmm.project import Plan

PLAN = Plan(needs=needs, record=record)
