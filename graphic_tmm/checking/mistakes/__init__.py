"""Mistakes: what each does to the figures of a scene, and which would explain the readings that are wrong."""
