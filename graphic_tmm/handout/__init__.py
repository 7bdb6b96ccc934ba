"""The construction on paper, picture by picture: the series that the page plays as sheets to hand out."""

FORMATS = ("svg", "pdf", "png")
"""What the sheets can be written as."""
