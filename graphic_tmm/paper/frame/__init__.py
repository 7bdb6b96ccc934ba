"""The frame of a sheet and its title block: ГОСТ 2.301 and 2.104, or ISO 5457 and 7200, by language."""
