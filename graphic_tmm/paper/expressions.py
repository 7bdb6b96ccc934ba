"""Expressions of marks: each once, in an order in which they can be calculated, and their values.

They are what ink is drawn by (see `traced`); a page calculates the same ones (`page/web/live/tied.js`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "plus": lambda a, b: a + b,
    "minus": lambda a, b: a - b,
    "times": lambda a, b: a * b,
    "over": lambda a, b: a / b,
    "conjugate": np.conjugate,
    "real": lambda a: a.real,
    "imag": lambda a: a.imag,
    "complex": lambda a, b: a.real + 1j * b.real,
    "abs": np.abs,
    "bearing": lambda a: np.degrees(np.angle(a)),
    "heading": lambda a: np.exp(1j * np.radians(a.real)),
    "tangent": lambda a: np.tan(np.radians(a.real)),
    "arcsine": lambda a: np.degrees(np.arcsin(a.real)),
    "sign": lambda a: np.copysign(1.0, a.real),
    "floor": lambda a: np.floor(a.real),
    "round": lambda a: np.round(a.real, 6),
    "smaller": lambda a, b: np.minimum(a.real, b.real),
    "larger": lambda a, b: np.maximum(a.real, b.real),
    "less": lambda a, b: np.where(np.isfinite(a) & np.isfinite(b), a.real < b.real, np.nan),
    "chosen": lambda a, b, c: np.where(a.real != 0, b, c),
}
"""What nodes are made by, on arrays; angles are in degrees."""
OVER_TURN = ("lowest", "highest")
"""What is found of an expression over all positions that can be drawn."""
COVERED = "covered"
"""Whether most of a line, by its ends, lies on strokes, written down as `covering` does it."""
_REAL = frozenset(
    {"real", "imag", "abs", "bearing", "tangent", "arcsine", "sign", "floor", "round", "less"}
    | {"smaller", "larger", COVERED, *OVER_TURN}
)
"""What is a real number whatever it is made of."""
_AS_ITS_PARTS = frozenset({"plus", "minus", "times", "over", "conjugate", "chosen"})
"""What is a real number where all that it is made of is."""


class Node(NamedTuple):
    """An expression: its operation and of which nodes it is made.

    Of a ``mark``: its slot and which of its values (0, or 1 for a direction or a radius); of a ``number``: its
    real and its imaginary part. Below 0 is what begins a stroke of a ``covered``.
    """

    op: str
    of: tuple[float, ...]

    @property
    def parts(self) -> list[int]:
        """The nodes that it is made of."""
        return [] if self.op in ("mark", "number") else [int(k) for k in self.of if k >= 0]


class Guard(NamedTuple):
    """A comparison (its node), how it came out; up to which of the guards it matters, 0: to all.

    ``taken``: it need not have come out so where it was traced.
    """

    node: int
    found: bool
    until: int = 0
    taken: bool = False


class Expressions:
    """The expressions that were met; ``guards``: what was compared since `begin`, in its order.

    ``marks``: of each node the marks that it is made of, a bit for each slot; ``real``: whether it is real.
    """

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.marks: list[int] = []
        self.real: list[bool] = []
        self.guards: list[Guard] = []
        self._known: dict[tuple[str, tuple[float, ...]], int] = {}

    def begin(self) -> None:
        """Begin another drawing."""
        self.guards = []

    def node(self, op: str, *of: float, real: bool = False) -> int:
        """Return the number of an expression; a new one is entered."""
        found = self._known.get((op, of))
        if found is None:
            node = Node(op, of)
            found = self._known[node] = len(self.nodes)
            marks = 1 << int(of[0]) if op == "mark" else 0
            for k in node.parts:
                marks |= self.marks[k]
            own = op in _REAL or (op == "number" and of[1] == 0.0)
            alike = op in _AS_ITS_PARTS and all(self.real[k] for k in node.parts)
            self.nodes.append(node)
            self.marks.append(marks)
            self.real.append(real or own or alike)
        return found

    def number(self, value: complex) -> int:
        """Return the node of a constant."""
        return self.node("number", value.real, value.imag)

    def place(self, x: int, y: int) -> int:
        """Return the node of a place by those of its coordinates."""
        whole, aside = self.nodes[x], self.nodes[y]
        if whole.op == "number" and aside.op == "number":
            return self.number(complex(whole.of[0], aside.of[0]))
        if aside.op == "imag":
            of = int(aside.of[0])
            if whole == Node("real", (of,)):
                return of
            if whole.op in ("plus", "minus") and self.nodes[int(whole.of[0])] == Node(
                "real", (of,)
            ):
                return self.node(whole.op, of, whole.of[1])
        return self.node("complex", x, y)

    def guard(self, node: int, *, found: bool, taken: bool = False) -> None:
        """Enter a comparison and how it came out; see `Guard`."""
        self.guards.append(Guard(node, found, 0, taken))

    def end(self, begun: int) -> None:
        """Let the guards from a number on matter no further."""
        self.guards.append(Guard(-1, found=True))
        for k in range(begun, len(self.guards)):
            if not self.guards[k].until:
                self.guards[k] = self.guards[k]._replace(until=len(self.guards))

    def needed(self, wanted: Iterable[int]) -> list[int]:
        """Return the nodes that some are made of, they among them, in their order."""
        found, ahead = set[int](), list(wanted)
        while ahead:
            k = ahead.pop()
            if k not in found:
                found.add(k)
                ahead += self.nodes[k].parts
        return sorted(found)

    def values(
        self,
        marks: Callable[[int, int], Any],
        over_turn: Callable[[str, int], Any],
        covered: Callable[..., Any],
        only: Iterable[int] | None = None,
    ) -> dict[int, Any]:
        """Return the values of expressions at some positions, of all or of ``only`` some and what these need.

        ``marks``: a slot, which of its values -> its numbers there; ``over_turn``: "lowest" or "highest" and a
        node -> the number over the turn; ``covered``: see `covering`.
        """
        found = dict[int, Any]()
        with np.errstate(all="ignore"):
            for k in range(len(self.nodes)) if only is None else self.needed(only):
                node = self.nodes[k]
                if node.op == "mark":
                    value = marks(int(node.of[0]), int(node.of[1]))
                elif node.op == "number":
                    value = np.array(complex(*node.of))
                elif node.op in OVER_TURN:
                    value = over_turn(node.op, int(node.of[0]))
                elif node.op == COVERED:
                    start, end = (found[int(one)] for one in node.of[:2])
                    value = covered(start, end, strokes_of(node, found))
                else:
                    value = OPERATIONS[node.op](*(found[one] for one in node.parts))
                found[k] = value + 0j
        return found


def strokes_of(node: Node, values: Mapping[int, Any]) -> Sequence[tuple[int, list[Any]]]:
    """Return the strokes of a ``covered``: how each begins, the values of its vertices."""
    found: list[tuple[int, list[Any]]] = []
    for k in map(int, node.of[2:]):
        if k < 0:
            found.append((k, []))
        else:
            found[-1][1].append(values[k])
    return found
