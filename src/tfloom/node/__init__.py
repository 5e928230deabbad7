"""Nodes and what they have: what rclpy exposes."""
