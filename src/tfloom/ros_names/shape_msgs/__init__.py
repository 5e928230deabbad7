"""The interfaces of shape_msgs."""
