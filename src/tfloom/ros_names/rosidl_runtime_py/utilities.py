"""Find message, service and action classes by name."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.rosidl.runtime import get_action as get_action
from tfloom.rosidl.runtime import get_action_namespaced_type as get_action_namespaced_type
from tfloom.rosidl.runtime import get_interface as get_interface
from tfloom.rosidl.runtime import get_message as get_message
from tfloom.rosidl.runtime import get_message_namespaced_type as get_message_namespaced_type
from tfloom.rosidl.runtime import get_namespaced_type as get_namespaced_type
from tfloom.rosidl.runtime import get_service as get_service
from tfloom.rosidl.runtime import get_service_namespaced_type as get_service_namespaced_type
from tfloom.rosidl.runtime import is_action as is_action
from tfloom.rosidl.runtime import is_message as is_message
from tfloom.rosidl.runtime import is_service as is_service

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.rosidl.definition import NamespacedType as NamespacedType
    from tfloom.rosidl.runtime import import_message_from_namespaced_type as import_message_from_namespaced_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        NamespacedType="tfloom.rosidl.definition",
        import_message_from_namespaced_type="tfloom.rosidl.runtime",
    )
