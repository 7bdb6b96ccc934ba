"""Mistakes: what each does to the figures of a scene, and which would explain the readings that are wrong.

Some numbers here were set by trial. What they were tried on are 36 drawings: those of
``tests/cases/check``, and the ``published.csv`` of the scenes. Where it is said how far a number could
move, the same mistakes are named of all of them within these bounds, and not outside, or nothing was tried
outside where it says "at least".
"""
