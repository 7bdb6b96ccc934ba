"""What is done on the board: instruments, curves, and formulas that more than one chapter uses."""
