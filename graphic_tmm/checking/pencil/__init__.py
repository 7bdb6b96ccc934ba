"""From the flat photograph of a sheet to readings: the pencil lines near each expected one, and where they meet."""
