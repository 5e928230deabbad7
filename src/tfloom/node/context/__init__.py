"""Contexts: one life of the library from `init` to `shutdown`, with its ROS arguments."""
