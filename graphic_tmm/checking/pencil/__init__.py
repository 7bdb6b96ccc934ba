"""From the flat photograph of a sheet to readings: pencil lines near the expected ones, and where they meet."""
