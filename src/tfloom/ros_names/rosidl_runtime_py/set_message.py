"""Set the fields of a message from plain values."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.rosidl.yaml_text import set_message_fields as set_message_fields

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.rosidl.definition import AbstractNestedType as AbstractNestedType
    from tfloom.rosidl.definition import NamespacedType as NamespacedType
    from tfloom.rosidl.runtime import get_message_slot_types as get_message_slot_types
    from tfloom.rosidl.runtime import import_message_from_namespaced_type as import_message_from_namespaced_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        AbstractNestedType="tfloom.rosidl.definition",
        NamespacedType="tfloom.rosidl.definition",
        get_message_slot_types="tfloom.rosidl.runtime",
        import_message_from_namespaced_type="tfloom.rosidl.runtime",
    )
