"""A student's own sheet: plans wherever he put them, read as they were drawn, right or wrong."""
