"""Lemoine's geometrography: the elementary operations that each operation of the board takes, as data.

R1, R2, C1, C2, C3, simplicity and exactitude are those of E. Lemoine, *Géométrographie ou art des constructions
géométriques*, Paris, 1902: the simplicity of a construction is the number of all its elementary operations, its
exactitude the number of those that prepare a stroke, for on them its accuracy depends (the smaller, the better
both). A point where drawn lines meet costs nothing. That the square is counted too is usual; the other
instruments are counted here in the same spirit, and how they are used is the choice of this table.

A construction's symbol reads as Lemoine wrote it, ``2R1 + R2``; the factor ``n`` is the number of knots or
intervals of the row that a step across positions works through, and of the trials of a refinement.
"""

from __future__ import annotations

from typing import NamedTuple


class Elementary(NamedTuple):
    """An elementary operation: what is done, whether it prepares, minutes of a practised draughtsman."""

    en: str
    prepares: bool
    minutes: float


ELEMENTARY: dict[str, Elementary] = {
    "R1": Elementary("place the ruler's edge on a point", True, 0.10),
    "R2": Elementary("draw a line along an edge", False, 0.10),
    "C1": Elementary("put a point of the compass on a given point or division", True, 0.10),
    "C2": Elementary("put a point of the compass on an arbitrary point of a line", True, 0.05),
    "C3": Elementary("draw a circle or an arc", False, 0.10),
    "E1": Elementary("place an edge of the square along a line, the ruler against it", True, 0.15),
    "E2": Elementary("slide the square until an edge goes through a point", True, 0.10),
    "M1": Elementary("place the ruler's zero on a point", True, 0.05),
    "M2": Elementary("prick off a division of the ruler", False, 0.10),
    "M3": Elementary("read a division of the ruler and write it down", False, 0.15),
    "P1": Elementary("place the protractor on a vertex and along a line", True, 0.15),
    "P2": Elementary("prick off an angle", False, 0.10),
    "P3": Elementary("read an angle and write it down", False, 0.15),
    "K1": Elementary("fit the French curve to a knot", True, 0.15),
    "K2": Elementary("draw along the French curve up to a knot", False, 0.10),
    "H1": Elementary("draw an arc between two knots by hand", False, 0.10),
    "A1": Elementary("set the planimeter on its beginning", True, 0.50),
    "A2": Elementary("go round once with the planimeter and read it", False, 1.50),
    "N1": Elementary(
        "evaluate a formula with slide rule or calculator, write it down", False, 0.50
    ),
}
"""Every elementary operation; the minutes are estimates, not measurements: give your own to `cost.count`."""

FREE = ""
_JOIN = "2R1 + R2"
_RAY = "P1 + P2 + 2R1 + R2"
_SLIDE = "E1 + E2 + R2"
_READ = "M1 + R1 + M3"
_ANGLE = "P1 + P3"
_CURVE = "nK1 + nK2"
_LOOK = "N1"  # in the row of standard values
_SUPPORT = "P1 + P2 + E1 + E2 + R2"

SYMBOLS: dict[str, str] = {
    # lines
    "join": _JOIN,
    "rocker_line": _JOIN,
    "cylinder_axis": _JOIN,
    "ray": _RAY,
    "incline": _RAY,
    "slew": _RAY,
    "inward_normal": _RAY,
    "at_friction_angle": f"N1 + {_RAY}",
    "doubled": f"{_ANGLE} + {_RAY}",
    "parallel": _SLIDE,
    "square": _SLIDE,
    "directed": _SLIDE,
    "action": _SLIDE,
    "shift": f"M1 + R1 + M2 + {_SLIDE} + {_SLIDE}",
    "tangent": "3C1 + C3 + 2R1 + R2",  # the edge is laid to the circle by eye
    "touch": f"{_JOIN} + {_SLIDE}",  # so too; the square from the centre marks the contact
    "touching": f"{_SLIDE} + 2R1 + R2",
    "supporting": _SUPPORT,
    "supporting_curve": _SUPPORT,
    "touch_curve": _SUPPORT,
    # arcs and points
    "strike": "3C1 + C3",
    "lay_off": "M1 + R1 + M2",
    "place": f"2M1 + 2R1 + 2M2 + {_SLIDE}",
    "halve": "2R1 + R2 + 2C1 + 2C3",
    "reflect": "2C1 + 2C2 + 2C3",
    "erect": _SLIDE,
    "level_off": f"{_SLIDE} + R2",  # by eye, so that as much is cut off as is added
    "turn_about": f"2C1 + C3 + {_RAY}",
    "divide_semicircle": _RAY,
    "along_arc": "N1 + P1 + P2",
    "similar": f"2P1 + 2P3 + {_RAY} + {_RAY}",
    "homologous": f"{_READ} + {_READ} + {_READ} + N1 + {_ANGLE} + {_RAY} + M1 + R1 + M2",
    "carry": f"{_READ} + N1 + {_SLIDE} + M1 + R1 + M2",
    "detach": f"{_READ} + N1 + {_SLIDE} + M1 + R1 + M2",
    # points that are there already: where lines meet, or one of several
    "meet": FREE,
    "cut": FREE,
    "cut_or_foot": FREE,
    "cross": FREE,
    "curve_meets_arc": FREE,
    "curves_cross": FREE,
    "beginning": FREE,
    "coincide": FREE,
    "at_zero": FREE,
    "following": FREE,
    "standing": FREE,
    "next_satellite": FREE,
    "phase_end": FREE,
    "arrival": FREE,
    "accepted": FREE,
    "whole_mm": FREE,
    "outer_parallel": FREE,
    "extreme_of_two": FREE,
    "stand": FREE,
    "in_turn": FREE,
    "while_on": FREE,
    "on_arc": FREE,
    "line_on_arc": FREE,
    "nearest_standard": _LOOK,
    "next_ratio": _LOOK,
    "next_standard": _LOOK,
    "next_standard_length": _LOOK,
    # readings
    "measure": _READ,
    "measure_along": _READ,
    "measure_arc": f"{_ANGLE} + N1",
    "arm": f"{_SLIDE} + {_READ}",
    "bearing": _ANGLE,
    "slant": _ANGLE,
    "turn_between": _ANGLE,
    "angle_at": _ANGLE,
    # a whole row at once
    "french_curve": _CURVE,
    "closed_graph": _CURVE,
    "taut_graph": _CURVE,
    "graph_of_stretch": _CURVE,
    "graph_of_rays": f"{_CURVE} + nP1 + nP2",
    "graph_of_differences": f"{_CURVE} + K1 + K2",
    "curve_of_two": _CURVE,
    "open_graph": f"{_CURVE} + K1 + K2",
    "open_graph_of_middles": f"{_CURVE} + K1 + K2",
    "smooth_stretch": _CURVE,
    "smooth_through": _CURVE,
    "swept_profile": _CURVE,
    "taut_curve": "nH1",
    "succession": "nE1 + nE2 + nR2",
    "highest": "E1 + E2",
    "lowest": "E1 + E2",
    "crest_of_curve": "E1 + E2",
    "farthest": "2C1",
    "planimeter": "A1 + A2",
    "mean_of_row": "N1",
    # a trial of a refinement: its angle laid off, its last segment read; the trial itself comes on top
    "refine": "nP1 + nP2 + nM1 + nR1 + nM3",
}
"""The symbol of each operation of the board by its name; formulas are not listed, they are `FORMULA`."""

FORMULA = "N1"
READING = _READ
DEFAULT = _JOIN
"""The symbol of an operation that is not listed: a formula, a reading, or else as much as a line."""
