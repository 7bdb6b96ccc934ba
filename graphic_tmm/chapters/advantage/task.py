"""What sheets show of forces by instantaneous centres: the name of the chapter, of its plan and its place."""

ADVANTAGE = "advantage"
