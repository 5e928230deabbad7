"""Convert sensor_msgs to numpy arrays and back."""
