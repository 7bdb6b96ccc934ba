"""What fails of a pair of gears."""

from __future__ import annotations

from graphic_tmm.chapters.gears.verdict import failures
from graphic_tmm.readers.warnings import Warned

WARNINGS = Warned(failures)
