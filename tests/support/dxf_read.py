"""Small sheets, and how ezdxf reads the DXF that is made of them."""

from __future__ import annotations

import io
import random

import pytest

from graphic_tmm.paper.drawing import Drawing, Ink, Label, Sheet
from graphic_tmm.paper.write.dxf import dxf

ezdxf = pytest.importorskip("ezdxf")


def sheet_of(*strokes: Ink, labels: tuple[Label, ...] = (), name: str = "plan") -> Sheet:
    return Sheet("s1", "Лист", "A4", 210, 297, (Drawing(name, "План", strokes, labels),))


def opened(made: Sheet, *, stroked: bool = False):
    return ezdxf.read(io.StringIO(dxf(made, stroked=stroked)))


def model(*strokes: Ink, labels: tuple[Label, ...] = ()):
    return list(opened(sheet_of(*strokes, labels=labels)).modelspace())


def scattered(seed: int, count: int) -> list[complex]:
    """Places on an A4, at random."""
    chance = random.Random(seed)
    return [complex(chance.uniform(50, 150), chance.uniform(50, 250)) for _ in range(count)]


def at(vector) -> complex:
    return complex(vector[0], vector[1])
