"""Clocks: system, steady and ROS time, time jumps, and sleeping."""
