"""The interfaces of moveit_msgs."""
