"""Import a message class by its type."""

from tfloom.rosidl.runtime import import_message_from_namespaced_type

__all__ = [
    "import_message_from_namespaced_type",
]
