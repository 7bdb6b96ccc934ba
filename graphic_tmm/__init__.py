"""The drawing board of the theory of machines and mechanisms."""
