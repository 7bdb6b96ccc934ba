"""A tape of numbers as the text of a loop over positions, in LLVM's language.

Several positions are worked in step (`WIDTH`). What does not vary is found once, before the loop. The last few
positions are worked again where their number is no multiple of the width: a number does not depend on its
neighbours, so it comes out the same to the last bit wherever a row is cut.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from graphic_tmm.board.loop_passes import (
    LIBRARY,
    ONE,
    WIDE,
    WIDTH,
    declared_by,
    kind_of,
    lines_of,
)
from graphic_tmm.board.tape import INPUT, Node, Tape

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
