"""Files of readings to be filled in: all that can be measured, or the main segments of one position."""
