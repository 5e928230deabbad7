"""Example programs of the tutorials, and the demonstration."""
