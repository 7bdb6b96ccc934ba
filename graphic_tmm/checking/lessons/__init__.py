"""Lessons: the steps that readings blame, told from the log with the drawing's own numbers; small plans."""
