"""Hidden topics and services: names with a part that begins with `_`."""

from tfloom.node.values.names import HIDDEN_TOPIC_PREFIX, topic_or_service_is_hidden

__all__ = ["HIDDEN_TOPIC_PREFIX", "topic_or_service_is_hidden"]
