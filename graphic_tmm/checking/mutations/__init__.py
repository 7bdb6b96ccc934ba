"""Mistakes as small mutations of the construction: generated from the log, executed together."""
