"""Languages: what the package says, in English as written and in others by a catalogue each (`catalogue`)."""
