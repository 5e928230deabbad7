"""The interfaces of turtlesim_msgs."""
