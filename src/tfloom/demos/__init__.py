"""Programs to learn from, and the demonstration."""
