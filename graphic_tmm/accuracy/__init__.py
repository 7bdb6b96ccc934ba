"""What accuracy costs: work at the board counted off the log, slopes in log-log, the Pareto front."""
