"""Checking hand-made drawings: readings against the log, verdicts, likely mistakes, reports."""
