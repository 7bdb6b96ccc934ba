"""A class: variants of a scene, task sheets and keys for them, marks for what is handed in; batches of it."""
