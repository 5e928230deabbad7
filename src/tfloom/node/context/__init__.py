"""Contexts: the state of the library from `init` to `shutdown`, and its ROS arguments."""
