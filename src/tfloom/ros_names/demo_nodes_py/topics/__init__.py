"""Demonstration nodes for topics."""
