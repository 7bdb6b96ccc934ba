"""Readings of a hand-made drawing: CSV as people write it, to figures with digits and units, and back."""
