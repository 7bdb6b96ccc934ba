"""A scene's mechanism at any angles of its crank: its log, recorded once, executed as often as is asked."""
