"""Validation of full topic names."""

from tfloom.node.values.names import validate_full_topic_name

__all__ = ["validate_full_topic_name"]
