"""Tables read off the log: columns of figures, and ways to write them down."""
