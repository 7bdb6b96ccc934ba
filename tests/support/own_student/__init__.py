"""A student of one's own: numpy and plane geometry, nothing of the package."""
