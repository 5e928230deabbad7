"""The interfaces of ackermann_msgs."""
