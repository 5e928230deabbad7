"""Convert messages to text and from values, and find types by name."""

# Imported before the function of the same name, because a later import of the module would replace the function.
import rosidl_runtime_py.get_interfaces
from tfloom.rosidl.runtime import get_message_slot_types, import_message_from_namespaced_type
from tfloom.rosidl.yaml_text import (
    message_to_csv,
    message_to_ordereddict,
    message_to_yaml,
    set_message_fields,
)
from tfloom.workspace.get_interfaces import (
    get_action_interfaces,
    get_interface_packages,
    get_interface_path,
    get_interfaces,
    get_message_interfaces,
    get_service_interfaces,
)

__all__ = [
    "get_action_interfaces",
    "get_interface_packages",
    "get_interface_path",
    "get_interfaces",
    "get_message_interfaces",
    "get_message_slot_types",
    "get_service_interfaces",
    "import_message_from_namespaced_type",
    "message_to_csv",
    "message_to_ordereddict",
    "message_to_yaml",
    "set_message_fields",
]
