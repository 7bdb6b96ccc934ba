"""What a kind of mistake is: its family, the steps at which it can be made, what is taken instead.

`AtStep` gives variants: other operands for a step, with words that name what was taken. `AtTable` changes the
readings when they are written down, `AtGiven` what the student reads off his assignment.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from support.another_hand import Rows
from support.students.records import Operands, Step
from support.students.tools import Tools

EVERYWHERE, POSITION, KIND = "everywhere", "position", "kind"
Variant = tuple[Operands, tuple[str, ...]]
"""What is taken instead, and words of which a good name of it has one each (regular expressions)."""


class AtStep(NamedTuple):
    """A mistake made at a step: ``of`` kinds of steps, ``variants`` of one (nothing: it cannot be made there).

    ``families``: how a report may call it, the first is its own; empty: outside any grammar. ``reach``: at
    this step in all positions, in one position, or at every step of its kind.
    """

    name: str
    families: tuple[str, ...]
    of: tuple[str, ...]
    variants: Callable[[Step, Tools], Iterable[Variant]]
    reach: tuple[str, ...] = (EVERYWHERE, POSITION)


class Written(NamedTuple):
    """What was done to the readings: which plan and segments, position ("" everywhere), words."""

    rows: Rows
    plan: str
    segments: frozenset[str]
    position: str
    words: tuple[str, ...] = ()


class AtTable(NamedTuple):
    """A mistake made when readings are written down; ``modes``: ways of giving them that can show it."""

    name: str
    families: tuple[str, ...]
    change: Callable[[Rows, np.random.Generator, Tools], Written | None]
    modes: tuple[str, ...] = ("mm", "quantities", "points", "both")


class AtGiven(NamedTuple):
    """A given misread: variants of what the assignment says."""

    name: str
    families: tuple[str, ...]
    variants: Callable[[dict[str, Any], np.random.Generator, Tools], Iterable[Variant]]


Kind = AtStep | AtTable | AtGiven


def others(of: Sequence[str], but: str) -> list[str]:
    """Return the names that are not the one that is due."""
    return [name for name in of if name != but]


def lengths_of(tools: Tools, plan: str, position: int) -> list[str]:
    """Return the segments of a plan that have been read in a position."""
    return [name for p, name in tools.pages[position].lengths if p == plan]


def letters_of(tools: Tools, plan: str, position: int) -> list[str]:
    return [name for p, name in tools.pages[position].points if p == plan]


SAID = {
    "F": "F_?3|load|force", "H_V": "H_?V|pole distance", "H_a": "H_?a|pole distance",
    "stroke": r"stroke|\bh\b", "r0": "r_?0|radius", "rise": "rise|φ", "fall": "return|fall|φ",
    "omega1": "ω_?1|omega1|crank",
}  # fmt: skip
"""How a sentence may say what is given."""


def word(name: str) -> str:
    """Return the words by which a sentence may name a segment, a link or a given."""
    if name in SAID:
        return SAID[name]
    apart = f"{name[0]}_?{name[1:]}" if name[1:].isdigit() else name
    return rf"(?<!\w){apart}(?!\w)"
