"""`tf`: check, explain, compare and keep transforms."""
