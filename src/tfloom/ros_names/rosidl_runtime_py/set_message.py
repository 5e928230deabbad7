"""Set the fields of a message from plain values."""

from tfloom.rosidl.definition import AbstractNestedType as AbstractNestedType
from tfloom.rosidl.definition import NamespacedType as NamespacedType
from tfloom.rosidl.runtime import get_message_slot_types as get_message_slot_types
from tfloom.rosidl.runtime import import_message_from_namespaced_type as import_message_from_namespaced_type
from tfloom.rosidl.yaml_text import set_message_fields as set_message_fields
