"""Benchmarks of frames over time."""
