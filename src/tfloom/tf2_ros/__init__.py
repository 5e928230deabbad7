"""Frames over time for ROS programs: buffers, listeners, broadcasters, and what is done with transforms."""
