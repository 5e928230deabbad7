"""Benchmarks of the tools that watch transforms."""
