"""How readings are judged: by the scatter of a hand, and by the error that each step made itself.

Of numbers that were set by trial it is said how far they could move before a verdict changed in 36
drawings, those of ``tests/cases/check`` and the ``published.csv`` of the scenes (100 drawings of the student).
What the limits promise is measured in ``checking/README.md``.
"""
