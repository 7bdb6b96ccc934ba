"""A tape of numbers as the text of a loop over positions, in LLVM's language.

Several positions are worked in step (`WIDTH`). What does not vary is found once, before the loop. The last few
positions are worked again where their number is no multiple of the width: a number does not depend on its
neighbours, so it comes out the same to the last bit wherever a row is cut. NaN comes out, or is in no order,
where numpy has it so.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.compile.tape import INPUT, MASKS, Node, Tape

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


NAME = "loop_over_positions"
"""Stands for the name of the function in its text."""
FRAME = 3
"""Numbers of a frame before the addresses of rows and results."""


End = int | float
"""A number that a tape leaves: that of a node, or a known one."""


class Leaf(NamedTuple):
    """A result: its parts, one or two (real, imaginary), and whether it varies."""

    parts: tuple[End, ...]
    varies: bool


class Loop(NamedTuple):
    """The text of a loop; which inputs are rows (of the others one number is taken); its results.

    The function takes the address of a frame of whole numbers, and a base. In the frame stand where to begin
    and to stop, the address of the numbers that do not vary, then those of the rows and of the results, which
    are told from the base on. Inputs that nothing needs are left out.
    """

    text: str
    rows: tuple[int, ...]
    still: tuple[int, ...]
    leaves: tuple[Leaf, ...]


def loop_of(tape: Tape, leaves: Sequence[tuple[End, ...]]) -> Loop:
    """Write the loop that fills ``leaves``."""
    nodes = tape.nodes
    moving = {k for k, node in enumerate(nodes) if node.moving}
    ends = tuple(
        Leaf(tuple(parts), any(isinstance(part, int) and part in moving for part in parts))
        for parts in leaves
    )
    writer = _Writer(tape)
    order = writer.needed(ends)
    # an input is known by its number among inputs
    inputs = {k: n for n, k in enumerate(k for k, node in enumerate(nodes) if node.does == INPUT)}
    taken = [k for k in order if k in inputs and nodes[k].moving]
    still = [k for k in order if k in inputs and not nodes[k].moving]
    text = writer.whole(order, taken, still, ends)
    return Loop(text, tuple(inputs[k] for k in taken), tuple(inputs[k] for k in still), ends)


class _Writer:
    """Writes lines before the loop and within it; what is needed only, each once."""

    def __init__(self, tape: Tape) -> None:
        self.nodes = tape.nodes
        self.before: list[str] = []
        self.within: list[str] = []
        self.declared: set[str] = set()
        self.spread: set[int] = set()
        self._count = 0

    def whole(
        self,
        order: Sequence[int],
        rows: Sequence[int],
        still: Sequence[int],
        leaves: Sequence[Leaf],
    ) -> str:
        """Return the text of the function: it works nodes in their order."""
        for n, k in enumerate(still):
            self._address("still", f"s{k}", n)
            self.before.append(f"%n{k} = load double, double* %s{k}_at, align 8")
        for n, k in enumerate(rows):
            self._row(f"r{k}", n)
            at = self._place(f"r{k}")
            self.within.append(f"%n{k} = load {WIDE.kind}, {WIDE.kind}* {at}, align 8")
        for k in order:
            if self.nodes[k].does != INPUT:
                self._step(k, self.nodes[k])
        for n, leaf in enumerate(leaves):
            self._leave(leaf, f"o{n}", len(rows) + n)
        declared = "".join(f"{line}\n" for line in sorted(self.declared))
        before = "".join(f"  {line}\n" for line in self.before)
        within = "".join(f"  {line}\n" for line in self.within)
        return _WHOLE.format(declared=declared, name=NAME, before=before, within=within, w=WIDTH)

    def needed(self, leaves: Sequence[Leaf]) -> list[int]:
        """Return the nodes that results need, in order."""
        found = {part for leaf in leaves for part in leaf.parts if isinstance(part, int)}
        for k in range(len(self.nodes) - 1, -1, -1):
            if k in found:
                node = self.nodes[k]
                found.update(t for t in node.takes if isinstance(t, int))
        return sorted(found)

    def _fresh(self) -> str:
        self._count += 1
        return f"%t{self._count}"

    def _address(self, of: str, name: str, k: int) -> None:
        self.before.append(f"%{name}_at = getelementptr double, double* %{of}, i64 {k}")

    def _row(self, name: str, k: int) -> None:
        self.before += [
            f"%{name}_slot = getelementptr i64, i64* %frame, i64 {FRAME + k}",
            f"%{name}_behind = load i64, i64* %{name}_slot, align 8",
            f"%{name}_number = add i64 %{name}_behind, %base",
            f"%{name}_row = inttoptr i64 %{name}_number to double*",
        ]

    def _place(self, name: str, twice: bool = False) -> str:
        """Write where the positions in hand stand in a row; return it."""
        size, place, found = (self._fresh() for _ in range(3))
        kind = _TWICE if twice else WIDE.kind
        at = "%i"
        if twice:
            self.within.append(f"{size} = shl i64 %i, 1")
            at = size
        self.within += [
            f"{place} = getelementptr double, double* %{name}_row, i64 {at}",
            f"{found} = bitcast double* {place} to {kind}*",
        ]
        return found

    def _name(self, k: End, wide: bool) -> str:
        """Return how a number is called, as one or as several alike."""
        if isinstance(k, float):
            return (WIDE if wide else ONE).constant(k)
        if not wide or self.nodes[k].moving:
            return f"%n{k}"
        if k not in self.spread:
            self.spread.add(k)
            one, kind = (kind_of(self.nodes[k].does, width) for width in (ONE, WIDE))
            self.before += [
                f"%n{k}_one = insertelement {kind} undef, {one} %n{k}, i32 0",
                f"%n{k}_wide = shufflevector {kind} %n{k}_one, {kind} undef, "
                f"<{WIDTH} x i32> zeroinitializer",
            ]
        return f"%n{k}_wide"

    def _step(self, k: int, node: Node) -> None:
        names = [self._name(t, node.moving) for t in node.takes]
        if node.does in LIBRARY:
            self._called(f"%n{k}", LIBRARY[node.does][0], names, node.moving)
            return
        width = WIDE if node.moving else ONE
        lines = lines_of(node.does, f"%n{k}", names, width)
        self.declared.update(declared_by(node.does, width))
        (self.within if node.moving else self.before).extend(lines)

    def _called(self, it: str, name: str, names: Sequence[str], wide: bool) -> None:
        """Write a call of the system's library, of one position after another."""
        self.declared.add(f"declare double @{name}({', '.join(['double'] * len(names))})")
        if not wide:
            arguments = ", ".join(f"double {one}" for one in names)
            self.before.append(f"{it} = call double @{name}({arguments})")
            return
        whole = "undef"
        for lane in range(WIDTH):
            ones = []
            for one in names:
                ones.append(self._fresh())
                self.within.append(f"{ones[-1]} = extractelement {WIDE.kind} {one}, i32 {lane}")
            found, after = self._fresh(), it if lane == WIDTH - 1 else self._fresh()
            arguments = ", ".join(f"double {one}" for one in ones)
            self.within += [
                f"{found} = call double @{name}({arguments})",
                f"{after} = insertelement {WIDE.kind} {whole}, double {found}, i32 {lane}",
            ]
            whole = after

    def _leave(self, leaf: Leaf, name: str, k: int) -> None:
        self._row(name, k)
        if not leaf.varies:
            for part, end in enumerate(leaf.parts):
                self._address(f"{name}_row", f"{name}_{part}", part)
                value = self._name(end, False)
                self.before.append(f"store double {value}, double* %{name}_{part}_at, align 8")
            return
        names = [self._name(end, True) for end in leaf.parts]
        value, kind = names[0], WIDE.kind
        at = self._place(name, len(names) == 2)
        if len(names) == 2:
            value, kind = self._fresh(), _TWICE
            turns = ", ".join(f"i32 {j}, i32 {j + WIDTH}" for j in range(WIDTH))
            self.within.append(
                f"{value} = shufflevector {WIDE.kind} {names[0]}, {WIDE.kind} {names[1]}, "
                f"<{2 * WIDTH} x i32> <{turns}>"
            )
        self.within.append(f"store {kind} {value}, {kind}* {at}, align 8")


_TWICE = f"<{2 * WIDTH} x double>"
_WHOLE = """{declared}define void @{name}(i64* %frame, i64 %base) nounwind {{
before:
  %start = load i64, i64* %frame, align 8
  %stop_slot = getelementptr i64, i64* %frame, i64 1
  %stop = load i64, i64* %stop_slot, align 8
  %still_slot = getelementptr i64, i64* %frame, i64 2
  %still_number = load i64, i64* %still_slot, align 8
  %still = inttoptr i64 %still_number to double*
{before}  %last = sub i64 %stop, {w}
  br label %loop
loop:
  %i = phi i64 [ %start, %before ], [ %next, %loop ]
{within}  %step = add i64 %i, {w}
  %over = icmp sgt i64 %step, %last
  %next = select i1 %over, i64 %last, i64 %step
  %done = icmp eq i64 %i, %last
  br i1 %done, label %end, label %loop
end:
  ret void
}}
"""
