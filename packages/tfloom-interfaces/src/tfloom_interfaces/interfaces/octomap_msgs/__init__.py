"""The interfaces of octomap_msgs."""
