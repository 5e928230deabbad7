"""The interfaces of nav2_msgs."""
