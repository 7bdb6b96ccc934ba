"""What marks are for, in the field's terms: by these code finds them in a log, never by their letters.

A chapter's own roles stand in the chapter.
"""

BASE = "base"
"""The length of a graph's base (Length)."""
POLE = "pole"
"""The pole of a graph, from which rays are drawn to differentiate or to integrate (Point)."""
POLE_DISTANCE = "pole distance"
"""How far the pole of a graph stands from its origin (Length)."""
CRANK_ANGLE = "crank angle"
"""How far the crank has turned from where positions are counted (Angle)."""
