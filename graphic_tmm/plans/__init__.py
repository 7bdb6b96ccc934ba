"""The textbook: each file talks to a Board only."""
