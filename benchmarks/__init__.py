"""Benchmarks of tfloom, beside its peers in the same run: `python -m benchmarks [ROOM ...]`."""
