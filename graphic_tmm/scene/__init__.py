"""scene.toml -> Scene: quantities with units, all faults at once with key path and line."""
