"""Photographs of hand-made sheets: the frame found, perspective taken out, flattened to true millimetres."""
