"""Actions, of which launch descriptions consist."""
