"""The interfaces of rosbag2_interfaces."""
