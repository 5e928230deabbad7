"""Frames over time, with no ROS types."""
