"""What marks are for, in the field's terms: by these code finds them in a log, never by their letters.

A chapter's own roles stand in the chapter.
"""

NORMAL = "normal"
"""The direction of a normal component (Line)."""
INERTIA = "inertia"
"""An inertia force or couple (Number), and the line that such a force acts along (Line)."""
BASE = "base"
"""The length of a graph's base (Length)."""
POLE = "pole"
"""The pole of a graph, from which rays are drawn to differentiate or to integrate (Point)."""
LEVEL_POLE = "level pole"
"""The pole carried to the level from which the rays have the slopes of what is left of a sum (Point)."""
POLE_DISTANCE = "pole distance"
"""How far the pole of a graph stands from its origin (Length)."""
MEAN = "mean"
"""The mean of what a graph shows, marked on the axis of its ordinates (Point)."""
EXTREME = "extreme"
"""The highest or the lowest point of a graph, carried to the axis of its ordinates (Point)."""
CRANK_ANGLE = "crank angle"
"""How far the crank has turned from where positions are counted (Angle)."""
