"""Practice: what a page packs so that a person draws a plan himself and is judged at once."""
