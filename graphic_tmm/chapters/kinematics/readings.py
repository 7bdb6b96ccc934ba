"""What is known of figures read off the plans of a mechanism."""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.names import PLANS
from graphic_tmm.chapters.kinematics.table import measured_vectors, rate_marks
from graphic_tmm.chapters.kinematics.views import plan_at
from graphic_tmm.readers.readings import Readings

READINGS = Readings(
    pointed=PLANS, plan_at=plan_at, named_marks=rate_marks, vectors=measured_vectors
)
