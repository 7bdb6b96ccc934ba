"""What protocols show of a motor; its figures stand in the table of the law of motion."""

from __future__ import annotations

from graphic_tmm.chapters.motor.task import MOTOR
from graphic_tmm.readers.columns import Tabled
from graphic_tmm.readers.protocol import Protocols

TABLE = Tabled(columns=lambda drawn: ())
PROTOCOL = Protocols(views=lambda project: {MOTOR: [MOTOR]})
