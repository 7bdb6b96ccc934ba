"""Mechanisms found from a task: recorded as calculated steps, so that the note can print them.

The rocker (coulisse) mechanism from K_v, the stroke and the centre distance: the angle of swing of the rocker
is θ = 180°·(K_v − 1)/(K_v + 1), the crank OA = OB·sin(θ/2), the rocker's arm BC = S/(2·sin(θ/2)). The other
kinds stand in `synthesis_kinds`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import product
from typing import Any, NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.mechanism import synthesis_kinds as kinds
from graphic_tmm.mechanism.synthesis_dwell import dwell
from graphic_tmm.mechanism.synthesis_four_bar import crank_rocker
from graphic_tmm.mechanism.synthesis_functions import function


class SynthesisLog(NamedTuple):
    """A synthesis: its log, the values given, and the marks of the lengths it finds."""

    construction: Construction
    given: dict[Mark, object]
    lengths: dict[str, Mark]

    def values(self) -> dict[str, float]:
        """Return the lengths found (m), by letters."""
        reading = execute(self.construction, self.given, self.lengths.values())
        return {name: float(reading[mark][0, 0]) for name, mark in self.lengths.items()}


class SynthesisKind(NamedTuple):
    """A kind of task: ``ways`` in which it may be given, each by its keys; what it finds; what calculates it.

    ``varied``: of which of its keys another value makes another mechanism of the same kind.
    """

    ways: tuple[frozenset[str], ...]
    finds: tuple[str, ...]
    calculate: Callable[[Draft, Mapping[str, Any]], dict[str, Mark]]
    varied: tuple[str, ...]


def _ways(*choices: tuple[str, ...]) -> tuple[frozenset[str], ...]:
    """Return each way of taking one of every choice; keys of one taken together stand in one text."""
    return tuple(frozenset(" ".join(one).split()) for one in product(*choices))


_STROKE = ("stroke", "v_m n")
KINDS: dict[str, SynthesisKind] = {
    "rocker": SynthesisKind(
        _ways(("K_v stroke OB",)), ("OA", "BC", "OB"), kinds.rocker, ("K_v", "stroke")
    ),
    "slider-crank": SynthesisKind(
        _ways(_STROKE, ("K_v e", "lambda", "lambda e", "pressure", "pressure e")),
        ("OA", "AB", "e"),
        kinds.slider_crank,
        ("K_v", "lambda", "pressure", "stroke", "v_m"),
    ),
    "crank-rocker": SynthesisKind(
        _ways(("psi K_v BC",), ("OC", "transmission")),
        ("OA", "AB", "BC", "OC"),
        crank_rocker,
        ("K_v", "psi"),
    ),
    "coupler": SynthesisKind(
        _ways(("A angles AB",)),
        ("xO", "yO", "xC", "yC", "OA", "AB", "BC"),
        kinds.coupler,
        ("AB", "A"),
    ),
    "angles": SynthesisKind(
        _ways(("crank rocker OA OC",)), ("OA", "AB", "BC", "OC"), kinds.angles, ("OA",)
    ),
    "function": SynthesisKind(
        _ways(("x crank rocker OA OC",), ("power", "y", "values")),
        ("OA", "AB", "BC", "OC"),
        function,
        ("power", "OA"),
    ),
    "cylinder": SynthesisKind(
        _ways(_STROKE, ("psi",)), ("OA", "OC"), kinds.cylinder, ("psi", "stroke", "v_m")
    ),
    "dwell": SynthesisKind(
        _ways(("OA AB BC OC M dwell tolerance E",)),
        ("OA", "AB", "BC", "OC", "xM", "yM", "xE", "yE", "MD", "DE"),
        dwell,
        ("M", "E"),
    ),
}
"""The kinds of tasks, by the name that a scene writes."""


def synthesis_log(kind: str, given: Mapping[str, Any]) -> SynthesisLog:
    """Record the synthesis of a kind; what is ``given`` in SI and degrees, by its keys.

    Raises
    ------
    StructureError
        If no mechanism does what is asked.
    """
    draft = Draft()
    draft.open("synthesis")
    made, finds = KINDS[kind].calculate(draft, given), KINDS[kind].finds
    lengths = {name: mark for name, mark in made.items() if name in finds}
    return SynthesisLog(draft.board.construction(), draft.given, lengths)


def rocker(K_v: float, stroke: float, OB: float) -> SynthesisLog:
    """Record the synthesis of the rocker mechanism; K_v > 1, ``stroke`` and ``OB`` in metres."""
    return synthesis_log("rocker", {"K_v": K_v, "stroke": stroke, "OB": OB})


def lengths_found(kind: str, given: Mapping[str, Any]) -> dict[str, float]:
    """Return the lengths (m) that a task finds, by their letters.

    >>> found = lengths_found("slider-crank", {"stroke": 0.1, "K_v": 1.2, "e": 0.03})
    >>> {name: round(1000.0 * value, 3) for name, value in found.items()}
    {'OA': 47.795, 'AB': 113.722, 'e': 30.0}
    """
    return synthesis_log(kind, given).values()


def rocker_lengths(K_v: float, stroke: float, OB: float) -> dict[str, float]:
    """Return OA, BC and OB (m) of the rocker mechanism found from the task.

    >>> {name: round(value, 5) for name, value in rocker_lengths(1.45, 0.095, 0.48).items()}
    {'OA': 0.13657, 'BC': 0.16694, 'OB': 0.48}
    """
    return rocker(K_v, stroke, OB).values()
