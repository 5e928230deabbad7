"""Demonstration nodes for services."""
