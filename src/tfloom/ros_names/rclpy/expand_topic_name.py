"""What a relative name stands for."""

from tfloom.node.names import expand_topic_name

__all__ = ["expand_topic_name"]
