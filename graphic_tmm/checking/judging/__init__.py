"""How readings are judged: by the scatter of a hand, and by the error that each step made itself.

Of numbers that were set by trial it is said how far they could move before a verdict changes in the 36
drawings of `graphic_tmm.checking.mistakes` (100 drawings of the student). What the limits promise is
measured in ``checking/README.md``.
"""
