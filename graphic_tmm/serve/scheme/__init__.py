"""A mechanism drawn by a hand in the studio: the scene that it is, and where the log puts it."""
