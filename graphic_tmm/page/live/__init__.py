"""Live lengths: what a page packs so that its plans follow when something given is changed."""
