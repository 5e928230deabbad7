"""Demonstration nodes for parameters."""
