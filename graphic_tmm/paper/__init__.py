"""Ink: from the log to true millimetres on a sheet."""
