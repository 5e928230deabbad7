"""Expansion of relative names to full names."""

from tfloom.node.values.names import expand_topic_name

__all__ = ["expand_topic_name"]
