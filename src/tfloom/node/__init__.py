"""What rclpy exposes, in rooms; each imports only those before it in ARCHITECTURE.md's list."""
