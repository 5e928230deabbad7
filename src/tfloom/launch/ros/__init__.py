"""Nodes in launch files: the room behind `launch_ros`."""
