"""sensor_msgs in numpy's hands."""
