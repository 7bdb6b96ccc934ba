"""What Python users hold: a dozen verbs, and the objects that these give. How they are used: README.md here.

The face only opens doors. Every number, sentence and picture comes from the readers of the one log that the
commands use too, so that a notebook and a terminal never differ.
"""
