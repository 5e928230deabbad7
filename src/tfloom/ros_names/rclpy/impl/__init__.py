"""What rclpy keeps for itself, and programs import all the same."""
