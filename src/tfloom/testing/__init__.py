"""Fixtures of pytest for packages that run on ROS: a graph of one's own, simulated time, transforms from a table."""
