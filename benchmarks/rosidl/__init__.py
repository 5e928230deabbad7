"""Benchmarks of messages."""
