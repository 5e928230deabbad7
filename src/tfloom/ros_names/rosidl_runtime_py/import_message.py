"""Import a message class by its type."""

from tfloom.rosidl.definition import NamespacedType as NamespacedType
from tfloom.rosidl.runtime import import_message_from_namespaced_type as import_message_from_namespaced_type
