"""Benchmarks of the commands."""
