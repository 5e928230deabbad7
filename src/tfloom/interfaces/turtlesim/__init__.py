"""The interfaces of turtlesim."""
