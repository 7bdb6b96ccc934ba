"""Symbols: links and pairs (ГОСТ 2.770), gears, arrows, dimensions, hatching, as strokes about a point."""
