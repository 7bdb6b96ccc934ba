"""The text of a straight line of passes: which of them are needed, and where each leaves its numbers.

A slot of the arena is taken again as soon as nobody uses its numbers any more; what is asked for is written
where it is to stay.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board import geometry, passes
from graphic_tmm.board.signs import Sign
from graphic_tmm.board.tape import INPUT, MASKS, Part, Ref, Tape

PLACED = ("maximum", "minimum", "fmax", "fmin")
"""Functions of numpy that are told by name where to leave what they find."""
_PASSES = ("length", "root", "signed", "choose", "count", "alike", "turn_x", "turn_y")
_ALIASES = ("choose", "turn_x", "turn_y")
"""Passes that may leave the very numbers that they took."""
_ROOMLESS = (INPUT, "count", "alike", *_ALIASES)
"""Passes that leave their numbers in no slot of their own."""
_STILL = {
    "add": "{} + {}",
    "subtract": "{} - {}",
    "multiply": "{} * {}",
    "divide": "{} / {}",
    "length": "hypot({}, {})",
    "root": "single_root({}, {}, {})",
    "choose": "{2} if {0} else {3}",
}
"""How a pass is written that is made once, of single numbers."""


class Passage(NamedTuple):
    """A function that fills rows, ``run(total, most, arena, masks, *entering, *rows)``, and returns numbers.

    ``slots``, ``masks``: how many rows the arenas need. ``entering``: which inputs are needed, by their order.
    ``rows``: which of the numbers asked for vary, by their order: a row of each; the others are returned.
    """

    run: Callable[..., tuple[Any, ...]]
    slots: int
    masks: int
    entering: tuple[int, ...]
    rows: tuple[int, ...]
    text: str


def passage(tape: Tape, asked: Sequence[Part], apart: Sequence[bool]) -> Passage:
    """Return the function of a tape that finds some numbers.

    ``apart``: whether the numbers of a row lie apart, as the parts of complex ones do.
    """
    return _Writer(tape, asked, apart).whole()


class _Rows:
    """Rows of an arena, taken and given back."""

    def __init__(self, name: str) -> None:
        self.name, self.free, self.count = name, list[str](), 0

    def take(self) -> str:
        """Return a row that nobody uses."""
        if self.free:
            return self.free.pop()
        self.count += 1
        return f"{self.name}{self.count - 1}"


class _Writer:
    """A passage while it is written."""

    def __init__(self, tape: Tape, asked: Sequence[Part], apart: Sequence[bool]) -> None:
        self.tape, self.asked, self.apart = tape, asked, apart
        self.nodes = tape.nodes
        self.last: dict[int, int] = {}
        self.uses: dict[int, int] = {}
        self.asking: dict[int, list[int]] = {}
        self.rows = tuple(k for k, part in enumerate(asked) if self._moves(part))
        for k in self.rows:
            self.asking.setdefault(asked[k].node, []).append(k)  # type: ignore[union-attr]
        self._follow()
        self.slots, self.masks = _Rows("s"), _Rows("m")
        self.held: dict[int, str] = {}
        self.constants: dict[str, str] = {}
        self.before: list[str] = []
        self.lines: list[str] = []
        self.lifted: set[int] = set()

    def _moves(self, part: Part) -> bool:
        return isinstance(part, Ref) and self.nodes[part.node].moving

    def _follow(self) -> None:
        """Find which nodes are needed, how often, and where for the last time."""
        for part in self.asked:
            if isinstance(part, Ref):
                self.last.setdefault(part.node, part.node)
        for k in range(len(self.nodes) - 1, -1, -1):
            if k not in self.last:
                continue
            node = self.nodes[k]
            for taken in node.takes:
                if isinstance(taken, int):
                    self.uses[taken] = self.uses.get(taken, 0) + 1
                    # what is chosen is the very row that it was chosen from
                    until = self.last[k] if node.does in _ALIASES else k
                    self.last[taken] = max(self.last.get(taken, k), until)

    def whole(self) -> Passage:
        """Return it."""
        needed = sorted(self.last)
        inputs = [k for k, node in enumerate(self.nodes) if node.does == INPUT]
        entering = tuple(n for n, k in enumerate(inputs) if k in self.last)
        for k in needed:
            node = self.nodes[k]
            if not node.moving:
                self._still(k)
            elif node.does != INPUT:
                self._pass(k)
            if node.moving:
                self._asked_for(k)
        text = self._text([inputs[n] for n in entering])
        space: dict[str, Any] = {name: getattr(passes, name) for name in _PASSES}
        space |= {name: getattr(np, name) for name in ("nan", "inf", "copyto", "asarray")}
        space |= {"hypot": np.hypot, "negative": np.negative, "single_root": geometry.root}
        for node in self.nodes:
            if node.does not in space and node.does != INPUT:
                space[node.does] = getattr(np, node.does)
        space |= {name: np.array(float(number)) for number, name in self.constants.items()}
        exec(compile(text, "<straight line>", "exec"), space)
        return Passage(space["line"], self.slots.count, self.masks.count, entering, self.rows, text)

    def _term(self, taken: int | float) -> str:
        """Return a number as a pass over rows takes it: single ones as arrays, which numpy takes quicker."""
        if isinstance(taken, float):
            return self.constants.setdefault(repr(taken), f"k{len(self.constants)}")
        if self.nodes[taken].moving or self.nodes[taken].does in ("count", "alike"):
            return f"v{taken}"
        if taken not in self.lifted:
            self.lifted.add(taken)
            self.before.append(f"w{taken} = asarray(v{taken})")
        return f"w{taken}"

    def _still(self, k: int) -> None:
        does, takes = self.nodes[k][:2]
        if does == INPUT:
            return
        told = [f"v{t}" if isinstance(t, int) else repr(t) for t in takes]
        pattern = _STILL.get(does, f"{does}({', '.join(['{}'] * len(told))})")
        self.before.append(f"v{k} = {pattern.format(*told)}")

    def _pass(self, k: int) -> None:
        does, takes = self.nodes[k][:2]
        if does == "copysign" and self._positive(takes[0]):
            does = "signed"
        told = [self._term(t) for t in takes]
        if does in _ROOMLESS:
            self.lines.append(f"v{k} = {does}({', '.join(told)})")
            self._free(k)
            return
        plain = does not in _PASSES
        if plain:
            self._free(k)
        kind = self.masks if does in MASKS else self.slots
        row = self._straight_to(k) if plain else None
        if row is None:
            row = self.held[k] = kind.take()
        if does == "length":
            other = self.slots.take()
            told.append(row)
            self.slots.free.append(other)
            row = other
        told.append(f"out={row}" if does in PLACED else row)
        self.lines.append(f"v{k} = {does}({', '.join(told)})")
        if not plain:
            self._free(k)

    def _positive(self, taken: int | float) -> bool:
        return isinstance(taken, int) and self.nodes[taken].sign == Sign.POSITIVE

    def _straight_to(self, k: int) -> str | None:
        """Return the row asked for that a pass may fill by itself, None if there is none."""
        for n in self.asking.get(k, ()):
            if not self.asked[n].minus and (not self.apart[n] or not self.uses.get(k)):  # type: ignore[union-attr]
                self.asking[k].remove(n)
                return f"p{n}"
        return None

    def _asked_for(self, k: int) -> None:
        """Write that the numbers of a node go where they are asked for."""
        for n in self.asking.get(k, ()):
            minus = self.asked[n].minus  # type: ignore[union-attr]
            self.lines.append(f"negative(v{k}, p{n})" if minus else f"copyto(p{n}, v{k})")
        if self.last[k] == k and k in self.held:
            self._give_back(k)

    def _free(self, k: int) -> None:
        """Give back the rows that are used here for the last time."""
        for taken in [t for t in self.held if self.last[t] == k and t != k]:
            self._give_back(taken)

    def _give_back(self, k: int) -> None:
        row = self.held.pop(k)
        (self.masks if row.startswith("m") else self.slots).free.append(row)

    def _text(self, entering: Sequence[int]) -> str:
        still = [k for k in entering if not self.nodes[k].moving]
        moving = [k for k in entering if self.nodes[k].moving]
        rows = [f"{'v' if k in still else 'i'}{k}" for k in entering]
        rows += [f"o{k}" for k in self.rows]
        lines = [f"def line({', '.join(['total', 'most', 'arena', 'masks', *rows])}):"]
        lines += [f"  {one}" for one in self.before]
        lines.append("  for start in range(0, total, most):")
        lines.append("    end = min(start + most, total)")
        slots = "".join(f"s{n}, " for n in range(self.slots.count))
        masks = "".join(f"m{n}, " for n in range(self.masks.count))
        lines.append("    if not start or end - start < most:")
        lines.append(f"      ({slots}) = arena[:, :end - start]")
        lines.append(f"      ({masks}) = masks[:, :end - start]")
        lines += [f"    v{k} = i{k}[start:end]" for k in moving]
        lines += [f"    p{k} = o{k}[start:end]" for k in self.rows]
        lines += [f"    {one}" for one in self.lines]
        single = [self._alone(k) for k in range(len(self.asked)) if k not in self.rows]
        lines.append(f"  return ({''.join(f'{one}, ' for one in single)})")
        return "\n".join(lines) + "\n"

    def _alone(self, k: int) -> str:
        part = self.asked[k]
        if isinstance(part, Ref):
            return f"{'-' * part.minus}v{part.node}"
        return repr(0.0 if part is None else part)
