"""Set the fields of a message from plain values."""

from tfloom.rosidl.yaml_text import set_message_fields

__all__ = [
    "set_message_fields",
]
