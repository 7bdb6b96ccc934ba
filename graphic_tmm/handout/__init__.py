"""The construction on paper, picture by picture: the series that the page plays as sheets to hand out."""
