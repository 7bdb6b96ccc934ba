"""What people call plans, tables and views of kinematics."""

from __future__ import annotations

from graphic_tmm.language.said import said

CAPTIONS: dict[str, str] = {
    "chapter kinematics": said("Kinematics of the mechanism"),
    "positions": said("Plan of positions"),
    "extremes": said("Extreme positions"),
    "velocities": said("Velocity plan"),
    "accelerations": said("Acceleration plan"),
    "table velocities": said("Velocities from the plans"),
    "table accelerations": said("Accelerations from the plans"),
    "positions in a turn": said("Positions"),
}
