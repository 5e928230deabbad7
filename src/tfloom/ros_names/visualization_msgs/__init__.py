"""The interfaces of visualization_msgs."""
