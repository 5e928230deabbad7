"""Descriptions of what a node is given."""
