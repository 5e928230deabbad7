"""Robots: their description in URDF, their joints' states, and the frames of their links."""
