"""What each effect of a scene costs and changes, and which is not worth drawing."""
