"""The interfaces of vision_msgs."""
