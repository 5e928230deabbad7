"""Benchmarks of nodes."""
