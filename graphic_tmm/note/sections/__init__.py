"""The sections of a note, in the order in which they stand: a file a section."""
