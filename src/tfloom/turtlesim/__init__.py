"""The turtle simulator: its world, the world's picture, and its programs."""
