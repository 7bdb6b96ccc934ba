"""Readers of the log: columns and tables, the protocol with its equations, findings and warnings."""
