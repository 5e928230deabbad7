"""Demonstration nodes for logging."""
