"""How readings are judged: by the scatter of a hand, and by the error that each step made itself."""
