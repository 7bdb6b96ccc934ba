"""What the passes of a tape are in LLVM's language, of one number or of several in step.

NaN comes out, or is in no order, where numpy has it so.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.tape import MASKS

WIDTH = 8
"""Positions in step: as many as a register holds at most. A row has at least so many."""
LIBRARY = {
    **{name: (name, 1) for name in ("sin", "cos", "tan", "exp", "log", "cbrt")},
    **{f"arc{name}": (f"a{name}", 1) for name in ("sin", "cos", "tan")},
    "arctan2": ("atan2", 2),
    "hypot": ("hypot", 2),
    "power": ("pow", 2),
}
"""Passes that the system's library does: by which function, and the number of its arguments."""
MAY_CALL = (*(name for name, _ in LIBRARY.values()), "floor", "ceil", "rint")
"""Functions of the library that machine code of a loop may call."""
_OWN = {**dict.fromkeys(("sqrt", "fabs", "floor", "ceil", "rint"), 1), "copysign": 2}
_CONSTANTS = {
    "zero": 0.0,
    "one": 1.0,
    "less": -1.0,
    "endless": float("inf"),
    "radian": float(np.pi / 180.0),
    "degree": float(180.0 / np.pi),
}


def _call(name: str, *of: str) -> str:
    return f"call {{kind}} @llvm.{name}.{{of}}({', '.join(f'{{kind}} {one}' for one in of)})"


_ORDER = "fcmp {how} {{kind}} {{0}}, {{1}}"
_EITHER = ("or {truth} {a}, {b}", "select {truth} {c}, {kind} {0}, {kind} {1}")
PASSES: dict[str, tuple[str, ...]] = {
    "add": ("fadd {kind} {0}, {1}",),
    "subtract": ("fsub {kind} {0}, {1}",),
    "multiply": ("fmul {kind} {0}, {1}",),
    "divide": ("fdiv {kind} {0}, {1}",),
    "negative": ("fneg {kind} {0}",),
    "absolute": (_call("fabs", "{0}"),),
    **{name: (_call(name, "{0}"),) for name in ("sqrt", "floor", "ceil", "rint")},
    "copysign": (_call("copysign", "{0}", "{1}"),),
    "length": (
        "fmul {kind} {0}, {0}",
        "fmul {kind} {1}, {1}",
        "fadd {kind} {a}, {b}",
        _call("sqrt", "{c}"),
    ),
    "less": (_ORDER.format(how="olt"),),
    "less_equal": (_ORDER.format(how="ole"),),
    "greater": (_ORDER.format(how="ogt"),),
    "greater_equal": (_ORDER.format(how="oge"),),
    "equal": (_ORDER.format(how="oeq"),),
    "not_equal": (_ORDER.format(how="une"),),
    "isnan": ("fcmp uno {kind} {0}, {0}",),
    "isfinite": (_call("fabs", "{0}"), "fcmp olt {kind} {a}, {endless}"),
    "logical_and": ("and {truth} {0}, {1}",),
    "logical_or": ("or {truth} {0}, {1}",),
    "logical_not": ("xor {truth} {0}, {true}",),
    "choose": ("select {truth} {0}, {kind} {1}, {kind} {2}",),
    "maximum": ("fcmp uno {kind} {0}, {0}", "fcmp ogt {kind} {0}, {1}", *_EITHER),
    "minimum": ("fcmp uno {kind} {0}, {0}", "fcmp olt {kind} {0}, {1}", *_EITHER),
    "fmax": ("fcmp uno {kind} {1}, {1}", "fcmp ogt {kind} {0}, {1}", *_EITHER),
    "fmin": ("fcmp uno {kind} {1}, {1}", "fcmp olt {kind} {0}, {1}", *_EITHER),
    "sign": (
        "fcmp olt {kind} {0}, {zero}",
        "select {truth} {a}, {kind} {less}, {kind} {0}",
        "fcmp ogt {kind} {0}, {zero}",
        "select {truth} {c}, {kind} {one}, {kind} {b}",
    ),
    "radians": ("fmul {kind} {0}, {radian}",),
    "degrees": ("fmul {kind} {0}, {degree}",),
}
"""The lines of a pass: {0}, {1} is what it takes; {a}, {b} is what its first, its second line leaves."""


class Width(NamedTuple):
    """How LLVM calls numbers and truths, of one position or of several."""

    kind: str
    truth: str
    suffix: str
    lanes: int

    def constant(self, value: float) -> str:
        """Return a constant, by its bits."""
        bits = f"0x{struct.unpack('<Q', struct.pack('<d', value))[0]:016X}"
        return self.alike(f"double {bits}")

    def alike(self, one: str) -> str:
        """Return a constant with its type as one or as several of it."""
        many = f"<{', '.join([one] * self.lanes)}>"
        return one.split()[1] if self.lanes == 1 else many


ONE = Width("double", "i1", "f64", 1)
WIDE = Width(f"<{WIDTH} x double>", f"<{WIDTH} x i1>", f"v{WIDTH}f64", WIDTH)


def kind_of(does: str, width: Width) -> str:
    """Return the type of what a pass leaves."""
    return width.truth if does in MASKS else width.kind


def lines_of(does: str, it: str, names: Sequence[str], width: Width) -> list[str]:
    """Return the lines of a pass that leaves ``it``; ``names``: what it takes is called."""
    patterns = _patterns(does, width)
    ends = [f"{it}{letter}" for letter in _LETTERS[: len(patterns) - 1]] + [it]
    left = dict(zip(_LETTERS, ends, strict=False))
    return [
        f"{end} = {pattern.format(*names, **left)}"
        for end, pattern in zip(ends, patterns, strict=True)
    ]


_LETTERS = "abcdef"


@cache
def _patterns(does: str, width: Width) -> tuple[str, ...]:
    """Return the lines of a pass at a width, without what it takes and what its lines leave."""
    told = {
        **{"kind": width.kind, "truth": width.truth, "of": width.suffix},
        **{name: width.constant(value) for name, value in _CONSTANTS.items()},
        **{letter: f"{{{letter}}}" for letter in _LETTERS},
        "true": width.alike("i1 true"),
    }
    return tuple(pattern.format("{0}", "{1}", "{2}", **told) for pattern in PASSES[does])


@cache
def declared_by(does: str, width: Width) -> tuple[str, ...]:
    """Return how the functions of LLVM's that a pass calls are declared."""
    names = re.findall(r"@llvm\.(\w+)\.", "".join(_patterns(does, width)))
    return tuple(
        f"declare {width.kind} @llvm.{name}.{width.suffix}({', '.join([width.kind] * _OWN[name])})"
        for name in names
    )
