"""The interfaces of map_msgs."""
