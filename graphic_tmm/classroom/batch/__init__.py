"""A list of work done once each, by processes here or elsewhere, whatever of them dies on the way."""
