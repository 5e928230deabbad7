"""Convert messages to YAML, CSV and dicts."""

from tfloom.rosidl.runtime import get_message_slot_types
from tfloom.rosidl.yaml_text import message_to_csv, message_to_ordereddict, message_to_yaml

__all__ = [
    "get_message_slot_types",
    "message_to_csv",
    "message_to_ordereddict",
    "message_to_yaml",
]
