"""What is valid as a name that a program gives."""

from tfloom.node.values.names import TOPIC_SEPARATOR_STRING, validate_topic_name

__all__ = ["TOPIC_SEPARATOR_STRING", "validate_topic_name"]
