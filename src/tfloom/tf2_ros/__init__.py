"""Frames over time for ROS programs: buffers, listeners, broadcasters, and operations on transforms."""
