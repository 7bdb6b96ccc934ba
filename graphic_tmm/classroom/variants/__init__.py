"""Variants of a scene: named by a table, or drawn from ranges so that each of them can be drawn well."""
