"""What accuracy costs: work at the board counted off the log, slopes of errors and of times, the Pareto front."""
