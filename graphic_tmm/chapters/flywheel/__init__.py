"""Flywheel."""
