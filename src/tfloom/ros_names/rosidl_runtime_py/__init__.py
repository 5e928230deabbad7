"""Convert messages to text and from values, and find types by name."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

import rosidl_runtime_py.get_interfaces
from tfloom.workspace.get_interfaces import get_interfaces as get_interfaces

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

TYPE_CHECKING = False
if TYPE_CHECKING:
    from rosidl_runtime_py import convert as convert
    from rosidl_runtime_py import import_message as import_message
    from rosidl_runtime_py import set_message as set_message
    from rosidl_runtime_py import utilities as utilities
    from tfloom.rosidl.runtime import get_message_slot_types as get_message_slot_types
    from tfloom.rosidl.runtime import import_message_from_namespaced_type as import_message_from_namespaced_type
    from tfloom.rosidl.yaml_text import message_to_csv as message_to_csv
    from tfloom.rosidl.yaml_text import message_to_ordereddict as message_to_ordereddict
    from tfloom.rosidl.yaml_text import message_to_yaml as message_to_yaml
    from tfloom.rosidl.yaml_text import set_message_fields as set_message_fields
    from tfloom.workspace.get_interfaces import get_action_interfaces as get_action_interfaces
    from tfloom.workspace.get_interfaces import get_interface_packages as get_interface_packages
    from tfloom.workspace.get_interfaces import get_interface_path as get_interface_path
    from tfloom.workspace.get_interfaces import get_message_interfaces as get_message_interfaces
    from tfloom.workspace.get_interfaces import get_service_interfaces as get_service_interfaces
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        convert="rosidl_runtime_py",
        get_action_interfaces="tfloom.workspace.get_interfaces",
        get_interface_packages="tfloom.workspace.get_interfaces",
        get_interface_path="tfloom.workspace.get_interfaces",
        get_message_interfaces="tfloom.workspace.get_interfaces",
        get_message_slot_types="tfloom.rosidl.runtime",
        get_service_interfaces="tfloom.workspace.get_interfaces",
        import_message="rosidl_runtime_py",
        import_message_from_namespaced_type="tfloom.rosidl.runtime",
        message_to_csv="tfloom.rosidl.yaml_text",
        message_to_ordereddict="tfloom.rosidl.yaml_text",
        message_to_yaml="tfloom.rosidl.yaml_text",
        set_message="rosidl_runtime_py",
        set_message_fields="tfloom.rosidl.yaml_text",
        utilities="rosidl_runtime_py",
    )
