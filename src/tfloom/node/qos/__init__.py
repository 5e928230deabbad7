"""Quality of service in rclpy's classes, and overrides by parameters."""
