"""Validation of topic names that are not expanded yet."""

from tfloom.node.values.names import TOPIC_SEPARATOR_STRING, validate_topic_name

__all__ = ["TOPIC_SEPARATOR_STRING", "validate_topic_name"]
