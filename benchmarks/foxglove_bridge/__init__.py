"""Benchmarks of foxglove_bridge."""
