"""A scene's mechanism at any angles of its crank: its log, recorded once and executed on every call."""
