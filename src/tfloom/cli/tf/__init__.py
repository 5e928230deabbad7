"""`tf`: explain, compare and keep transforms."""
