"""Internal modules of rclpy that programs import."""
