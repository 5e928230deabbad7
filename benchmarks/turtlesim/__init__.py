"""Benchmarks of turtlesim."""
