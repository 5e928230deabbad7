"""Import a message class by its type."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.rosidl.runtime import import_message_from_namespaced_type as import_message_from_namespaced_type

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.rosidl.definition import NamespacedType as NamespacedType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        NamespacedType="tfloom.rosidl.definition",
    )
