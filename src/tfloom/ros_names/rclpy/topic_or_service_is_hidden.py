"""Names that tools leave out."""

from tfloom.node.values.names import HIDDEN_TOPIC_PREFIX, topic_or_service_is_hidden

__all__ = ["HIDDEN_TOPIC_PREFIX", "topic_or_service_is_hidden"]
