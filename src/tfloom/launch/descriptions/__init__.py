"""Descriptions of what actions run."""
