"""Clocks: system, steady and ROS time, their jumps, and sleeping by them."""
